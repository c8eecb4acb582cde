// SPDX-License-Identifier: MIT
#include "editor/imgui_rotation.h"

#include <gtest/gtest.h>

#include "engine/core/field_random.h"

namespace sl {
namespace {

quat rotation_of(const YawPitchRoll& angles) {
    return glm::angleAxis(angles.yaw, vec3(0, 1, 0)) * glm::angleAxis(angles.pitch, vec3(1, 0, 0)) *
           glm::angleAxis(angles.roll, vec3(0, 0, 1));
}

float angle_between(const quat& a, const quat& b) {
    return 2.0f * std::acos(std::min(1.0f, std::abs(glm::dot(a, b))));
}

TEST(ImguiRotation, AnglesAreReadBack) {
    const YawPitchRoll angles = yaw_pitch_roll(rotation_of({0.4f, -0.9f, 2.0f}));
    EXPECT_NEAR(angles.yaw, 0.4f, 1e-5f);
    EXPECT_NEAR(angles.pitch, -0.9f, 1e-5f);
    EXPECT_NEAR(angles.roll, 2.0f, 1e-5f);
}

TEST(ImguiRotation, AnglesGiveTheRotationAlsoStraightUpAndDown) {
    RandomFields random(7);
    for (int i = 0; i < 1000; ++i) {
        quat rotation;
        random.field("rotation", rotation, {});
        if (i % 10 == 0)
            rotation = rotation_of({static_cast<float>(i), i % 20 == 0 ? 0.5f * pi : -0.5f * pi, 0.3f});
        EXPECT_LT(angle_between(rotation_of(yaw_pitch_roll(rotation)), rotation), 5e-3f) << i;
    }
}

TEST(ImguiRotation, AStepRaisesOneAngle) {
    const YawPitchRoll from{0.4f, -0.9f, 2.0f};
    const quat start = rotation_of(from);
    EXPECT_LT(angle_between(turned(start, {0.1f, 0, 0}), rotation_of({0.5f, -0.9f, 2.0f})), 1e-3f);
    EXPECT_LT(angle_between(turned(start, {0, 0.1f, 0}), rotation_of({0.4f, -0.8f, 2.0f})), 1e-3f);
    EXPECT_LT(angle_between(turned(start, {0, 0, 0.1f}), rotation_of({0.4f, -0.9f, 2.1f})), 1e-3f);
}

TEST(ImguiRotation, StepsTurnSteadilyThroughStraightUp) {
    quat rotation = rotation_of({0.2f, 1.5f, 0.0f});
    for (int i = 0; i < 20; ++i) {
        const quat next = turned(rotation, {0, 0.02f, 0});
        EXPECT_NEAR(angle_between(rotation, next), 0.02f, 5e-3f) << i;
        EXPECT_NEAR(glm::length(next), 1.0f, 1e-5f);
        rotation = next;
    }
}

}  // namespace
}  // namespace sl
