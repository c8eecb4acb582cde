// SPDX-License-Identifier: MIT
#include "engine/core/model/gltf_nodes.h"

#include <algorithm>
#include <cmath>

#include "engine/core/error.h"
#include "engine/core/model/gltf_accessor.h"
#include "engine/core/model/gltf_values.h"

namespace sl {

namespace {

using Index = std::int32_t;

Index in_range(int index, std::size_t size) { return index >= 0 && static_cast<std::size_t>(index) < size ? index : -1; }

/// As a float, which may have no room for it.
float finite(double value, float otherwise) {
    const auto number = static_cast<float>(value);
    return std::isfinite(number) ? number : otherwise;
}

/// The numbers of nodes of the file, parents first.
class NodeOrder {
  public:
    explicit NodeOrder(const tinygltf::Model& file) : file_(file), parent_(file.nodes.size(), -1), place_(file.nodes.size(), -1) {
        for (std::size_t i = 0; i < file.nodes.size(); ++i) {
            for (const int child : file.nodes[i].children) {
                if (in_range(child, file.nodes.size()) < 0) fail("/nodes/{}/children: there is no node {}", i, child);
                if (parent_[static_cast<std::size_t>(child)] >= 0) fail("/nodes/{}: it is a child of node {} already", i, parent_[static_cast<std::size_t>(child)]);
                parent_[static_cast<std::size_t>(child)] = static_cast<Index>(i);
            }
        }
        for (std::size_t i = 0; i < file.nodes.size(); ++i) {
            if (parent_[i] < 0) add_with_children(static_cast<Index>(i));
        }
        for (std::size_t i = 0; i < file.nodes.size(); ++i) {
            if (place_[i] < 0) fail("/nodes/{}: it stands above itself", i);
        }
    }
    const std::vector<Index>& order() const { return order_; }
    Index parent(Index node) const { return parent_[static_cast<std::size_t>(node)]; }
    /// Where a node of the file stands in the order; -1 for what is none.
    Index place(int node) const { return in_range(node, place_.size()) < 0 ? -1 : place_[static_cast<std::size_t>(node)]; }

  private:
    void add_with_children(Index root) {
        // A list, and no recursion: chains may be as long as a file.
        for (std::vector<Index> waiting{root}; !waiting.empty();) {
            const Index node = waiting.back();
            waiting.pop_back();
            place_[static_cast<std::size_t>(node)] = static_cast<Index>(order_.size());
            order_.push_back(node);
            const auto& children = file_.nodes[static_cast<std::size_t>(node)].children;
            waiting.insert(waiting.end(), children.rbegin(), children.rend());
        }
    }

    const tinygltf::Model& file_;
    std::vector<Index> parent_, place_, order_;
};

template <class Vector>
void take(const std::vector<double>& values, std::size_t count, Vector& into) {
    if (values.size() != count) return;
    for (std::size_t i = 0; i < count; ++i) {
        if (std::isfinite(static_cast<float>(values[i]))) into[static_cast<int>(i)] = static_cast<typename Vector::value_type>(values[i]);
    }
}

quat unit(const quat& rotation) {
    const float length = glm::length(rotation);
    return length > 0.0f && std::isfinite(length) ? rotation / length : quat(1, 0, 0, 0);
}

/// Translation, rotation and scale of a matrix that is made of them; of any other, what comes near.
void decompose(const std::vector<double>& values, ModelNode& node) {
    mat4 matrix(1.0f);
    for (std::size_t i = 0; i < 16; ++i) matrix[static_cast<int>(i / 4)][static_cast<int>(i % 4)] = finite(values[i], i % 5 == 0 ? 1.0f : 0.0f);
    node.translation = dvec3(matrix[3]);
    mat3 turn(matrix);
    for (int axis = 0; axis < 3; ++axis) {
        node.scale[axis] = glm::length(turn[axis]);
        turn[axis] = node.scale[axis] > 0.0f ? turn[axis] / node.scale[axis] : vec3(axis == 0, axis == 1, axis == 2);
    }
    if (glm::determinant(turn) < 0.0f) {
        node.scale.x = -node.scale.x;
        turn[0] = -turn[0];
    }
    node.rotation = unit(glm::quat_cast(turn));
}

ModelNode node_of(const tinygltf::Model& file, const tinygltf::Node& from) {
    ModelNode node;
    node.name = from.name;
    if (from.matrix.size() == 16) {
        decompose(from.matrix, node);
    } else {
        take(from.translation, 3, node.translation);
        take(from.scale, 3, node.scale);
        if (from.rotation.size() == 4) {
            vec4 rotation(0, 0, 0, 1);
            take(from.rotation, 4, rotation);
            node.rotation = unit(quat(rotation.w, rotation.x, rotation.y, rotation.z));
        }
    }
    node.mesh = in_range(from.mesh, file.meshes.size());
    node.skin = in_range(from.skin, file.skins.size());
    node.camera = in_range(from.camera, file.cameras.size());
    const tinygltf::Value* light = gltf_member(from.extensions, "KHR_lights_punctual", "light");
    if (light != nullptr && light->IsInt()) node.light = in_range(light->GetNumberAsInt(), file.lights.size());
    for (const double weight : from.weights) node.weights.push_back(finite(weight, 0.0f));
    return node;
}

ModelLight light_of(const tinygltf::Light& from) {
    ModelLight light;
    light.name = from.name;
    light.kind = from.type == "directional" ? ModelLight::Kind::directional : from.type == "spot" ? ModelLight::Kind::spot : ModelLight::Kind::point;
    take(from.color, 3, light.colour);
    light.colour = glm::clamp(light.colour, 0.0f, 1.0f);
    light.intensity = std::max(finite(from.intensity, 1.0f), 0.0f);
    light.range = std::max(finite(from.range, 0.0f), 0.0f);
    light.outer_cone = std::clamp(finite(from.spot.outerConeAngle, 0.7854f), 0.001f, 1.5533f);
    light.inner_cone = std::clamp(finite(from.spot.innerConeAngle, 0.0f), 0.0f, light.outer_cone);
    return light;
}

ModelCamera camera_of(const tinygltf::Camera& from, const std::string& where, std::vector<std::string>& warnings) {
    ModelCamera camera;
    camera.name = from.name;
    if (from.type == "perspective") {
        camera.fov_y = std::clamp(finite(from.perspective.yfov, 1.0f), 0.01f, 2.9f);
        camera.near = std::clamp(finite(from.perspective.znear, 0.01f), 1e-6f, 1e3f);
    } else {
        warnings.push_back(fmt::format("{}: an orthographic camera is shown in perspective", where));
    }
    return camera;
}

ModelSkin skin_of(const tinygltf::Model& file, const tinygltf::Skin& from, const NodeOrder& order, const std::string& where) {
    ModelSkin skin;
    for (const int joint : from.joints) {
        const Index node = order.place(joint);
        if (node < 0) fail("{}/joints: there is no node {}", where, joint);
        skin.joints.push_back(node);
    }
    skin.joint_from_mesh.assign(skin.joints.size(), mat4(1.0f));
    if (from.inverseBindMatrices < 0) return skin;
    const AccessorValues matrices = accessor_values(file, from.inverseBindMatrices, where + "/inverseBindMatrices");
    if (matrices.width != 16 || matrices.count < skin.joints.size()) fail("{}/inverseBindMatrices: {} matrices of {} numbers for {} joints", where, matrices.count, matrices.width, skin.joints.size());
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
        for (int k = 0; k < 16; ++k) skin.joint_from_mesh[i][k / 4][k % 4] = matrices.numbers[16 * i + static_cast<std::size_t>(k)];
    }
    return skin;
}

std::optional<ModelChannel::Path> path_of(const std::string& name) {
    if (name == "translation") return ModelChannel::Path::translation;
    if (name == "rotation") return ModelChannel::Path::rotation;
    if (name == "scale") return ModelChannel::Path::scale;
    if (name == "weights") return ModelChannel::Path::weights;
    return std::nullopt;
}

/// Nothing, and a warning, of a channel that makes no sense.
std::optional<ModelChannel> channel_of(const tinygltf::Model& file, const tinygltf::Animation& animation, const tinygltf::AnimationChannel& from, const NodeOrder& order,
                                       const std::string& where, std::vector<std::string>& warnings) {
    const auto left_out = [&](const char* why) {
        warnings.push_back(fmt::format("{}: {}; it is left out", where, why));
        return std::nullopt;
    };
    const auto path = path_of(from.target_path);
    if (!path) return left_out("what it moves is not known");
    ModelChannel channel{.node = order.place(from.target_node), .path = *path};
    if (channel.node < 0) return left_out("it moves no node");
    if (in_range(from.sampler, animation.samplers.size()) < 0) return left_out("it has no sampler");
    const tinygltf::AnimationSampler& sampler = animation.samplers[static_cast<std::size_t>(from.sampler)];
    channel.between = sampler.interpolation == "STEP" ? ModelChannel::Between::step : sampler.interpolation == "CUBICSPLINE" ? ModelChannel::Between::cubic : ModelChannel::Between::linear;
    channel.times = accessor_values(file, sampler.input, where + "/input").numbers;
    channel.values = accessor_values(file, sampler.output, where + "/output").numbers;
    if (channel.times.empty() || !std::ranges::all_of(channel.times, [](float time) { return std::isfinite(time); }) || !std::ranges::is_sorted(channel.times)) return left_out("its times do not rise");
    for (float& value : channel.values) value = std::isfinite(value) ? value : 0.0f;
    const std::size_t keys = channel.times.size() * (channel.between == ModelChannel::Between::cubic ? 3 : 1);
    channel.width = channel.path == ModelChannel::Path::rotation ? 4 : 3;
    if (channel.path == ModelChannel::Path::weights) channel.width = channel.values.size() / keys;
    if (channel.width == 0 || channel.values.size() != keys * channel.width) return left_out("its values are not as many as its times");
    return channel;
}

}  // namespace

void read_gltf_nodes(const tinygltf::Model& file, Model& model) {
    const NodeOrder order(file);
    for (const Index number : order.order()) {
        ModelNode node = node_of(file, file.nodes[static_cast<std::size_t>(number)]);
        node.parent = order.place(order.parent(number));
        model.nodes.push_back(std::move(node));
    }
    for (const tinygltf::Light& light : file.lights) model.lights.push_back(light_of(light));
    for (std::size_t i = 0; i < file.cameras.size(); ++i) model.cameras.push_back(camera_of(file.cameras[i], fmt::format("/cameras/{}", i), model.warnings));
    for (std::size_t i = 0; i < file.skins.size(); ++i) model.skins.push_back(skin_of(file, file.skins[i], order, fmt::format("/skins/{}", i)));
    for (std::size_t i = 0; i < file.animations.size(); ++i) {
        ModelAnimation& animation = model.animations.emplace_back();
        animation.name = file.animations[i].name;
        for (std::size_t k = 0; k < file.animations[i].channels.size(); ++k) {
            auto channel = channel_of(file, file.animations[i], file.animations[i].channels[k], order, fmt::format("/animations/{}/channels/{}", i, k), model.warnings);
            if (!channel) continue;
            animation.length = std::max(animation.length, channel->times.back());
            animation.channels.push_back(std::move(*channel));
        }
    }
    for (const tinygltf::Scene& from : file.scenes) {
        Model::Scene& scene = model.scenes.emplace_back();
        scene.name = from.name;
        for (const int root : from.nodes) {
            if (order.place(root) < 0) fail("/scenes/{}/nodes: there is no node {}", model.scenes.size() - 1, root);
            scene.roots.push_back(order.place(root));
        }
    }
    // A file without scenes is a library of parts: all of them are shown.
    if (model.scenes.empty()) {
        Model::Scene& all = model.scenes.emplace_back();
        for (std::size_t i = 0; i < model.nodes.size(); ++i) {
            if (model.nodes[i].parent < 0) all.roots.push_back(static_cast<Index>(i));
        }
    }
    model.scene = static_cast<std::size_t>(std::max(in_range(file.defaultScene, model.scenes.size()), Index{0}));
}

}  // namespace sl
