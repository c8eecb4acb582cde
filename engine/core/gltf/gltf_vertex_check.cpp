// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_vertex_check.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/core/gltf/gltf_attribute.h"
#include "engine/core/gltf/gltf_tolerance.h"
#include "engine/core/gltf/gltf_value.h"

namespace sl {

using nlohmann::json;

namespace {

/// Sets of joints and weights that are read: one accessor may be named for many.
constexpr std::size_t most_sets = 8;

class Vertices {
  public:
    Vertices(const GltfLayout& layout, GltfElements::Buffers buffers, GltfFaults& faults)
        : layout_(layout), buffers_(buffers), faults_(faults), checked_(layout.accessors.size()) {}

    void check(const json& primitive, const GltfPlace& place) {
        const GltfPlace list(place, "attributes");
        const json& attributes = gltf_part(primitive, "attributes");
        for (const auto& [name, index] : attributes.items()) {
            if (!faults_.takes_notes()) return;
            const auto attribute = read_gltf_attribute(name);
            if (attribute) check_attribute(attribute->kind, *gltf_whole_number(index), GltfPlace(list, name));
        }
        check_skinning(attributes, list);
    }

  private:
    /// Each accessor once as what it is, however many primitives share it.
    bool is_new(GltfAttributeKind kind, std::size_t accessor) {
        const auto bit = static_cast<std::uint8_t>(1u << static_cast<unsigned>(kind));
        if ((checked_[accessor] & bit) != 0) return false;
        checked_[accessor] |= bit;
        return true;
    }

    void check_attribute(GltfAttributeKind kind, std::size_t accessor, const GltfPlace& place) {
        using enum GltfAttributeKind;
        const bool is_asked = kind == normal || kind == tangent || kind == colour;
        if (!is_asked || !is_new(kind, accessor)) return;
        const auto elements = GltfElements::read(layout_, buffers_, accessor);
        if (!elements) return;
        if (kind == colour) {
            check_colours(*elements, accessor, place);
            return;
        }
        check_unit(*elements, accessor, place);
        if (kind == tangent) check_hands(*elements, accessor, place);
    }

    void check_unit(const GltfElements& elements, std::size_t accessor, const GltfPlace& place) {
        for (std::size_t i = 0; i < elements.count(); ++i) {
            const double x = elements.value(i, 0), y = elements.value(i, 1), z = elements.value(i, 2);
            const double length = std::sqrt(x * x + y * y + z * z);
            if (std::abs(length - 1.0) <= gltf_tolerance::unit_vector) continue;
            faults_.note(place.text(), "element {} of accessor {} has the length {}, not 1", i, accessor, length);
            return;
        }
    }

    void check_hands(const GltfElements& elements, std::size_t accessor, const GltfPlace& place) {
        for (std::size_t i = 0; i < elements.count(); ++i) {
            const double hand = elements.value(i, 3);
            if (std::abs(hand) == 1.0) continue;
            faults_.note(place.text(), "the fourth component of element {} of accessor {} is {}, not 1 or -1", i, accessor, hand);
            return;
        }
    }

    void check_colours(const GltfElements& elements, std::size_t accessor, const GltfPlace& place) {
        for (std::size_t i = 0; i < elements.count(); ++i) {
            for (std::size_t k = 0; k < elements.components(); ++k) {
                const double part = elements.value(i, k);
                if (part >= 0.0 && part <= 1.0) continue;
                faults_.note(place.text(), "element {} of accessor {} holds {}, not between 0 and 1", i, accessor, part);
                return;
            }
        }
    }

    struct Skinning {
        std::vector<GltfElements> joints, weights;
        std::size_t count = 0;
    };

    /// Empty where a part of it is missing, or was read before: primitives that share some weights are taken to share all.
    Skinning read_skinning(const json& attributes) {
        Skinning skinning;
        for (std::size_t set = 0; set < most_sets; ++set) {
            const auto joint = attributes.find(fmt::format("JOINTS_{}", set));
            const auto weight = attributes.find(fmt::format("WEIGHTS_{}", set));
            if (joint == attributes.end() || weight == attributes.end()) break;
            const std::size_t weight_accessor = *gltf_whole_number(*weight);
            if (!is_new(GltfAttributeKind::weights, weight_accessor)) return {};
            auto joints = GltfElements::read(layout_, buffers_, *gltf_whole_number(*joint));
            auto weights = GltfElements::read(layout_, buffers_, weight_accessor);
            if (!joints || !weights) return {};
            const std::size_t count = std::min(joints->count(), weights->count());
            skinning.count = set == 0 ? count : std::min(skinning.count, count);
            skinning.joints.push_back(std::move(*joints));
            skinning.weights.push_back(std::move(*weights));
        }
        return skinning;
    }

    /// The first vertex with each kind of fault.
    void check_skinning(const json& attributes, const GltfPlace& place) {
        const Skinning skinning = read_skinning(attributes);
        bool has_negative = false, has_sum = false, has_twin = false;
        std::vector<double> moved;
        for (std::size_t i = 0; i < skinning.count; ++i) {
            double sum = 0.0;
            moved.clear();
            for (std::size_t set = 0; set < skinning.joints.size(); ++set) {
                for (std::size_t k = 0; k < 4; ++k) {
                    const double weight = skinning.weights[set].value(i, k);
                    sum += weight;
                    if (weight < 0.0 && !std::exchange(has_negative, true)) {
                        faults_.note(place.text(), "vertex {} has the weight {} in WEIGHTS_{}", i, weight, set);
                    }
                    if (weight != 0.0) moved.push_back(skinning.joints[set].stored(i, k));
                }
            }
            const double tolerance = gltf_tolerance::weight_sum * static_cast<double>(std::max<std::size_t>(moved.size(), 1));
            if (!(std::abs(sum - 1.0) <= tolerance) && !std::exchange(has_sum, true)) {
                faults_.note(place.text(), "the weights of vertex {} sum to {}, not 1", i, sum);
            }
            std::sort(moved.begin(), moved.end());
            const auto twin = std::adjacent_find(moved.begin(), moved.end());
            if (twin != moved.end() && !std::exchange(has_twin, true)) {
                faults_.note(place.text(), "vertex {} hangs on joint {} twice", i, *twin);
            }
        }
    }

    const GltfLayout& layout_;
    GltfElements::Buffers buffers_;
    GltfFaults& faults_;
    std::vector<std::uint8_t> checked_;
};

}  // namespace

void check_gltf_vertices(const json& document, const GltfLayout& layout, GltfElements::Buffers buffers, GltfFaults& faults) {
    Vertices vertices(layout, buffers, faults);
    const json& meshes = gltf_list(document, "meshes");
    const GltfPlace root, list(root, "meshes");
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const GltfPlace mesh(list, i), primitive_list(mesh, "primitives");
        const json& primitives = gltf_list(meshes[i], "primitives");
        for (std::size_t k = 0; k < primitives.size() && faults.takes_notes(); ++k) {
            vertices.check(primitives[k], GltfPlace(primitive_list, k));
        }
    }
}

}  // namespace sl
