// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/passes/gbuffer.h"

namespace sl {

/// Radiance towards the camera (nit, rgba32f). `irradiance` may be of any size from 1×1; it is read per pixel, clamped.
ImageId compose(const FrameInput& frame, const GBuffer& gbuffer, ImageId direct, ImageId irradiance);

/// Exposes, as the camera says or as the picture asks for, and applies the filmic curve: rgba8, sRGB-encoded, luma in alpha.
ImageId tonemap(const FrameInput& frame, ImageId hdr);

/// Smooths edges of the tonemapped picture.
ImageId antialias(const FrameInput& frame, ImageId ldr);

}  // namespace sl
