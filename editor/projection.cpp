// SPDX-License-Identifier: MIT
#include "editor/projection.h"

#include <cmath>

namespace sl {

Projection::Projection(const Camera& camera, const WorldTransform& place) : place_(place), near_(lens_of(camera).near) {
    const Lens lens = lens_of(camera);
    place_.origin += dvec3(place.linear * vec3(0, 0, lens.behind));
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    centre_ = screen.GetCenter();
    focal_ = 0.5f * screen.Size.y / std::tan(0.5f * lens.fov_y);
}

void Projection::line(const dvec3& from, const dvec3& to, ImU32 colour, float width) const {
    vec3 a = from_eye(from), b = from_eye(to);
    if (-a.z < -b.z) std::swap(a, b);
    if (-a.z <= near_) return;
    if (-b.z < near_) b = glm::mix(a, b, (a.z + near_) / (a.z - b.z));
    ImGui::GetBackgroundDrawList()->AddLine(on_screen(a), on_screen(b), colour, width);
}

std::optional<ImVec2> Projection::at(const dvec3& point) const {
    const vec3 seen = from_eye(point);
    return -seen.z > near_ ? std::optional(on_screen(seen)) : std::nullopt;
}

vec3 Projection::from_eye(const dvec3& point) const {
    return glm::transpose(place_.linear) * vec3(point - place_.origin);
}

ImVec2 Projection::on_screen(const vec3& from_eye) const {
    return {centre_.x - focal_ * from_eye.x / from_eye.z, centre_.y + focal_ * from_eye.y / from_eye.z};
}

}  // namespace sl
