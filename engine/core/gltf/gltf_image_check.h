// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <vector>

#include "engine/core/gltf/gltf_fault.h"

namespace sl {

/// Headers of images against what the document says of them. Nothing here is fatal: a model can be shown without a
/// picture. `images` holds the undecoded bytes of each, or nothing where they are not known.
void check_gltf_images(const nlohmann::json& document, std::span<const std::span<const std::byte>> images,
                       GltfFaults& faults);

}  // namespace sl
