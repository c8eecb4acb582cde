// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/passes/frame_input.h"

namespace sl {

/// What the camera sees, before light.
struct GBuffer {
    ImageId albedo;    ///< srgb8: base colour
    ImageId normal;    ///< rg16: octahedral, 0..1; what light sees, with normal textures
    ImageId material;  ///< rgba8: roughness, metallic, specular
    ImageId emission;  ///< rgba16f: nit
    ImageId depth;     ///< reversed: near / distance; 0 is the background
    ImageId vertex_normal;  ///< as `normal`, and the same image where no normal texture is in view: without those
};

/// Draws what is in view, nearest first.
GBuffer gbuffer(const FrameInput& frame);

}  // namespace sl
