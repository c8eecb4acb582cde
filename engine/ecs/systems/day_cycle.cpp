// SPDX-License-Identifier: MIT
#include "engine/ecs/systems/day_cycle.h"

#include <algorithm>
#include <cmath>

#include "engine/ecs/systems/daylight.h"
#include "engine/ecs/systems/sun_direction.h"

namespace sl {

namespace {

/// Of the sun above the air: 14 magnitudes.
constexpr float full_moon = 2.5e-6f;
/// Lux above the air of what gives that share.
constexpr float real_moon = 0.32f;

/// The sun has been put elsewhere, and the day has not.
bool sun_was_moved(const DayCycle& day, const SunAngles& sun) {
    const DayCycle::Shown& shown = day.shown;
    const bool same_arc = day.latitude == shown.latitude && day.declination == shown.declination;
    return shown.any && same_arc && (sun.azimuth != shown.sun.azimuth || sun.elevation != shown.sun.elevation);
}

/// The way round the day from one hour to another, h.
double hours_between(double a, double b) { return std::abs(std::remainder(a - b, 24.0)); }

bool needs_showing(const DayCycle& day) {
    const DayCycle::Shown& shown = day.shown;
    if (!shown.any || day.latitude != shown.latitude || day.declination != shown.declination || day.moon != shown.moon) return true;
    const double apart = hours_between(day.hour, shown.hour);
    // While it stands, the sun stands where the hour says.
    return day.runs ? apart * glm::radians(15.0) >= std::max(double{day.step}, 1e-9) : apart > 0.0;
}

/// A colour whose brightest channel is 1, and the strength that it then needs.
void set_light(vec3 light, vec3& colour, float& strength) {
    strength = std::max({light.x, light.y, light.z});
    if (strength > 0.0f) colour = light / strength;
}

}  // namespace

void day_cycle(Query<DayCycle, SunAngles, DirectionalLight, Transform> days, Query<SkyLight> skies, const FrameClock& clock, const DayPause& pause) {
    days.each([&](DayCycle& day, SunAngles& sun, DirectionalLight& light, Transform& transform) {
        if (sun_was_moved(day, sun)) {
            const SunTime time = time_of(sun, day.latitude);
            day.hour = time.hour;
            day.declination = time.declination;
        } else if (day.runs && !pause.on) {
            day.hour = std::fmod(day.hour + clock.step * 24.0 / (60.0 * double{day.minutes}), 24.0);
        }
        if (needs_showing(day)) {
            sun = sun_at(day.hour, day.latitude, day.declination);
            day.shown = {.hour = day.hour, .latitude = day.latitude, .declination = day.declination, .moon = day.moon, .sun = sun, .any = true};
        }
        const SunAngles moon{.azimuth = sun.azimuth + pi, .elevation = -sun.elevation};
        const Daylight by_day = daylight(sun.elevation), by_moon = daylight(moon.elevation);
        const float moonlight = full_moon * day.moon / real_moon;
        const bool night = by_day.sun.x <= 0.0f;
        transform.rotation = sun_rotation(night ? moon : sun);
        set_light(night ? moonlight * by_moon.sun : by_day.sun, light.colour, light.illuminance);
        // Airglow and stars are in the twilight's end.
        skies.each([&](SkyLight& sky) { set_light(by_day.sky + moonlight * by_moon.sky, sky.colour, sky.luminance); });
    });
}

}  // namespace sl
