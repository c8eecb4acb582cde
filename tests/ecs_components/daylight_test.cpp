// SPDX-License-Identifier: MIT
#include "engine/ecs/systems/daylight.h"

#include <gtest/gtest.h>

namespace sl {
namespace {

float degrees(float rad) { return glm::degrees(rad); }
float sun_lux(float elevation) { return luminance(daylight(glm::radians(elevation)).sun); }
float sky_lux(float elevation) { return pi * luminance(daylight(glm::radians(elevation)).sky); }

TEST(SunAt, AtNoonItStandsAsHighAsLatitudeAndDeclinationSay) {
    const float latitude = 0.8f, declination = 0.2f;
    const SunAngles noon = sun_at(12.0, latitude, declination), midnight = sun_at(0.0, latitude, declination);
    EXPECT_NEAR(noon.elevation, pi / 2 - latitude + declination, 1e-5f);
    EXPECT_NEAR(std::abs(noon.azimuth), pi, 1e-5f);
    EXPECT_NEAR(midnight.elevation, latitude + declination - pi / 2, 1e-5f);
    EXPECT_NEAR(midnight.azimuth, 0.0f, 1e-5f);
}

TEST(SunAt, RisesInTheEastAndSetsInTheWestAtTheEquinox) {
    for (const float latitude : {-1.0f, -0.6f, 0.0f, 0.8f}) {
        const SunAngles rise = sun_at(6.0, latitude, 0.0f), set = sun_at(18.0, latitude, 0.0f);
        EXPECT_NEAR(degrees(rise.elevation), 0.0f, 1e-3f);
        EXPECT_NEAR(degrees(rise.azimuth), 90.0f, 1e-3f);
        EXPECT_NEAR(degrees(set.elevation), 0.0f, 1e-3f);
        EXPECT_NEAR(degrees(set.azimuth), -90.0f, 1e-3f);
    }
}

TEST(SunAt, SouthOfTheEquatorItStandsInTheNorthAtNoon) {
    EXPECT_NEAR(sun_at(12.0, -0.6f, 0.0f).azimuth, 0.0f, 1e-5f);
}

TEST(TimeOf, IsTheInverse) {
    for (const float latitude : {-1.2f, -0.6f, 0.3f, 0.9f}) {
        for (double hour = 0.25; hour < 24.0; hour += 0.5) {
            const SunTime time = time_of(sun_at(hour, latitude, 0.3f), latitude);
            EXPECT_NEAR(time.hour, hour, 1e-4);
            EXPECT_NEAR(time.declination, 0.3f, 1e-5f);
        }
    }
}

TEST(TimeOf, EveryPlaceOfTheSkyIsOnAnArc) {
    for (float azimuth = -3.0f; azimuth < 3.1f; azimuth += 0.25f) {
        for (float elevation = -1.5f; elevation < 1.55f; elevation += 0.25f) {
            const SunTime time = time_of({azimuth, elevation}, 0.7f);
            const SunAngles sun = sun_at(time.hour, 0.7f, time.declination);
            EXPECT_NEAR(sun.elevation, elevation, 1e-3f);
            EXPECT_NEAR(std::cos(elevation) * std::sin(0.5f * (sun.azimuth - azimuth)), 0.0f, 1e-3f);
        }
    }
}

TEST(Daylight, TheSunFallsAsTheClearSkyOfIesHasIt) {
    // 127.5 klx exp(-0.21 m); air masses of Kasten & Young 1989.
    EXPECT_NEAR(sun_lux(90.0f), 127500.0f * std::exp(-0.21f), 1300.0f);
    EXPECT_NEAR(sun_lux(30.0f), 127500.0f * std::exp(-0.21f * 1.994f), 1600.0f);
    EXPECT_EQ(sun_lux(-0.3f), 0.0f);
    for (float elevation = 0.0f; elevation < 90.0f; elevation += 1.0f) EXPECT_GT(sun_lux(elevation + 1.0f), sun_lux(elevation));
}

TEST(Daylight, TheLowSunIsWarm) {
    float before = 1.0f;
    for (float elevation = 80.0f; elevation >= 0.0f; elevation -= 5.0f) {
        const vec3 sun = daylight(glm::radians(elevation)).sun;
        EXPECT_LT(sun.z / sun.x, before);
        EXPECT_GT(sun.x, sun.y);
        EXPECT_GT(sun.y, sun.z);
        before = sun.z / sun.x;
    }
    EXPECT_LT(before, 0.01f);
}

TEST(Daylight, TheSkyLightsTheGroundAsMeasured) {
    EXPECT_NEAR(sky_lux(90.0f), 16258.0f, 20.0f);
    EXPECT_NEAR(sky_lux(30.0f), 758.0f + 15500.0f * std::sqrt(0.5f), 20.0f);
    EXPECT_NEAR(sky_lux(0.0f), 758.0f, 1.0f);
    EXPECT_NEAR(sky_lux(-6.0f), 3.41f, 0.01f);
    EXPECT_NEAR(sky_lux(-12.0f), 8.1e-3f, 1e-4f);
    EXPECT_NEAR(sky_lux(-90.0f), 6.5e-4f, 1e-6f);
}

TEST(Daylight, NothingJumpsAndNothingIsNegative) {
    Daylight before = daylight(-0.5f * pi);
    for (float elevation = -90.0f; elevation <= 90.0f; elevation += 0.01f) {
        const Daylight now = daylight(glm::radians(elevation));
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_GE(now.sun[channel], 0.0f);
            EXPECT_GT(now.sky[channel], 0.0f);
            EXPECT_LE(now.sky[channel], 1.4f * before.sky[channel]) << elevation;
            EXPECT_LE(now.sun[channel] - before.sun[channel], 400.0f) << elevation;
        }
        before = now;
    }
}

}  // namespace
}  // namespace sl
