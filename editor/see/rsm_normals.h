// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/image.h"

namespace sl {

/// Names of the normals of reflective shadow maps, which are no image of their own, and of the image that holds them.
inline constexpr const char* rsm_normal_image = "rsm_normal";
inline constexpr const char* rsm_flux_image = "rsm_flux";

/// The normals in a map's flux, as the G-buffer encodes its own.
Image rsm_normals(const Image& flux);

}  // namespace sl
