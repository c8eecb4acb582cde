// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "engine/render/trace/samples.h"
#include "engine/render/trace/transport_world.h"

namespace sl {

/// From a surface point to a light: what it meets is in the way.
Ray shadow_ray(const LightParams& light, const SurfacePoint& point);

/// Irradiance straight from directional, spot and point lights and from glowing surfaces, lux. Up to four lights are asked
/// each whether something stands before them; of more, four are drawn by what they would bring, and one point of all glowing
/// surfaces: the mean over `samples` is right. Lights with a 1 in `without` are left out; it may be empty.
vec3 direct_irradiance(const TransportWorld& world, const SurfacePoint& point, SampleSequence samples, std::span<const char> without = {});

}  // namespace sl
