// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/graph/frame_graph.h"
#include "engine/render/scene/frame_params.h"
#include "engine/render/upload.h"

namespace sl {

struct FacetLight;

/// What every pass of a frame may draw on.
struct FrameInput {
    FrameGraph& graph;
    const RenderScene& scene;
    const LightTable& lights;
    const SceneInputs& inputs;
    FacetLight& facets;  ///< what the method facets keeps between frames
    FrameParams params;
    std::uint32_t width = 1;
    std::uint32_t height = 1;
    /// How many steps of sliced work may run this frame; a window keeps this small, a capture finishes everything.
    std::uint32_t slice_budget = ~0u;
    /// What the passes for GI took on the GPU when that was last known; 0 where nobody times them.
    double gi_gpu_seconds = 0.0;
    float seconds = 1.0f / 60.0f;  ///< since the last frame
    double time = 0.0;             ///< s; what moves by itself moves by it

    /// An image of the size of the picture.
    TextureDesc screen(Format format) const { return {.width = width, .height = height, .format = format}; }
};

}  // namespace sl
