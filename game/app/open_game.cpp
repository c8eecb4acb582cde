// SPDX-License-Identifier: MIT
#include "game/app/open_game.h"

#include "engine/core/log.h"
#include "engine/ecs/systems/load_models.h"
#include "engine/render/trace/light_meter.h"
#include "game/block_tool.h"
#include "game/flashlight.h"
#include "game/fly_camera.h"
#include "game/light_keys.h"
#include "game/notice.h"
#include "game/player/player.h"
#include "game/saved_world.h"
#include "game/streaming/terrain_stream.h"

namespace sl {

App open_game(PlaySettings settings) {
    std::unique_ptr<WorldFile> file;
    if (!settings.world.empty() && !settings.new_world) {
        file = WorldFile::open(settings.world);
        settings.scene.scene = file->scene();
    }
    App app = open_scene(settings.scene);
    make_playable(app);
    if (file) attach_world(app, std::move(file));
    return app;
}

void make_playable(App& app) {
    // What is near is there; from now on nothing waits for the rest.
    app.world.resource<TerrainView>().at_once = false;
    app.world.resource<ModelLibrary>().at_once = false;
    add_light_keys(app);
    add_block_tool(app);
    add_fly_camera(app);
    add_player(app);
    add_flashlight(app);
    app.world.emplace_resource<LightMeter>();
}

void make_world(App& app, const PlaySettings& settings) {
    const std::string& scene = settings.scene.scene;
    // A path must lead there from any folder.
    const std::filesystem::path file = scene_path(scene);
    const std::string lasting = file == scene ? std::filesystem::absolute(file).string() : scene;
    try {
        if (settings.world.parent_path() == worlds_folder()) std::filesystem::create_directories(settings.world.parent_path());
        attach_world(app, WorldFile::create(settings.world, lasting));
    } catch (const std::exception& error) {
        if (!settings.unsaved_if_need_be) throw;
        log::warn("nothing is saved: {}", error.what());
        app.world.resource<Notice>().say(fmt::format("nothing is saved: {}", error.what()), 20.0);
    }
}

}  // namespace sl
