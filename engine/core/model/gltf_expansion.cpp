// SPDX-License-Identifier: MIT
#include "engine/core/model/gltf_expansion.h"

#include <algorithm>

#include "engine/core/error.h"
#include "engine/core/gltf/gltf_value.h"

namespace sl {

using nlohmann::json;

namespace {

/// Bytes of memory, in double: sums of absurd counts overflow whole numbers.
class Expansion {
  public:
    Expansion(const GltfChecked& file, const std::vector<ModelMaterial>& materials)
        : document_(file.file.json), accessors_(file.layout.accessors), materials_(materials), used_(accessors_.size()) {
        for (const json& mesh : gltf_list(document_, "meshes")) posed_bytes_.push_back(add_mesh(mesh));
        posed_.resize(posed_bytes_.size());
        for (const json& node : gltf_list(document_, "nodes")) add_posed(node);
        for (const json& skin : gltf_list(document_, "skins")) add_read(gltf_find_whole(skin, "inverseBindMatrices"));
        for (const json& animation : gltf_list(document_, "animations")) add_animation(animation);
    }
    double total() const { return total_; }
    /// With each accessor used once.
    double once() const { return once_; }

  private:
    /// What an accessor is the cause of: once, where it is the first time.
    void add(std::size_t accessor, double bytes) {
        total_ += bytes;
        if (!used_[accessor]) once_ += bytes;
    }
    double count_of(std::size_t accessor) const { return static_cast<double>(accessors_[accessor].count); }
    double numbers_of(std::size_t accessor) const { return count_of(accessor) * static_cast<double>(accessors_[accessor].format.components()); }

    /// Numbers of 4 bytes each, and all that is made of them.
    void add_read(std::optional<std::size_t> accessor, double bytes_more = 0.0) {
        if (!accessor) return;
        add(*accessor, numbers_of(*accessor) * sizeof(float) + bytes_more);
        used_[*accessor] = true;
    }

    /// Returns what each node that moves its vertices takes for a copy of its own.
    double add_mesh(const json& mesh) {
        double posed = 0.0;
        for (const json& primitive : gltf_list(mesh, "primitives")) posed += add_primitive(primitive);
        return posed;
    }

    double add_primitive(const json& primitive) {
        const json &attributes = gltf_part(primitive, "attributes"), &targets = gltf_list(primitive, "targets");
        const auto position = gltf_find_whole(attributes, "POSITION"), index = gltf_find_whole(primitive, "indices");
        if (!position) return 0.0;
        const auto material = gltf_find_whole(primitive, "material");
        const ModelMaterial surface = material ? materials_[*material] : ModelMaterial{};
        const double sides = surface.two_sided ? 2.0 : 1.0;
        const bool is_flat = !attributes.contains("NORMAL"), has_joints = attributes.contains("JOINTS_0");
        // Of a strip or a fan, each index but two makes a triangle.
        constexpr std::size_t triangles = 4;
        const double corners = count_of(index.value_or(*position)) * (gltf_whole_at(primitive, "mode", triangles) == triangles ? 1.0 : 3.0);
        const double vertex_bytes = sizeof(Vertex) + (has_joints ? sizeof(ModelJoints) : 0.0) + (surface.needs_pictured_vertices() ? sizeof(PicturedVertex) : 0.0);
        // Where a normal texture lies mirrored, vertices whose tangents are made are parted.
        const double parted = surface.normal_texture && !attributes.contains("TANGENT") ? 2.0 : 1.0;
        const double vertices_bytes = sides * parted * count_of(*position) * vertex_bytes, indices_bytes = sides * corners * sizeof(std::uint32_t);
        const double vertices_kept = sides * (is_flat ? corners : parted * count_of(*position));
        // Flat normals give each corner a vertex of its own.
        const double corner_bytes = indices_bytes + (is_flat ? sides * corners * vertex_bytes : 0.0);
        for (const auto& [name, accessor] : attributes.items()) {
            if (name != "POSITION") add_read(gltf_whole_number(accessor));
        }
        for (const json& target : targets) {
            for (const auto& [name, accessor] : target.items()) add_read(gltf_whole_number(accessor), vertices_kept * sizeof(vec3));
        }
        add_read(position, vertices_bytes + (index ? 0.0 : corner_bytes));
        add_read(index, corner_bytes);
        return targets.empty() && !has_joints ? 0.0 : indices_bytes + vertices_kept * sizeof(Vertex);
    }

    void add_posed(const json& node) {
        const auto mesh = gltf_find_whole(node, "mesh");
        if (!mesh) return;
        total_ += posed_bytes_[*mesh];
        if (!posed_[*mesh]) once_ += posed_bytes_[*mesh];
        posed_[*mesh] = true;
    }

    void add_animation(const json& animation) {
        const json& samplers = gltf_list(animation, "samplers");
        for (const json& channel : gltf_list(animation, "channels")) {
            const json& sampler = samplers[*gltf_find_whole(channel, "sampler")];
            add_read(gltf_find_whole(sampler, "input"));
            add_read(gltf_find_whole(sampler, "output"));
        }
    }

    const json& document_;
    const std::vector<GltfAccessor>& accessors_;
    const std::vector<ModelMaterial>& materials_;
    std::vector<bool> used_;
    std::vector<double> posed_bytes_;  ///< per mesh, that a node which shows it takes for vertices of its own
    std::vector<bool> posed_;          ///< per mesh, whether a node has been counted
    double total_ = 0.0, once_ = 0.0;
};

/// Which part of what the accessors hold is stored: they may overlap each other, or hold zeros that are nowhere.
double stored_part(const GltfChecked& file) {
    double held = 0.0;
    for (const GltfAccessor& accessor : file.layout.accessors) held += static_cast<double>(accessor.count) * static_cast<double>(accessor.format.packed_bytes());
    return std::min(1.0, static_cast<double>(file.resources.stored_bytes()) / std::max(held, 1.0));
}

}  // namespace

void check_gltf_expansion(const GltfChecked& file, const std::vector<ModelMaterial>& materials) {
    const Expansion expansion(file, materials);
    const double once = expansion.once() * stored_part(file), most = 2.0 * once + most_shared_bytes;
    if (expansion.total() <= most) return;
    constexpr double megabyte = 1 << 20;
    fail("the model would take {:.0f} MB by using the same numbers many times, which take {:.0f} MB once; it may take {:.0f} MB", expansion.total() / megabyte, once / megabyte, most / megabyte);
}

}  // namespace sl
