// SPDX-License-Identifier: MIT
#include "engine/core/model/model_pose.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace sl {
namespace {

/// A chain of two nodes, the second one metre above the first.
Model chain() {
    Model model;
    model.nodes = {ModelNode{}, ModelNode{.parent = 0, .translation = dvec3(0, 1, 0)}};
    model.scenes.push_back({.name = "", .roots = {0}});
    return model;
}

ModelAnimation moving(ModelChannel channel) { return {.name = "", .channels = {channel}, .length = channel.times.back()}; }

TEST(ModelPose, StepsLinesAndSplinesGoThroughTheirKeys) {
    const Model model = chain();
    const auto x_at = [&](ModelChannel::Between between, std::vector<float> values, double time) {
        return pose_at(model, moving({.node = 1, .path = ModelChannel::Path::translation, .between = between, .times = {0, 2}, .values = std::move(values), .width = 3}), time).nodes[1].translation.x;
    };
    const std::vector<float> keys{0, 0, 0, 4, 0, 0}, slopes{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 4, 0, 0, 0, 0, 0};
    EXPECT_EQ(x_at(ModelChannel::Between::step, keys, 1.5), 0.0);
    EXPECT_EQ(x_at(ModelChannel::Between::linear, keys, 1.5), 3.0);
    EXPECT_NEAR(x_at(ModelChannel::Between::cubic, slopes, 1.0), 2.0, 1e-6);
    EXPECT_NEAR(x_at(ModelChannel::Between::cubic, slopes, 0.5), 4.0 * 0.15625, 1e-6);
    EXPECT_EQ(x_at(ModelChannel::Between::linear, keys, 3.0), 2.0) << "it begins anew";
}

TEST(ModelPose, RotationsTurnAtAnEvenSpeed) {
    const Model model = chain();
    const auto animation = moving({.node = 0, .path = ModelChannel::Path::rotation, .between = ModelChannel::Between::linear, .times = {0, 1}, .values = {0, 0, 0, 1, 0, 0, 0.70710678f, 0.70710678f}, .width = 4});
    const quat third = pose_at(model, animation, 1.0 / 3.0).nodes[0].rotation;
    EXPECT_NEAR(2.0f * std::atan2(third.z, third.w), glm::radians(30.0f), 1e-4f);
}

TEST(ModelPose, JointsMoveVerticesAndNormals) {
    Model model = chain();
    model.skins.push_back({.joints = {0, 1}, .joint_from_mesh = {mat4(1.0f), mat4(1.0f)}});
    model.skins[0].joint_from_mesh[1][3] = vec4(0, -1, 0, 1);
    ModelPrimitive primitive;
    primitive.mesh.vertices = {Vertex{.position = vec3(0, 2, 0), .normal = pack_normal(vec3(0, 1, 0))}};
    primitive.joints = {{.joints = {1, 0, 0, 0}, .weights = vec4(1, 0, 0, 0)}};
    ModelPose pose = rest_of(model);
    MeshData mesh;
    deform(primitive, primitive.mesh, {}, joint_matrices(model.skins[0], places_of(model, pose)), mesh);
    EXPECT_LT(glm::length(mesh.vertices[0].position - vec3(0, 2, 0)), 1e-6f) << "at rest nothing moves";
    // The second joint turns by a quarter round z.
    pose.nodes[1].rotation = glm::angleAxis(glm::pi<float>() / 2.0f, vec3(0, 0, 1));
    deform(primitive, primitive.mesh, {}, joint_matrices(model.skins[0], places_of(model, pose)), mesh);
    EXPECT_LT(glm::length(mesh.vertices[0].position - vec3(-1, 1, 0)), 1e-5f);
    EXPECT_LT(glm::length(unpack_normal(mesh.vertices[0].normal) - vec3(-1, 0, 0)), 1e-3f);
}

TEST(ModelPose, TangentsMoveWithTheSurface) {
    Model model = chain();
    model.skins.push_back({.joints = {0}, .joint_from_mesh = {mat4(1.0f)}});
    ModelPrimitive primitive;
    primitive.mesh.vertices = {Vertex{.position = vec3(0), .normal = pack_normal(vec3(0, 0, 1))}};
    primitive.mesh.pictured = {PicturedVertex{.tangent = pack_normal(vec3(1, 0, 0)), .hand = -1.0f}};
    primitive.joints = {{.joints = {0, 0, 0, 0}, .weights = vec4(1, 0, 0, 0)}};
    primitive.morphs = {{.positions = {}, .normals = {}, .tangents = {vec3(-1, 1, 0)}}};
    ModelPose pose = rest_of(model);
    MeshData mesh;
    deform(primitive, primitive.mesh, {1.0f}, {}, mesh);
    EXPECT_LT(glm::length(unpack_normal(mesh.pictured.at(0).tangent) - vec3(0, 1, 0)), 1e-3f) << "morphed";
    // Sheared, the normal leans one way and the tangent the other: they stay at a right angle.
    pose.nodes[0].rotation = glm::angleAxis(glm::pi<float>() / 4.0f, vec3(0, 1, 0));
    auto joints = joint_matrices(model.skins[0], places_of(model, pose));
    joints[0] = glm::scale(mat4(1.0f), vec3(2, 1, 1)) * joints[0];
    deform(primitive, primitive.mesh, {}, joints, mesh);
    const vec3 tangent = unpack_normal(mesh.pictured[0].tangent);
    EXPECT_LT(glm::length(tangent - glm::normalize(vec3(2, 0, -1))), 1e-3f);
    EXPECT_NEAR(glm::dot(tangent, unpack_normal(mesh.vertices[0].normal)), 0.0f, 1e-3f);
    EXPECT_EQ(mesh.pictured[0].hand, -1.0f);
}

TEST(ModelPose, MorphsAddUp) {
    ModelPrimitive primitive;
    primitive.mesh.vertices = {Vertex{.position = vec3(1, 0, 0), .normal = pack_normal(vec3(0, 1, 0))}};
    primitive.morphs = {{.positions = {vec3(0, 2, 0)}, .normals = {}}, {.positions = {vec3(0, 0, 4)}, .normals = {}}};
    MeshData mesh;
    deform(primitive, primitive.mesh, {0.5f, 0.25f}, {}, mesh);
    EXPECT_EQ(mesh.vertices[0].position, vec3(1, 1, 1));
    EXPECT_EQ(mesh.bounds.low, vec3(1, 1, 1));
}

}  // namespace
}  // namespace sl
