// SPDX-License-Identifier: MIT
// Radiance towards the camera: direct light, plus indirect irradiance on the diffuse surface, or the sky behind it all.
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
    hdr = vec4(texelFetch(depth, pixel, 0).r > 0.0 ? radiance : frame.sky.rgb, 1.0);
}
