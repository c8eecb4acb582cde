// SPDX-License-Identifier: MIT
#include "game/menu/menu.h"

#include <gmock/gmock.h>
#include <imgui_internal.h>
#include <unistd.h>

#include "editor/imgui_navigation.h"
#include "editor/imgui_taps.h"
#include "engine/core/text_file.h"
#include "game/menu/keys_text.h"
#include "tests/editor/imgui_test.h"

namespace sl {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr MenuPage all_pages[] = {MenuPage::pause, MenuPage::worlds, MenuPage::new_world, MenuPage::delete_world, MenuPage::opening_world, MenuPage::settings, MenuPage::keys, MenuPage::press_key, MenuPage::help};

/// The menu over a screen that nobody sees, with three worlds, one of them damaged, in a folder of its own.
class MenuTest : public ImguiTest {
  protected:
    Menu menu_;
    UserSettings settings_;
    MenuWish wish_;
    std::string text_;

    MenuTest() {
        resize(1280, 720, 1.0f);
        ImGui::GetIO().ClipboardUserData = &text_;
        for (int key = 0; key < ImGuiKey_COUNT; ++key) ImGui::GetIO().KeyMap[key] = key;
        menu_.folder = std::filesystem::temp_directory_path() / fmt::format("secondlight_menu_{}", ::getpid());
        std::filesystem::create_directories(menu_.folder);
        for (const char* name : {"first", "second"}) (void)WorldFile::create(world_path(menu_.folder, name), "outdoor");
        write_text_file(world_path(menu_.folder, "damaged"), std::string(3000, 'x'));
        menu_.scenes = {{"indoor", "A room."}, {"outdoor", "A village."}};
        menu_.new_name = "World 1";
        menu_.chosen = world_path(menu_.folder, "first");
    }
    ~MenuTest() override { std::filesystem::remove_all(menu_.folder); }

    static void resize(float width, float height, float scale) {
        ImGui::GetIO().DisplaySize = ImVec2(width, height);
        ImGui::GetIO().FontGlobalScale = scale;
    }
    void show(const Input& input = {}) {
        menu_keys(menu_, input, settings_);
        keep_taps(input);
        navigate_widgets(menu_.is_open() && menu_.page != MenuPage::press_key, input);
        ImGui::NewFrame();
        ImGui::LogToClipboard();  // until the end of the menu's window
        wish_ = draw_menu(menu_, settings_, nullptr);
        ImGui::Render();
    }
    void settle() {
        for (int i = 0; i < 4; ++i) show();
    }
    void press(Key key) {
        Input input;
        input.keys_pressed.set(static_cast<std::size_t>(key));
        show(input);
    }
    void press(GamepadButton button) {
        Input input;
        input.gamepad.connected = true;
        input.gamepad.buttons_down.set(static_cast<std::size_t>(button));
        input.gamepad.buttons_pressed.set(static_cast<std::size_t>(button));
        show(input);
        const MenuWish wished = wish_;
        settle();
        wish_ = wished;
    }
    /// As somebody with a gamepad chooses the widget that lies so many below the first.
    void choose(int below) {
        settle();
        press(GamepadButton::back);
        for (int i = 0; i < below; ++i) press(GamepadButton::down);
        press(GamepadButton::a);
    }
};

TEST_F(MenuTest, EveryPageFitsEveryScreen) {
    const vec3 screens[] = {{640, 360, 1}, {1280, 720, 1}, {3840, 2160, 2}, {333, 77, 1}, {1, 1, 1}};
    for (const vec3 screen : screens) {
        resize(screen.x, screen.y, screen.z);
        for (const MenuPage page : all_pages) {
            menu_.page = page;
            menu_.worlds = list_worlds(menu_.folder, nullptr);
            settle();
            EXPECT_EQ(menu_.page, page);
            EXPECT_NE(text_, "");
            if (screen.x < 640) continue;  // it must not crash there; nobody could read it
            for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
                if (!window->WasActive || window->Hidden) continue;
                EXPECT_GE(window->Pos.x, 0.0f);
                EXPECT_GE(window->Pos.y, 0.0f);
                EXPECT_LE(window->Pos.x + window->Size.x, screen.x) << window->Name;
                EXPECT_LE(window->Pos.y + window->Size.y, screen.y) << window->Name;
                EXPECT_LE(window->ContentSize.x, window->WorkRect.GetWidth() + 1.0f) << window->Name << " is cut off at its right";
            }
        }
    }
}

TEST_F(MenuTest, EscapeOpensGoesBackAndCloses) {
    press(Key::escape);
    EXPECT_EQ(menu_.page, MenuPage::pause);
    for (const MenuPage page : all_pages) {
        menu_.page = page;
        for (int i = 0; i < 5 && menu_.is_open(); ++i) press(Key::escape);
        EXPECT_FALSE(menu_.is_open());
    }
    EXPECT_EQ(settings_, UserSettings{});
}

TEST_F(MenuTest, AGamepadReachesEveryPage) {
    const std::pair<int, MenuPage> pages[] = {{1, MenuPage::worlds}, {2, MenuPage::settings}, {3, MenuPage::help}, {0, MenuPage::closed}};
    for (const auto& [below, page] : pages) {
        menu_.page = MenuPage::closed;
        settle();
        press(GamepadButton::start);
        ASSERT_EQ(menu_.page, MenuPage::pause);
        choose(below);
        EXPECT_EQ(menu_.page, page);
        if (menu_.is_open()) press(GamepadButton::b);
        EXPECT_EQ(menu_.page, page == MenuPage::closed ? MenuPage::closed : MenuPage::pause);
    }
}

TEST_F(MenuTest, QuitIsAWish) {
    menu_.page = MenuPage::pause;
    choose(4);
    EXPECT_TRUE(wish_.quit);
}

TEST_F(MenuTest, AKeyIsChosenByPressingItAndConflictsAreShown) {
    menu_.page = MenuPage::keys;
    settle();
    EXPECT_THAT(text_, Not(HasSubstr("also")));
    press(GamepadButton::a);
    ASSERT_EQ(menu_.page, MenuPage::press_key);
    EXPECT_EQ(menu_.rebound, Action::forward);
    press(Key::g);
    EXPECT_EQ(menu_.page, MenuPage::keys);
    EXPECT_EQ(settings_.keys[Action::forward], Key::g);
    settle();
    EXPECT_THAT(text_, HasSubstr("also next_gi_method"));
    EXPECT_THAT(text_, HasSubstr("also forward"));
}

TEST_F(MenuTest, EscapeKeepsTheKey) {
    menu_.page = MenuPage::press_key;
    menu_.rebound = Action::jump;
    press(Key::escape);
    EXPECT_EQ(menu_.page, MenuPage::keys);
    EXPECT_EQ(settings_, UserSettings{});
}

TEST_F(MenuTest, SettingsShowAllThereIsAndStayAsTheyAre) {
    menu_.page = MenuPage::settings;
    settle();
    for (const char* word : {"mouse_sensitivity", "invert_y", "vsync", "render_scale", "view_distance", "as_the_scene_has_it", "budget_ms"}) EXPECT_THAT(text_, HasSubstr(word));
    EXPECT_EQ(settings_, UserSettings{});
    choose(3);  // below Keys, Back and mouse_sensitivity
    EXPECT_TRUE(settings_.controls.invert_y);
}

TEST_F(MenuTest, HelpShowsTheKeysAsTheyAreNow) {
    settings_.keys[Action::flashlight] = Key::page_up;
    menu_.page = MenuPage::help;
    settle();
    EXPECT_THAT(text_, HasSubstr("Page up"));
    EXPECT_THAT(text_, HasSubstr("W A S D        Walk"));
    EXPECT_THAT(text_, HasSubstr("right trigger"));
    for (const char* tab : {"Light", "Scene", "Compare", "See", "Picture", "Frame"}) EXPECT_THAT(text_, HasSubstr(tab));
    EXPECT_THAT(text_, HasSubstr("drags the sun"));
    EXPECT_LE(std::ranges::count(keys_text(settings_.keys), '\n'), 24) << "it must fit a window 360 pixels high";
}

TEST_F(MenuTest, DamagedWorldsAreListedWithTheirFaultAndCannotBePlayed) {
    show_worlds(menu_, nullptr);
    settle();
    for (const char* word : {"first", "second", "damaged", "no world", "outdoor", "KiB"}) EXPECT_THAT(text_, HasSubstr(word));
    EXPECT_EQ(std::ranges::count_if(menu_.worlds, [](const WorldEntry& world) { return world.fault.empty(); }), 2);
    choose(2);  // New world, Back, and the first that can be played
    ASSERT_TRUE(wish_.world);
    EXPECT_THAT(wish_.world->path.string(), Not(HasSubstr("damaged")));
    EXPECT_EQ(wish_.world->scene, "");
}

TEST_F(MenuTest, AWorldIsDeletedOnlyWhereTheQuestionIsAnswered) {
    menu_.page = MenuPage::delete_world;
    settle();
    EXPECT_THAT(text_, HasSubstr("\"first\""));
    press(GamepadButton::a);
    EXPECT_EQ(menu_.page, MenuPage::worlds) << "the first answer keeps it";
    EXPECT_EQ(menu_.worlds.size(), 3u);
    show_page(menu_, MenuPage::delete_world);
    choose(1);
    EXPECT_EQ(menu_.worlds.size(), 2u);
    EXPECT_FALSE(std::filesystem::exists(menu_.chosen));
}

TEST_F(MenuTest, ANewWorldNeedsAGoodName) {
    menu_.page = MenuPage::new_world;
    menu_.new_name = "a/b";
    choose(0);
    EXPECT_FALSE(wish_.world);
    EXPECT_THAT(text_, HasSubstr("must do without /"));
    menu_.new_name = "Grotto";
    menu_.page = MenuPage::closed;
    settle();
    menu_.page = MenuPage::new_world;
    choose(0);
    ASSERT_TRUE(wish_.world);
    EXPECT_EQ(wish_.world->path, menu_.folder / "Grotto.world");
    EXPECT_EQ(wish_.world->scene, "indoor");
}

}  // namespace
}  // namespace sl
