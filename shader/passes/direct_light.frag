// SPDX-License-Identifier: MIT
// Light that comes straight from a light: all lights of the scene, shadowed, on the surface's full reflectance.
#include "lib/gbuffer.glsl"
#include "lib/shadow.glsl"

layout(std430) readonly buffer Lights { LightParams lights[]; };
uniform sampler2D albedo;
uniform sampler2D material;
uniform sampler2D emission;

layout(location = 0) out vec4 direct;  // rgb: radiance, nit

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Point point = point_at(pixel);
    vec4 layers = texelFetch(material, pixel, 0);
    Surface surface;
    surface.base_colour = vec4(texelFetch(albedo, pixel, 0).rgb, layers.x);
    surface.normal = vec4(point.normal, layers.y);
    surface.specular = vec4(layers.z);
    vec3 to_eye = normalize(frame.camera_position.xyz - point.position);
    vec3 radiance = texelFetch(emission, pixel, 0).rgb;
    uint count = point.distance > 0.0 ? frame.counts.x : 0u;
    for (uint i = 0u; i < count; ++i) {
        LightParams light = lights[i];
        Incident incident = incident_light(light, point.position);
        float visible = shadow_visibility(light, incident, point.position, point.normal);
        radiance += incident.irradiance.rgb * visible * reflected(surface, incident.to_light.xyz, to_eye);
    }
    direct = vec4(point.distance > 0.0 ? radiance : vec3(0.0), 1.0);
}
