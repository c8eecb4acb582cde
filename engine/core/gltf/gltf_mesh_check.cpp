// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_mesh_check.h"

#include <algorithm>
#include <array>
#include <unordered_set>

#include "engine/core/closest_name.h"
#include "engine/core/gltf/gltf_attribute.h"
#include "engine/core/gltf/gltf_material_needs.h"
#include "engine/core/gltf/gltf_value.h"

namespace sl {

using nlohmann::json;

namespace {

constexpr std::size_t vertex_alignment = 4;

/// How many attributes of each kind a primitive has, and the highest number of one.
struct AttributeSets {
    std::array<std::size_t, gltf_attribute_kinds> counts{}, ends{};

    void add(GltfAttribute attribute) {
        const auto kind = static_cast<std::size_t>(attribute.kind);
        ++counts[kind];
        ends[kind] = std::max(ends[kind], attribute.set + 1);
    }
    std::size_t count(GltfAttributeKind kind) const { return counts[static_cast<std::size_t>(kind)]; }
};

class Meshes {
  public:
    Meshes(const json& document, const GltfLayout& layout, GltfViewUses& uses, GltfFaults& faults)
        : layout_(layout), uses_(uses), faults_(faults), materials_(gltf_material_needs(document)) {
        for (const json& name : gltf_list(document, "extensionsUsed")) {
            is_quantized_ = is_quantized_ || name.get_ref<const std::string&>() == "KHR_mesh_quantization";
        }
    }

    void check_mesh(const json& mesh, const GltfPlace& place) {
        const json& primitives = gltf_list(mesh, "primitives");
        const GltfPlace list(place, "primitives");
        const std::size_t targets = primitives.empty() ? 0 : gltf_list(primitives[0], "targets").size();
        for (std::size_t i = 0; i < primitives.size() && !faults_.is_done(); ++i) {
            const GltfPlace at(list, i);
            check_primitive(primitives[i], at);
            if (const std::size_t other = gltf_list(primitives[i], "targets").size(); other != targets) {
                faults_.note(at.text() + "/targets", "has {} morph targets; the mesh's first primitive has {}", other, targets);
            }
        }
        if (const auto weights = mesh.find("weights"); weights != mesh.end() && weights->size() != targets) {
            faults_.note(place.text() + "/weights", "has {} weights for {} morph targets", weights->size(), targets);
        }
    }

  private:
    void check_primitive(const json& primitive, const GltfPlace& place) {
        const json& attributes = gltf_part(primitive, "attributes");
        if (attributes.empty()) return;
        const auto position = attributes.find("POSITION");
        const std::size_t vertices =
            layout_.accessors[*gltf_whole_number(position == attributes.end() ? *attributes.begin() : *position)].count;
        AttributeSets sets;
        const GltfPlace list(place, "attributes");
        for (const auto& [name, index] : attributes.items()) {
            if (faults_.is_done()) return;
            check_attribute(name, *gltf_whole_number(index), vertices, {.is_quantized = is_quantized_}, GltfPlace(list, name));
            if (const auto attribute = read_gltf_attribute(name)) sets.add(*attribute);
        }
        check_sets(sets, list);
        check_indices(primitive, place);
        check_targets(primitive, attributes, vertices, place);
        check_material(primitive, sets, place);
        check_variants(primitive, place);
    }

    void check_attribute(const std::string& name, std::size_t index, std::size_t vertices, GltfAttributeRules rules,
                         const GltfPlace& place) {
        const GltfAccessor& accessor = layout_.accessors[index];
        const auto attribute = read_gltf_attribute(name);
        if (!attribute) {
            faults_.note(place.text(), "'{}' is no attribute of the format; others begin with '_'", for_message(name));
        } else if (const std::string allowed = gltf_attribute_format_fault(attribute->kind, accessor.format, rules);
                   !allowed.empty()) {
            tell_format(index, allowed, attribute->kind == GltfAttributeKind::custom, place);
        }
        if (accessor.count != vertices) {
            faults_.fatal(place.text(), "accessor {} has {} elements for {} vertices", index, accessor.count, vertices);
        }
        if (attribute && attribute->kind == GltfAttributeKind::position && !accessor.has_bounds) {
            faults_.note(place.text(), "accessor {} has no min and max, which positions need", index);
        }
        if (accessor.view && (accessor.offset % vertex_alignment != 0 || accessor.stride % vertex_alignment != 0)) {
            faults_.note(place.text(), "the elements of accessor {} do not begin at multiples of {} bytes", index,
                         vertex_alignment);
        }
        uses_.use(index, GltfViewUse::vertices, place);
    }

    /// Nobody has to read a custom attribute.
    void tell_format(std::size_t index, const std::string& allowed, bool is_custom, const GltfPlace& place) {
        const std::string format = gltf_format_text(layout_.accessors[index].format);
        if (is_custom) {
            faults_.note(place.text(), "accessor {} is {}; it may be {}", index, format, allowed);
        } else {
            faults_.fatal(place.text(), "accessor {} is {}; it must be {}", index, format, allowed);
        }
    }

    void check_sets(const AttributeSets& sets, const GltfPlace& place) {
        for (std::size_t kind = 0; kind + 1 < gltf_attribute_kinds; ++kind) {
            if (sets.counts[kind] == sets.ends[kind]) continue;
            faults_.note(place.text(), "attributes of one kind are numbered from 0 without a gap; here {} go up to {}",
                         sets.counts[kind], sets.ends[kind] - 1);
        }
        const std::size_t joints = sets.count(GltfAttributeKind::joints), weights = sets.count(GltfAttributeKind::weights);
        if (joints != weights) faults_.note(place.text(), "has {} JOINTS and {} WEIGHTS", joints, weights);
    }

    void check_indices(const json& primitive, const GltfPlace& place) {
        const auto index = gltf_find_whole(primitive, "indices");
        if (!index) return;
        const GltfPlace at(place, "indices");
        uses_.use(*index, GltfViewUse::indices, at);
        const GltfFormat& format = layout_.accessors[*index].format;
        const bool is_unsigned = format.component == GltfComponent::uint8 || format.component == GltfComponent::uint16 ||
                                 format.component == GltfComponent::uint32;
        if (is_unsigned && format.components() == 1 && !format.is_normalized) return;
        faults_.fatal(at.text(), "accessor {} is {}; it must be SCALAR of uint8, uint16 or uint32", *index,
                      gltf_format_text(format));
    }

    void check_targets(const json& primitive, const json& attributes, std::size_t vertices, const GltfPlace& place) {
        const json& targets = gltf_list(primitive, "targets");
        const GltfPlace list(place, "targets");
        for (std::size_t i = 0; i < targets.size(); ++i) {
            const GltfPlace target(list, i);
            for (const auto& [name, index] : targets[i].items()) {
                if (faults_.is_done()) return;
                const GltfPlace at(target, name);
                check_attribute(name, *gltf_whole_number(index), vertices, {.is_target = true, .is_quantized = is_quantized_},
                                at);
                if (attributes.contains(name)) continue;
                faults_.note(at.text(), "the primitive has no {} to add it to", for_message(name));
            }
        }
    }

    void check_material(const json& primitive, const AttributeSets& sets, const GltfPlace& place) {
        const auto material = gltf_find_whole(primitive, "material");
        if (!material) return;
        const GltfMaterialNeeds& needs = materials_[*material];
        const std::size_t texcoords = sets.count(GltfAttributeKind::texcoord);
        if (texcoords < needs.texcoord_sets) {
            faults_.note(place.text() + "/material", "material {} needs TEXCOORD_{}; the primitive has {} of them", *material,
                         needs.texcoord_sets - 1, texcoords);
        }
        const bool has_tangents =
            sets.count(GltfAttributeKind::normal) > 0 && sets.count(GltfAttributeKind::tangent) > 0;
        if (!needs.has_tangent_space && !has_tangents) {
            faults_.note(place.text() + "/material", "material {} needs NORMAL and TANGENT, or a normal texture of its own",
                         *material);
        }
    }

    void check_variants(const json& primitive, const GltfPlace& place) {
        const json* extension = gltf_extension(primitive, "KHR_materials_variants");
        if (!extension) return;
        std::unordered_set<std::size_t> seen;
        for (const json& mapping : gltf_list(*extension, "mappings")) {
            for (const json& entry : gltf_list(mapping, "variants")) {
                const std::size_t variant = *gltf_whole_number(entry);
                if (seen.insert(variant).second) continue;
                faults_.note(place.text() + "/extensions/KHR_materials_variants", "variant {} has two materials", variant);
            }
        }
    }

    const GltfLayout& layout_;
    GltfViewUses& uses_;
    GltfFaults& faults_;
    std::vector<GltfMaterialNeeds> materials_;
    bool is_quantized_ = false;
};

}  // namespace

void check_gltf_meshes(const json& document, const GltfLayout& layout, GltfViewUses& uses, GltfFaults& faults) {
    Meshes meshes(document, layout, uses, faults);
    const json& list = gltf_list(document, "meshes");
    const GltfPlace root, place(root, "meshes");
    for (std::size_t i = 0; i < list.size() && !faults.is_done(); ++i) meshes.check_mesh(list[i], GltfPlace(place, i));
}

}  // namespace sl
