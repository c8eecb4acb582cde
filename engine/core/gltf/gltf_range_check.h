// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "engine/core/gltf/gltf_elements.h"
#include "engine/core/gltf/gltf_fault.h"

namespace sl {

/// Between which numbers the elements of an accessor lie, as stored, component by component.
struct GltfRange {
    std::array<double, 16> least{}, most{};
    /// Over all components.
    double greatest = 0.0;
};

/// The ranges of all accessors, nothing where there are no data. Tells what is no number, bounds that are wrong and
/// replaced elements that are not there.
std::vector<std::optional<GltfRange>> check_gltf_ranges(const nlohmann::json& document, const GltfLayout& layout,
                                                        GltfElements::Buffers buffers, GltfFaults& faults);

}  // namespace sl
