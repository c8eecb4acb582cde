// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/math.h"
#include "shared/brdf.h"

namespace sl {

/// Of light that comes evenly from everywhere, the share that a surface gives back, in each of three colours: its
/// bihemispherical reflectance. A diffuse surface of that albedo gives as much, though not to the same directions; of a rough
/// metal it is far less than its colour, because light that a microfacet hides from the eye is lost (Heitz 2014).
vec3 mean_albedo(const Surface& surface);

}  // namespace sl
