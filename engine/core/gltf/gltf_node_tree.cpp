// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_node_tree.h"

#include "engine/core/gltf/gltf_value.h"

namespace sl {

using nlohmann::json;

GltfNodeTree::GltfNodeTree(const json& document, GltfFaults& faults) {
    const json& nodes = gltf_list(document, "nodes");
    parents_.assign(nodes.size(), none);
    find_parents(nodes, faults);
    find_loops(faults);
    // Who stops early for too many faults has not seen every loop.
    if (faults.is_done()) is_sound_ = false;
    if (is_sound_) walk(nodes);
}

void GltfNodeTree::find_parents(const json& nodes, GltfFaults& faults) {
    for (std::size_t i = 0; i < nodes.size() && !faults.is_done(); ++i) {
        const json& children = gltf_list(nodes[i], "children");
        for (std::size_t k = 0; k < children.size() && !faults.is_done(); ++k) {
            const std::size_t child = *gltf_whole_number(children[k]);
            if (parents_[child] == none) {
                parents_[child] = i;
                continue;
            }
            faults.fatal(fmt::format("/nodes/{}/children/{}", i, k), "node {} is already a child of node {}", child,
                         parents_[child]);
            is_sound_ = false;
        }
    }
}

void GltfNodeTree::find_loops(GltfFaults& faults) {
    std::vector<std::size_t> reached_from(parents_.size(), none);
    for (std::size_t start = 0; start < parents_.size() && !faults.is_done(); ++start) {
        std::size_t at = start;
        while (at != none && reached_from[at] == none) {
            reached_from[at] = start;
            at = parents_[at];
        }
        if (at == none || reached_from[at] != start) continue;
        faults.fatal(fmt::format("/nodes/{}", at), "the node hangs on itself through its parents");
        is_sound_ = false;
    }
}

void GltfNodeTree::walk(const json& nodes) {
    roots_.assign(nodes.size(), none);
    enters_.assign(nodes.size(), 0);
    leaves_.assign(nodes.size(), 0);
    std::size_t time = 0;
    struct Step {
        std::size_t node, next_child;
    };
    std::vector<Step> path;
    for (std::size_t root = 0; root < nodes.size(); ++root) {
        if (parents_[root] != none) continue;
        const auto enter = [&](std::size_t node) {
            roots_[node] = root;
            enters_[node] = time++;
            path.push_back({node, 0});
        };
        enter(root);
        while (!path.empty()) {
            Step& step = path.back();
            const json& children = gltf_list(nodes[step.node], "children");
            if (step.next_child < children.size()) {
                enter(*gltf_whole_number(children[step.next_child++]));
                continue;
            }
            leaves_[step.node] = time;
            path.pop_back();
        }
    }
}

}  // namespace sl
