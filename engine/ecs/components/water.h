// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/mesh_data.h"

namespace sl {

/// Where water ends, drawn at the entity's WorldTransform: light passes through it unchanged, and it tints and mirrors what is
/// seen. Normals point out of the water. Made by systems, not by people, so it has no fields.
struct WaterSurface {
    MeshHandle mesh;
};

/// On a camera that is in water: all that it sees is seen through that. Made by systems.
struct InWater {};

}  // namespace sl
