// SPDX-License-Identifier: MIT
#pragma once

#include "engine/ecs/components/day_cycle.h"

namespace sl {

/// Where the sun stands at a solar time (h, 12 is noon), latitude and declination (rad): spherical astronomy. It rises in the
/// east, +x, and sets in the west.
SunAngles sun_at(double hour, float latitude, float declination);

/// A solar time and the declination at which the sun stands there, seen from a latitude.
struct SunTime {
    double hour;
    float declination;
};
/// The hour and the season at which the sun of a latitude (rad) stands there.
SunTime time_of(const SunAngles& sun, float latitude);

/// Light of a clear day, linear Rec. 709.
struct Daylight {
    vec3 sun{0.0f};  ///< lux on a surface that faces it
    vec3 sky{0.0f};  ///< nit, its mean
};

/// By the sun's elevation, rad. The sun: 127.5 klx above the air (IES, Recommended practice for the calculation of daylight
/// availability, 1984), less what the air scatters (Rayleigh, by Hansen & Travis 1974) and haze absorbs (Ångström's law) along
/// the air mass of Kasten & Young 1989. The sky lights the ground with 0.76 klx + 15.5 klx sqrt(sin h) by day (IES 1984,
/// clear sky) and as U.S. Naval Observatory Circular 171 (1987) has it in twilight.
Daylight daylight(float elevation);

}  // namespace sl
