// SPDX-License-Identifier: MIT
#include "engine/core/clock.h"
#include "engine/core/error.h"
#include "engine/core/log.h"
#include "engine/render/pass_times.h"
#include "engine/render/scene/extract.h"
#include "game/app/open_game.h"
#include "game/app/play.h"
#include "game/notice.h"
#include "game/saved_world.h"
#include "game/settings/player_input.h"

namespace sl {

namespace {

constexpr double longest_step = 0.1;     // s; a pause is no flight through a wall
constexpr double reload_interval = 0.5;  // s

/// A command line holds for one run and changes no settings.
WindowSettings window_settings(WindowSettings window, const PictureSettings& picture) {
    window.vsync = window.vsync && picture.vsync;
    window.fullscreen = window.fullscreen || picture.fullscreen;
    return window;
}

bool chooses_light(const SceneChoice& scene) {
    return !scene.gi.empty() || std::ranges::any_of(scene.sets, [](const std::string& set) { return set.starts_with("gi."); });
}

std::filesystem::file_time_type newest_change(const std::filesystem::path& folder) {
    auto newest = std::filesystem::file_time_type::min();
    std::error_code ignored;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, ignored)) {
        newest = std::max(newest, entry.last_write_time(ignored));
    }
    return newest;
}

std::size_t method_index(const RenderScene& scene) {
    return scene.gi ? scene.gi->method.index() : 0;
}

std::filesystem::path free_picture_path() {
    const std::filesystem::path folder = "out";
    std::filesystem::create_directories(folder);
    for (int number = 1;; ++number) {
        const auto path = folder / fmt::format("play_{:04}.png", number);
        if (!std::filesystem::exists(path)) return path;
    }
}

}  // namespace

Play::Play(const PlaySettings& settings)
    : settings_(settings),
      user_(settings_path()),
      app_(open_game(settings)),
      window_(window_settings(settings.window, user_.values().picture)),
      context_(gl::create_context(gl::ContextKind::window, window_.native())),
      widgets_(window_) {
    renderer_.emplace(shader_folder());
    user_.override_render_scale(settings_.render_scale);
    user_.enter(app_, !chooses_light(settings_.scene));
    menu_.folder = worlds_folder();
    // Last: no file is left behind by a game that does not begin.
    if (settings_.new_world) make_world(app_, settings_);
}

void Play::run() {
    std::uint64_t drawn = 0;
    last_frame_ = Clock::now();
    while (!window_.close_requested()) {
        frame();
        if (window_.drawable() && ++drawn == settings_.max_frames) break;
    }
    user_.follow(app_, window_, true);
    if (!context_->errors().empty()) {
        fail("OpenGL reported {} errors, the first: {}", context_->errors().size(),
             context_->errors().front());
    }
}

void Play::frame() {
    open_wanted_world();
    Input input = window_.poll();
    steer_menu(input);
    const double seconds = step_clock();
    window_keys(input);
    user_.follow(app_, window_, !ImguiLayer::has_active_widget());
    menu_.is_open() ? held_over_.note(input) : held_over_.remove_from(input);
    widgets_.begin(input, menu_.is_open() && menu_.page != MenuPage::press_key);
    editor_.scale = widgets_.scale();
    capture_on_click(input);
    app_.world.resource<Input>() = menu_.is_open() ? Input{} : player_input(input, user_.values(), seconds);
    app_.schedule.run(app_.world);
    auto& notice = app_.world.resource<Notice>();
    notice.seconds_left = std::max(0.0, notice.seconds_left - seconds);

    const uvec2 size = window_.framebuffer_size();
    if (!window_.drawable()) {
        widgets_.skip();
        return;
    }
    if (result_.drawn) {
        meter_.add(seconds);
        budget_.frame_took(seconds, result_.images.gi_progress < 1.0f);
    }
    reload_shaders();
    render(size);
    if (std::exchange(save_wanted_, false)) save_picture();
    show(size);
    window_.swap();
}

double Play::step_clock() {
    const auto now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - std::exchange(last_frame_, now)).count();
    auto& clock = app_.world.resource<FrameClock>();
    clock.step = menu_.is_open() ? 0.0 : std::clamp(seconds, 1e-4, longest_step);
    clock.advance();
    return seconds;
}

void Play::window_keys(Input& input) {
    if (input.active(Key::control) && input.pressed(Key::q)) window_.request_close();
    input.mouse_captured = window_.mouse_captured();
    if (menu_.is_open()) return;
    const Input keys = with_usual_keys(input, user_.values().keys);
    if (keys.pressed(Key::f11)) {
        window_.toggle_fullscreen();
        user_.values().picture.fullscreen = window_.fullscreen();
    }
    if (keys.pressed(Key::f12)) save_wanted_ = true;
    if (keys.pressed(Key::h) && !ImguiLayer::has_keyboard()) help_ = !help_;
    if (keys.pressed(Key::f1)) {
        editor_.open = !editor_.open;
        editor_.open ? free_mouse() : give_mouse_back();
    }
    input.mouse_captured = window_.mouse_captured();
}

void Play::capture_on_click(Input& input) {
    if (menu_.is_open() || window_.mouse_captured() || !input.pressed(MouseButton::left)) return;
    window_.capture_mouse(true);
    input.ignore_mouse();
}

void Play::render(uvec2 window_size) {
    if (failure_) return;
    extract(app_.world, scene_);
    picture_size_ = glm::max(uvec2(dvec3(window_size, 0) * user_.render_scale()), uvec2(1));
    const auto frame = static_cast<std::uint32_t>(app_.world.resource<FrameClock>().frame);
    renderer_->executor().set_timing(true);
    try {
        result_ = renderer_->render(scene_, {.width = picture_size_.x,
                                             .height = picture_size_.y,
                                             .frame_index = frame,
                                             .slice_budget = budget_.slices()});
    } catch (const Error& error) {
        // A shader that was never good. What the frame left half done goes with the renderer.
        log::error("{}", error.what());
        failure_ = Failure{error.what(), method_index(scene_), newest_change(shader_folder())};
        result_ = {};
        renderer_.emplace(shader_folder());
    }
}

bool Play::worth_trying_again() {
    extract(app_.world, scene_);
    return method_index(scene_) != failure_->method || newest_change(shader_folder()) != failure_->shaders;
}

void Play::reload_shaders() {
    const auto now = Clock::now();
    if (std::chrono::duration<double>(now - last_reload_).count() < reload_interval) return;
    last_reload_ = now;
    if (failure_) {
        if (worth_trying_again()) failure_.reset();
    } else if (auto& programs = renderer_->executor().programs(); programs.reload_changed()) {
        for (const std::string& error : programs.errors()) log::error("{}", error);
        if (programs.errors().empty()) app_.world.resource<Notice>().say("shaders reloaded");
    }
}

void Play::show(uvec2 window_size) {
    presenter_.begin(window_size);
    if (result_.drawn) {
        const GLuint picture = renderer_->executor().texture(renderer_->graph(), result_.images.final);
        presenter_.show(picture, picture_size_, window_size);
    }
    draw_hud(app_, {.frame = result_,
                    .frame_ms = meter_.milliseconds(),
                    .gi_ms = gi_milliseconds(renderer_->executor().timers().newest()),
                    .keys = user_.values().keys,
                    .help = help_,
                    .mouse_captured = window_.mouse_captured(),
                    .shader_errors = renderer_->executor().programs().errors(),
                    .failure = failure_ ? failure_->text : ""});
    if (!menu_.is_open()) editor_panel(app_, *renderer_, editor_);
    show_menu();
    widgets_.draw();
    presenter_.end();
}

void Play::save_picture() {
    auto& notice = app_.world.resource<Notice>();
    if (!result_.drawn) return notice.say("there is no picture to save");
    try {
        const Image picture = renderer_->read(result_.images.final);
        Image opaque(picture.width, picture.height, 3);
        for (std::size_t i = 0; i < opaque.data.size(); ++i)
            opaque.data[i] = picture.data[i / 3 * picture.channels + i % 3];
        const auto path = free_picture_path();
        write_png(path, opaque);
        notice.say(fmt::format("saved {}", path.string()), 4.0);
        log::info("saved {}", std::filesystem::absolute(path).string());
    } catch (const std::exception& error) {
        notice.say(error.what(), 6.0);
        log::error("{}", error.what());
    }
}

}  // namespace sl
