// SPDX-License-Identifier: MIT
#pragma once

#include <imgui.h>

#include <optional>

#include "engine/ecs/components/camera.h"
#include "engine/ecs/components/transform.h"

namespace sl {

/// Where things in the world are on the screen, for lines over the picture.
class Projection {
  public:
    Projection(const Camera& camera, const WorldTransform& place);

    /// Draws the part of a line that is before the camera, behind all widgets.
    void line(const dvec3& from, const dvec3& to, ImU32 colour, float width) const;
    /// None behind the camera.
    std::optional<ImVec2> at(const dvec3& point) const;

  private:
    vec3 from_eye(const dvec3& point) const;
    ImVec2 on_screen(const vec3& from_eye) const;

    WorldTransform place_;
    float near_, focal_;
    ImVec2 centre_;
};

}  // namespace sl
