// SPDX-License-Identifier: MIT
#include "engine/render/trace/transport_world.h"

#include "engine/render/scene/light_map.h"

namespace sl {

TransportWorld::TransportWorld(const RenderScene& render_scene, const TransportSettings& transport)
    : scene(render_scene, transport.relief), emitters(scene), settings(transport) {
    relight(render_scene);
}

void TransportWorld::resurface(const RenderScene& render_scene) {
    scene.update(render_scene);
    emitters = Emitters(scene);
}

void TransportWorld::move(vec3 offset) {
    scene.move(offset);
    emitters = Emitters(scene);
    for (LightParams& light : lights) {
        light.map_clip_from_world[3] = light.map_clip_from_world * vec4(-offset, 1.0f);
        if (light.kind.x != light_directional) light.position += vec4(offset, 0.0f);
    }
}

void TransportWorld::relight(const RenderScene& render_scene) {
    lights = build_light_table(render_scene).params;
    sky = render_scene.sky_radiance;
    casts.clear();
    bounces.clear();
    for (const RenderScene::Light& light : render_scene.lights) {
        // Rays need no maps, and what is right does not hang on the memory for them.
        casts.push_back(light.casts_shadow);
        bounces.push_back(light.bounces && light.mapped);
    }
}

}  // namespace sl
