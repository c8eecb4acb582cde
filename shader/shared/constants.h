// SPDX-License-Identifier: MIT
#pragma once

#include "shared/prelude.h"

SHARED_BEGIN

const float shared_pi = 3.14159265358979f;

const uint light_directional = 0u;
const uint light_spot = 1u;
const uint light_point = 2u;

/// In a light's shadow or RSM layer: it has none.
const uint no_layer = 0xffffffffu;
/// In a material's texture: it has none.
const uint no_texture = 0xffffffffu;

SHARED_END
