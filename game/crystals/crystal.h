// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/core/fields.h"

namespace sl {

/// Sleeps until enough reflected light of its colour reaches it; what shines on it straight does not count.
struct Crystal {
    vec3 colour{1.0f};         ///< of the light it waits for
    float need = 100.0f;       ///< lux of reflected light
    float purity = 0.95f;      ///< cosine between the colours of what comes and what it waits for
    float glow = 3000.0f;      ///< nit, once it is awake
    std::string hint;          ///< for who asks
    bool awake = false;
};

void visit_fields(FieldVisitor& visit, Crystal& crystal);

/// How near a crystal is to waking, by the light that reaches it.
struct CrystalLight {
    vec3 irradiance{0.0f};  ///< reflected light, lux; mean over its sides
    float amount = 0.0f;    ///< luminance over the need
    float match = 0.0f;     ///< cosine of the colours; 0 in the dark

    /// 0 to 1; 1 wakes.
    float share(const Crystal& crystal) const;
};

CrystalLight crystal_light(const Crystal& crystal, vec3 irradiance);

}  // namespace sl
