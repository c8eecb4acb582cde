// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/fields.h"

namespace sl {

/// Where an entity stands relative to its Parent (or the world): what people edit. Translation is in double precision,
/// so that a scene 10⁶ m from the origin is as sharp as one at it.
struct Transform {
    dvec3 translation{0.0};
    quat rotation{1, 0, 0, 0};
    vec3 scale{1.0f};
};

/// world_from_local, split into an exact origin and a linear part. Written by one system, world_transform.
struct WorldTransform {
    dvec3 origin{0.0};
    mat3 linear{1.0f};
};

inline void visit_fields(FieldVisitor& visit, Transform& transform) {
    visit.field("translation", transform.translation,
                {.min = -1e7, .max = 1e7, .unit = "m", .help = "Position relative to the parent, or to the world."});
    visit.field("rotation", transform.rotation, {.help = "Unit quaternion (x, y, z, w); identity looks along -z."});
    visit.field("scale", transform.scale, {.min = -1e6, .max = 1e6, .help = "Size factor per local axis; 1 keeps the size."});
}

}  // namespace sl
