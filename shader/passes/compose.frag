// SPDX-License-Identifier: MIT
// Radiance towards the camera: direct light, plus indirect irradiance on the diffuse surface, through the air, or the sky behind it all.
#include "shared/brdf.h"
#include "shared/frame.h"

layout(std140) uniform Frame { FrameParams frame; };
uniform sampler2D depth;
uniform sampler2D albedo;
uniform sampler2D material;
uniform sampler2D direct;
uniform sampler2D irradiance;

layout(location = 0) out vec4 hdr;  // rgb: radiance, nit

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    // Without indirect light the image is a single black pixel.
    ivec2 last = textureSize(irradiance, 0) - 1;
    vec3 arriving = texelFetch(irradiance, min(pixel, last), 0).rgb;
    vec3 diffuse = texelFetch(albedo, pixel, 0).rgb * (1.0 - texelFetch(material, pixel, 0).y);
    vec3 radiance = texelFetch(direct, pixel, 0).rgb + arriving * diffuse / shared_pi;
    float d = texelFetch(depth, pixel, 0).r;
    vec2 ndc = (vec2(pixel) + 0.5) / vec2(frame.ray_right.w, frame.ray_up.w) * 2.0 - 1.0;
    float distance = length(view_ray(frame, ndc)) * view_distance(max(d, 1e-20), frame.camera_position.w);
    hdr = vec4(d > 0.0 ? mix(frame.sky.rgb, radiance, air_transmittance(frame, distance)) : frame.sky.rgb, 1.0);
}
