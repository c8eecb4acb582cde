// SPDX-License-Identifier: MIT
// Every scene with every method on both headless contexts: no GL error, no NaN, no negative light, the same bytes twice,
// and the same picture from EGL as from OSMesa within rounding.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/render/capture.h"
#include "engine/render/gl/context.h"
#include "engine/ecs/query.h"
#include "game/session.h"

namespace sl {
namespace {

/// All scenes but the base that others include, which has no active camera, and endless land, which is the valley in a land
/// that takes seconds to make and has tests of its own.
std::vector<std::string> scenes() {
    std::vector<std::string> names;
    for (const SceneListing& listing : scene_names()) {
        if (listing.name != "village" && listing.name != "endless") names.push_back(listing.name);
    }
    return names;
}

/// A frame small enough that the exact sum takes no time.
Capture small_capture(Renderer& renderer, const std::string& scene, const std::string& method) {
    App app = open_scene({.scene = scene, .gi = method});
    for (auto [entity, gi] : Query<GiSettings>(app.world)) {
        if (auto* exact = gi.method.get_if<RsmExact>()) exact->rsm_size = 32;
    }
    return capture(app, renderer, {.width = 80, .height = 45, .frame = 1, .layers = true});
}

void expect_light_is_sane(const Capture& captured, const std::string& what) {
    for (const ImageLayer& layer : captured.layers) {
        if (layer.name == "normal") continue;
        for (const float value : layer.image.data) {
            ASSERT_TRUE(std::isfinite(value)) << what << ": " << layer.name;
            ASSERT_GE(value, 0.0f) << what << ": " << layer.name;
        }
    }
}

struct Session {
    std::unique_ptr<gl::Context> context;
    Renderer renderer;
    explicit Session(gl::ContextKind kind) : context(gl::create_context(kind)), renderer(shader_folder()) {}
    ~Session() {
        for (const std::string& error : context->errors()) ADD_FAILURE() << "OpenGL: " << error;
    }
};

using Pictures = std::map<std::string, Capture>;

Pictures capture_all(gl::ContextKind kind) {
    Session session(kind);
    Pictures pictures;
    for (const std::string& scene : scenes()) {
        for (const std::string_view method : gi_method_names()) {
            const std::string what = fmt::format("{} with {}", scene, method);
            pictures[what] = small_capture(session.renderer, scene, std::string(method));
            expect_light_is_sane(pictures[what], what);
        }
    }
    return pictures;
}

TEST(EveryFrame, EglAndOsmesaAgree) {
    const Pictures egl = capture_all(gl::ContextKind::egl);
    const Pictures osmesa = capture_all(gl::ContextKind::osmesa);
    ASSERT_GE(egl.size(), 5u * std::size(gi_method_names()));
    for (const auto& [what, picture] : egl) {
        const Image& other = osmesa.at(what).picture;
        double difference = 0.0;
        for (std::size_t i = 0; i < other.data.size(); ++i) difference += std::abs(double(picture.picture.data[i]) - other.data[i]);
        EXPECT_LT(difference / static_cast<double>(other.data.size()), 0.5 / 255) << what << ": mean difference over half a grey level";
    }
}

TEST(EveryFrame, TwoRunsGiveTheSameBytes) {
    Session session(gl::ContextKind::egl);
    for (const std::string_view method : gi_method_names()) {
        const Capture first = small_capture(session.renderer, "indoor", std::string(method));
        Renderer another(shader_folder());
        const Capture second = small_capture(another, "indoor", std::string(method));
        EXPECT_EQ(first.picture.data, second.picture.data) << method;
        for (std::size_t i = 0; i < first.layers.size(); ++i) EXPECT_EQ(first.layers[i].image.data, second.layers[i].image.data) << method << ": " << first.layers[i].name;
    }
}

TEST(EveryFrame, SmallAndOddSizes) {
    Session session(gl::ContextKind::egl);
    for (const std::string_view method : gi_method_names()) {
        for (const uvec2 size : {uvec2(1, 1), uvec2(1, 33), uvec2(7680, 1), uvec2(17, 13)}) {
            App app = open_scene({.scene = "cornell", .gi = std::string(method)});
            for (auto [entity, gi] : Query<GiSettings>(app.world)) {
                if (auto* exact = gi.method.get_if<RsmExact>()) exact->rsm_size = 16;
            }
            const Capture captured = capture(app, session.renderer, {.width = size.x, .height = size.y, .layers = true});
            expect_light_is_sane(captured, fmt::format("{} at {}x{}", method, size.x, size.y));
            EXPECT_EQ(captured.picture.width, size.x);
        }
    }
}

std::vector<std::string> pass_names(const Renderer& renderer) {
    std::vector<std::string> names;
    for (const Step& step : renderer.steps()) names.push_back(renderer.graph().passes()[static_cast<std::size_t>(step.pass)].name);
    return names;
}

bool any_rsm(const std::vector<std::string>& passes) {
    return std::ranges::any_of(passes, [](const std::string& name) { return name.starts_with("rsm"); });
}

TEST(EveryFrame, HardlyAPixelOfALitRoomIsBlack) {
    // At edges quads of blocks go on by a hair behind each other, and some pixels show that hair.
    Session session(gl::ContextKind::egl);
    App app = open_scene({.scene = "cornell", .gi = "facets", .sets = {"gi.noise=0.3"}});
    const Capture captured = capture(app, session.renderer, {.width = 640, .height = 360, .frame = 1, .layers = true});
    const auto layer = [&](std::string_view name) { return std::ranges::find(captured.layers, name, &ImageLayer::name)->image; };
    const Image depth = layer("depth"), irradiance = layer("irradiance");
    std::size_t surface = 0, black = 0;
    for (std::size_t i = 0; i < depth.data.size(); ++i) {
        if (depth.data[i] <= 0.0f) continue;
        ++surface;
        if (irradiance.data[i * irradiance.channels] <= 0.0f) ++black;
    }
    EXPECT_GT(surface, 10000u);
    // 9 of 65,000: facets all of whose corners lie in the gap between two quads, where it is dark. Without a look beside the
    // edge it is 96.
    EXPECT_LT(black, surface / 4000);
}

TEST(EveryFrame, WithoutGiSettingsThereIsNoRsmPass) {
    Session session(gl::ContextKind::egl);
    App app = open_scene({.scene = "outdoor", .gi = "rsm_disc"});
    (void)capture(app, session.renderer, {.width = 16, .height = 9});
    EXPECT_TRUE(any_rsm(pass_names(session.renderer)));
    app.world.remove<GiSettings>(active_camera(app.world));
    session.renderer.forget();
    (void)capture(app, session.renderer, {.width = 16, .height = 9});
    EXPECT_FALSE(any_rsm(pass_names(session.renderer)));
}

TEST(EveryFrame, StillLightAndGeometryAreNotDrawnAgain) {
    Session session(gl::ContextKind::egl);
    App app = open_scene({.scene = "outdoor", .gi = "rsm_disc"});
    const auto map_passes = [&] {
        (void)capture(app, session.renderer, {.width = 16, .height = 9});
        const auto names = pass_names(session.renderer);
        return std::ranges::count_if(names, [](const std::string& name) {
            return name == "rsm_0" || name == "rsm_1" || name == "rsm_2" || name.starts_with("shadow_");
        });
    };
    EXPECT_EQ(map_passes(), 6) << "sun and two lamps, shadow map and RSM each";
    // The camera may move: the village is covered whole.
    app.world.get<Transform>(active_camera(app.world)).translation.x += 0.5;
    EXPECT_EQ(map_passes(), 0);
    for (auto [entity, sun] : Query<SunAngles>(app.world)) sun.azimuth += 0.1f;
    EXPECT_EQ(map_passes(), 2) << "only the sun's";
}

}  // namespace
}  // namespace sl
