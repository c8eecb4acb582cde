// SPDX-License-Identifier: MIT
#include "engine/ecs/systems/sun_direction.h"

#include <gtest/gtest.h>

#include "engine/ecs/systems/engine_systems.h"

namespace sl {
namespace {

/// Where the sun stands, seen from the ground.
vec3 to_sun(float azimuth, float elevation) {
    return -(sun_rotation({.azimuth = azimuth, .elevation = elevation}) * vec3(0, 0, -1));
}

void expect_near(vec3 a, vec3 b) {
    EXPECT_LT(glm::length(a - b), 1e-6f) << a.x << " " << a.y << " " << a.z;
}

TEST(SunDirection, AzimuthRunsClockwiseFromMinusZ) {
    expect_near(to_sun(0, 0), {0, 0, -1});
    expect_near(to_sun(pi / 2, 0), {1, 0, 0});
    expect_near(to_sun(pi, 0), {0, 0, 1});
    expect_near(to_sun(-pi / 2, 0), {-1, 0, 0});
}

TEST(SunDirection, ElevationLifts) {
    expect_near(to_sun(1.3f, pi / 2), {0, 1, 0});
    expect_near(to_sun(0, -pi / 2), {0, -1, 0});
    for (float elevation = -1.5f; elevation < 1.5f; elevation += 0.1f) {
        EXPECT_NEAR(to_sun(2.0f, elevation).y, std::sin(elevation), 1e-6f);
    }
}

TEST(SunDirection, TheSunsOwnRightStaysLevel) {
    for (float azimuth = -6.0f; azimuth < 6.0f; azimuth += 0.5f) {
        EXPECT_NEAR((sun_rotation({.azimuth = azimuth, .elevation = 0.7f}) * vec3(1, 0, 0)).y, 0.0f, 1e-6f);
    }
}

TEST(SunDirection, ASunWithoutTransformIsPlacedInTheSameFrame) {
    World world;
    Schedule schedule;
    add_engine_resources(world);
    add_engine_systems(schedule);
    const Entity with =
        world.create(SunAngles{.azimuth = 0, .elevation = 0}, Transform{.translation = {1, 2, 3}});
    const Entity without = world.create(SunAngles{.azimuth = 0, .elevation = 0});
    schedule.run(world);
    expect_near(world.get<WorldTransform>(with).linear * vec3(0, 0, -1), {0, 0, 1});
    expect_near(world.get<WorldTransform>(without).linear * vec3(0, 0, -1), {0, 0, 1});
    EXPECT_EQ(world.get<Transform>(with).translation, dvec3(1, 2, 3));
}

}  // namespace
}  // namespace sl
