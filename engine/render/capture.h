// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "engine/ecs/app.h"
#include "engine/render/renderer.h"

namespace sl {

/// How a frame is captured without a display: at a fixed time step, so that two runs give the same bytes.
struct CaptureSettings {
    std::uint32_t width = 640;
    std::uint32_t height = 360;
    std::uint32_t frame = 0;           ///< frames 0 … frame are simulated and drawn; the last is kept
    std::string show;                  ///< an image of the frame by name, "name.layer" for arrays; empty: the final picture
    bool layers = false;               ///< also read the linear layers for an EXR
    bool keep_refined = false;         ///< keep rsm_disc's picture of refined pixels readable, where there is one
    Executor::OnStep on_step{};        ///< of the last frame
};

/// What a capture leaves.
struct Capture {
    Image picture;                   ///< display-referred, what a PNG holds
    std::vector<ImageLayer> layers;  ///< linear: "" (radiance), direct, irradiance, albedo, normal, depth, shown image
    Renderer::Result result;
    bool empty = false;              ///< the scene has no camera: the picture is black
};

/// Runs the world's systems and draws. Throws Error when `show` names no image.
Capture capture(App& app, Renderer& renderer, const CaptureSettings& settings);

}  // namespace sl
