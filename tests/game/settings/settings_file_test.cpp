// SPDX-License-Identifier: MIT
#include "game/settings/settings_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

#include "engine/core/error.h"
#include "engine/core/field_list.h"
#include "engine/core/field_random.h"
#include "engine/core/text_file.h"

namespace sl {
namespace {

using testing::HasSubstr;

class SettingsFileTest : public testing::Test {
  protected:
    std::filesystem::path folder_ = std::filesystem::temp_directory_path() / fmt::format("secondlight_settings_{}", ::getpid());
    std::filesystem::path path_ = folder_ / "secondlight/settings.json";

    ~SettingsFileTest() override { std::filesystem::remove_all(folder_); }
    void write(std::string_view text) const {
        std::filesystem::create_directories(path_.parent_path());
        write_text_file(path_, text);
    }
    std::string text() const { return read_text_file(path_, 1 << 20); }
};

TEST_F(SettingsFileTest, WithoutAFileTheUsualSettingsAreInUseAndNoneIsMade) {
    const SettingsFile file(path_);
    EXPECT_EQ(file.settings, UserSettings{});
    EXPECT_EQ(file.fault(), "");
    EXPECT_FALSE(std::filesystem::exists(folder_));
}

TEST_F(SettingsFileTest, WhatIsSavedIsReadAgain) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        SettingsFile file(path_);
        RandomFields random(seed);
        each_section(file.settings, [&](const char*, auto& section) { visit_fields(random, section); });
        EXPECT_EQ(file.save(), "");
        const SettingsFile again(path_);
        EXPECT_EQ(again.fault(), "");
        EXPECT_THAT(again.warnings(), testing::IsEmpty());
        EXPECT_EQ(again.settings, file.settings);
    }
}

TEST_F(SettingsFileTest, EachFieldHasAHelpSentence) {
    UserSettings settings;
    each_section(settings, [](const char* name, auto& section) {
        for (const FieldRow& row : list_fields(section)) EXPECT_THAT(row.help, testing::EndsWith(".")) << name << '/' << row.name;
    });
}

TEST_F(SettingsFileTest, AFaultNamesFileAndPlaceAndTheFileStaysUntilSomethingIsChanged) {
    const std::pair<std::string, std::string> faults[] = {
        {R"({"secondlight_settings": 1, "controls": {"mouse_sensitivity": "high"}})", "/controls/mouse_sensitivity"},
        {R"({"secondlight_settings": 1, "picture": {"vsync": false, "render_scale": 1e9}})", "/picture/render_scale"},
        {R"({"secondlight_settings": 1, "keys": {"jump": "spaec"}})", "/keys/jump"},
        {R"({"secondlight_settings": 1, "light": []})", "/light"},
        {R"({"secondlight_settings": 2})", "/secondlight_settings"},
        {R"({"scene": "outdoor"})", "/secondlight_settings"},
        {"[]", "must be an object"},
        {"{\"secondlight_settings\": 1,\n  oops", ":2:"},
        {"", ":1:"},
        {std::string("\0\xff\xfe", 3), ":1:"}};
    for (const auto& [text_before, place] : faults) {
        SCOPED_TRACE(text_before);
        write(text_before);
        SettingsFile file(path_);
        EXPECT_THAT(file.fault(), testing::AllOf(HasSubstr(path_.string()), HasSubstr(place)));
        EXPECT_EQ(file.settings, UserSettings{}) << "nothing is taken from half a file";
        EXPECT_EQ(text(), text_before);
        file.settings.controls.invert_y = true;
        const std::filesystem::path kept = file.save();
        EXPECT_THAT(kept.string(), testing::StartsWith(path_.string() + ".broken"));
        EXPECT_EQ(read_text_file(kept, 1000), text_before);
        EXPECT_TRUE(SettingsFile(path_).settings.controls.invert_y);
        EXPECT_EQ(file.save(), "") << "the file is sound now";
    }
    EXPECT_TRUE(std::filesystem::exists(path_.string() + ".broken")) << "none of them took the place of another";
    EXPECT_TRUE(std::filesystem::exists(fmt::format("{}.broken.{}", path_.string(), std::size(faults))));
}

TEST_F(SettingsFileTest, WhatNobodyKnowsIsToldAndStays) {
    write(R"({"secondlight_settings": 1, "controls": {"invert_y": true, "moose_sensitivity": 2}, "sound": {"volume": 3}})");
    SettingsFile file(path_);
    EXPECT_EQ(file.fault(), "");
    EXPECT_TRUE(file.settings.controls.invert_y);
    EXPECT_THAT(file.warnings(), testing::ElementsAre(HasSubstr("moose_sensitivity"), HasSubstr("sound")));
    file.settings.controls.invert_y = false;
    EXPECT_EQ(file.save(), "");
    EXPECT_THAT(text(), testing::AllOf(HasSubstr("moose_sensitivity"), HasSubstr("volume"), HasSubstr("\"invert_y\": false")));
}

TEST_F(SettingsFileTest, WhereNothingCanBeWrittenSavingSaysSo) {
    for (const std::filesystem::path place : {"/proc/secondlight/settings.json", "/dev/null/settings.json"}) {
        SettingsFile file(place);
        EXPECT_EQ(file.settings, UserSettings{});
        try {
            file.save();
            ADD_FAILURE() << "saved to " << place;
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), HasSubstr(place.string()));
        }
    }
}

TEST_F(SettingsFileTest, AFolderInItsPlaceIsNeitherReadNorReplaced) {
    std::filesystem::create_directories(path_ / "inside");
    SettingsFile file(path_);
    EXPECT_THAT(file.fault(), HasSubstr("no regular file"));
    EXPECT_THROW(file.save(), Error);
    EXPECT_TRUE(std::filesystem::is_directory(path_ / "inside"));
}

TEST_F(SettingsFileTest, LiesInTheConfigFolder) {
    const auto with = [](const char* config, const char* home) {
        config != nullptr ? ::setenv("XDG_CONFIG_HOME", config, 1) : ::unsetenv("XDG_CONFIG_HOME");
        ::setenv("HOME", home, 1);
        return settings_path().string();
    };
    const std::string home = std::getenv("HOME") != nullptr ? std::getenv("HOME") : "";
    EXPECT_EQ(with("/c", "/h"), "/c/secondlight/settings.json");
    EXPECT_EQ(with(nullptr, "/h"), "/h/.config/secondlight/settings.json");
    EXPECT_EQ(with("relative", "/h"), "/h/.config/secondlight/settings.json") << "as the standard has it";
    ::unsetenv("XDG_CONFIG_HOME");
    ::setenv("HOME", home.c_str(), 1);
}

}  // namespace
}  // namespace sl
