// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/graph/frame_graph.h"
#include "engine/render/scene/upload.h"
#include "shared/frame.h"

namespace sl {

/// What every pass of a frame may draw on.
struct FrameInput {
    FrameGraph& graph;
    const RenderScene& scene;
    const LightTable& lights;
    const SceneInputs& inputs;
    FrameParams params;
    std::uint32_t width = 1;
    std::uint32_t height = 1;
    /// How many steps of sliced work may run this frame; a window keeps this small, a capture finishes everything.
    std::uint32_t slice_budget = ~0u;

    TextureDesc screen(Format format) const { return {.width = width, .height = height, .format = format}; }
};

/// Fills the block that all passes read. `view` must be there.
FrameParams frame_params(const RenderScene& scene, std::uint32_t width, std::uint32_t height, std::uint32_t frame_index);

}  // namespace sl
