// SPDX-License-Identifier: MIT
#include "engine/core/model/gltf_nodes.h"

#include <algorithm>
#include <cmath>

#include "engine/core/model/gltf_floats.h"

namespace sl {

using nlohmann::json;

namespace {

using Index = std::int32_t;

constexpr std::string_view lights_extension = "KHR_lights_punctual";

Index index_at(const json& object, std::string_view key) {
    const auto found = gltf_find_whole(object, key);
    return found ? static_cast<Index>(*found) : -1;
}

/// The numbers of nodes of the file, parents first.
class NodeOrder {
  public:
    explicit NodeOrder(const json& nodes) : nodes_(nodes), parent_(nodes.size(), -1), place_(nodes.size(), -1) {
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            for (const json& child : gltf_list(nodes[i], "children")) parent_[*gltf_whole_number(child)] = static_cast<Index>(i);
        }
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (parent_[i] < 0) add_with_children(i);
        }
    }
    const std::vector<std::size_t>& order() const { return order_; }
    /// Where the parent of a node stands in the order; -1: it has none.
    Index parent(std::size_t node) const { return parent_[node] < 0 ? -1 : place_[static_cast<std::size_t>(parent_[node])]; }
    /// Where a node of the file stands in the order.
    Index place(const json& node) const { return place_[*gltf_whole_number(node)]; }

  private:
    void add_with_children(std::size_t root) {
        // A list, and no recursion: chains may be as long as a file.
        for (std::vector<std::size_t> waiting{root}; !waiting.empty();) {
            const std::size_t node = waiting.back();
            waiting.pop_back();
            place_[node] = static_cast<Index>(order_.size());
            order_.push_back(node);
            const json& children = gltf_list(nodes_[node], "children");
            for (auto child = children.rbegin(); child != children.rend(); ++child) waiting.push_back(*gltf_whole_number(*child));
        }
    }

    const json& nodes_;
    std::vector<Index> parent_, place_;
    std::vector<std::size_t> order_;
};

quat unit(const quat& rotation) {
    const float length = glm::length(rotation);
    return length > 0.0f && std::isfinite(length) ? rotation / length : quat(1, 0, 0, 0);
}

/// Translation, rotation and scale of a matrix that is made of them; of any other, what comes near.
void decompose(const json& values, ModelNode& node) {
    mat4 matrix(1.0f);
    for (std::size_t i = 0; i < 16; ++i)
        matrix[static_cast<int>(i / 4)][static_cast<int>(i % 4)] = gltf_float(values[i].get<double>());
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

ModelNode node_of(const json& from) {
    ModelNode node;
    node.name = gltf_text_at(from, "name");
    if (const auto matrix = from.find("matrix"); matrix != from.end()) {
        decompose(*matrix, node);
    } else {
        vec3 translation(0.0f);
        take_gltf_numbers(from, "translation", translation);
        node.translation = dvec3(translation);
        take_gltf_numbers(from, "scale", node.scale);
        vec4 rotation(0, 0, 0, 1);
        take_gltf_numbers(from, "rotation", rotation);
        node.rotation = unit(quat(rotation.w, rotation.x, rotation.y, rotation.z));
    }
    node.mesh = index_at(from, "mesh");
    node.skin = index_at(from, "skin");
    node.camera = index_at(from, "camera");
    if (const json* light = gltf_extension(from, lights_extension)) node.light = index_at(*light, "light");
    for (const json& weight : gltf_list(from, "weights")) node.weights.push_back(gltf_float(weight.get<double>()));
    return node;
}

ModelLight light_of(const json& from) {
    const std::string_view type = gltf_text_at(from, "type");
    ModelLight light;
    light.name = gltf_text_at(from, "name");
    light.kind = type == "directional" ? ModelLight::Kind::directional
                 : type == "spot"      ? ModelLight::Kind::spot
                                       : ModelLight::Kind::point;
    take_gltf_numbers(from, "color", light.colour, {0.0f, 1.0f});
    light.intensity = gltf_float_at(from, "intensity", 1.0f, {.low = 0.0f});
    light.range = gltf_float_at(from, "range", 0.0f, {.low = 0.0f});
    const json& spot = gltf_part(from, "spot");
    light.outer_cone = gltf_float_at(spot, "outerConeAngle", 0.7854f, {0.001f, 1.5533f});
    light.inner_cone = gltf_float_at(spot, "innerConeAngle", 0.0f, {0.0f, light.outer_cone});
    return light;
}

ModelCamera camera_of(const json& from) {
    constexpr FloatRange near{1e-6f, 1e3f};
    ModelCamera camera;
    camera.name = gltf_text_at(from, "name");
    const json &perspective = gltf_part(from, "perspective"), &orthographic = gltf_part(from, "orthographic");
    if (gltf_text_at(from, "type") == "orthographic") {
        // Half of it, and mirrored where it is negative, which nobody means.
        camera.height = 2.0f * std::abs(gltf_float_at(orthographic, "ymag", 1.0f, {-5e5f, 5e5f}));
        camera.near = gltf_float_at(orthographic, "znear", 0.01f, near);
    } else {
        camera.fov_y = gltf_float_at(perspective, "yfov", 1.0f, {0.01f, 2.9f});
        camera.near = gltf_float_at(perspective, "znear", 0.01f, near);
    }
    return camera;
}

ModelSkin skin_of(const json& from, const NodeOrder& order, const std::string& where, GltfReader& reader) {
    ModelSkin skin;
    for (const json& joint : gltf_list(from, "joints")) skin.joints.push_back(order.place(joint));
    skin.joint_from_mesh.assign(skin.joints.size(), mat4(1.0f));
    const auto accessor = gltf_find_whole(from, "inverseBindMatrices");
    const auto matrices = accessor ? reader.values(*accessor) : std::nullopt;
    if (accessor && !matrices)
        reader.warn(where + "/inverseBindMatrices", "they lie in a file that is not read, and are left out");
    for (std::size_t i = 0; matrices && i < skin.joints.size(); ++i) {
        for (int k = 0; k < 16; ++k) {
            const float number = matrices->numbers[16 * i + static_cast<std::size_t>(k)];
            if (std::isfinite(number)) skin.joint_from_mesh[i][k / 4][k % 4] = number;
        }
    }
    return skin;
}

std::optional<ModelChannel::Path> path_of(std::string_view name) {
    if (name == "translation") return ModelChannel::Path::translation;
    if (name == "rotation") return ModelChannel::Path::rotation;
    if (name == "scale") return ModelChannel::Path::scale;
    if (name == "weights") return ModelChannel::Path::weights;
    return std::nullopt;
}

/// Nothing, and a warning, of a channel that makes no sense.
std::optional<ModelChannel> channel_of(const json& animation, const json& from, const NodeOrder& order, const std::string& where,
                                       GltfReader& reader) {
    const auto left_out = [&](std::string_view why) {
        reader.warn(where, fmt::format("{}; it is left out", why));
        return std::nullopt;
    };
    const json& target = gltf_part(from, "target");
    const auto path = path_of(gltf_text_at(target, "path"));
    if (!path) return left_out("what it moves is not known");
    const auto node = target.find("node");
    if (node == target.end()) return left_out("it moves no node");
    ModelChannel channel{.node = order.place(*node), .path = *path};
    const json& sampler = gltf_list(animation, "samplers")[*gltf_find_whole(from, "sampler")];
    const std::string_view between = gltf_text_at(sampler, "interpolation");
    channel.between = between == "STEP"          ? ModelChannel::Between::step
                      : between == "CUBICSPLINE" ? ModelChannel::Between::cubic
                                                 : ModelChannel::Between::linear;
    auto times = reader.values(*gltf_find_whole(sampler, "input")), values = reader.values(*gltf_find_whole(sampler, "output"));
    if (!times || !values) return left_out("its keys lie in a file that is not read");
    channel.times = std::move(times->numbers);
    channel.values = std::move(values->numbers);
    if (!std::ranges::all_of(channel.times, [](float time) { return std::isfinite(time); }) ||
        !std::ranges::is_sorted(channel.times))
        return left_out("its times do not rise");
    for (float& value : channel.values) value = std::isfinite(value) ? value : 0.0f;
    const std::size_t keys = channel.times.size() * (channel.between == ModelChannel::Between::cubic ? 3 : 1);
    const bool is_morph = channel.path == ModelChannel::Path::weights;
    channel.width = is_morph ? channel.values.size() / keys : channel.path == ModelChannel::Path::rotation ? 4 : 3;
    if (channel.width == 0) return left_out("it has fewer values than times");
    channel.values.resize(keys * channel.width);
    return channel;
}

ModelAnimation animation_of(const json& from, const NodeOrder& order, const std::string& where, GltfReader& reader) {
    ModelAnimation animation;
    animation.name = gltf_text_at(from, "name");
    const json& channels = gltf_list(from, "channels");
    for (std::size_t i = 0; i < channels.size(); ++i) {
        auto channel = channel_of(from, channels[i], order, fmt::format("{}/channels/{}", where, i), reader);
        if (!channel) continue;
        animation.length = std::max(animation.length, channel->times.back());
        animation.channels.push_back(std::move(*channel));
    }
    return animation;
}

void read_scenes(const json& document, const NodeOrder& order, Model& model) {
    for (const json& from : gltf_list(document, "scenes")) {
        Model::Scene& scene = model.scenes.emplace_back();
        scene.name = gltf_text_at(from, "name");
        for (const json& root : gltf_list(from, "nodes")) scene.roots.push_back(order.place(root));
    }
    // A file without scenes is a library of parts: all of them are shown.
    if (model.scenes.empty()) {
        Model::Scene& all = model.scenes.emplace_back();
        for (std::size_t i = 0; i < model.nodes.size(); ++i) {
            if (model.nodes[i].parent < 0) all.roots.push_back(static_cast<Index>(i));
        }
    }
    model.scene = gltf_whole_at(document, "scene", 0);
}

}  // namespace

void read_gltf_nodes(GltfReader& reader, Model& model) {
    const json& document = reader.document();
    const json& nodes = gltf_list(document, "nodes");
    const NodeOrder order(nodes);
    for (const std::size_t number : order.order()) {
        ModelNode node = node_of(nodes[number]);
        node.parent = order.parent(number);
        model.nodes.push_back(std::move(node));
    }
    if (const json* lights = gltf_extension(document, lights_extension)) {
        for (const json& light : gltf_list(*lights, "lights")) model.lights.push_back(light_of(light));
    }
    const json &cameras = gltf_list(document, "cameras"), &skins = gltf_list(document, "skins"),
               &animations = gltf_list(document, "animations");
    for (const json& camera : cameras) model.cameras.push_back(camera_of(camera));
    for (std::size_t i = 0; i < skins.size(); ++i)
        model.skins.push_back(skin_of(skins[i], order, fmt::format("/skins/{}", i), reader));
    for (std::size_t i = 0; i < animations.size(); ++i)
        model.animations.push_back(animation_of(animations[i], order, fmt::format("/animations/{}", i), reader));
    read_scenes(document, order, model);
}

}  // namespace sl
