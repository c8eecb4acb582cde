// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/facets/facet_cache.h"
#include "engine/render/gl/buffer.h"

namespace sl {

/// The facets of a renderer's scene, and their table on the GPU.
struct FacetLight {
    FacetCache cache;
    gl::Buffer table;
    std::uint64_t uploaded = 0;  ///< version that the GPU has
};

}  // namespace sl
