// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "engine/render/gi/gi.h"
#include "shared/view.h"

namespace sl {

/// A sum over all RSM texels, cut into slices of interleaved texels so that no draw runs for seconds. A frame runs as
/// many slices as its budget allows and the next one continues while nothing changes; a partial sum is scaled up.
struct SlicedSum {
    std::string_view name;        ///< of passes and images
    std::string_view fragment;    ///< adds one slice to output "partial"
    RsmGatherParams params{};     ///< slice is filled in
    std::uint32_t texels = 0;     ///< of all layers, in steps that the shader walks
    /// Declares what the passes read besides the G-buffer and the blocks "Frame" and "Gather".
    std::function<void(PassBuilder&)> inputs;
    /// Makes the result of a finished sum; empty: the sum times strength. Reads `inputs`, `finish_inputs` and "partial".
    std::string_view finish;
    std::function<void(PassBuilder&)> finish_inputs;
};

/// Adds the passes. When nothing changed and all slices are done, none.
GiResult sliced_sum(const FrameInput& frame, const GBuffer& gbuffer, const Rsm& rsm, const SlicedSum& sum);

}  // namespace sl
