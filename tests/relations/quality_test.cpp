// SPDX-License-Identifier: MIT
// Settings of quality change the error of a picture, not its brightness; and what nobody sees changes nothing.
#include <glm/gtc/matrix_transform.hpp>

#include "engine/render/passes/frame_input.h"
#include "tests/relations/relation_test.h"

namespace sl {
namespace {

/// The method with another setting; null where it has no such setting.
template <class Settings, class Change>
std::optional<LightMethod> with(LightMethod method, Change&& change) {
    if (method.traced() || !method.gi->is<Settings>()) return std::nullopt;
    change(method.gi->get<Settings>());
    return method;
}

struct Setting {
    std::string name;
    std::optional<LightMethod> method;
    std::vector<double> changes{};  ///< of the mean brightness, one per scene
};

std::vector<Setting> better_and_worse(const LightMethod& m) {
    return {{"`rsm_size` 64 → 128", with<RsmExact>(m, [](RsmExact& s) { s.rsm_size = 128; })},
            {"`rsm_size` 64 → 128", with<RsmDisc>(m, [](RsmDisc& s) { s.rsm_size = 128; })},
            {"`samples` 1024 → 256", with<RsmDisc>(m, [](RsmDisc& s) { s.samples = 256; })},
            {"`rotate`", with<RsmDisc>(m, [](RsmDisc& s) { s.rotate = true; })},
            {"`interpolate` off", with<RsmDisc>(m, [](RsmDisc& s) { s.interpolate = false; })},
            {"`spacing` 8 → 4", with<Facets>(m, [](Facets& s) { s.spacing = 4.0f; })},
            {"`noise` 0.07 → 0.15", with<Facets>(m, [](Facets& s) { s.noise = 0.15f; })},
            {"`low_resolution` 4 → 2", with<RsmDisc>(m, [](RsmDisc& s) { s.low_resolution = 2; })}};
}

TEST_P(Relations, QualityDoesNotChangeBrightness) {
    if (is("rsm_grid")) return;  // fails by design: by_design_test.cpp says by how much
    std::vector<Setting> settings = better_and_worse(method());
    for_plans([&](const ScenePlan& plan) {
        if (method().traced()) return expect_within_noise("mean brightness: samples 384 → 768", trace(plan), trace(plan, {}, 768));
        const Picture& plain = draw_once(plan);
        for (Setting& setting : settings) {
            if (setting.method) setting.changes.push_back(deviation(draw(plan, {}, *setting.method), plain).mean);
        }
    });
    for (const Setting& setting : settings) {
        if (setting.method) expect_same_brightness("mean brightness: " + setting.name, setting.changes);
    }
}

TEST_P(Relations, AThingInsideABoxChangesNothing) {
    // Neither camera nor light sees it, and it makes the scene no larger.
    for_plans([&](ScenePlan plan) {
        const Picture& without = draw_once(plan);
        ScenePlan::Thing hidden = plan.things.front();
        hidden.size *= 0.9f;
        hidden.albedo = vec3(1, 0, 1);
        plan.things.push_back(hidden);
        const Picture picture = draw(plan);
        // Of millions of rays some pass right along an edge, and which side they are on hangs on what else is there.
        if (method().facets()) return expect_facets_agree("an unseen entity added", picture, without);
        expect_within("an unseen entity added", deviation(picture, without).worst, 0.0);
        RC_ASSERT(same_bytes(picture, without));
    });
}

/// Whether a light's map or the camera has it in its view.
bool seen(const RenderScene& scene, std::uint32_t draw) {
    const auto has = [&](const mat4& clip_from_world) { return std::ranges::count(visible_draws(scene, clip_from_world), draw) > 0; };
    bool result = has(frame_params(scene, 16, 12, 0).clip_from_world);
    for (const LightMap& map : build_light_table(scene).maps) result |= map.map_area > 0.0f && has(map.clip_from_world);
    return result;
}

TEST_P(Relations, AThingFarOutsideChangesNothing) {
    // Maps that do not hold the whole scene keep their place when the scene grows.
    for_plans([&](ScenePlan plan) {
        const auto picture_with = [&](std::optional<vec3> far) {
            SceneBuilder builder;
            build(plan, {}, builder);
            for (auto& light : builder.scene().lights) light.shadow_distance = 2.0f;
            if (far) builder.add({Shape::Kind::box, vec3(1)}, glm::translate(mat4(1.0f), *far), vec3(1.0f));
            const auto last = static_cast<std::uint32_t>(builder.scene().draws.size()) - 1;
            const bool hidden = !far || !seen(builder.scene(), last);
            renderer->forget();
            return std::pair(hidden, hidden ? picture_of(method(), builder.scene(), *renderer, size) : Picture{});
        };
        std::erase_if(plan.lamps, [](const auto& lamp) { return lamp.kind == RenderScene::Light::Kind::point; });
        const Picture without = picture_with(std::nullopt).second;
        bool compared = false;
        for (const vec3 far : {vec3(0, -30, 0), vec3(30, 0, 0), vec3(-30, 0, 0), vec3(0, 0, 30), vec3(0, 0, -30)}) {
            const auto [hidden, picture] = picture_with(far);
            // A path may meet it: only what lies under the floor is out of everybody's sight.
            if (!hidden || ((method().traced() || method().facets()) && far.y >= 0.0f)) continue;
            compared = true;
            // The scene is larger, and so are the patches that patches see.
            if (method().facets()) {
                expect_facets_agree("an entity added outside of all maps", picture, without);
                continue;
            }
            expect_within("an entity added outside of all maps", deviation(picture, without).worst, 0.0);
            RC_ASSERT(same_bytes(picture, without));
        }
        RC_PRE(compared);
    });
}

}  // namespace
}  // namespace sl
