// SPDX-License-Identifier: MIT
#include "engine/core/log.h"
#include "engine/core/model/read_model.h"
#include "game/app/open_game.h"
#include "game/app/play.h"
#include "game/notice.h"
#include "game/saved_world.h"
#include "game/saving/world_list.h"

namespace sl {

namespace {

constexpr double seconds_to_read = 6.0, seconds_to_answer = 10.0;

bool is_scene(const std::filesystem::path& file) { return file.extension() == ".json"; }

}  // namespace

std::optional<Play::Opening> Play::opening_of(const PlaySettings& settings) {
    if (!settings.world.empty()) return std::nullopt;
    Opening opening{.scene = SceneOpening(settings.scene), .settings = settings};
    return opening.scene.shows_models() ? std::optional(std::move(opening)) : std::nullopt;
}

void Play::open_dropped(const std::vector<std::filesystem::path>& files) {
    if (files.empty()) return;
    const auto known = std::ranges::find_if(files, [](const auto& file) { return is_world_file(file) || is_scene(file) || is_model(file); });
    const auto tell = [&](const std::string& text) {
        log::warn("{}", text);
        app_.world.resource<Notice>().say(text, seconds_to_read);
    };
    if (known == files.end()) return tell(fmt::format("{}: it is no model (.gltf, .glb, .vox), scene (.json) or world (.world)", files.front().string()));
    if (!may_leave(known->filename().string())) return;
    if (is_world_file(*known)) return choose_world({.path = *known});
    if (std::exchange(wanted_world_, std::nullopt)) show_page(menu_, MenuPage::closed);
    PlaySettings next = settings_;
    next.scene = {.scene = known->string()};
    next.world.clear();
    next.new_world = false;
    try {
        if (auto opening = opening_of(next)) {
            opening_.emplace(std::move(*opening));
            return;
        }
        App app = open_game(next);
        user_.enter(app, true);
        finish_world(app_.world);
        show_instead(std::move(app), std::move(next));
    } catch (const std::exception& error) {
        tell(error.what());
    }
}

void Play::go_on_opening() {
    if (!opening_) return;
    try {
        if (!opening_->scene.advance(false)) return;
        make_playable(opening_->scene.app);
        user_.enter(opening_->scene.app, !opening_->settings.scene.chooses_light());
        finish_world(app_.world);
        Opening done = *std::exchange(opening_, std::nullopt);
        show_instead(std::move(done.scene.app), std::move(done.settings));
    } catch (const std::exception& error) {
        opening_.reset();
        if (placeholder_) throw;
        log::error("{}", error.what());
        app_.world.resource<Notice>().say(error.what(), seconds_to_read);
    }
}

void Play::log_model_faults() {
    std::vector<std::string> faults = app_.world.resource<ModelLibrary>().faults();
    for (const std::string& fault : faults) {
        if (std::ranges::find(model_faults_, fault) == model_faults_.end()) log::error("{}", fault);
    }
    model_faults_ = std::move(faults);
}

bool Play::may_leave(const std::string& wish) {
    if (editor_.history.saved()) return true;
    // Later it is another question: more may have been changed since.
    const auto now = Clock::now();
    const std::chrono::duration<double> passed = now - std::exchange(asked_at_, now);
    if (wish == std::exchange(asked_, wish) && passed.count() < seconds_to_answer) return true;
    window_.stay_open();
    log::warn("there are changes that no file holds; nothing was left");
    app_.world.resource<Notice>().say(unsaved_changes, seconds_to_answer);
    return false;
}

}  // namespace sl
