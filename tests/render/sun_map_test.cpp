// SPDX-License-Identifier: MIT
#include "engine/render/scene/sun_map.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace sl {
namespace {

/// A field of cubes, larger than what the sun's map covers.
RenderScene field_of_cubes() {
    RenderScene scene;
    scene.view = RenderScene::View{};
    scene.lights.push_back({.direction = glm::normalize(vec3(0.3f, -1.0f, 0.2f)), .casts_shadow = true, .shadow_size = 256, .shadow_distance = 64.0f});
    for (int x = -20; x < 20; ++x) {
        for (int z = -20; z < 20; ++z) {
            RenderScene::Draw draw;
            draw.bounds = {vec3(8 * x, 0, 8 * z), vec3(8 * x + 8, 2, 8 * z + 8)};
            draw.content = hash_mix(static_cast<std::uint64_t>(x + 20), static_cast<std::uint64_t>(z + 20));
            scene.bounds.add(draw.bounds);
            scene.draws.push_back(draw);
        }
    }
    return scene;
}

std::vector<ShadowLayer> layers_of(const RenderScene& scene) {
    const RenderScene::Light& light = scene.lights.front();
    return sun_layers(scene, light, fit_sun_square(scene, light), SunSquare::most_tiles).layers;
}

std::size_t differing(const std::vector<ShadowLayer>& a, const std::vector<ShadowLayer>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += a[i].key != b[i].key;
    return count;
}

TEST(SunMap, AChangeIsDrawnWhereItIsAlone) {
    RenderScene scene = field_of_cubes();
    const auto before = layers_of(scene);
    scene.draws[20 * 40 + 20].content += 1;
    const std::size_t changed = differing(before, layers_of(scene));
    EXPECT_GE(changed, 1u);
    EXPECT_LE(changed, 4u);
}

TEST(SunMap, WhatIsEditedNearByIsDrawnAtOnceAndWhatCameByItselfMayWait) {
    RenderScene scene = field_of_cubes();
    EXPECT_TRUE(std::ranges::all_of(layers_of(scene), &ShadowLayer::may_wait));
    // The camera stands at the field's middle.
    scene.draws[20 * 40 + 20].changed = {vec3(1), vec3(2)};
    const auto urgent = static_cast<std::size_t>(std::ranges::count(layers_of(scene), false, &ShadowLayer::may_wait));
    const auto before = layers_of(scene);
    scene.draws[20 * 40 + 20].content += 1;
    EXPECT_EQ(urgent, differing(before, layers_of(scene)));
    EXPECT_GE(urgent, 1u);
    // Of an edit at the field's end nobody sees the shadow.
    scene = field_of_cubes();
    scene.draws.front().changed = {vec3(-160, 0, -160), vec3(-159, 1, -159)};
    EXPECT_TRUE(std::ranges::all_of(layers_of(scene), &ShadowLayer::may_wait));
}

TEST(SunMap, ASquareThatMovesByATileKeepsTheOthers) {
    RenderScene scene = field_of_cubes();
    const auto before = layers_of(scene);
    const mat4 light_from_world = fit_sun_square(scene, scene.lights.front()).light_from_world;
    // Along the light's own axis: 128 m in 8 tiles.
    scene.view->position = 16.0f * vec3(glm::transpose(mat3(light_from_world))[0]);
    EXPECT_EQ(differing(before, layers_of(scene)), 8u);
}

TEST(SunMap, AStepOfTheOriginChangesNothing) {
    RenderScene scene = field_of_cubes();
    scene.view->position = vec3(900.3f, 2.0f, -40.0f);
    const SunSquare square_before = fit_sun_square(scene, scene.lights.front());
    const auto before = layers_of(scene);
    const vec3 step(1024, 0, -1024), place(890, 1, -35);
    scene.origin += dvec3(step);
    scene.view->position -= step;
    scene.bounds = scene.bounds.moved(-step);
    for (RenderScene::Draw& draw : scene.draws) draw.bounds = draw.bounds.moved(-step);
    const auto after = layers_of(scene);
    EXPECT_EQ(differing(before, after), 0u);
    const SunSquare square = fit_sun_square(scene, scene.lights.front());
    EXPECT_EQ(square.lowest_tile, square_before.lowest_tile);
    // What was drawn is found where it is.
    for (std::size_t i = 0; i < after.size(); ++i) {
        const vec4 difference = after[i].clip_from_world * vec4(place - step, 1.0f) - before[i].clip_from_world * vec4(place, 1.0f);
        EXPECT_LT(glm::length(difference), 1e-3f) << "a quarter of a texel";
    }
}

TEST(SunMap, TheOrderOfDrawsIsNotSeen) {
    RenderScene scene = field_of_cubes();
    const auto before = layers_of(scene);
    std::swap(scene.draws.front(), scene.draws.back());
    EXPECT_EQ(differing(before, layers_of(scene)), 0u);
}

}  // namespace
}  // namespace sl
