// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/fields.h"

namespace sl {

/// Parallel light along -z of its entity, as in glTF's KHR_lights_punctual.
struct DirectionalLight {
    vec3 colour{1.0f};
    float illuminance = 100000.0f;
    bool casts_shadow = true;
    bool bounces = true;
    std::uint32_t shadow_size = 2048;
    float shadow_distance = 128.0f;
};

/// Sets the rotation of a directional light's entity from angles, so that a sun is dragged by two numbers.
struct SunAngles {
    float azimuth = 0.6f;
    float elevation = 0.9f;
};

/// Light from a point along -z inside a cone, as in glTF's KHR_lights_punctual: full inside `inner_cone`, none outside
/// `outer_cone` (half angles).
struct SpotLight {
    vec3 colour{1.0f};
    float intensity = 1000.0f;
    float range = 0.0f;
    float inner_cone = 0.0f;
    float outer_cone = 0.7854f;
    bool casts_shadow = true;
    bool bounces = true;
    std::uint32_t shadow_size = 512;
};

/// Light from a point in all directions, as in glTF's KHR_lights_punctual. Has no reflective shadow map.
struct PointLight {
    vec3 colour{1.0f};
    float intensity = 100.0f;
    float range = 0.0f;
    bool casts_shadow = true;
    std::uint32_t shadow_size = 512;
};

/// The sky: uniform radiance from every direction that nothing blocks. Never an ambient constant: a method that cannot
/// tell what blocks it takes no light from it. The air before it may be hazy.
struct SkyLight {
    vec3 colour{0.55f, 0.75f, 1.0f};
    float luminance = 4000.0f;
    float visibility = 0.0f;
};

/// How far from the camera the land ends that a game keeps round it, m; a resource. Air that is hazy at all hides that edge.
struct LandEdge {
    double distance = 0.0;
};

inline constexpr FieldInfo light_colour_info{.min = 0, .max = 1, .unit = "linear Rec. 709",
                                             .help = "Colour of the light; intensity is set apart.",
                                             .look = FieldLook::colour};
inline constexpr FieldInfo casts_shadow_info{.help = "Whether things stand in its way; without, no shadow map is drawn."};
inline constexpr FieldInfo bounces_info{.help = "Whether surfaces it reaches light others (needs GI settings on the camera); "
                                                "without, no reflective shadow map is drawn."};
inline constexpr FieldInfo shadow_size_info{.min = 16, .max = 8192, .unit = "texels",
                                            .help = "Side of the shadow map; more sharpens shadow edges and costs memory and, "
                                                    "when something moves, time."};
inline constexpr FieldInfo intensity_info{.min = 0, .max = 1e9, .unit = "cd",
                                          .help = "Luminous intensity; doubling it doubles the light everywhere.",
                                          .look = FieldLook::logarithmic};
inline constexpr FieldInfo range_info{.min = 0, .max = 1e6, .unit = "m",
                                      .help = "Light fades to nothing at this distance; 0 lets it reach without end, as light does."};

inline void visit_fields(FieldVisitor& visit, DirectionalLight& light) {
    visit.field("colour", light.colour, light_colour_info);
    visit.field("illuminance", light.illuminance,
                {.min = 0, .max = 1e6, .unit = "lux", .help = "On a surface facing the light; noon sun 100,000, full moon 0.25.",
                 .look = FieldLook::logarithmic});
    visit.field("casts_shadow", light.casts_shadow, casts_shadow_info);
    visit.field("bounces", light.bounces, bounces_info);
    visit.field("shadow_size", light.shadow_size, shadow_size_info);
    visit.field("shadow_distance", light.shadow_distance,
                {.min = 1e-3, .max = 1e5, .unit = "m",
                 .help = "Radius around the camera that the light's maps cover where the scene is larger; more covers more with "
                         "coarser texels. A smaller scene is covered whole.",
                 .look = FieldLook::logarithmic});
}

inline void visit_fields(FieldVisitor& visit, SunAngles& sun) {
    visit.field("azimuth", sun.azimuth,
                {.min = -6.2832, .max = 6.2832, .unit = "rad", .help = "Where the sun stands, clockwise from -z seen from above.",
                 .look = FieldLook::angle});
    visit.field("elevation", sun.elevation,
                {.min = -1.5708, .max = 1.5708, .unit = "rad", .help = "Height above the horizon; below 0 it is night.",
                 .look = FieldLook::angle});
}

inline void visit_fields(FieldVisitor& visit, SpotLight& light) {
    visit.field("colour", light.colour, light_colour_info);
    visit.field("intensity", light.intensity, intensity_info);
    visit.field("range", light.range, range_info);
    visit.field("inner_cone", light.inner_cone,
                {.min = 0, .max = 1.5533, .unit = "rad", .help = "Half angle of full light; nearer to the outer cone is a harder edge.",
                 .look = FieldLook::angle});
    visit.field("outer_cone", light.outer_cone,
                {.min = 0.001, .max = 1.5533, .unit = "rad", .help = "Half angle at which the light ends; more lights more.",
                 .look = FieldLook::angle});
    visit.field("casts_shadow", light.casts_shadow, casts_shadow_info);
    visit.field("bounces", light.bounces, bounces_info);
    visit.field("shadow_size", light.shadow_size, shadow_size_info);
}

inline void visit_fields(FieldVisitor& visit, PointLight& light) {
    visit.field("colour", light.colour, light_colour_info);
    visit.field("intensity", light.intensity, intensity_info);
    visit.field("range", light.range, range_info);
    visit.field("casts_shadow", light.casts_shadow, casts_shadow_info);
    visit.field("shadow_size", light.shadow_size,
                {.min = 16, .max = 4096, .unit = "texels",
                 .help = "Side of each of the six faces of the shadow map; more sharpens shadow edges and costs memory and, when "
                         "something moves, time."});
}

inline void visit_fields(FieldVisitor& visit, SkyLight& sky) {
    visit.field("colour", sky.colour, light_colour_info);
    visit.field("luminance", sky.luminance,
                {.min = 0, .max = 1e6, .unit = "nit", .help = "Radiance of the sky in every direction; clear day 2,000 to 8,000. Lights in references and with the method facets; methods with reflective shadow maps only draw it.",
                 .look = FieldLook::logarithmic});
    visit.field("visibility", sky.visibility,
                {.min = 0, .max = 1e6, .unit = "m", .help = "How far one sees through the air: what lies that far off keeps 2 % of its contrast with the sky. 0 is air without haze.",
                 .look = FieldLook::logarithmic});
}

}  // namespace sl
