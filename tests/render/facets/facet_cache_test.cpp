// SPDX-License-Identifier: MIT
#include "engine/render/facets/facet_cache.h"

#include <glm/gtc/matrix_transform.hpp>

#include "engine/render/scene/frame_params.h"
#include "tests/support/scene_builder.h"

namespace sl {
namespace {

/// A street of walls along x under a sun.
void build_street(SceneBuilder& builder, int walls) {
    builder.add({Shape::Kind::box, vec3(static_cast<float>(10 * walls), 0.5f, 30)}, glm::translate(mat4(1.0f), vec3(5 * walls, -0.25f, 0)), vec3(0.5f));
    for (int i = 0; i < walls; ++i) {
        builder.add({Shape::Kind::box, vec3(0.5f, 3, 8)}, glm::translate(mat4(1.0f), vec3(10 * i, 1.5f, 4)), vec3(0.7f));
    }
    builder.add({.kind = RenderScene::Light::Kind::directional, .direction = glm::normalize(vec3(0.5f, -1, 0.3f)), .intensity = vec3(1e5f), .casts_shadow = true, .bounces = true});
}

FacetTable walk(FacetCache& cache, SceneBuilder& builder, float x, std::size_t memory) {
    builder.look(vec3(x, 1.7f, -2.0f), glm::normalize(vec3(0.6f, -0.3f, 1)), vec3(0, 1, 0), 1.2f);
    (void)cache.update(builder.scene(), frame_params(builder.scene(), 48, 27, 0), {.spacing = 12.0f, .noise = 1.0f}, {.memory = memory});
    return cache.table();
}

TEST(FacetCache, ForgetsWhatWasNotSeenForLong) {
    constexpr std::size_t little = std::size_t{1} << 18, much = std::size_t{1} << 30;
    SceneBuilder builder;
    build_street(builder, 58);
    FacetCache all, some;
    std::size_t most = 0, halfway = 0;
    for (int step = 0; step < 56; ++step) {
        (void)walk(some, builder, 10.0f * static_cast<float>(step), little);
        (void)walk(all, builder, 10.0f * static_cast<float>(step), much);
        most = std::max(most, some.memory());
        if (step == 28) halfway = most;
    }
    EXPECT_LT(most, all.memory() * 3 / 4);
    EXPECT_LT(most, halfway + halfway / 2) << "it does not grow with the way";
    // Where it began, light is found again: there is as much to see as ever.
    const FacetTable again = walk(some, builder, 0.0f, little);
    FacetCache fresh;
    const FacetTable first = walk(fresh, builder, 0.0f, much);
    EXPECT_GE(again.slots, first.slots);
    EXPECT_FLOAT_EQ(again.unit, walk(all, builder, 0.0f, much).unit);
}

TEST(FacetCache, ACameraThatStandsStillFindsWhatCameFarOff) {
    SceneBuilder builder;
    build_street(builder, 8);
    builder.look(vec3(0, 6, 0), vec3(1, 0, 0), vec3(0, 1, 0), 1.0f);
    FacetCache cache;
    const auto frames = [&](int count) {
        for (int i = 0; i < count; ++i) (void)cache.update(builder.scene(), frame_params(builder.scene(), 96, 54, 0), {.spacing = 2.0f, .noise = 1.0f}, {.seconds = 1.0});
    };
    // Its material is there from the start: another one would be another scene.
    builder.add({Shape::Kind::box, vec3(8)}, glm::translate(mat4(1.0f), vec3(44, 4, -8)), vec3(0.5f));
    std::vector<RenderScene::Draw>& draws = builder.scene().draws;
    const RenderScene::Draw box = draws.back();
    draws.pop_back();
    frames(30);
    draws.push_back(box);
    frames(40);
    const vec3 face(40, 4, -8);
    const auto nearest = cache.outlines_near(face, 1);
    ASSERT_EQ(nearest.size(), 1u);
    vec3 middle(0.0f);
    for (const vec3& corner : nearest.front().corners) middle += 0.25f * corner;
    EXPECT_LT(glm::length(middle - face), 2.0f);
}

}  // namespace
}  // namespace sl
