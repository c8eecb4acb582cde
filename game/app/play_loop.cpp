// SPDX-License-Identifier: MIT
#include "engine/core/clock.h"
#include "engine/core/error.h"
#include "engine/core/log.h"
#include "engine/ecs/systems/day_cycle.h"
#include "engine/render/image_layers.h"
#include "engine/render/pass_times.h"
#include "engine/render/refined_share.h"
#include "engine/render/scene/extract.h"
#include "engine/render/trace/light_meter.h"
#include "game/app/open_game.h"
#include "game/app/picture_file.h"
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

std::filesystem::file_time_type newest_change(const std::filesystem::path& folder) {
    auto newest = std::filesystem::file_time_type::min();
    std::error_code ignored;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, ignored)) {
        newest = std::max(newest, entry.last_write_time(ignored));
    }
    return newest;
}

/// What is shown while the files of a scene are read.
PlaySettings placeholder_of(PlaySettings settings) {
    settings.scene = {.scene = "empty"};
    return settings;
}

std::string_view method_name(const RenderScene& scene) {
    return scene.gi ? scene.gi->method.name() : GiOff::name;
}

}  // namespace

Play::Play(const PlaySettings& settings)
    : settings_(settings),
      user_(settings_path()),
      opening_(opening_of(settings)),
      app_(open_game(opening_ ? placeholder_of(settings) : settings)),
      window_(window_settings(settings.window, user_.values().picture)),
      context_(gl::create_context(gl::ContextKind::window, window_.native())),
      widgets_(window_) {
    renderer_.emplace(shader_folder());
    user_.override_render_scale(settings_.render_scale);
    user_.enter(app_, !settings_.scene.chooses_light());
    menu_.folder = worlds_folder();
    // Last: no file is left behind by a game that does not begin.
    if (settings_.new_world) make_world(app_, settings_);
    placeholder_ = opening_.has_value();
}

void Play::run() {
    std::uint64_t drawn = 0;
    last_frame_ = Clock::now();
    while (!window_.close_requested() || !may_leave("close")) {
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
    go_on_opening();
    Input input = window_.poll();
    open_dropped(input.dropped);
    steer_menu(input);
    const double seconds = step_clock();
    window_keys(input);
    user_.follow(app_, window_, !ImguiLayer::has_active_widget());
    menu_.is_open() ? held_over_.note(input) : held_over_.remove_from(input);
    widgets_.begin(input, menu_.is_open() && menu_.page != MenuPage::press_key);
    editor_.scale = widgets_.scale();
    capture_on_click(input);
    app_.world.resource<Input>() = menu_.is_open() ? Input{} : player_input(input, user_.values(), seconds);
    // Figures and truths need a light that rests.
    app_.world.resource<DayPause>().on = editor_.open;
    app_.schedule.run(app_.world);
    log_model_faults();
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
    if (const auto format = std::exchange(editor_.picture.wish, {})) save_picture(*format);
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
    if (keys.pressed(Key::f12)) editor_.picture.wish = PictureFormat::png;
    if (keys.pressed(Key::h) && !ImguiLayer::has_keyboard()) help_ = !help_;
    if (keys.pressed(Key::f1)) {
        editor_.open = !editor_.open;
        editor_.open ? free_mouse() : give_mouse_back();
    }
    input.mouse_captured = window_.mouse_captured();
}

void Play::capture_on_click(Input& input) {
    if (menu_.is_open() || window_.mouse_captured() || !input.pressed(MouseButton::left)) return;
    if (!click_picture(editor_)) window_.capture_mouse(true);
    input.ignore_mouse();
}

void Play::render(uvec2 window_size) {
    if (failure_) return;
    extract(app_.world, scene_);
    app_.world.resource<LightMeter>().update(scene_);
    picture_size_ = glm::max(uvec2(dvec3(window_size, 0) * user_.render_scale()), uvec2(1));
    const auto frame = static_cast<std::uint32_t>(app_.world.resource<FrameClock>().frame);
    renderer_->executor().set_timing(true);
    Renderer::Request request{.width = picture_size_.x,
                              .height = picture_size_.y,
                              .frame_index = frame,
                              .seconds = static_cast<float>(app_.world.resource<FrameClock>().step),
                              .time = app_.world.resource<FrameClock>().seconds,
                              .slice_budget = budget_.slices()};
    if (editor_.picture.wish == PictureFormat::exr) want_linear_layers(request);
    editor_.compare.prepare(scene_, request);
    editor_.see.prepare(request);
    if (editor_.open) request.wanted_if_there.push_back(refined_image);
    try {
        result_ = renderer_->render(scene_, request);
        editor_.compare.update(scene_, request, *renderer_, result_, request.seconds);
        editor_.see.update({scene_, *renderer_, result_, picture_size_, request.seconds, &app_.world.resource<LightMeter>()});
    } catch (const Error& error) {
        // A shader that was never good. What the frame left half done goes with the renderer.
        log::error("{}", error.what());
        failure_ = Failure{error.what(), method_name(scene_), newest_change(shader_folder())};
        result_ = {};
        renderer_.emplace(shader_folder());
    }
}

bool Play::worth_trying_again() {
    extract(app_.world, scene_);
    return method_name(scene_) != failure_->method || newest_change(shader_folder()) != failure_->shaders;
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
        editor_.compare.on ? show_compared(window_size) : presenter_.show(picture, picture_size_, window_size);
    }
    editor_.see.draw(app_.world, editor_.scale);
    draw_hud(app_, {.frame = result_,
                    .frame_ms = meter_.milliseconds(),
                    .gi_ms = gi_milliseconds(renderer_->executor().timers().newest()),
                    .keys = user_.values().keys,
                    .help = help_,
                    .panel = editor_.open,
                    .mouse_captured = window_.mouse_captured(),
                    .click_measures = editor_.open && editor_.see.picks,
                    .shader_errors = renderer_->executor().programs().errors(),
                    .failure = failure_ ? failure_->text : "",
                    .being_read = opening_ ? opening_->scene.being_read() : app_.world.resource<ModelLibrary>().being_read(),
                    .placeholder = placeholder_});
    draw_compare_bar(editor_.compare, editor_.scale);
    if (editor_.open && !menu_.is_open()) editor_panel(app_, panel_report(), editor_);
    show_menu();
    widgets_.draw();
    presenter_.end();
}

void Play::show_compared(uvec2 window_size) {
    for (const CompareView::Part& part : editor_.compare.parts()) {
        if (part.picture.texture != 0) presenter_.show_part(part.picture.texture, part.picture.size, window_size, part.from, part.to);
    }
}

FrameReport Play::panel_report() {
    FrameReport report = frame_report(*renderer_, result_);
    // Rarely, because reading an image waits for the graphics card.
    constexpr std::uint64_t frames_between = 30;
    if (!result_.drawn) {
        refined_.reset();
    } else if (app_.world.resource<FrameClock>().frame % frames_between == 0) {
        refined_ = refined_share(*renderer_);
    }
    report.refined = refined_;
    return report;
}

void Play::save_picture(PictureFormat format) {
    auto& notice = app_.world.resource<Notice>();
    if (!result_.drawn) return notice.say("there is no picture to save");
    try {
        const auto path = save_frame(*renderer_, result_.images, format);
        notice.say(fmt::format("saved {}", path.string()), 4.0);
        editor_.picture.saved = {fmt::format("saved {}", std::filesystem::absolute(path).string())};
        log::info("{}", editor_.picture.saved.text);
    } catch (const std::exception& error) {
        notice.say(error.what(), 6.0);
        editor_.picture.saved = {error.what(), true};
        log::error("{}", error.what());
    }
}

}  // namespace sl
