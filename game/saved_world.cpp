// SPDX-License-Identifier: MIT
#include "game/saved_world.h"

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "engine/core/clock.h"
#include "engine/core/error.h"
#include "engine/core/log.h"
#include "engine/ecs/components.h"
#include "engine/ecs/query.h"
#include "game/crystals/crystals.h"
#include "game/session.h"
#include "game/voxel_content.h"

namespace sl {

namespace {

constexpr double player_is_saved_every = 1.0;  // s
constexpr double longest_wait = 3.0;           // s
constexpr const char* player_key = "player";
constexpr const char* crystals_key = "crystals";
constexpr const char* day_key = "day";

std::string player_text(World& world, Entity camera) {
    const auto& place = world.get<Transform>(camera);
    const dvec3& at = place.translation;
    const quat& turn = place.rotation;
    return nlohmann::json{{"translation", {at.x, at.y, at.z}}, {"rotation", {turn.x, turn.y, turn.z, turn.w}}}.dump();
}

/// Nothing where the text is none of player_text.
void place_player(World& world, Entity camera, const std::string& text) {
    const auto json = nlohmann::json::parse(text, nullptr, false);
    const auto numbers = [&](const char* key, std::size_t count) {
        std::vector<double> values;
        if (!json.is_object() || !json.contains(key) || !json[key].is_array() || json[key].size() != count) return values;
        for (const auto& value : json[key]) values.push_back(value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN());
        return std::ranges::all_of(values, [](double value) { return std::abs(value) <= 1e7; }) ? values : std::vector<double>();
    };
    const auto at = numbers("translation", 3), turn = numbers("rotation", 4);
    if (at.empty() || turn.empty()) return log::warn("the world does not tell where the player was; it begins as the scene does");
    const quat rotation(static_cast<float>(turn[3]), static_cast<float>(turn[0]), static_cast<float>(turn[1]), static_cast<float>(turn[2]));
    if (!(glm::length(rotation) > 0.5f)) return;
    auto& place = world.get<Transform>(camera);
    place.translation = {at[0], at[1], at[2]};
    place.rotation = glm::normalize(rotation);
}

/// Empty in scenes without a day.
std::string day_text(World& world) {
    for (auto [entity, day] : Query<const DayCycle>(world)) {
        // While it runs, tenths are enough: nothing is to be written every second of a day that nobody plays.
        const double hour = day.runs ? std::floor(day.hour * 10.0) / 10.0 : day.hour;
        return nlohmann::json{{"hour", hour}, {"declination", day.declination}, {"runs", day.runs}}.dump();
    }
    return {};
}

/// Nothing where the text is none of day_text.
void set_day(World& world, const std::string& text) {
    const auto json = nlohmann::json::parse(text, nullptr, false);
    const auto number = [&](const char* key, double most) {
        const bool there = json.is_object() && json.contains(key) && json[key].is_number();
        const double value = there ? json[key].template get<double>() : std::numeric_limits<double>::quiet_NaN();
        return std::abs(value) <= most ? std::optional<double>(value) : std::nullopt;
    };
    const auto hour = number("hour", 24.0), declination = number("declination", 1.5708);
    if (!hour || *hour < 0.0 || !declination || !json.contains("runs") || !json["runs"].is_boolean()) {
        return log::warn("the world does not tell which hour it was; it begins as the scene does");
    }
    for (auto [entity, day] : Query<DayCycle>(world)) {
        day.hour = *hour;
        day.declination = static_cast<float>(*declination);
        day.runs = json["runs"].get<bool>();
        day.shown = {};
        return;
    }
}

/// Nothing where the text is no list of names.
void wake_crystals(World& world, const std::string& text) {
    const auto json = nlohmann::json::parse(text, nullptr, false);
    if (!json.is_array()) return log::warn("the world does not tell which crystals are awake; all sleep");
    for (auto [entity, crystal, name] : Query<Crystal, const Name>(world)) {
        crystal.awake = crystal.awake || std::ranges::any_of(json, [&](const auto& one) { return one.is_string() && one.template get_ref<const std::string&>() == name.value; });
    }
}

/// Saved where it differs from what was saved last.
void save_changed(SavedWorld& saved, const char* key, std::string text) {
    std::string& last = saved.texts[key];
    if (text == last) return;
    last = text;
    saved.file->save_text(key, std::move(text));
}

/// The entity itself, or the one that came in its place.
Entity living(World& world, const SavedWorld::Volume& volume) {
    if (world.alive(volume.entity)) return volume.entity;
    for (auto [entity, generator, name] : Query<const VoxelGenerator, const Name>(world)) {
        if (name.value == volume.name) return entity;
    }
    return {};
}

void build_again(World& world, SavedWorld::Volume& volume) {
    volume.entity = living(world, volume);
    const auto* content = volume.entity ? world.find<VoxelContent>(volume.entity) : nullptr;
    if (content == nullptr || content->volume == volume.filled) return;
    volume.filled = content->volume;
    for (const auto& [cell, block] : volume.built) put_block(world, volume.entity, {cell[0], cell[1], cell[2]}, block);
}

}  // namespace

std::filesystem::path worlds_folder() {
    const char* data = std::getenv("XDG_DATA_HOME");
    const char* home = std::getenv("HOME");
    if (data != nullptr && *data == '/') return std::filesystem::path(data) / "secondlight/worlds";
    if (home != nullptr && *home == '/') return std::filesystem::path(home) / ".local/share/secondlight/worlds";
    return std::filesystem::temp_directory_path() / "secondlight/worlds";
}

void attach_world(App& app, std::unique_ptr<WorldFile> file) {
    World& world = app.world;
    SavedWorld saved;
    for (auto [entity, generator] : Query<const VoxelGenerator>(world)) {
        const Name* name = world.find<Name>(entity);
        saved.volumes.push_back({.entity = entity, .name = name != nullptr ? name->value : "", .built = {}, .filled = {}});
    }
    std::size_t lost = 0;
    for (const BlockEdit& edit : file->edits()) {
        edit.volume < saved.volumes.size() ? void(saved.volumes[edit.volume].built[{edit.cell.x, edit.cell.y, edit.cell.z}] = edit.block) : void(++lost);
    }
    for (SavedWorld::Volume& volume : saved.volumes) build_again(world, volume);
    if (lost > 0) log::warn("{}: the scene {} has no place for {} changed blocks", file->path().string(), file->scene(), lost);
    const Entity camera = active_camera(world);
    if (const std::string player = file->text(player_key); camera && world.has<Transform>(camera) && !player.empty()) place_player(world, camera, player);
    if (const std::string awake = file->text(crystals_key); !awake.empty()) wake_crystals(world, awake);
    if (const std::string day = file->text(day_key); !day.empty()) set_day(world, day);
    saved.file = std::move(file);
    // From now on, and not what was just read.
    world.add_resource(EditJournal{});
    world.add_resource(std::move(saved));
    app.schedule.add(Stage::present, "save_world", &save_world);
    app.schedule.run(world);
}

void finish_world(World& world) {
    auto* saved = world.find_resource<SavedWorld>();
    if (saved == nullptr) return;
    saved->unsaved = player_is_saved_every;
    save_world(world);
    if (saved->file->read_only() || saved->file->wait(longest_wait)) return;
    const WorldFile::Status status = saved->file->status();
    fail("this world is not left, for {} changes are not saved yet: {}", status.waiting, status.problem);
}

void save_world(World& world) {
    auto& saved = world.resource<SavedWorld>();
    for (const EditJournal::Edit& edit : std::exchange(world.resource<EditJournal>().edits, {})) {
        const auto volume = std::ranges::find(saved.volumes, edit.entity, &SavedWorld::Volume::entity);
        if (volume == saved.volumes.end()) continue;
        volume->built[{edit.cell.x, edit.cell.y, edit.cell.z}] = edit.block;
        saved.file->save({static_cast<std::uint32_t>(volume - saved.volumes.begin()), edit.cell, edit.block});
    }
    for (SavedWorld::Volume& volume : saved.volumes) build_again(world, volume);
    // Unlike a step of the player, a crystal that woke must not be lost.
    if (world.find_resource<CrystalSearch>() != nullptr) save_changed(saved, crystals_key, nlohmann::json(awake_crystals(world)).dump());
    saved.unsaved += world.resource<FrameClock>().step;
    const Entity camera = active_camera(world);
    if (saved.unsaved < player_is_saved_every || !camera || !world.has<Transform>(camera)) return;
    saved.unsaved = 0.0;
    save_changed(saved, player_key, player_text(world, camera));
    if (std::string day = day_text(world); !day.empty()) save_changed(saved, day_key, std::move(day));
}

}  // namespace sl
