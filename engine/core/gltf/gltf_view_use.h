// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/core/gltf/gltf_fault.h"
#include "engine/core/gltf/gltf_layout.h"

namespace sl {

/// What the accessors that lie in a buffer view are.
enum class GltfViewUse : std::uint8_t { none, vertices, indices, other };

/// Tells where a buffer view serves in two ways that exclude each other.
class GltfViewUses {
  public:
    GltfViewUses(const GltfLayout& layout, GltfFaults& faults)
        : layout_(layout), faults_(faults), records_(layout.views.size()) {}

    /// `where` is the place that refers to the accessor. An accessor without a view is none of our business.
    void use(std::size_t accessor, GltfViewUse use, const GltfPlace& where);
    void use_view(std::size_t view, GltfViewUse use, const GltfPlace& where);

  private:
    static constexpr std::size_t no_accessor = ~std::size_t{0};

    struct Record {
        GltfViewUse use = GltfViewUse::none;
        std::size_t vertex_accessor = no_accessor;
        bool has_told_sharing = false;
    };

    const GltfLayout& layout_;
    GltfFaults& faults_;
    std::vector<Record> records_;
};

}  // namespace sl
