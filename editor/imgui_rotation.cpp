// SPDX-License-Identifier: MIT
#include "editor/imgui_rotation.h"

#include <imgui.h>

namespace sl {

YawPitchRoll yaw_pitch_roll(const quat& rotation) {
    const mat3 m = glm::mat3_cast(rotation);  // columns are the turned axes
    YawPitchRoll angles;
    angles.pitch = std::asin(glm::clamp(-m[2].y, -1.0f, 1.0f));
    if (std::abs(m[2].y) > 0.99999f) {
        angles.yaw = std::atan2(-m[0].z, m[0].x);
        return angles;
    }
    angles.yaw = std::atan2(m[2].x, m[2].z);
    angles.roll = std::atan2(m[0].y, m[1].y);
    return angles;
}

quat turned(const quat& rotation, const YawPitchRoll& step) {
    const float yaw = yaw_pitch_roll(rotation).yaw;
    const vec3 level_x(std::cos(yaw), 0.0f, -std::sin(yaw));
    const quat pitched = glm::angleAxis(step.pitch, level_x) * rotation;
    const quat yawed = glm::angleAxis(step.yaw, vec3(0, 1, 0)) * pitched;
    return glm::normalize(yawed * glm::angleAxis(step.roll, vec3(0, 0, 1)));
}

bool edit_rotation(quat& rotation) {
    const YawPitchRoll before = yaw_pitch_roll(rotation);
    vec3 shown = glm::degrees(vec3(before.yaw, before.pitch, before.roll));
    const vec3 drawn = shown;
    if (!ImGui::DragFloat3("##value", &shown.x, 0.5f, 0.0f, 0.0f, "%.4g")) return false;
    const vec3 step = glm::radians(shown - drawn);
    rotation = turned(rotation, {step.x, step.y, step.z});
    return true;
}

}  // namespace sl
