// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "engine/core/gltf/gltf_file.h"
#include "engine/core/gltf/gltf_layout.h"
#include "engine/core/gltf/gltf_resources.h"

namespace sl {

/// A file with all that it needs, and all that is wrong with it. Where a fault is fatal, everything behind it may be
/// missing.
struct GltfChecked {
    GltfFile file;
    GltfLayout layout;
    GltfResources resources;
    GltfFaults faults;
};

/// The whole sequence: container, structure, meaning, buffers, data, images. Each step only follows where the one before
/// it has no fatal fault. Throws nothing but std::bad_alloc; takes time in proportion to what it
/// reads. `supported` is as for check_gltf_structure; `bytes` must outlive what is returned.
GltfChecked check_gltf(std::span<const std::byte> bytes, const GltfLoad& load,
                       std::span<const std::string_view> supported = {});

}  // namespace sl
