// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/clock.h"
#include "engine/ecs/components/day_cycle.h"
#include "engine/ecs/components/transform.h"
#include "engine/ecs/query.h"

namespace sl {

/// Whether every day stands still for now, whatever it says itself: while somebody works at its light; a resource.
struct DayPause {
    bool on = false;
};

/// Lets time pass and moves sun and moon by it. Whoever else turns the sun (SunAngles) changes hour and declination: it goes on
/// from where it was put. Colour and strength of sun and sky follow; of several days the last one has the sky.
/// After sun_direction: by night the light comes from the moon.
void day_cycle(Query<DayCycle, SunAngles, DirectionalLight, Transform> days, Query<SkyLight> skies, const FrameClock& clock, const DayPause& pause);

}  // namespace sl
