// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_node_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/core/gltf/gltf_tolerance.h"
#include "engine/core/gltf/gltf_value.h"

namespace sl {

using nlohmann::json;

namespace {

/// A product of translation, rotation and scale: its columns stand upright on each other.
bool is_transform(const json& matrix) {
    const auto at = [&](std::size_t column, std::size_t row) { return matrix[column * 4 + row].get<double>(); };
    if (at(0, 3) != 0.0 || at(1, 3) != 0.0 || at(2, 3) != 0.0 || at(3, 3) != 1.0) return false;
    for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t b = (a + 1) % 3;
        double product = 0.0, square_a = 0.0, square_b = 0.0;
        for (std::size_t row = 0; row < 3; ++row) {
            product += at(a, row) * at(b, row);
            square_a += at(a, row) * at(a, row);
            square_b += at(b, row) * at(b, row);
        }
        if (!(std::abs(product) <= gltf_tolerance::upright * std::sqrt(square_a) * std::sqrt(square_b))) return false;
    }
    return true;
}

void check_transform(const json& node, const std::string& where, GltfFaults& faults) {
    const auto matrix = node.find("matrix");
    if (matrix != node.end()) {
        const bool has_parts = node.contains("translation") || node.contains("rotation") || node.contains("scale");
        if (has_parts) faults.note(where, "has a matrix beside translation, rotation or scale");
        if (!is_transform(*matrix)) {
            faults.note(where + "/matrix", "is no product of translation, rotation and scale");
        }
    }
    if (const auto rotation = node.find("rotation"); rotation != node.end()) {
        double square = 0.0;
        for (const json& part : *rotation) square += part.get<double>() * part.get<double>();
        if (!(std::abs(std::sqrt(square) - 1.0) <= gltf_tolerance::unit_quaternion)) {
            faults.note(where + "/rotation", "is a quaternion of length {}, not 1", std::sqrt(square));
        }
    }
}

std::size_t targets_of(const json& mesh) {
    const json& primitives = gltf_list(mesh, "primitives");
    return primitives.empty() ? 0 : gltf_list(primitives[0], "targets").size();
}

/// In every primitive, or the skin would move a part of the mesh only.
bool is_skinned(const json& mesh) {
    const json& primitives = gltf_list(mesh, "primitives");
    return std::all_of(primitives.begin(), primitives.end(), [](const json& primitive) {
        const json& attributes = gltf_part(primitive, "attributes");
        return attributes.contains("JOINTS_0") && attributes.contains("WEIGHTS_0");
    });
}

void check_mesh(const json& document, const json& node, const std::vector<bool>& skinned, const std::string& where,
                GltfFaults& faults) {
    const auto index = gltf_find_whole(node, "mesh");
    if (!index) return;
    const json& mesh = gltf_list(document, "meshes")[*index];
    if (const auto weights = node.find("weights"); weights != node.end() && weights->size() != targets_of(mesh)) {
        faults.note(where + "/weights", "has {} weights; mesh {} has {} morph targets", weights->size(), *index,
                    targets_of(mesh));
    }
    if (node.contains("skin") && !skinned[*index]) {
        faults.note(where + "/skin", "is there, but mesh {} has no JOINTS_0 and WEIGHTS_0 for it", *index);
    }
}

/// Roots of scenes, and skins whose joints are in another scene than the node that they move.
class Scenes {
  public:
    Scenes(const json& document, const GltfNodeTree& tree, GltfFaults& faults)
        : document_(document), tree_(tree), faults_(faults) {
        const json& nodes = gltf_list(document, "nodes");
        scene_of_root_.assign(nodes.size(), GltfNodeTree::none);
        skinned_under_.resize(nodes.size());
        for (std::size_t i = 0; tree.is_sound() && i < nodes.size(); ++i) {
            if (nodes[i].contains("skin")) skinned_under_[tree.root(i)].push_back(i);
        }
    }

    void check(std::size_t scene, const json& roots) {
        for (std::size_t k = 0; k < roots.size(); ++k) {
            const std::size_t node = *gltf_whole_number(roots[k]);
            scene_of_root_[node] = scene;
            if (tree_.parent(node) == GltfNodeTree::none) continue;
            faults_.note(fmt::format("/scenes/{}/nodes/{}", scene, k), "node {} is no root: it is a child of node {}", node,
                         tree_.parent(node));
        }
        for (const json& root : roots) {
            // Of scenes that share a root only the first is looked at: the time would be their product.
            const auto skinned = std::exchange(skinned_under_[*gltf_whole_number(root)], {});
            for (const std::size_t node : skinned) check_skin(scene, node);
        }
    }

  private:
    void check_skin(std::size_t scene, std::size_t node) {
        if (!faults_.takes_notes()) return;
        const std::size_t skin = *gltf_find_whole(gltf_list(document_, "nodes")[node], "skin");
        const json& joints = gltf_list(gltf_list(document_, "skins")[skin], "joints");
        if (joints.empty() || scene_of_root_[tree_.root(*gltf_whole_number(joints[0]))] == scene) return;
        faults_.note(fmt::format("/nodes/{}/skin", node), "the joints of skin {} are not in scene {}, as the node is", skin, scene);
    }

    const json& document_;
    const GltfNodeTree& tree_;
    GltfFaults& faults_;
    std::vector<std::size_t> scene_of_root_;
    std::vector<std::vector<std::size_t>> skinned_under_;
};

}  // namespace

void check_gltf_nodes(const json& document, const GltfNodeTree& tree, GltfFaults& faults) {
    std::vector<bool> skinned;
    for (const json& mesh : gltf_list(document, "meshes")) skinned.push_back(is_skinned(mesh));
    const json& nodes = gltf_list(document, "nodes");
    for (std::size_t i = 0; i < nodes.size() && faults.takes_notes(); ++i) {
        const std::string where = fmt::format("/nodes/{}", i);
        check_transform(nodes[i], where, faults);
        check_mesh(document, nodes[i], skinned, where, faults);
    }
    Scenes scenes(document, tree, faults);
    const json& list = gltf_list(document, "scenes");
    for (std::size_t i = 0; i < list.size() && faults.takes_notes(); ++i) scenes.check(i, gltf_list(list[i], "nodes"));
}

void check_gltf_skins(const json& document, const GltfLayout& layout, const GltfNodeTree& tree, GltfViewUses& uses,
                      GltfFaults& faults) {
    const json& skins = gltf_list(document, "skins");
    const GltfPlace root, list(root, "skins");
    for (std::size_t i = 0; i < skins.size() && !faults.is_done(); ++i) {
        const GltfPlace place(list, i);
        const json& joints = gltf_list(skins[i], "joints");
        const auto skeleton = gltf_find_whole(skins[i], "skeleton");
        for (std::size_t k = 0; tree.is_sound() && k < joints.size() && faults.takes_notes(); ++k) {
            const std::size_t joint = *gltf_whole_number(joints[k]), first = *gltf_whole_number(joints[0]);
            if (tree.root(joint) != tree.root(first)) {
                faults.note(place.text() + "/joints", "nodes {} and {} have no common root", first, joint);
                break;
            }
            if (skeleton && !tree.contains(*skeleton, joint)) {
                faults.note(place.text() + "/skeleton", "joint {} is not below node {}", joint, *skeleton);
                break;
            }
        }
        const auto matrices = gltf_find_whole(skins[i], "inverseBindMatrices");
        if (!matrices) continue;
        const GltfPlace at(place, "inverseBindMatrices");
        const GltfAccessor& accessor = layout.accessors[*matrices];
        uses.use(*matrices, GltfViewUse::other, at);
        if (accessor.format != GltfFormat{GltfComponent::float32, 4, 4}) {
            faults.fatal(at.text(), "accessor {} is {}; it must be MAT4 of float32", *matrices,
                         gltf_format_text(accessor.format));
        }
        if (accessor.count < joints.size()) {
            faults.fatal(at.text(), "accessor {} has {} matrices for {} joints", *matrices, accessor.count, joints.size());
        }
    }
}

void check_gltf_cameras_and_lights(const json& document, GltfFaults& faults) {
    const json& cameras = gltf_list(document, "cameras");
    for (std::size_t i = 0; i < cameras.size() && faults.takes_notes(); ++i) {
        for (const std::string_view kind : {"perspective", "orthographic"}) {
            const auto camera = cameras[i].find(kind);
            if (camera == cameras[i].end()) continue;
            const std::string where = fmt::format("/cameras/{}/{}", i, kind);
            const double near = gltf_number_at(*camera, "znear", 0.0), far = gltf_number_at(*camera, "zfar", INFINITY);
            if (far <= near) faults.note(where, "zfar is {}, not more than znear, {}", far, near);
            for (const std::string_view side : {"xmag", "ymag"}) {
                if (gltf_number_at(*camera, side, 1.0) == 0.0) faults.note(where, "{} is 0", side);
            }
        }
    }
    const json* lights = gltf_extension(document, "KHR_lights_punctual");
    if (!lights) return;
    const json& list = gltf_list(*lights, "lights");
    for (std::size_t i = 0; i < list.size() && faults.takes_notes(); ++i) {
        const auto spot = list[i].find("spot");
        if (spot == list[i].end()) continue;
        const double inner = gltf_number_at(*spot, "innerConeAngle", 0.0);
        const double outer = gltf_number_at(*spot, "outerConeAngle", std::numbers::pi / 4);
        if (inner < outer) continue;
        faults.note(fmt::format("/extensions/KHR_lights_punctual/lights/{}/spot", i),
                    "innerConeAngle is {}, not less than outerConeAngle, {}", inner, outer);
    }
}

}  // namespace sl
