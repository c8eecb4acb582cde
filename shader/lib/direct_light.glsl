// SPDX-License-Identifier: MIT
// Light that comes straight from a light: all lights of the scene, shadowed, on a pixel's full reflectance.
#include "lib/emission.glsl"
#include "lib/gbuffer.glsl"
#include "lib/shadow.glsl"

layout(std430) readonly buffer Lights { LightParams lights[]; };
uniform sampler2D albedo;
uniform sampler2D material;
uniform sampler2D emission;

/// What the surface says of light from a direction besides its reflectance, 0 or 1; of the program that includes this.
float share_from(vec3 to_light, vec3 facing);

/// Radiance towards the camera, nit. facing: the way the surface lies, whatever its normal says.
vec3 directly_lit(ivec2 pixel, Point point, vec3 facing) {
    vec4 layers = texelFetch(material, pixel, 0);
    Surface surface;
    surface.base_colour = vec4(texelFetch(albedo, pixel, 0).rgb, layers.x);
    surface.normal = vec4(point.normal, layers.y);
    surface.specular = vec4(layers.z);
    vec3 to_eye = normalize(frame.camera_position.xyz - point.position);
    vec3 radiance = emission_of(texelFetch(emission, pixel, 0));
    bool there = point.distance > 0.0;
    // One loop per kind of light: a software rasterizer runs both sides of every branch, but no empty loop.
    for (uint i = 0u; i < (there ? frame.counts.z : 0u); ++i) {
        LightParams light = lights[i];
        Incident incident = incident_light(light, point.position);
        radiance += incident.irradiance.rgb * sun_visibility(light, incident, point.position, facing) *
                    reflected(surface, incident.to_light.xyz, to_eye) * share_from(incident.to_light.xyz, facing);
    }
    for (uint i = frame.counts.z; i < (there ? frame.counts.w : 0u); ++i) {
        LightParams light = lights[i];
        Incident incident = incident_light(light, point.position);
        radiance += incident.irradiance.rgb * spot_visibility(light, incident, point.position, facing) *
                    reflected(surface, incident.to_light.xyz, to_eye) * share_from(incident.to_light.xyz, facing);
    }
    for (uint i = frame.counts.w; i < (there ? frame.counts.x : 0u); ++i) {
        LightParams light = lights[i];
        Incident incident = incident_light(light, point.position);
        radiance += incident.irradiance.rgb * point_visibility(light, incident, point.position, facing) *
                    reflected(surface, incident.to_light.xyz, to_eye) * share_from(incident.to_light.xyz, facing);
    }
    return there ? radiance : vec3(0.0);
}
