// SPDX-License-Identifier: MIT
#include "engine/render/trace/trace_scene.h"

#include <glm/gtc/matrix_transform.hpp>

#include "engine/render/trace/samples.h"
#include "tests/support/scene_builder.h"

namespace sl {
namespace {

/// Distances along rays all over a ball around the origin; -1 where nothing was met.
std::vector<float> distances(const TraceScene& scene) {
    std::vector<float> result;
    for (std::uint32_t i = 0; i < 512; ++i) {
        SampleSequence samples(1, uvec2(0), i);
        const auto on_sphere = [&] {
            const vec2 xi = samples.pair();
            const float height = 2.0f * xi.x - 1.0f, radius = std::sqrt(1.0f - height * height);
            return vec3(radius * std::cos(2.0f * pi * xi.y), height, radius * std::sin(2.0f * pi * xi.y));
        };
        const vec3 from = 8.0f * on_sphere();
        const auto hit = scene.intersect({.origin = from, .direction = glm::normalize(4.0f * on_sphere() - from)});
        result.push_back(hit ? hit->distance : -1.0f);
        if (hit) {
            EXPECT_NEAR(glm::length(scene.surface_at(*hit).position - from), hit->distance, 1e-4f);
        }
    }
    return result;
}

TEST(TraceScene, AnUpdatedSceneIsMetAsOneBuiltAnew) {
    SceneBuilder builder;
    for (const vec3 place : {vec3(0), vec3(3, 0, 0), vec3(0, 3, 0), vec3(0, 0, -3), vec3(-3, 0, 0)}) {
        builder.add({Shape::Kind::box, vec3(1.5f)}, glm::translate(mat4(1.0f), place), vec3(0.5f));
    }
    RenderScene& scene = builder.scene();
    const std::vector<RenderScene::Draw> all = scene.draws;
    TraceScene updated(scene);
    for (const std::uint32_t bits : {31, 30, 17, 0, 14, 31, 1}) {
        scene.draws.clear();
        for (std::uint32_t i = 0; i < all.size(); ++i) {
            if ((bits >> i & 1) != 0) scene.draws.push_back(all[i]);
        }
        updated.update(scene);
        const TraceScene anew(scene);
        EXPECT_EQ(distances(updated), distances(anew)) << "draws " << bits;
        EXPECT_EQ(updated.triangles(), anew.triangles());
        EXPECT_EQ(updated.bounds().low, anew.bounds().low);
    }
}

TEST(TraceScene, DrawsThatAreOnePointMeetNoRay) {
    SceneBuilder builder;
    for (int i = 0; i < 2; ++i) builder.add({Shape::Kind::box, vec3(1.0f)}, glm::scale(mat4(1.0f), vec3(0.0f)), vec3(0.5f));
    const TraceScene scene(builder.scene());
    EXPECT_FALSE(scene.intersect({.origin = vec3(0, 0, 5), .direction = vec3(0, 0, -1)}));
}

}  // namespace
}  // namespace sl
