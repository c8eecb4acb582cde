// SPDX-License-Identifier: MIT
#pragma once

#include "engine/ecs/components/lights.h"

namespace sl {

/// Moves the sun of its entity through the day and the year's one declination, and sets colour and strength of that sun and
/// of every sky by it. By night the same light is the full moon, which stands opposite.
struct DayCycle {
    bool runs = true;
    double hour = 12.0;
    float minutes = 30.0f;
    float latitude = 0.8f;
    float declination = 0.2f;
    float moon = 0.32f;
    float step = 0.00436f;

    /// What the system has set last, so that it knows who has moved the sun since. No field.
    struct Shown {
        double hour = 0.0;
        float latitude = 0.0f, declination = 0.0f, moon = 0.0f;
        SunAngles sun;
        bool any = false;
    };
    Shown shown{};
};

inline void visit_fields(FieldVisitor& visit, DayCycle& day) {
    visit.field("runs", day.runs, {.help = "Whether time passes; without, the sun stands still."});
    visit.field("hour", day.hour, {.min = 0, .max = 24, .unit = "h", .help = "Solar time: at 12 the sun stands highest."});
    visit.field("minutes", day.minutes,
                {.min = 0.01, .max = 1e5, .unit = "min", .help = "How long a day and a night take together; fewer move the sun faster.",
                 .look = FieldLook::logarithmic});
    visit.field("latitude", day.latitude,
                {.min = -1.5, .max = 1.5, .unit = "rad", .help = "North of the equator; the farther from it, the flatter the sun's arc. South of it the sun stands in the north at noon.",
                 .look = FieldLook::angle});
    visit.field("declination", day.declination,
                {.min = -1.5708, .max = 1.5708, .unit = "rad", .help = "Height of the sun over the celestial equator: the season, 0.41 at the northern summer's height. More lifts its arc north of the equator.",
                 .look = FieldLook::angle});
    visit.field("moon", day.moon,
                {.min = 0, .max = 1000, .unit = "lux", .help = "Light of the full moon above the air; the real one gives 0.32, more makes nights easier.",
                 .look = FieldLook::logarithmic});
    visit.field("step", day.step,
                {.min = 0, .max = 0.2, .unit = "rad", .help = "The sun moves in steps of this angle; larger ones leave indirect light more time to follow, and are seen.",
                 .look = FieldLook::angle});
}

}  // namespace sl
