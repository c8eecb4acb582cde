// SPDX-License-Identifier: MIT
#include "engine/core/log.h"
#include "game/app/open_game.h"
#include "game/app/play.h"
#include "game/saved_world.h"

namespace sl {

namespace {

/// A window that is as high as what is in it is not seen in its first frame.
constexpr int frames_to_tell = 3;

const WorldFile* world_file(App& app) {
    const auto* saved = app.world.find_resource<SavedWorld>();
    return saved != nullptr ? saved->file.get() : nullptr;
}

bool is_open(const WorldFile* file, const std::filesystem::path& path) {
    std::error_code ignored;
    return file != nullptr && std::filesystem::equivalent(file->path(), path, ignored);
}

}  // namespace

void Play::free_mouse() {
    recapture_ = recapture_ || window_.mouse_captured();
    window_.capture_mouse(false);
}

void Play::give_mouse_back() {
    if (editor_.open || menu_.is_open()) return;
    if (std::exchange(recapture_, false)) window_.capture_mouse(true);
}

void Play::steer_menu(const Input& input) {
    if (ImguiLayer::has_keyboard() && !menu_.is_open()) return;
    const bool was_open = menu_.is_open();
    menu_keys(menu_, input, user_.values());
    if (menu_.is_open() && !was_open) free_mouse();
    if (!menu_.is_open() && was_open) give_mouse_back();
}

void Play::show_menu() {
    const bool was_open = menu_.is_open();
    const MenuWish wish = draw_menu(menu_, user_.values(), world_file(app_));
    if (wish.quit) window_.request_close();
    if (wish.world) may_leave(wish.world->path.string()) ? choose_world(*wish.world) : void(menu_.problem = unsaved_changes);
    if (!menu_.is_open() && was_open) give_mouse_back();
}

void Play::choose_world(const WorldChoice& choice) {
    if (is_open(world_file(app_), choice.path)) return show_page(menu_, MenuPage::closed);
    wanted_world_ = choice;
    frames_until_opened_ = frames_to_tell;
    show_page(menu_, MenuPage::opening_world);
    menu_.chosen = choice.path;
}

void Play::open_wanted_world() {
    if (!wanted_world_ || --frames_until_opened_ > 0) return;
    const WorldChoice choice = *std::exchange(wanted_world_, std::nullopt);
    try {
        finish_world(app_.world);
        change_world(choice);
        show_page(menu_, MenuPage::closed);
        give_mouse_back();
    } catch (const std::exception& error) {
        log::warn("{}", error.what());
        show_worlds(menu_, world_file(app_));
        menu_.problem = error.what();
    }
}

void Play::change_world(const WorldChoice& choice) {
    PlaySettings next = settings_;
    next.scene = {};
    next.world = choice.path;
    next.new_world = !choice.scene.empty();
    next.unsaved_if_need_be = false;
    if (next.new_world) next.scene.scene = choice.scene;
    App app = open_game(next);
    if (next.new_world) make_world(app, next);
    user_.enter(app, true);
    show_instead(std::move(app), std::move(next));
}

void Play::show_instead(App app, PlaySettings settings) {
    // What was wished for earlier and is still being read comes no more.
    opening_.reset();
    settings_ = std::move(settings);
    app_ = std::move(app);
    renderer_.emplace(shader_folder());
    result_ = {};
    failure_.reset();
    editor_ = {};
    placeholder_ = false;
    last_frame_ = Clock::now();
}

}  // namespace sl
