// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "engine/render/gi/gi.h"

namespace sl {

/// A frame's images that people ask for; all handles are of this frame's graph.
struct FrameOutput {
    ImageId final;       ///< rgba8, sRGB-encoded: what is shown
    ImageId hdr;         ///< rgba32f, nit; as if there were no water
    ImageId direct;      ///< rgba32f, nit
    ImageId irradiance;  ///< rgba32f, lux, indirect
    GBuffer gbuffer;
    float gi_progress = 1.0f;
    double gi_traced_seconds = 0.0;  ///< of the frame, spent by the CPU on tracing light
    std::optional<float> gi_error;   ///< standard error of sampling, over the irradiance, where the method knows it
    bool next_suns_are_drawn = false;  ///< the maps of suns that are about to move
};

/// A pass that a program adds: takes what the frame has made and the picture so far (nit, rgba32f, not exposed yet), adds to
/// frame.graph what it needs, and returns the picture that goes on.
using PicturePass = std::function<ImageId(const FrameInput& frame, const FrameOutput& made, ImageId picture)>;

/// The group of all passes that the GI method asked for.
inline constexpr std::string_view gi_group = "gi";

/// The table of contents of a frame. No GL: each line takes image handles and returns image handles, and a pass exists
/// because a later line asked for what it makes. `added` run in their order before the picture is exposed.
FrameOutput build_frame(const FrameInput& frame, std::span<const PicturePass> added);

}  // namespace sl
