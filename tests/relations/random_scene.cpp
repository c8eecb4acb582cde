// SPDX-License-Identifier: MIT
#include "tests/relations/random_scene.h"

#include <fmt/ranges.h>

#include <glm/gtc/matrix_transform.hpp>
#include <ostream>

namespace sl {

namespace {

using Light = RenderScene::Light;

mat4 place_of(const ScenePlan::Thing& thing) {
    mat4 place = glm::translate(mat4(1.0f), thing.place);
    for (int axis = 0; axis < 3; ++axis) {
        vec3 around(0.0f);
        around[axis] = 1.0f;
        place = glm::rotate(place, thing.turn[axis], around);
    }
    return place;
}

vec3 on_sphere(float azimuth, float elevation) {
    return vec3(std::cos(elevation) * std::sin(azimuth), std::sin(elevation), std::cos(elevation) * std::cos(azimuth));
}

vec3 permuted(vec3 colour, uvec3 channels) { return vec3(colour[channels.x], colour[channels.y], colour[channels.z]); }

Light light_of(const ScenePlan::Lamp& lamp) {
    const vec3 towards = on_sphere(lamp.azimuth, lamp.elevation);
    Light light{.kind = lamp.kind, .position = towards * (lamp.height / towards.y), .direction = -towards, .intensity = lamp.intensity,
                .inner_cone = 0.5f * lamp.outer_cone, .outer_cone = lamp.outer_cone, .casts_shadow = true, .bounces = true,
                .shadow_size = 256, .shadow_distance = 100.0f};
    if (lamp.kind == Light::Kind::point) light.bounces = false;
    return light;
}

std::string text(vec3 v) { return fmt::format("({:.4g} {:.4g} {:.4g})", v.x, v.y, v.z); }

}  // namespace

void build(const ScenePlan& plan, const SceneChange& change, SceneBuilder& builder) {
    const mat4 world = glm::scale(mat4(1.0f), vec3(change.scale)) * change.place;
    const mat3 turn(change.place);
    const auto add = [&](const Shape& shape, const mat4& place, vec3 albedo) { builder.add(shape, world * place, permuted(albedo, change.channels)); };
    add({Shape::Kind::quad, vec3(8, 0, 8)}, mat4(1.0f), plan.floor_albedo);
    for (const auto& thing : plan.things) add({thing.kind, thing.size}, place_of(thing), thing.albedo);

    std::vector<Light> lights;
    for (const auto& lamp : plan.lamps) {
        Light light = light_of(lamp);
        light.position = vec3(world * vec4(light.position, 1.0f));
        light.direction = glm::normalize(turn * light.direction);
        light.shadow_distance *= change.scale;
        light.intensity = permuted(light.intensity, change.channels) * change.light;
        // Lux stays; candela grows with the square of distance, or things further off would be darker.
        if (light.kind != Light::Kind::directional) light.intensity *= change.scale * change.scale;
        lights.push_back(light);
    }
    std::ranges::stable_sort(lights, {}, &Light::kind);
    for (const Light& light : lights) builder.add(light);

    const vec3 target(0, 0.5f, 0);
    const vec3 eye = target + plan.eye_distance * on_sphere(plan.eye_azimuth, plan.eye_elevation);
    builder.look(vec3(world * vec4(eye, 1.0f)), turn * (target - eye), turn * vec3(0, 1, 0), 0.9f);
    builder.scene().view->near = 0.05f * change.scale;
}

void showValue(const ScenePlan& plan, std::ostream& out) {
    constexpr std::array<const char*, 3> lamps{"directional", "spot", "point"};
    out << "floor of albedo " << text(plan.floor_albedo) << fmt::format("; eye at azimuth {:.4g}, elevation {:.4g}, {:.4g} m away\n", plan.eye_azimuth, plan.eye_elevation, plan.eye_distance);
    for (const auto& thing : plan.things) {
        out << "  " << shape_kind_names[static_cast<std::size_t>(thing.kind)] << " of size " << text(thing.size) << " at " << text(thing.place) << " turned by "
            << text(thing.turn) << ", albedo " << text(thing.albedo) << '\n';
    }
    for (const auto& lamp : plan.lamps) {
        out << "  " << lamps[static_cast<std::size_t>(lamp.kind)] << " light of " << text(lamp.intensity)
            << fmt::format(" from azimuth {:.4g}, elevation {:.4g}, height {:.4g} m, outer cone {:.4g}\n", lamp.azimuth, lamp.elevation, lamp.height, lamp.outer_cone);
    }
}

}  // namespace sl
