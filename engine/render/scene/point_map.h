// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/render/scene/sun_map.h"
#include "shared/frame.h"

namespace sl {

/// Layers of a point light's shadow map: faces of a cube that stands along the world's axes, numbered as by point_face in
/// shared/lights.h.
inline constexpr std::uint32_t point_face_count = 6;

/// Tangent of half a face's angle: a right angle, and a texel of its neighbours round it.
float point_face_tangent(const RenderScene::Light& light);
/// Distance of the faces' near planes, m. What lies beyond the light's range does not change it.
float point_near_plane(const RenderScene& scene, const RenderScene::Light& light);

/// The six layers as they are to be for a picture of `frame`: with what stands in the light's range, and `in_view` where some of
/// that may be seen. Layers out of view have neither key nor draws.
std::vector<ShadowLayer> point_faces(const RenderScene& scene, const RenderScene::Light& light, const FrameParams& frame);

}  // namespace sl
