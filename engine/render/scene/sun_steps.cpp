// SPDX-License-Identifier: MIT
#include "engine/render/scene/sun_steps.h"

#include <algorithm>
#include <cmath>

namespace sl {

namespace {

using Light = RenderScene::Light;

/// rad: who turns a sun further wants to see it.
constexpr float little = 0.06f;

std::vector<vec3> directions(const RenderScene& scene) {
    std::vector<vec3> result;
    for (const Light& light : scene.lights) {
        if (light.kind == Light::Kind::directional) result.push_back(light.direction);
    }
    return result;
}

/// Directional lights come first.
void turn(RenderScene& scene, const std::vector<vec3>& directions) {
    for (std::size_t i = 0; i < directions.size(); ++i) scene.lights[i].direction = directions[i];
}

bool lies_in_tiles(const RenderScene& scene) {
    return std::ranges::any_of(scene.lights, [&](const Light& light) { return light.kind == Light::Kind::directional && light.casts_shadow && fit_sun_square(scene, light).moves; });
}

bool close(const std::vector<vec3>& a, const std::vector<vec3>& b) {
    return std::ranges::equal(a, b, [](vec3 x, vec3 y) { return glm::length(x - y) < little; });
}

}  // namespace

const RenderScene& SunSteps::hold(const RenderScene& scene, bool at_once) {
    const std::vector<vec3> wanted = directions(scene);
    const bool drawn = std::exchange(next_is_drawn_, false);
    if (at_once || !close(shown_, wanted) || !lies_in_tiles(scene)) {
        shown_ = wanted;
        moving_ = false;
        return scene;
    }
    if (moving_ && drawn) {
        shown_ = directions(next_);
        array_ = 1 - array_;
        moving_ = false;
    }
    if (shown_ == wanted && !moving_) return scene;
    // It goes where it was on its way to, even if it is wanted elsewhere by now, or it would never come anywhere.
    const std::vector<vec3> next = moving_ ? directions(next_) : wanted;
    next_ = scene;
    turn(next_, next);
    moving_ = true;
    held_ = scene;
    turn(held_, shown_);
    return held_;
}

void SunSteps::add_next_layers(LightTable& table) const {
    table.sun_array = array_;
    if (moving_) table.next_sun_layers = build_light_table(next_).sun_layers;
}

}  // namespace sl
