// SPDX-License-Identifier: MIT
// Radiance towards the camera: direct light, plus what the surface makes of indirect irradiance, through the air, or the sky behind it all.
#include "lib/gbuffer.glsl"
#include "shared/specular_lobe.h"

uniform sampler2D albedo;
uniform sampler2D material;
uniform sampler2D direct;
uniform sampler2D irradiance;
uniform sampler2D specular_lobe;

layout(location = 0) out vec4 hdr;  // rgb: radiance, nit

/// As albedo_in_even_light wants it.
vec3 lobe_towards(float n_dot_v, float roughness) {
    vec2 place = vec2(sqrt(n_dot_v), roughness);
    vec2 lobe = textureLod(specular_lobe, (place * float(specular_lobe_size - 1u) + 0.5) / float(specular_lobe_size), 0.0).rg;
    return vec3(lobe, grazing_of_diffuse(n_dot_v));
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Point point = point_at(pixel);
    if (point.distance < 0.0) {
        hdr = vec4(frame.sky.rgb, 1.0);
        return;
    }
    // Without indirect light the image is a single black pixel.
    ivec2 last = textureSize(irradiance, 0) - 1;
    vec3 arriving = texelFetch(irradiance, min(pixel, last), 0).rgb;
    vec3 roughness_metallic_specular = texelFetch(material, pixel, 0).xyz;
    Surface surface;
    surface.base_colour = vec4(texelFetch(albedo, pixel, 0).rgb, roughness_metallic_specular.x);
    surface.normal = vec4(point.normal, roughness_metallic_specular.y);
    surface.specular = vec4(roughness_metallic_specular.z);
    vec3 ray = ray_through(pixel), lobe = vec3(0.0);
    float stretch = length(ray);
    if (specular_strength(surface) > 0.0) lobe = lobe_towards(clamp(-dot(point.normal, ray) / stretch, 0.0, 1.0), surface.base_colour.a);
    vec3 radiance = texelFetch(direct, pixel, 0).rgb + arriving * albedo_in_even_light(surface, lobe) / shared_pi;
    hdr = vec4(mix(frame.sky.rgb, radiance, air_transmittance(frame, point.distance * stretch)), 1.0);
}
