// SPDX-License-Identifier: MIT
#include "engine/core/model/model_pose.h"

#include <algorithm>
#include <cmath>

namespace sl {

namespace {

/// Between which two keys a time lies, and how far: 0 at the first.
struct Moment {
    std::size_t before = 0, after = 0;
    float part = 0.0f, length = 0.0f;  ///< `length` s
};

Moment moment_of(const std::vector<float>& times, float time) {
    const auto after = std::ranges::upper_bound(times, time);
    if (after == times.begin()) return {};
    if (after == times.end()) return {times.size() - 1, times.size() - 1, 0.0f, 0.0f};
    const auto next = static_cast<std::size_t>(after - times.begin());
    const float length = times[next] - times[next - 1];
    return {next - 1, next, length > 0.0f ? (time - times[next - 1]) / length : 0.0f, length};
}

/// The numbers of a channel at a time.
class ChannelValue {
  public:
    ChannelValue(const ModelChannel& channel, float time) : channel_(channel), moment_(moment_of(channel.times, time)) {}

    float number(std::size_t k) const {
        const float a = key(moment_.before, k), b = key(moment_.after, k), t = moment_.part;
        switch (channel_.between) {
            case ModelChannel::Between::step: return a;
            case ModelChannel::Between::linear: return a + (b - a) * t;
            default: {
                const float out = slope(moment_.before, 2, k), in = slope(moment_.after, 0, k), t2 = t * t, t3 = t2 * t;
                return (2 * t3 - 3 * t2 + 1) * a + moment_.length * (t3 - 2 * t2 + t) * out + (3 * t2 - 2 * t3) * b + moment_.length * (t3 - t2) * in;
            }
        }
    }
    vec3 vector() const { return {number(0), number(1), number(2)}; }
    quat rotation() const {
        const auto at = [&](std::size_t moment) { return quat(key(moment, 3), key(moment, 0), key(moment, 1), key(moment, 2)); };
        const quat turned = channel_.between == ModelChannel::Between::linear ? glm::slerp(at(moment_.before), at(moment_.after), moment_.part) : quat(number(3), number(0), number(1), number(2));
        const float length = glm::length(turned);
        return length > 0.0f ? turned / length : quat(1, 0, 0, 0);
    }

  private:
    bool cubic() const { return channel_.between == ModelChannel::Between::cubic; }
    float key(std::size_t moment, std::size_t k) const { return channel_.values[(cubic() ? 3 * moment + 1 : moment) * channel_.width + k]; }
    /// Of a cubic key: 0: coming in, 2: going out.
    float slope(std::size_t moment, std::size_t which, std::size_t k) const { return channel_.values[(3 * moment + which) * channel_.width + k]; }

    const ModelChannel& channel_;
    Moment moment_;
};

mat4 matrix_of(const ModelPose::Node& node) {
    mat4 matrix = glm::mat4_cast(node.rotation);
    for (int axis = 0; axis < 3; ++axis) matrix[axis] *= node.scale[axis];
    matrix[3] = vec4(vec3(node.translation), 1.0f);
    return matrix;
}

vec3 unit_or(vec3 v, vec3 otherwise) {
    const float length = glm::length(v);
    return length > 0.0f && std::isfinite(length) ? v / length : otherwise;
}

}  // namespace

ModelPose rest_of(const Model& model) {
    ModelPose pose;
    for (const ModelNode& node : model.nodes) {
        pose.nodes.push_back({node.translation, node.rotation, node.scale});
        pose.weights.push_back(!node.weights.empty() || node.mesh < 0 ? node.weights : model.meshes[static_cast<std::size_t>(node.mesh)].weights);
    }
    return pose;
}

ModelPose pose_at(const Model& model, const ModelAnimation& animation, double seconds) {
    ModelPose pose = rest_of(model);
    const float time = animation.length > 0.0f ? static_cast<float>(std::fmod(std::max(seconds, 0.0), double{animation.length})) : 0.0f;
    for (const ModelChannel& channel : animation.channels) {
        const auto number = static_cast<std::size_t>(channel.node);
        const ChannelValue value(channel, time);
        switch (channel.path) {
            case ModelChannel::Path::translation: pose.nodes[number].translation = dvec3(value.vector()); break;
            case ModelChannel::Path::rotation: pose.nodes[number].rotation = value.rotation(); break;
            case ModelChannel::Path::scale: pose.nodes[number].scale = value.vector(); break;
            case ModelChannel::Path::weights:
                pose.weights[number].resize(channel.width);
                for (std::size_t k = 0; k < channel.width; ++k) pose.weights[number][k] = value.number(k);
                break;
        }
    }
    return pose;
}

bool deforms(const ModelPrimitive& primitive) { return !primitive.joints.empty() || !primitive.morphs.empty(); }

std::vector<mat4> places_of(const Model& model, const ModelPose& pose) {
    std::vector<mat4> places(model.nodes.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::int32_t parent = model.nodes[i].parent;
        places[i] = parent >= 0 ? places[static_cast<std::size_t>(parent)] * matrix_of(pose.nodes[i]) : matrix_of(pose.nodes[i]);
    }
    return places;
}

std::vector<mat4> joint_matrices(const ModelSkin& skin, const std::vector<mat4>& places) {
    std::vector<mat4> matrices;
    for (std::size_t i = 0; i < skin.joints.size(); ++i) matrices.push_back(places[static_cast<std::size_t>(skin.joints[i])] * skin.joint_from_mesh[i]);
    return matrices;
}

void deform(const ModelPrimitive& primitive, const MeshData& rest, const std::vector<float>& weights, const std::vector<mat4>& joints, MeshData& mesh) {
    mesh.vertices = rest.vertices;
    mesh.pictured = rest.pictured;
    mesh.bounds = {};
    const bool skinned = !joints.empty() && !primitive.joints.empty();
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        vec3 position = rest.vertices[i].position, normal = unpack_normal(rest.vertices[i].normal);
        const vec3 tangent_at_rest = rest.pictured.empty() ? vec3(1, 0, 0) : unpack_normal(rest.pictured[i].tangent);
        vec3 tangent = tangent_at_rest;
        for (std::size_t k = 0; k < std::min(weights.size(), primitive.morphs.size()); ++k) {
            const ModelMorph& morph = primitive.morphs[k];
            if (!morph.positions.empty()) position += weights[k] * morph.positions[i];
            if (!morph.normals.empty()) normal += weights[k] * morph.normals[i];
            if (!morph.tangents.empty()) tangent += weights[k] * morph.tangents[i];
        }
        if (skinned) {
            mat4 blended(0.0f);
            for (std::size_t k = 0; k < 4; ++k) {
                const std::size_t joint = std::min<std::size_t>(primitive.joints[i].joints[k], joints.size() - 1);
                blended += primitive.joints[i].weights[static_cast<int>(k)] * joints[joint];
            }
            position = vec3(blended * vec4(position, 1.0f));
            tangent = mat3(blended) * tangent;
            const vec3 x(blended[0]), y(blended[1]), z(blended[2]);
            normal = normal.x * glm::cross(y, z) + normal.y * glm::cross(z, x) + normal.z * glm::cross(x, y);
        }
        // Numbers of a file may be such that their sums and products are none.
        for (int axis = 0; axis < 3; ++axis) position[axis] = std::isfinite(position[axis]) ? position[axis] : rest.vertices[i].position[axis];
        mesh.vertices[i].position = position;
        mesh.vertices[i].normal = pack_normal(unit_or(normal, vec3(0, 1, 0)));
        if (!mesh.pictured.empty()) mesh.pictured[i].tangent = pack_normal(unit_or(tangent, tangent_at_rest));
        mesh.bounds.add(position);
    }
}

}  // namespace sl
