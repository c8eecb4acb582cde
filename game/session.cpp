// SPDX-License-Identifier: MIT
#include "game/session.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "engine/core/clock.h"
#include "engine/core/closest_name.h"
#include "engine/core/error.h"
#include "engine/core/field_list.h"
#include "engine/core/json_text.h"
#include "engine/core/model/read_model.h"
#include "engine/core/text_file.h"
#include "engine/ecs/query.h"
#include "engine/ecs/scene_document.h"
#include "engine/ecs/scene_file.h"
#include "engine/ecs/set_field.h"
#include "engine/ecs/systems/load_models.h"
#include "engine/render/data_folder.h"
#include "game/camera_choice.h"
#include "game/crystals/crystals.h"
#include "game/gi_presets.h"
#include "game/model_scene.h"
#include "game/streaming/terrain_stream.h"
#include "game/voxel_content.h"

namespace sl {

namespace {

std::filesystem::path scene_folder() {
    if (const char* chosen = std::getenv("SECONDLIGHT_SCENES")) return chosen;
    return data_folder() / "game/scenes";
}

std::string description_of(const std::filesystem::path& file) {
    const auto json = nlohmann::json::parse(without_comments(read_text_file(file, most_scene_bytes)), nullptr, false);
    return json.is_object() ? json.value("description", std::string()) : std::string();
}

/// What a preset sets: one that was measured, or one of the method's own field "preset".
std::vector<std::string> preset_settings(const std::string& method, const std::string& preset) {
    std::vector<std::string> names;
    for (const GiPreset& one : gi_presets()) {
        if (one.method != method) continue;
        if (one.step == preset) return one.settings;
        names.push_back(one.step);
    }
    for (const FieldRow& row : list_fields(GiSettings{make_gi_method(method)})) {
        if (row.name == "preset") return {"preset=" + preset};
    }
    if (names.empty()) fail("the GI method {} has no presets", method);
    fail("the GI method {} has no preset '{}'; choose one of {}", method, preset, fmt::join(names, ", "));
}

ModelReading model_reading;

}  // namespace

void allow_outside_files(bool allowed) { model_reading.files_anywhere = allowed; }

std::vector<SceneListing> scene_names() {
    std::vector<SceneListing> scenes;
    for (const auto& entry : std::filesystem::directory_iterator(scene_folder())) {
        if (entry.path().extension() == ".json") scenes.push_back({entry.path().stem().string(), description_of(entry.path())});
    }
    std::ranges::sort(scenes, {}, &SceneListing::name);
    return scenes;
}

std::filesystem::path scene_path(const std::string& scene) {
    const bool is_path = scene.find('/') != std::string::npos || scene.ends_with(".json") || is_model(scene);
    if (is_path) return scene;
    std::filesystem::path file = scene_folder() / (scene + ".json");
    if (std::filesystem::exists(file)) return file;
    std::vector<std::string> names;
    for (const SceneListing& listing : scene_names()) names.push_back(listing.name);
    fail("{}, or give the path of a scene file", no_such_name("scene", scene, names));
}

void choose_gi(App& app, const std::string& gi) {
    const std::size_t colon = gi.find(':');
    const GiSettings settings{make_gi_method(gi.substr(0, colon))};
    if (const Entity camera = active_camera(app.world)) app.world.add(camera, settings);
    // All cameras alike, so that a following --set gi.field finds the field on each.
    for (auto [entity, other] : Query<GiSettings>(app.world)) other = settings;
    if (colon == std::string::npos) return;
    for (const std::string& setting : preset_settings(gi.substr(0, colon), gi.substr(colon + 1))) {
        set_field(app.world, app.registry(), "gi." + setting);
    }
}

std::uint32_t map_size(const GiSettings& settings) {
    for (const FieldRow& row : list_fields(settings)) {
        if (row.name == "rsm_size") return static_cast<std::uint32_t>(std::stoul(row.value));
    }
    return 0;
}

App empty_game() {
    App app;
    add_voxel_world(app);
    add_terrain_streaming(app);
    add_crystals(app);
    app.world.add_resource(FrameClock{});
    app.world.resource<ModelLibrary>().reading = model_reading;
    return app;
}

bool SceneChoice::chooses_light() const {
    return !gi.empty() || std::ranges::any_of(sets, [](const std::string& set) { return set.starts_with("gi."); });
}

SceneOpening::SceneOpening(SceneChoice choice) : app(empty_game()), choice_(std::move(choice)) {
    const std::filesystem::path path = scene_path(choice_.scene);
    is_model_ = is_model(path);
    if (is_model_) {
        add_model_scene(app, path);
    } else {
        read_scene(app.world, app.registry(), path);
        apply_choice();
    }
}

bool SceneOpening::shows_models() {
    bool any = false;
    Query<const ModelFile>(app.world).each([&](const ModelFile&) { any = true; });
    return any;
}

bool SceneOpening::advance(bool wait) {
    auto& library = app.world.resource<ModelLibrary>();
    library.at_once = wait;
    app.schedule.run(app.world);
    if (const auto faults = library.faults(); !faults.empty()) fail("{}", faults.front());
    if (!library.being_read().empty()) return false;
    if (!is_model_ && choice_.camera.empty()) return true;
    // It may be one of a model's.
    if (!choice_.camera.empty()) choose_camera(app.world, choice_.camera);
    if (is_model_) complete_model_scene(app);
    apply_choice();
    app.schedule.run(app.world);
    return true;
}

void SceneOpening::apply_choice() {
    if (!choice_.gi.empty()) choose_gi(app, choice_.gi);
    for (const std::string& assignment : choice_.sets) set_field(app.world, app.registry(), assignment);
}

App open_scene(const SceneChoice& choice) {
    SceneOpening opening(choice);
    opening.advance(true);
    return std::move(opening.app);
}

}  // namespace sl
