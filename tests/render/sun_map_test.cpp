// SPDX-License-Identifier: MIT
#include "engine/render/scene/sun_map.h"

#include <gtest/gtest.h>

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

TEST(SunMap, ASquareThatMovesByATileKeepsTheOthers) {
    RenderScene scene = field_of_cubes();
    const auto before = layers_of(scene);
    const mat4 light_from_world = fit_sun_square(scene, scene.lights.front()).light_from_world;
    // Along the light's own axis: 128 m in 8 tiles.
    scene.view->position = 16.0f * vec3(glm::transpose(mat3(light_from_world))[0]);
    EXPECT_EQ(differing(before, layers_of(scene)), 8u);
}

TEST(SunMap, TheOrderOfDrawsIsNotSeen) {
    RenderScene scene = field_of_cubes();
    const auto before = layers_of(scene);
    std::swap(scene.draws.front(), scene.draws.back());
    EXPECT_EQ(differing(before, layers_of(scene)), 0u);
}

}  // namespace
}  // namespace sl
