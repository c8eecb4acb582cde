// SPDX-License-Identifier: MIT
// Water where it is seen: it reflects by Fresnel's law what is on the screen or the sky, glitters in the sun, swallows light on
// its way through it, and gives a little of what falls on it back.
#include "lib/water.glsl"
#include "shared/brdf.h"
#include "shared/octahedral.h"

uniform sampler2D hdr;
uniform sampler2D water_depth;
uniform sampler2D water_normal;

layout(location = 0) out vec4 hdr_water;  // rgb: radiance, nit

#include "lib/screen_trace.glsl"

// What mirrors less than this mirrors the sky alone: a search of the screen would not be seen.
const float least_mirror = 0.03;
// Of what swells too small for the ripples do to a reflected light.
const float least_alpha = 0.02;

// xyz: the normal with ripples; w: variance of the slope that is too small to be seen.
vec4 rippled(vec3 flat_normal, vec3 position, float footprint) {
    vec3 along = abs(flat_normal.y) > 0.5 ? vec3(1, 0, 0) : vec3(0, 1, 0);
    vec3 right = normalize(along - flat_normal * dot(along, flat_normal));
    vec3 up = cross(flat_normal, right);
    vec3 slope = water_slope(vec2(dot(position, right), dot(position, up)), water.absorption.w, footprint);
    return vec4(normalize(flat_normal - right * slope.x - up * slope.y), slope.z);
}

vec3 glitter(vec3 position, vec3 flat_normal, vec3 normal, float variance, vec3 to_eye) {
    float alpha = min(least_alpha + sqrt(variance), 0.5);
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < frame.counts.z; ++i) {
        Incident incident = incident_light(lights[i], position);
        vec3 to_light = incident.to_light.xyz;
        float n_dot_l = dot(normal, to_light);
        if (n_dot_l <= 0.0) { continue; }
        vec3 halfway = normalize(to_light + to_eye);
        float lobe = ggx_specular(alpha, normal, halfway, n_dot_l, max(dot(normal, to_eye), 1e-3));
        float visible = sun_visibility(lights[i], incident, position, flat_normal);
        sum += incident.irradiance.rgb * (visible * lobe * n_dot_l * water_fresnel(clamp(dot(to_eye, halfway), 0.0, 1.0), 0.0));
    }
    return sum;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    bool submerged = water.view.x > 0.0;
    float ground = distance_at(depth, pixel);
    float surface = distance_at(water_depth, pixel);
    if (surface >= ground) { discard; }
    float share_of_sky = sky_share(pixel);
    vec3 around = submerged ? body(frame.camera_position.xyz, share_of_sky) : vec3(0.0);

    vec3 towards = normalize(view_ray(frame, ndc_of(pixel)));
    vec3 position = frame.camera_position.xyz + towards * surface;
    vec3 outward = octahedral_decode(texelFetch(water_normal, pixel, 0).rg * 2.0 - 1.0);
    bool from_below = dot(outward, towards) > 0.0;
    vec3 flat_normal = from_below ? -outward : outward;
    float level = max(-dot(flat_normal, towards), 1e-3);
    vec4 ripples = rippled(flat_normal, position, water.view.z * surface / level);
    vec3 normal = ripples.xyz;
    float cosine = clamp(-dot(normal, towards), 1e-3, 1.0);

    // Ripples shift what is seen through them by how much they bend the ray more than a mirror-like surface would.
    float ratio = from_below ? water_index : 1.0 / water_index;
    vec3 plain = refract(towards, flat_normal, ratio);
    vec3 bent = refract(towards, normal, ratio);
    vec3 shift = plain == vec3(0.0) || bent == vec3(0.0) ? vec3(0.0) : bent - plain;
    float behind = min((ground - surface) * level / max(-dot(flat_normal, plain), 0.1), 10.0);
    vec4 clip = frame.clip_from_world * vec4(frame.camera_position.xyz + towards * ground + shift * behind, 1.0);
    ivec2 last = ivec2(frame.ray_right.w, frame.ray_up.w) - 1;
    ivec2 shifted = ground < farthest ? clamp(ivec2((clip.xy / max(clip.w, 1e-6) * 0.5 + 0.5) * vec2(last + 1)), ivec2(0), last) : pixel;
    float there = distance_at(depth, shifted);
    float surface_there = distance_at(water_depth, shifted);
    // What stands before the water is not seen through it.
    if (surface_there >= there) {
        shifted = pixel;
        there = ground;
        surface_there = surface;
    }
    vec3 seen = texelFetch(hdr, shifted, 0).rgb;
    vec3 below = submerged ? around : body(position, share_of_sky);
    if (!from_below) { seen = seen_through(seen, (there - surface_there) * level / max(-dot(flat_normal, plain), 0.1), below); }

    vec3 mirrored = reflect(towards, normal);
    mirrored = normalize(mirrored + flat_normal * max(0.02 - dot(mirrored, flat_normal), 0.0));
    float share = water_fresnel(cosine, from_below ? 1.0 : 0.0);
    ScreenHit hit = ScreenHit(vec2(0.5), 0.0, 0.0);
    // The ground of a lake goes on behind what is seen of it.
    if (share > least_mirror) { hit = trace_screen(position + flat_normal * 0.02, mirrored, 0.01 * surface + 0.05, from_below ? 1e9 : 2.0); }
    vec3 on_screen = texture(hdr, hit.uv).rgb;
    vec3 reflection = from_below ? seen_through(on_screen, hit.distance, below) : mix(frame.sky.rgb * share_of_sky, on_screen, hit.found);
    vec3 radiance = mix(seen, reflection, share);
    if (!from_below) { radiance += glitter(position, flat_normal, normal, ripples.w, -towards); }
    hdr_water = vec4(submerged ? seen_through(radiance, surface, around) : radiance, 1.0);
}
