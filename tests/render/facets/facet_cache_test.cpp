// SPDX-License-Identifier: MIT
#include "engine/render/facets/facet_cache.h"

#include <glm/gtc/matrix_transform.hpp>
#include <set>

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

/// The same scene with its origin elsewhere.
RenderScene with_origin_at(const RenderScene& scene, const dvec3& origin) {
    const vec3 offset(scene.origin - origin);
    RenderScene moved = scene;
    moved.origin = origin;
    moved.view->position += offset;
    moved.bounds = scene.bounds.moved(offset);
    for (RenderScene::Draw& draw : moved.draws) {
        draw.world_from_local[3] += vec4(offset, 0.0f);
        draw.bounds = draw.bounds.moved(offset);
    }
    for (RenderScene::Light& light : moved.lights) {
        if (light.kind != RenderScene::Light::Kind::directional) light.position += offset;
    }
    return moved;
}

TEST(FacetCache, KeepsItsLightWhenTheOriginStepsOn) {
    SceneBuilder builder;
    build_street(builder, 8);
    builder.add({.kind = RenderScene::Light::Kind::point, .position = vec3(13.3f, 2.1f, 1.7f), .intensity = vec3(3e4f), .casts_shadow = true});
    builder.look(vec3(4, 1.7f, -2), glm::normalize(vec3(0.6f, -0.3f, 1)), vec3(0, 1, 0), 1.2f);
    const Facets settings{.spacing = 6.0f, .noise = 0.5f};
    FacetCache cache;
    (void)cache.update(builder.scene(), frame_params(builder.scene(), 96, 54, 0), settings, {});
    constexpr std::size_t all = std::numeric_limits<std::uint32_t>::max();
    const auto before = cache.outlines_near(vec3(0.0f), all);
    ASSERT_GT(before.size(), 50u);
    for (const dvec3& origin : {dvec3(1024, 0, 0), dvec3(2048, -1024, 1024), dvec3(0.0)}) {
        const RenderScene moved = with_origin_at(builder.scene(), origin);
        const FrameParams frame = frame_params(moved, 96, 54, 0);
        const std::uint64_t version = cache.version();
        EXPECT_EQ(cache.update(moved, frame, settings, {.seconds = 1e-9}), 1.0f) << "nothing is to be gathered";
        EXPECT_GT(cache.version(), version);
        const std::size_t slots = cache.table().slots;
        (void)cache.update(moved, frame, settings, {});
        EXPECT_EQ(cache.table().slots, slots) << "all that is seen was there";
        const auto after = cache.outlines_near(vec3(0.0f), all);
        ASSERT_EQ(after.size(), before.size());
        for (const FacetOutline& facet : before) {
            EXPECT_TRUE(std::ranges::any_of(after, [&](const FacetOutline& same) {
                return glm::length(same.irradiance - facet.irradiance) < 1e-3f * glm::length(facet.irradiance) && glm::length(same.corners[0] + vec3(origin) - facet.corners[0]) < 1e-3f &&
                       glm::length(same.corners[2] + vec3(origin) - facet.corners[2]) < 1e-3f;
            }));
        }
    }
}

/// Two walls, looked at until all light is known.
void light_two_walls(FacetCache& cache, SceneBuilder& builder, const Facets& settings) {
    build_street(builder, 2);
    builder.look(vec3(4, 1.7f, -2), glm::normalize(vec3(0.6f, -0.3f, 1)), vec3(0, 1, 0), 1.2f);
    (void)cache.update(builder.scene(), frame_params(builder.scene(), 96, 54, 0), settings, {});
    ASSERT_GT(cache.outlines_near(vec3(0.0f), 1000).size(), 50u);
}

TEST(FacetCache, KeepsItsLightWhenMuchComesFarOff) {
    SceneBuilder builder;
    FacetCache cache;
    const Facets settings{.spacing = 6.0f, .noise = 0.5f};
    light_two_walls(cache, builder, settings);
    const std::size_t before = cache.outlines_near(vec3(0.0f), 1000).size();
    // As much ground again as there was; materials stay, as those of a world's land do.
    const std::uint64_t materials = builder.scene().materials_hash;
    builder.add({Shape::Kind::box, vec3(20, 0.5f, 30)}, glm::translate(mat4(1.0f), vec3(60, -0.25f, 0)), vec3(0.5f));
    builder.scene().materials_hash = materials;
    // Without time nothing is gathered anew: what is there was kept.
    (void)cache.update(builder.scene(), frame_params(builder.scene(), 96, 54, 0), settings, {.seconds = 1e-9});
    EXPECT_EQ(cache.outlines_near(vec3(0.0f), 1000).size(), before);
}

std::set<FacetName> names_of(const FacetTable& table) {
    std::set<FacetName> names;
    for (std::uint32_t slot = 0; slot < table.slots; ++slot) names.insert(FacetName{table.words[2 * slot]} << 32 | table.words[2 * slot + 1]);
    return names;
}

TEST(FacetCache, LooksThatAreCutShortMeetTheRestLater) {
    SceneBuilder builder;
    build_street(builder, 2);
    // In the dark no facet is split.
    builder.scene().lights.clear();
    builder.look(vec3(4, 1.7f, -2), glm::normalize(vec3(0.6f, -0.3f, 1)), vec3(0, 1, 0), 1.2f);
    const FrameParams frame = frame_params(builder.scene(), 96, 54, 0);
    const Facets settings{.spacing = 6.0f, .noise = 1.0f};
    FacetCache cut, whole;
    for (int i = 0; i < 500; ++i) (void)whole.update(builder.scene(), frame, settings, {.seconds = 1e-3});
    const std::set<FacetName> all = names_of(whole.table());
    ASSERT_GT(all.size(), 200u);
    (void)cut.update(builder.scene(), frame, settings, {.seconds = 1e-3, .longest_look = 1e-9});
    EXPECT_LT(names_of(cut.table()).size(), 10u);
    // Each look meets one place at least.
    for (int i = 0; i < 4000; ++i) (void)cut.update(builder.scene(), frame, settings, {.seconds = 1e-3, .longest_look = 1e-9});
    // Which larger facets stand in for others, and which are cut and have finer ones, depends on the order in which they are met.
    const std::set<FacetName> met = names_of(cut.table());
    const auto missed = std::ranges::count_if(all, [&](FacetName name) { return !met.contains(name); });
    EXPECT_LT(static_cast<double>(missed), 0.05 * static_cast<double>(all.size()));
}

TEST(FacetCache, LightThatTurnsWhileLandComesIsFollowedInTheNextFrame) {
    SceneBuilder builder;
    FacetCache cache;
    const Facets settings{.spacing = 6.0f, .noise = 0.5f};
    light_two_walls(cache, builder, settings);
    const std::uint64_t materials = builder.scene().materials_hash;
    builder.add({Shape::Kind::box, vec3(5, 0.5f, 5)}, glm::translate(mat4(1.0f), vec3(20, -0.25f, 0)), vec3(0.5f));
    builder.scene().materials_hash = materials;
    builder.scene().lights.front().intensity = vec3(0.0f);
    const FrameParams frame = frame_params(builder.scene(), 96, 54, 0);
    (void)cache.update(builder.scene(), frame, settings, {.seconds = 1e-9});
    (void)cache.update(builder.scene(), frame, settings, {});
    for (const FacetOutline& facet : cache.outlines_near(vec3(0.0f), 1000)) EXPECT_EQ(facet.irradiance, vec3(0.0f));
}

TEST(FacetCache, AfterAStepOfTheOriginAnEditIsFollowedAsBefore) {
    SceneBuilder stays, steps;
    FacetCache cache, stepped;
    const Facets settings{.spacing = 6.0f, .noise = 0.2f};
    for (SceneBuilder* builder : {&stays, &steps}) {
        build_street(*builder, 4);
        builder->look(vec3(4, 1.7f, -2), glm::normalize(vec3(0.6f, -0.3f, 1)), vec3(0, 1, 0), 1.2f);
    }
    const dvec3 origin(0, 0, -1024);
    const auto update = [&](FacetCache& of, const RenderScene& scene) { (void)of.update(scene, frame_params(scene, 96, 54, 0), settings, {}); };
    update(cache, stays.scene());
    update(stepped, steps.scene());
    update(stepped, with_origin_at(steps.scene(), origin));
    stays.scene().draws.erase(stays.scene().draws.begin() + 2);
    steps.scene().draws.erase(steps.scene().draws.begin() + 2);
    update(cache, stays.scene());
    update(stepped, with_origin_at(steps.scene(), origin));
    double difference = 0.0, sum = 0.0;
    for (const vec3 place : {vec3(6, 0, 1), vec3(10, 0, 4), vec3(14, 0, 2), vec3(20, 2, 3)}) {
        const auto a = cache.outlines_near(place, 1), b = stepped.outlines_near(place - vec3(origin), 1);
        ASSERT_EQ(a.size() + b.size(), 2u);
        difference += glm::length(a.front().irradiance - b.front().irradiance);
        sum += glm::length(a.front().irradiance);
    }
    EXPECT_LT(difference, 0.1 * sum);
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
