// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_data_check.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/core/gltf/gltf_key_check.h"
#include "engine/core/gltf/gltf_range_check.h"
#include "engine/core/gltf/gltf_resources.h"
#include "engine/core/gltf/gltf_value.h"
#include "engine/core/gltf/gltf_vertex_check.h"

namespace sl {

using nlohmann::json;

namespace {

using Ranges = std::vector<std::optional<GltfRange>>;

/// In double: the sum of absurd counts overflows whole numbers.
bool is_affordable(const GltfLayout& layout, GltfElements::Buffers buffers, std::size_t stored_bytes, GltfFaults& faults) {
    double bytes = 0.0;
    for (const GltfAccessor& accessor : layout.accessors) {
        const bool is_known = !accessor.view || !buffers[layout.views[*accessor.view].buffer].empty();
        if (is_known) bytes += static_cast<double>(accessor.count) * static_cast<double>(accessor.format.packed_bytes());
    }
    if (bytes <= static_cast<double>(most_gltf_bytes(stored_bytes))) return true;
    faults.fatal("/accessors", "hold {:.0f} bytes together, of {} that are stored", bytes, stored_bytes);
    return false;
}

/// The highest index of a primitive, against its vertices.
void check_indices(const json& primitive, const GltfLayout& layout, const Ranges& ranges, const GltfPlace& place,
                   GltfFaults& faults) {
    const auto index = gltf_find_whole(primitive, "indices");
    const json& attributes = gltf_part(primitive, "attributes");
    if (!index || !ranges[*index] || attributes.empty()) return;
    const GltfFormat& format = layout.accessors[*index].format;
    const double highest = ranges[*index]->greatest;
    const std::size_t vertices = layout.accessors[*gltf_whole_number(*attributes.begin())].count;
    const double restart = static_cast<double>((std::uint64_t{1} << (8 * gltf_component_bytes(format.component))) - 1);
    if (highest == restart) {
        faults.note(place.text() + "/indices", "accessor {} holds {}, which would begin a new primitive", *index, highest);
    }
    if (highest >= static_cast<double>(vertices)) {
        faults.fatal(place.text() + "/indices", "accessor {} leads to vertex {}; there are {}", *index, highest, vertices);
    }
}

/// The highest joint that a mesh refers to.
double highest_joint(const json& mesh, const Ranges& ranges) {
    double highest = 0.0;
    for (const json& primitive : gltf_list(mesh, "primitives")) {
        for (const auto& [name, index] : gltf_part(primitive, "attributes").items()) {
            const auto& range = ranges[*gltf_whole_number(index)];
            if (name.starts_with("JOINTS_") && range) highest = std::max(highest, range->greatest);
        }
    }
    return highest;
}

void check_joints(const json& document, const Ranges& ranges, GltfFaults& faults) {
    std::vector<double> highest;
    for (const json& mesh : gltf_list(document, "meshes")) highest.push_back(highest_joint(mesh, ranges));
    const json& nodes = gltf_list(document, "nodes");
    for (std::size_t i = 0; i < nodes.size() && !faults.is_done(); ++i) {
        const auto mesh = gltf_find_whole(nodes[i], "mesh"), skin = gltf_find_whole(nodes[i], "skin");
        if (!mesh || !skin) continue;
        const std::size_t joints = gltf_list(gltf_list(document, "skins")[*skin], "joints").size();
        if (highest[*mesh] < static_cast<double>(joints)) continue;
        faults.fatal(fmt::format("/nodes/{}/skin", i), "mesh {} refers to joint {}; skin {} has {}", *mesh, highest[*mesh],
                     *skin, joints);
    }
}

}  // namespace

void check_gltf_data(const json& document, const GltfLayout& layout, GltfElements::Buffers buffers, std::size_t stored_bytes,
                     GltfFaults& faults) {
    if (!is_affordable(layout, buffers, stored_bytes, faults)) return;
    const Ranges ranges = check_gltf_ranges(document, layout, buffers, faults);
    const json& meshes = gltf_list(document, "meshes");
    const GltfPlace root, list(root, "meshes");
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const GltfPlace mesh(list, i), primitive_list(mesh, "primitives");
        const json& primitives = gltf_list(meshes[i], "primitives");
        for (std::size_t k = 0; k < primitives.size() && !faults.is_done(); ++k) {
            check_indices(primitives[k], layout, ranges, GltfPlace(primitive_list, k), faults);
        }
    }
    check_joints(document, ranges, faults);
    check_gltf_vertices(document, layout, buffers, faults);
    check_gltf_keys(document, layout, buffers, faults);
}

}  // namespace sl
