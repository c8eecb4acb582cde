// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/passes/frame_input.h"

namespace sl {

/// Reflective shadow maps (Dachsbacher & Stamminger 2005) of all lights that bounce, a layer each; drawn again only
/// when the light or what it sees has changed.
struct Rsm {
    ImageId position;  ///< rgba32f array: m; a: patch area, m²
    ImageId flux;      ///< rgba32f array: lumen; a: packed normal
    std::uint32_t size = 0;
    std::uint32_t layers = 0;
    std::uint64_t key = 0;  ///< hash of everything the maps are made from
};

/// Pulls the maps at a size; `layers` is 0 when no light bounces.
Rsm rsm(const FrameInput& frame, std::uint32_t size);

}  // namespace sl
