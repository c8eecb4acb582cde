// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <optional>

#include "editor/editor_panel.h"
#include "editor/imgui_layer.h"
#include "game/app/commands.h"
#include "game/app/hud.h"
#include "game/app/live_settings.h"
#include "game/app/presenter.h"
#include "game/app/slice_budget.h"
#include "game/menu/menu.h"
#include "game/settings/held_over.h"

namespace sl {

inline constexpr const char* unsaved_changes = "The scene has changes that no file holds: save them (F1, Scene), or ask once more to leave them.";

struct PlaySettings {
    SceneChoice scene;
    std::filesystem::path world;  ///< where changes are kept; empty: nowhere
    bool new_world = false;       ///< it is made from the scene; otherwise it is there and names its scene
    bool unsaved_if_need_be = false;  ///< where it cannot be made, the game goes on without
    WindowSettings window;
    std::optional<double> render_scale;  ///< pixels drawn per pixel shown, per axis; else what the player's settings say
    std::uint64_t max_frames = 0;  ///< 0: until the window is closed
};

/// The game in a window: everything from the context to the loop. Construction throws Error like open_scene
/// and Window.
class Play {
  public:
    explicit Play(const PlaySettings& settings);
    /// Until the window is closed. Throws Error at the end when the driver reported errors.
    void run();

  private:
    using Clock = std::chrono::steady_clock;
    struct Opening {
        SceneOpening scene;
        PlaySettings settings;
    };

    /// Of what shows models, whose files are read while the window is there; worlds, and what they are made from, are not.
    static std::optional<Opening> opening_of(const PlaySettings& settings);
    void frame();
    double step_clock();
    /// Frees the mouse for menu or panel, and captures it again where it was when both are gone.
    void free_mouse();
    void give_mouse_back();
    void steer_menu(const Input& input);
    void show_menu();
    void choose_world(const WorldChoice& choice);
    void open_wanted_world();
    /// Files that were dropped onto the window: a world, a scene or a model.
    void open_dropped(const std::vector<std::filesystem::path>& files);
    /// Throws Error where it cannot be opened and there is nothing else to show.
    void go_on_opening();
    void log_model_faults();
    /// Whether what the panel changed may be lost: a file holds it, or the same was wished twice within a few seconds.
    bool may_leave(const std::string& wish);
    /// Throws Error, and leaves the old world as it is where the new one cannot be opened.
    void change_world(const WorldChoice& choice);
    /// Nothing can fail from here on.
    void show_instead(App app, PlaySettings settings);
    /// Keys of the window itself, which also work while a widget has the keyboard.
    void window_keys(Input& input);
    void capture_on_click(Input& input);
    void render(uvec2 window_size);
    bool worth_trying_again();
    void reload_shaders();
    void show(uvec2 window_size);
    void show_compared(uvec2 window_size);
    FrameReport panel_report();
    void save_picture(PictureFormat format);

    PlaySettings settings_;
    LiveSettings user_;
    std::optional<Opening> opening_;
    App app_;
    Window window_;
    std::unique_ptr<gl::Context> context_;
    std::optional<Renderer> renderer_;
    ImguiLayer widgets_;
    Presenter presenter_;
    EditorState editor_;
    Menu menu_;
    HeldOver held_over_;
    std::optional<WorldChoice> wanted_world_;
    int frames_until_opened_ = 0;  ///< while the menu says which world is being opened
    std::vector<std::string> model_faults_;  ///< that the log knows
    bool placeholder_ = false;  ///< what is shown only stands for what is being opened
    std::string asked_;         ///< for what may_leave was asked last, and when
    Clock::time_point asked_at_{};
    RenderScene scene_;
    Renderer::Result result_;
    uvec2 picture_size_{0};
    SliceBudget budget_;
    FrameMeter meter_;
    Clock::time_point last_frame_ = Clock::now();
    Clock::time_point last_reload_ = Clock::now();
    /// Why the last try to render gave no picture, and what it was made from: with another method or another
    /// shader it is tried again.
    struct Failure {
        std::string text;
        std::string_view method;
        std::filesystem::file_time_type shaders{};
    };
    std::optional<Failure> failure_;
    bool help_ = false;
    std::optional<double> refined_;  ///< as it was read last, for the panel
    bool recapture_ = false;  ///< panel or menu freed the mouse and gives it back
};

}  // namespace sl
