// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_animation_check.h"

#include <set>

#include "engine/core/closest_name.h"
#include "engine/core/gltf/gltf_value.h"

namespace sl {

using nlohmann::json;

namespace {

/// float32, or whole numbers that stand for fractions.
bool is_fraction(const GltfFormat& format) {
    if (format.component == GltfComponent::float32) return !format.is_normalized;
    return format.is_normalized && format.component != GltfComponent::uint32;
}

/// What the values of a path must be; empty where they are.
std::string_view format_fault(std::string_view path, const GltfFormat& format) {
    const bool is_column = format.columns == 1;
    if (path == "translation" || path == "scale") {
        return format == GltfFormat{GltfComponent::float32, 1, 3} ? "" : "VEC3 of float32";
    }
    if (path == "rotation") {
        return is_column && format.rows == 4 && is_fraction(format) ? "" : "VEC4 of float32 or of a normalized type";
    }
    if (path == "weights") {
        return is_column && format.rows == 1 && is_fraction(format) ? "" : "SCALAR of float32 or of a normalized type";
    }
    return "";
}

class Animations {
  public:
    Animations(const json& document, const GltfLayout& layout, GltfViewUses& uses, GltfFaults& faults)
        : document_(document), layout_(layout), uses_(uses), faults_(faults) {}

    void check(const json& animation, const GltfPlace& place) {
        const json& samplers = gltf_list(animation, "samplers");
        const GltfPlace sampler_list(place, "samplers");
        for (std::size_t i = 0; i < samplers.size() && !faults_.is_done(); ++i) {
            check_sampler(samplers[i], GltfPlace(sampler_list, i));
        }
        const json& channels = gltf_list(animation, "channels");
        const GltfPlace channel_list(place, "channels");
        std::set<std::pair<std::size_t, std::string_view>> moved;
        for (std::size_t i = 0; i < channels.size() && !faults_.is_done(); ++i) {
            const GltfPlace at(channel_list, i);
            const json& target = gltf_part(channels[i], "target");
            check_target(target, at);
            const auto node = gltf_find_whole(target, "node");
            const std::string_view path = gltf_text_at(target, "path");
            if (node && !moved.emplace(*node, path).second) {
                faults_.note(at.text() + "/target", "another channel moves the {} of node {} already", for_message(path), *node);
            }
            check_values(samplers[*gltf_find_whole(channels[i], "sampler")], path, node, at);
        }
    }

  private:
    void check_sampler(const json& sampler, const GltfPlace& place) {
        const std::size_t index = *gltf_find_whole(sampler, "input");
        const GltfPlace input(place, "input");
        const GltfAccessor& times = layout_.accessors[index];
        uses_.use(index, GltfViewUse::other, input);
        uses_.use(*gltf_find_whole(sampler, "output"), GltfViewUse::other, GltfPlace(place, "output"));
        if (times.format != GltfFormat{GltfComponent::float32, 1, 1}) {
            faults_.fatal(input.text(), "accessor {} is {}; it must be SCALAR of float32", index, gltf_format_text(times.format));
        }
        if (!times.has_bounds) faults_.note(input.text(), "accessor {} has no min and max, which key times need", index);
        if (is_cubic(sampler) && times.count < 2) {
            faults_.note(input.text(), "accessor {} has a single key; CUBICSPLINE needs two", index);
        }
    }

    static bool is_cubic(const json& sampler) { return gltf_text_at(sampler, "interpolation") == "CUBICSPLINE"; }

    void check_target(const json& target, const GltfPlace& place) {
        const auto node = gltf_find_whole(target, "node");
        const std::string_view path = gltf_text_at(target, "path");
        if (gltf_extension(target, "KHR_animation_pointer")) {
            if (node) faults_.note(place.text() + "/target/node", "must be left out beside KHR_animation_pointer");
            if (path != "pointer") {
                faults_.note(place.text() + "/target/path", "is '{}'; beside KHR_animation_pointer it must be 'pointer'",
                             for_message(path));
            }
            return;
        }
        if (!node) return;
        if (path == "weights") {
            if (targets_of(*node) == 0) faults_.note(place.text() + "/target", "node {} has no morph targets", *node);
        } else if (gltf_list(document_, "nodes")[*node].contains("matrix")) {
            faults_.note(place.text() + "/target", "node {} has a matrix; only translation, rotation and scale can be moved",
                         *node);
        }
    }

    std::size_t targets_of(std::size_t node) const {
        const auto mesh = gltf_find_whole(gltf_list(document_, "nodes")[node], "mesh");
        if (!mesh) return 0;
        const json& primitives = gltf_list(gltf_list(document_, "meshes")[*mesh], "primitives");
        return primitives.empty() ? 0 : gltf_list(primitives[0], "targets").size();
    }

    void check_values(const json& sampler, std::string_view path, std::optional<std::size_t> node, const GltfPlace& place) {
        const bool is_known = path == "translation" || path == "rotation" || path == "scale" || path == "weights";
        if (!is_known) return;
        const std::size_t index = *gltf_find_whole(sampler, "output");
        const GltfAccessor& values = layout_.accessors[index];
        if (const std::string_view must_be = format_fault(path, values.format); !must_be.empty()) {
            faults_.fatal(place.text(), "accessor {} is {}; for {} it must be {}", index, gltf_format_text(values.format),
                          path, must_be);
        }
        if (path == "weights" && (!node || targets_of(*node) == 0)) return;
        const std::size_t keys = layout_.accessors[*gltf_find_whole(sampler, "input")].count;
        const std::size_t per_key = (is_cubic(sampler) ? 3 : 1) * (path == "weights" ? targets_of(*node) : 1);
        const std::size_t wanted = saturated_product(keys, per_key);
        if (values.count == wanted) return;
        constexpr std::string_view text = "accessor {} has {} values; {} keys need {}";
        if (values.count < wanted) {
            faults_.fatal(place.text(), text, index, values.count, keys, wanted);
        } else {
            faults_.note(place.text(), text, index, values.count, keys, wanted);
        }
    }

    static std::size_t saturated_product(std::size_t a, std::size_t b) {
        return b != 0 && a > SIZE_MAX / b ? SIZE_MAX : a * b;
    }

    const json& document_;
    const GltfLayout& layout_;
    GltfViewUses& uses_;
    GltfFaults& faults_;
};

}  // namespace

void check_gltf_animations(const json& document, const GltfLayout& layout, GltfViewUses& uses, GltfFaults& faults) {
    Animations animations(document, layout, uses, faults);
    const json& list = gltf_list(document, "animations");
    const GltfPlace root, place(root, "animations");
    for (std::size_t i = 0; i < list.size() && !faults.is_done(); ++i) animations.check(list[i], GltfPlace(place, i));
}

}  // namespace sl
