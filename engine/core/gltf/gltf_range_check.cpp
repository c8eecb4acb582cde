// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_range_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "engine/core/gltf/gltf_value.h"

namespace sl {

using nlohmann::json;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A bound is written in decimals and meant in the component's type.
double as_stored(double bound, GltfComponent component) {
    if (component != GltfComponent::float32 || std::abs(bound) > std::numeric_limits<float>::max()) return bound;
    return static_cast<double>(static_cast<float>(bound));
}

class Ranges {
  public:
    Ranges(const json& document, const GltfLayout& layout, GltfElements::Buffers buffers, GltfFaults& faults)
        : accessors_(gltf_list(document, "accessors")), layout_(layout), buffers_(buffers), faults_(faults) {}

    std::optional<GltfRange> check(std::size_t index) {
        const auto elements = GltfElements::read(layout_, buffers_, index);
        if (!elements) return std::nullopt;
        if (layout_.accessors[index].sparse) check_replaced(index);
        GltfRange range;
        range.least.fill(infinity);
        range.most.fill(-infinity);
        const std::size_t components = elements->components();
        std::size_t wrong = 0, first_wrong = 0;
        elements->each_stored([&](std::size_t i, std::size_t k, double number) {
            if (!std::isfinite(number)) {
                if (wrong++ == 0) first_wrong = i;
                return;
            }
            range.least[k] = std::min(range.least[k], number);
            range.most[k] = std::max(range.most[k], number);
        });
        if (wrong > 0) {
            faults_.note(fmt::format("/accessors/{}", index), "{} components are no finite numbers, first in element {}", wrong,
                         first_wrong);
        } else {
            check_bound(index, "min", range.least, components);
            check_bound(index, "max", range.most, components);
        }
        range.greatest = *std::max_element(range.most.begin(), range.most.begin() + static_cast<std::ptrdiff_t>(components));
        return range;
    }

  private:
    void check_bound(std::size_t index, std::string_view name, const std::array<double, 16>& found, std::size_t components) {
        const auto bound = accessors_[index].find(name);
        if (bound == accessors_[index].end() || bound->size() != components) return;
        for (std::size_t k = 0; k < components; ++k) {
            const double told = (*bound)[k].get<double>();
            if (as_stored(told, layout_.accessors[index].format.component) == found[k]) continue;
            faults_.note(fmt::format("/accessors/{}/{}/{}", index, name, k), "is {}; the elements' is {}", told, found[k]);
        }
    }

    void check_replaced(std::size_t index) {
        const GltfAccessor& accessor = layout_.accessors[index];
        const GltfSparse& sparse = *accessor.sparse;
        const GltfView& view = layout_.views[sparse.index_view];
        const auto bytes = buffers_[view.buffer].subspan(view.offset + sparse.index_offset);
        const std::size_t step = gltf_component_bytes(sparse.index_component);
        const auto where = [&] { return fmt::format("/accessors/{}/sparse/indices", index); };
        double last = -1.0;
        for (std::size_t i = 0; i < sparse.count; ++i) {
            const double at = read_gltf_number(&bytes[i * step], sparse.index_component);
            if (at >= static_cast<double>(accessor.count)) {
                faults_.fatal(where(), "number {} is {}, in an accessor of {} elements", i, at, accessor.count);
                return;
            }
            if (at <= last) {
                faults_.note(where(), "number {} is {}, after {}: they must rise", i, at, last);
                return;
            }
            last = at;
        }
    }

    const json& accessors_;
    const GltfLayout& layout_;
    GltfElements::Buffers buffers_;
    GltfFaults& faults_;
};

}  // namespace

std::vector<std::optional<GltfRange>> check_gltf_ranges(const json& document, const GltfLayout& layout,
                                                        GltfElements::Buffers buffers, GltfFaults& faults) {
    Ranges check(document, layout, buffers, faults);
    std::vector<std::optional<GltfRange>> ranges(layout.accessors.size());
    for (std::size_t i = 0; i < ranges.size() && !faults.is_done(); ++i) ranges[i] = check.check(i);
    return ranges;
}

}  // namespace sl
