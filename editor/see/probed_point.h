// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "engine/ecs/entity.h"
#include "engine/render/scene/frame_params.h"

namespace sl {

/// A point on a surface, as a G-buffer knows it.
struct ProbedPoint {
    dvec3 position{0.0};  ///< in the world, m
    vec3 normal{0, 1, 0};
    bool operator==(const ProbedPoint&) const = default;
};

/// The point under a pixel, counted from the top left, from its depth and octahedral normal; none where there is no surface.
std::optional<ProbedPoint> point_under(const FrameParams& frame, const dvec3& origin, uvec2 pixel, float depth, vec2 encoded_normal);

/// Where a frame's camera sees a place.
struct SeenAt {
    uvec2 pixel{0};         ///< from the top left
    float distance = 0.0f;  ///< along the view axis, m
};
/// None beside the picture and behind the camera.
std::optional<SeenAt> seen_at(const FrameParams& frame, const dvec3& origin, const dvec3& position);
/// Whether nothing stands before a place whose pixel has this depth.
bool is_visible(const FrameParams& frame, const SeenAt& place, float depth);

/// How far off the surface rays should begin, m: a depth buffer is not as exact as a ray.
float clearance(vec3 position);

/// The entity whose surface passes through a place, relative to the scene's origin; null where none does.
Entity entity_at(const RenderScene& scene, vec3 position);

}  // namespace sl
