// SPDX-License-Identifier: MIT
// Random cameras, suns, methods, settings inside their ranges and sizes from 1×1, one after the other on one renderer: no
// GL error, no NaN, no negative light, and no growth of memory once every method has been seen.
#include <gtest/gtest.h>
#include <malloc.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

#include "engine/core/field_random.h"
#include "engine/ecs/query.h"
#include "engine/render/capture.h"
#include "engine/render/gl/context.h"
#include "game/session.h"

namespace sl {
namespace {

/// What is allocated once the last frame's method keeps nothing, MB: `heap` in small pieces, `mapped` in pieces of their own, as
/// maps and screens are.
struct Memory {
    double heap, mapped;
};
Memory memory_without_facets(App& empty, Renderer& renderer) {
    for (auto [entity, gi] : Query<GiSettings>(empty.world)) gi.method = Facets{};
    (void)capture(empty, renderer, {.width = 16, .height = 16});
    const auto info = mallinfo2();
    return {static_cast<double>(info.uordblks) / 1e6, static_cast<double>(info.hblkhd) / 1e6};
}

int frame_count() {
    const char* chosen = std::getenv("SECONDLIGHT_RANDOM_FRAMES");
    return chosen != nullptr ? std::atoi(chosen) : 2000;
}

/// Keeps a frame's work small; the settings themselves stay random. A few frames of a few pixels are not bounded.
void bound_cost(GiMethod& method) {
    if (auto* exact = method.get_if<RsmExact>()) exact->rsm_size = std::min(exact->rsm_size, 64u);
    if (auto* grid = method.get_if<RsmGrid>()) grid->rsm_size = std::min(grid->rsm_size, 64u);
    if (auto* disc = method.get_if<RsmDisc>()) {
        disc->rsm_size = std::min(disc->rsm_size, 256u);
        disc->samples = std::min(disc->samples, 512u);
    }
    if (auto* facets = method.get_if<Facets>()) {
        facets->spacing = std::max(facets->spacing, 4.0f);
        facets->noise = std::max(facets->noise, 0.2f);
    }
}

void randomise(App& app, RandomFields& random, bool bounded) {
    for (auto [entity, light] : Query<DirectionalLight>(app.world)) {
        visit_fields(random, light);
        light.shadow_size = std::min(light.shadow_size, bounded ? 256u : 2048u);
    }
    for (auto [entity, light] : Query<SpotLight>(app.world)) {
        visit_fields(random, light);
        light.shadow_size = std::min(light.shadow_size, bounded ? 256u : 2048u);
    }
    for (auto [entity, light] : Query<PointLight>(app.world)) {
        visit_fields(random, light);
        light.shadow_size = std::min(light.shadow_size, bounded ? 128u : 1024u);
    }
    for (auto [entity, sun] : Query<SunAngles>(app.world)) visit_fields(random, sun);
    for (auto [entity, sky] : Query<SkyLight>(app.world)) visit_fields(random, sky);
    for (auto [entity, material] : Query<Material>(app.world)) visit_fields(random, material);
    const Entity camera = active_camera(app.world);
    auto& view = app.world.get<Camera>(camera);
    visit_fields(random, view);
    view.active = true;
    // Most in perspective; of the orthographic ones, half are so near that the scene is more than a dot.
    if (const double kind = random.uniform(); kind < 0.9) view.height = kind < 0.8 ? 0.0f : 1.0f + 50.0f * static_cast<float>(random.uniform());
    visit_fields(random, app.world.get<GiSettings>(camera));
    if (bounded) bound_cost(app.world.get<GiSettings>(camera).method);
    auto& transform = app.world.get<Transform>(camera);
    // Mostly inside the scene, sometimes far outside.
    const double reach = random.uniform() < 0.9 ? 20.0 : 1e6;
    for (int axis = 0; axis < 3; ++axis) transform.translation[axis] = (random.uniform() * 2.0 - 1.0) * reach;
    random.field("rotation", transform.rotation, {});
}

TEST(RandomFrames, NeverBreak) {
    auto context = gl::create_context(gl::ContextKind::egl);
    {
        Renderer renderer(shader_folder());
        RandomFields random(20260101);
        std::vector<App> worlds;
        for (const char* scene : {"outdoor", "indoor", "hills", "night", "cornell", "plates", "empty"}) worlds.push_back(open_scene({.scene = scene}));
        // Many lights: maps and texels of all together must still fit.
        worlds.push_back(open_scene({.scene = "cornell"}));
        for (int lamp = 0; lamp < 6; ++lamp) worlds.back().world.create(SpotLight{}, Transform{.translation = {0.2 * lamp - 0.5, 1.5, 0.0}});
        App nothing = open_scene({.scene = "empty"});
        const int frames = frame_count();
        double early = std::numeric_limits<double>::infinity(), late = early;
        for (int frame = 0; frame < frames; ++frame) {
            App& app = worlds[static_cast<std::size_t>(random.uniform() * static_cast<double>(worlds.size()))];
            const bool bounded = random.uniform() > 0.03;
            randomise(app, random, bounded);
            const auto side = [&] { return 1u + static_cast<std::uint32_t>(std::pow(random.uniform(), 3.0) * (bounded ? 96.0 : 4.0)); };
            const Capture captured = capture(app, renderer, {.width = side(), .height = side(), .layers = true});
            for (const ImageLayer& layer : captured.layers) {
                for (const float value : layer.image.data) {
                    ASSERT_TRUE(std::isfinite(value)) << "frame " << frame << ", layer " << layer.name;
                    if (layer.name != "normal") {
                        ASSERT_GE(value, 0.0f) << "frame " << frame << ", layer " << layer.name;
                    }
                }
            }
            ASSERT_TRUE(context->errors().empty()) << "frame " << frame << ": " << context->errors().front();
            if (frame % 50 != 49 || frame < frames / 4) continue;
            // It goes up and down with what frames want; a leak lifts the lowest of many.
            const Memory memory = memory_without_facets(nothing, renderer);
            double& lowest = frame < frames / 2 ? early : late;
            lowest = std::min(lowest, memory.heap);
            // Maps and screens of the largest frames stay for the next ones; they are a bounded set.
            EXPECT_LT(memory.mapped, 600.0);
        }
        RecordProperty("megabytes_early", fmt::format("{:.1f}", early));
        RecordProperty("megabytes_late", fmt::format("{:.1f}", late));
        EXPECT_LT(late, early + 16.0) << "memory grew";
    }
}

}  // namespace
}  // namespace sl
