// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/fields.h"

namespace sl {

/// Metallic-roughness surface as in glTF 2.0; linear Rec. 709.
struct Material {
    vec3 base_colour{0.8f};
    float metallic = 0.0f;
    float roughness = 1.0f;
    float specular = 1.0f;
    vec3 emission_colour{1.0f};
    float emission = 0.0f;
};

inline void visit_fields(FieldVisitor& visit, Material& material) {
    visit.field("base_colour", material.base_colour,
                {.min = 0, .max = 1, .unit = "linear Rec. 709",
                 .help = "Share of light given back diffusely (or, on metal, reflected); brighter makes more bounced light.",
                 .look = FieldLook::colour});
    visit.field("metallic", material.metallic, {.min = 0, .max = 1, .help = "0 is a dielectric, 1 a metal, which bounces no diffuse light."});
    visit.field("roughness", material.roughness, {.min = 0, .max = 1, .help = "0 is a mirror, 1 is chalk."});
    visit.field("specular", material.specular,
                {.min = 0, .max = 1, .help = "Strength of the dielectric reflection; 0 leaves a purely diffuse surface."});
    visit.field("emission_colour", material.emission_colour,
                {.min = 0, .max = 1, .unit = "linear Rec. 709", .help = "Colour of the light it gives off.", .look = FieldLook::colour});
    visit.field("emission", material.emission,
                {.min = 0, .max = 1e6, .unit = "nit", .help = "Luminance it gives off by itself.", .look = FieldLook::logarithmic});
}

}  // namespace sl
