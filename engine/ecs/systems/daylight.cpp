// SPDX-License-Identifier: MIT
#include "engine/ecs/systems/daylight.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sl {

namespace {

/// Of the sun above the air, lux; a little warmer than white, and of luminance 1.
constexpr float above_air = 127500.0f;
constexpr vec3 above_air_colour{1.08f, 0.985f, 0.9f};
/// Optical depth of the air overhead at 610, 550 and 465 nm: Rayleigh scattering, and haze (Ångström's β 0.0525, α 1.3), whose
/// luminance falls as the clear sky's of IES 1984, by exp(-0.21) overhead.
constexpr vec3 optical_depth{0.164f, 0.211f, 0.335f};
constexpr float disc_radius = 0.00465f;  // rad

/// Light of the sky on level ground, lux. Twilight ends at -18 deg, and what is left is airglow and stars.
struct Twilight {
    float elevation, lux;  // deg
};
constexpr std::array<Twilight, 7> twilight{{{-18.0f, 6.5e-4f}, {-15.0f, 2.0e-3f}, {-12.0f, 8.1e-3f}, {-9.0f, 0.116f}, {-6.0f, 3.41f}, {-3.0f, 79.0f}, {0.0f, 758.0f}}};

/// The mean colour of a clear sky, brightest channel 1: pale where the sun is low, deep blue after it has set, by ozone. Chosen
/// by eye.
struct SkyColour {
    float elevation;  // deg
    vec3 colour;
};
constexpr std::array<SkyColour, 5> sky_colours{{{-12.0f, {0.45f, 0.6f, 1.0f}}, {-5.0f, {0.42f, 0.52f, 1.0f}}, {0.0f, {0.8f, 0.74f, 1.0f}}, {8.0f, {0.68f, 0.8f, 1.0f}}, {25.0f, {0.52f, 0.74f, 1.0f}}}};

/// Between the rows on both sides of an elevation, deg; the first and last reach without end.
template <class Rows, class Value>
auto interpolated(const Rows& rows, float elevation, Value&& value) {
    const auto above = std::ranges::find_if(rows, [&](const auto& row) { return row.elevation >= elevation; });
    if (above == rows.begin()) return value(rows.front());
    if (above == rows.end()) return value(rows.back());
    const auto& below = *std::prev(above);
    return glm::mix(value(below), value(*above), (elevation - below.elevation) / (above->elevation - below.elevation));
}

float sky_illuminance(float elevation) {
    if (elevation >= 0.0f) return twilight.back().lux + 15500.0f * std::sqrt(std::sin(elevation));
    return std::exp(interpolated(twilight, glm::degrees(elevation), [](const Twilight& row) { return std::log(row.lux); }));
}

/// In that of the zenith.
float air_mass(float elevation) {
    const float degrees = std::max(glm::degrees(elevation), 0.0f);
    return 1.0f / (std::sin(glm::radians(degrees)) + 0.50572f * std::pow(degrees + 6.07995f, -1.6364f));
}

vec3 north_up_east(const SunAngles& sun) {
    return vec3(std::cos(sun.elevation) * std::cos(sun.azimuth), std::sin(sun.elevation), std::cos(sun.elevation) * std::sin(sun.azimuth));
}

}  // namespace

SunAngles sun_at(double hour, float latitude, float declination) {
    const auto turned = static_cast<float>(glm::radians(15.0 * (hour - 12.0)));
    const float level = std::cos(declination) * std::cos(turned), pole = std::sin(declination);
    const float north = pole * std::cos(latitude) - level * std::sin(latitude), east = -std::cos(declination) * std::sin(turned);
    const float up = pole * std::sin(latitude) + level * std::cos(latitude);
    return {.azimuth = std::atan2(east, north), .elevation = std::asin(std::clamp(up, -1.0f, 1.0f))};
}

SunTime time_of(const SunAngles& sun, float latitude) {
    const vec3 at = north_up_east(sun);
    const float pole = at.y * std::sin(latitude) + at.x * std::cos(latitude), level = at.y * std::cos(latitude) - at.x * std::sin(latitude);
    const double hour = 12.0 + glm::degrees(static_cast<double>(std::atan2(-at.z, level))) / 15.0;
    return {.hour = hour < 24.0 ? hour : hour - 24.0, .declination = std::asin(std::clamp(pole, -1.0f, 1.0f))};
}

Daylight daylight(float elevation) {
    Daylight light;
    const float disc = std::clamp(0.5f + 0.5f * elevation / disc_radius, 0.0f, 1.0f);
    light.sun = disc * above_air * above_air_colour * glm::exp(-optical_depth * air_mass(elevation));
    const vec3 colour = interpolated(sky_colours, glm::degrees(elevation), [](const SkyColour& row) { return row.colour; });
    light.sky = colour * (sky_illuminance(elevation) / (pi * luminance(colour)));
    return light;
}

}  // namespace sl
