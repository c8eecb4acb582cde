// SPDX-License-Identifier: MIT
#include "game/crystals/crystal.h"

#include <algorithm>

#include "shared/brdf.h"

namespace sl {

void visit_fields(FieldVisitor& visit, Crystal& crystal) {
    visit.field("colour", crystal.colour,
                {.min = 0, .max = 1, .unit = "linear Rec. 709", .help = "Colour of the light that it waits for, and in which it glows.", .look = FieldLook::colour});
    visit.field("need", crystal.need, {.min = 1e-3, .max = 1e6, .unit = "lux", .help = "Reflected light that wakes it; more is harder.", .look = FieldLook::logarithmic});
    visit.field("purity", crystal.purity, {.min = 0, .max = 1, .help = "How near that light's colour must be; 1 is exactly."});
    visit.field("glow", crystal.glow, {.min = 0, .max = 1e6, .unit = "nit", .help = "Luminance once it is awake.", .look = FieldLook::logarithmic});
    visit.field("hint", crystal.hint, {.help = "What players read who ask for a hint."});
    visit.field("awake", crystal.awake, {.help = "It has had its light, and glows."});
}

CrystalLight crystal_light(const Crystal& crystal, vec3 irradiance) {
    CrystalLight light{.irradiance = irradiance, .amount = luminance(irradiance) / std::max(crystal.need, 1e-3f)};
    const float lengths = glm::length(irradiance) * glm::length(crystal.colour);
    if (lengths > 0.0f) light.match = glm::dot(irradiance, crystal.colour) / lengths;
    return light;
}

float CrystalLight::share(const Crystal& crystal) const {
    // All colours are somewhat alike: what counts is how much of the way to the last bit is done.
    const float colour = crystal.purity > 0.0f ? std::clamp((match - 0.5f) / std::max(crystal.purity - 0.5f, 1e-3f), 0.0f, 1.0f) : 1.0f;
    return std::clamp(amount, 0.0f, 1.0f) * colour;
}

}  // namespace sl
