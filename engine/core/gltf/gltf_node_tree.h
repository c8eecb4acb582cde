// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "engine/core/gltf/gltf_fault.h"

namespace sl {

/// How the nodes of a document hang together.
class GltfNodeTree {
  public:
    static constexpr std::size_t none = ~std::size_t{0};

    /// A node with two parents, or one that hangs on itself, is a fatal fault, and the tree is not `sound` then.
    GltfNodeTree(const nlohmann::json& document, GltfFaults& faults);

    bool is_sound() const { return is_sound_; }
    std::size_t parent(std::size_t node) const { return parents_[node]; }

    /// For sound trees.
    std::size_t root(std::size_t node) const { return roots_[node]; }
    /// A node contains itself.
    bool contains(std::size_t ancestor, std::size_t node) const {
        return enters_[ancestor] <= enters_[node] && enters_[node] < leaves_[ancestor];
    }

  private:
    void find_parents(const nlohmann::json& nodes, GltfFaults& faults);
    void find_loops(GltfFaults& faults);
    void walk(const nlohmann::json& nodes);

    std::vector<std::size_t> parents_, roots_;
    std::vector<std::size_t> enters_, leaves_;  ///< when a walk through the tree enters a node, and leaves it
    bool is_sound_ = true;
};

}  // namespace sl
