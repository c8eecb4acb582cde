// SPDX-License-Identifier: MIT
// A model file, .gltf, .glb or .vox, made to a scene by itself and shown: all that comes before the graphics card, and one ray.
#include "engine/core/error.h"
#include "engine/ecs/app.h"
#include "engine/ecs/systems/load_models.h"
#include "engine/render/scene/extract.h"
#include "engine/render/scene/frame_params.h"
#include "engine/render/scene/light_map.h"
#include "engine/render/trace/trace_scene.h"
#include "game/model_scene.h"
#include "tests/fuzz/input_folder.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const sl::InputFolder files;
    const std::string_view text = sl::text_of(data, size);
    const auto file = files.write(text.starts_with("VOX ") ? "model.vox" : "model.gltf", text);
    sl::App app;
    app.world.resource<sl::ModelLibrary>().at_once = true;
    try {
        sl::add_model_scene(app, file);
        app.schedule.run(app.world);
        sl::complete_model_scene(app);
    } catch (const sl::Error&) {
        return 0;
    }
    for (int frame = 0; frame < 2; ++frame) {
        app.schedule.run(app.world);
        sl::RenderScene scene;
        sl::extract(app.world, scene);
        if (!scene.view) return 0;
        const sl::LightTable lights = sl::build_light_table(scene);
        const sl::FrameParams params = sl::frame_params(scene, 640, 360, 0);
        (void)sl::visible_draws(scene, params.clip_from_world);
        const sl::TraceScene trace(scene);
        (void)trace.intersect_front({.origin = scene.view->position, .direction = scene.view->forward});
    }
    return 0;
}
