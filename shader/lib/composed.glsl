// SPDX-License-Identifier: MIT
// Radiance towards the camera: direct light, plus what the surface makes of indirect irradiance, through the air, or the sky behind it all.
#include "lib/gbuffer.glsl"
#include "shared/brdf.h"

uniform sampler2D albedo;
uniform sampler2D material;
uniform sampler2D direct;
uniform sampler2D irradiance;

layout(location = 0) out vec4 hdr;  // rgb: radiance, nit

/// As albedo_in_even_light wants it; each pass has its own.
vec3 lobe_towards_eye(Surface surface, ivec2 pixel, vec3 to_eye);

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float distance = distance_at(pixel);
    if (distance < 0.0) {
        hdr = vec4(frame.sky.rgb, 1.0);
        return;
    }
    // Without indirect light the image is a single black pixel.
    ivec2 last = textureSize(irradiance, 0) - 1;
    vec3 arriving = texelFetch(irradiance, min(pixel, last), 0).rgb;
    vec3 roughness_metallic_specular = texelFetch(material, pixel, 0).xyz;
    Surface surface;
    surface.base_colour = vec4(texelFetch(albedo, pixel, 0).rgb, roughness_metallic_specular.x);
    surface.normal = vec4(vec3(0.0), roughness_metallic_specular.y);  // even light asks for none
    surface.specular = vec4(roughness_metallic_specular.z);
    vec3 ray = ray_through(pixel);
    float stretch = length(ray);
    vec3 lobe = lobe_towards_eye(surface, pixel, -ray / stretch);
    vec3 radiance = texelFetch(direct, pixel, 0).rgb + arriving * albedo_in_even_light(surface, lobe) / shared_pi;
    hdr = vec4(mix(frame.sky.rgb, radiance, air_transmittance(frame, distance * stretch)), 1.0);
}
