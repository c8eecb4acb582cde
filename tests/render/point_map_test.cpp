// SPDX-License-Identifier: MIT
#include "engine/render/scene/point_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "engine/render/scene/frame_params.h"
#include "shared/lights.h"

namespace sl {
namespace {

using Light = RenderScene::Light;

constexpr float range = 10.0f;

class PointMapTest : public testing::Test {
  protected:
    PointMapTest() {
        scene.view = RenderScene::View{};
        scene.lights.push_back({.kind = Light::Kind::point, .position = vec3(1, 2, 3), .intensity = vec3(100), .range = range, .casts_shadow = true, .shadow_size = 64});
        // A cube 4 m off in each direction, then one out of range; and the ground under them, so that the scene's size stays.
        for (int axis = 0; axis < 3; ++axis) {
            for (const float side : {4.0f, -4.0f}) {
                vec3 place = scene.lights[0].position;
                place[axis] += side;
                add(place, 0.5f);
            }
        }
        add(vec3(1, 2, 30), 0.5f);
        add(vec3(0, -100, 0), 90.0f);
    }
    void add(vec3 middle, float half) {
        RenderScene::Draw draw;
        draw.bounds = {middle - half, middle + half};
        draw.content = scene.draws.size() + 1;
        scene.bounds.add(draw.bounds);
        scene.draws.push_back(draw);
    }
    void look(vec3 from, vec3 forward) {
        scene.view->position = from;
        scene.view->forward = glm::normalize(forward);
    }
    std::vector<ShadowLayer> faces() const { return point_faces(scene, scene.lights[0], frame_params(scene, 90, 90, 0)); }
    std::vector<std::uint64_t> keys() const {
        std::vector<std::uint64_t> result;
        for (const ShadowLayer& face : faces()) result.push_back(face.key);
        return result;
    }
    /// Faces, by their numbers, whose keys are not those any more.
    std::vector<std::uint32_t> changed(const std::vector<std::uint64_t>& before) const {
        std::vector<std::uint32_t> result;
        const auto now = keys();
        for (std::uint32_t face = 0; face < now.size(); ++face) {
            if (now[face] != before[face]) result.push_back(face);
        }
        return result;
    }

    RenderScene scene;
};

using Numbers = std::vector<std::uint32_t>;

TEST_F(PointMapTest, AFaceIsDrawnAsTheShaderReadsIt) {
    const auto layers = faces();
    const float tangent = point_face_tangent(scene.lights[0]), near = point_near_plane(scene, scene.lights[0]);
    std::mt19937 random(1);
    std::uniform_real_distribution<float> any(-5.0f, 5.0f);
    for (int i = 0; i < 1000; ++i) {
        const vec3 from_light(any(random), any(random), any(random));
        const std::uint32_t face = point_face(from_light);
        const vec3 read = in_point_face(from_light, face);
        ASSERT_EQ(read.z, std::max({std::abs(from_light.x), std::abs(from_light.y), std::abs(from_light.z)}));
        const vec4 clip = layers[face].clip_from_world * vec4(scene.lights[0].position + from_light, 1.0f);
        ASSERT_NEAR(clip.x / clip.w, read.x / (read.z * tangent), 1e-4f) << "face " << face;
        ASSERT_NEAR(clip.y / clip.w, read.y / (read.z * tangent), 1e-4f) << "face " << face;
        ASSERT_NEAR(clip.z / clip.w / (near / read.z), 1.0f, 1e-4f) << "face " << face;
    }
}

TEST_F(PointMapTest, EachFaceHoldsWhatLiesThereWithinRange) {
    look(vec3(1, 2, 3), vec3(0, 0, -1));
    scene.view->fov_y = 3.0f;  // six pictures' worth
    const auto layers = faces();
    // Behind the camera lies face 4.
    for (std::uint32_t face : {0u, 1u, 2u, 3u, 5u}) {
        EXPECT_EQ(layers[face].draws, Numbers{face});
    }
    look(vec3(1, 2, 3), vec3(0, 0, 1));
    EXPECT_EQ(faces()[4].draws, Numbers{4});
    scene.lights[0].range = 0.0f;
    EXPECT_EQ(faces()[4].draws, (Numbers{4, 6, 7}));
}

TEST_F(PointMapTest, OnlyWhatTheFaceShowsChangesItsKey) {
    look(vec3(1, 2, 3 + 60), vec3(0, 0, -1));
    const auto before = keys();
    EXPECT_TRUE(std::ranges::none_of(before, [](std::uint64_t key) { return key == 0; })) << "from afar all faces are seen";
    scene.lights[0].intensity *= 2.0f;
    scene.draws[6].content += 1;
    EXPECT_EQ(changed(before), Numbers{}) << "how bright it is, and what lies out of range, is not seen";
    std::ranges::swap(scene.draws[0], scene.draws[1]);
    EXPECT_EQ(changed(before), Numbers{}) << "nor in which order things stand";
    scene.draws[3].content += 1;
    EXPECT_EQ(changed(before), Numbers{3});
    scene.draws[3].content -= 1;
    add(vec3(3, 4, 3), 0.1f);
    EXPECT_EQ(changed(before), (Numbers{0, 2})) << "across their common edge";
    scene.draws.pop_back();
    scene.lights[0].position.x += 0.01f;
    EXPECT_EQ(changed(before), (Numbers{0, 1, 2, 3, 4, 5}));
}

TEST_F(PointMapTest, ASceneThatGrowsOutOfRangeChangesNothing) {
    look(vec3(1, 2, 63), vec3(0, 0, -1));
    const auto before = keys();
    add(vec3(500, 0, 0), 10.0f);
    EXPECT_EQ(changed(before), Numbers{});
}

TEST_F(PointMapTest, FacesOutOfViewAreLeftOut) {
    const auto in_view = [&] {
        Numbers result;
        const auto layers = faces();
        for (std::uint32_t face = 0; face < layers.size(); ++face) {
            if (layers[face].in_view) result.push_back(face);
            EXPECT_TRUE(layers[face].in_view || (layers[face].draws.empty() && layers[face].key == 0));
        }
        return result;
    };
    look(vec3(1, 2, 3), vec3(1, 0, 0));
    EXPECT_EQ(in_view(), Numbers{0}) << "57 degrees of a right angle";
    look(vec3(1, 2, 3), vec3(0, 0, -1));
    EXPECT_EQ(in_view(), Numbers{5});
    look(vec3(1, 2, 20), vec3(0, 0, 1));
    EXPECT_EQ(in_view(), Numbers{}) << "the light is behind";
    look(vec3(1, 2, 5), vec3(0, 0, 1));
    EXPECT_EQ(in_view(), Numbers{4}) << "and here its range reaches before the camera";
    scene.lights[0].range = 0.0f;
    look(vec3(1, 2, 20), vec3(0, 0, 1));
    EXPECT_EQ(in_view(), Numbers{4});
}

TEST_F(PointMapTest, NoFaceThatAPictureLooksIntoIsLeftOut) {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> any(-1.0f, 1.0f);
    int left_out = 0;
    for (int i = 0; i < 300; ++i) {
        scene.lights[0].range = i % 3 == 0 ? 0.0f : 8.0f + 7.0f * any(random);
        scene.view->fov_y = 1.0f + 0.8f * any(random);
        look(20.0f * vec3(any(random), any(random), any(random)), vec3(any(random), any(random), any(random)));
        const FrameParams frame = frame_params(scene, 90, 90, 0);
        const auto layers = faces();
        left_out += static_cast<int>(std::ranges::count(layers, false, &ShadowLayer::in_view));
        for (int pixel = 0; pixel < 200; ++pixel) {
            const vec3 place = vec3(frame.camera_position) + view_ray(frame, vec2(any(random), any(random))) * (20.0f + 20.0f * any(random));
            const vec3 from_light = place - scene.lights[0].position;
            if (scene.lights[0].range > 0.0f && glm::length(from_light) > scene.lights[0].range) continue;
            ASSERT_TRUE(layers[point_face(from_light)].in_view) << "view " << i;
        }
    }
    EXPECT_GT(left_out, 300) << "more than one of six, on average";
}

}  // namespace
}  // namespace sl
