// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/renderer.h"

namespace sl {

/// Makes the frame keep what linear_layers reads.
void want_linear_layers(Renderer::Request& request);
/// The frame's linear images for an EXR: "" (radiance), direct, irradiance, albedo, normal, depth.
std::vector<ImageLayer> linear_layers(const Renderer& renderer, const FrameOutput& images);

/// The first three channels.
Image without_alpha(const Image& image);
/// Without indirect light a frame holds one black pixel of it; people get a black picture of the right size.
Image at_least(Image image, uvec2 size);
/// Unit vectors of the G-buffer's octahedral normals.
Image decoded_normals(const Image& encoded);

}  // namespace sl
