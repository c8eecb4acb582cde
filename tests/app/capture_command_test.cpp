// SPDX-License-Identifier: MIT
#include "editor/capture_command.h"

#include <gmock/gmock.h>

#include <cstdio>

#include "editor/shell_words.h"
#include "engine/core/error.h"
#include "engine/core/field_list.h"
#include "engine/core/field_random.h"
#include "engine/ecs/query.h"
#include "engine/ecs/scene_file.h"
#include "game/session.h"

namespace sl {
namespace {

using Words = std::vector<std::string>;

/// What a shell hands to a program that is started with this line.
Words words_by_the_shell(const std::string& line) {
    const std::string command = "printf '%s\\001' " + line;
    FILE* pipe = popen(command.c_str(), "r");
    std::string text;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
    pclose(pipe);
    Words words;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = text.find('\001', begin);
        words.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return words;
}

/// The scene that the words choose; "--flag value" and "--flag=value" are the same.
SceneChoice choice_of(const Words& words) {
    SceneChoice choice;
    for (std::size_t i = 2; i < words.size(); ++i) {
        const std::size_t equals = words[i].find('=');
        const std::string flag = words[i].substr(0, equals);
        const std::string value = equals != std::string::npos ? words[i].substr(equals + 1) : words[++i];
        if (flag == "--scene") choice.scene = value;
        if (flag == "--gi") choice.gi = value;
        if (flag == "--set") choice.sets.push_back(value);
    }
    return choice;
}

std::string settings_of(App& app) {
    const Entity camera = active_camera(app.world);
    std::string text = app.world.get<Name>(camera).value + "\n";
    for (const char* component : {"gi", "camera", "transform"}) {
        const ComponentType& type = app.registry().get(component, "test");
        FieldLister lister;
        if (type.has(app.world, camera)) type.visit_copy(app.world, camera, lister);
        for (const FieldRow& row : lister.rows) text += fmt::format("{}.{}={}\n", component, row.name, row.value);
    }
    return text;
}

Words command_of(App& app) {
    return capture_command(app.world, app.registry(), uvec2(640, 360));
}

/// Opens the scene that the copied line names, as `capture` would.
App opened(App& shown) {
    const Words words = command_of(shown);
    EXPECT_EQ(words_by_the_shell(shell_line(words)), words);
    return open_scene(choice_of(words));
}

TEST(CaptureCommand, AnUnchangedSceneNeedsNoSettings) {
    App app = open_scene({.scene = "cornell"});
    const Words words = command_of(app);
    EXPECT_THAT(words, testing::Not(testing::Contains("--set")));
    EXPECT_THAT(words, testing::Not(testing::Contains("--gi")));
}

TEST(CaptureCommand, AChangedFieldIsTheOnlyOneNamed) {
    App app = open_scene({.scene = "cornell"});
    app.world.get<Camera>(active_camera(app.world)).ev100 += 0.1f;
    const Words words = command_of(app);
    EXPECT_EQ(std::ranges::count(words, "--set"), 1);
    App again = opened(app);
    EXPECT_EQ(settings_of(again), settings_of(app));
}

TEST(CaptureCommand, ReadBackItGivesTheSameSettingsForEveryMethodAndRandomValues) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        App app = open_scene({.scene = "cornell"});
        const Entity camera = active_camera(app.world);
        const auto names = gi_method_names();
        app.world.get<GiSettings>(camera).method = make_gi_method(names[seed % names.size()]);
        for (const char* component : {"gi", "camera", "transform"}) {
            if (seed % 3 == 0 && std::string_view(component) == "gi") continue;
            RandomFields random(seed);
            app.registry().get(component, "test").visit(app.world, camera, random);
        }
        app.world.get<Camera>(camera).active = true;
        App again = opened(app);
        EXPECT_EQ(settings_of(again), settings_of(app)) << shell_line(command_of(app));
    }
}

TEST(CaptureCommand, NamesThatAShellWouldTakeApartSurvive) {
    const auto path = std::filesystem::path(testing::TempDir()) / "it's $HOME; \"a scene\".json";
    for (const char* name : {"it's", "a b.c", "$(false)", "-x", "--set", "`ls`\n\\", "näher"}) {
        App app;
        app.world.create(Name{name}, Camera{}, Transform{}, GiSettings{});
        app.world.create(Name{"another"}, Camera{.active = false}, Transform{});
        write_scene(app.world, app.registry(), path);
        app.world.add_resource(SceneInfo{"", path});
        app.world.get<Camera>(active_camera(app.world)).ev100 = 3.0f;
        app.world.get<Transform>(active_camera(app.world)).translation.x = -4.5;
        App again = opened(app);
        EXPECT_EQ(settings_of(again), settings_of(app)) << name;
    }
    std::filesystem::remove(path);
}

TEST(CaptureCommand, AnotherCameraIsChosen) {
    const auto path = std::filesystem::path(testing::TempDir()) / "cameras.json";
    App app;
    const Entity first = app.world.create(Name{"first"}, Camera{}, Transform{}, GiSettings{});
    const Entity second = app.world.create(Name{"second"}, Camera{.active = false}, Transform{}, GiSettings{GiOff{}});
    write_scene(app.world, app.registry(), path);
    app.world.add_resource(SceneInfo{"", path});
    app.world.get<Camera>(first).active = false;
    app.world.get<Camera>(second).active = true;
    app.world.get<GiSettings>(second).method = RsmGrid{.step = 3};
    App again = opened(app);
    EXPECT_EQ(settings_of(again), settings_of(app));
    std::filesystem::remove(path);
}

TEST(CaptureCommand, WhatItCannotSayIsAnError) {
    App app;
    EXPECT_THROW(command_of(app), Error);
    const Entity camera = app.world.create(Name{"eye"}, Camera{}, Transform{});
    EXPECT_THROW(command_of(app), Error);
    const auto path = std::filesystem::path(testing::TempDir()) / "error.json";
    write_scene(app.world, app.registry(), path);
    app.world.add_resource(SceneInfo{"", path});
    EXPECT_NO_THROW(command_of(app));
    app.world.get<Name>(camera).value = "renamed";
    EXPECT_THROW(command_of(app), Error);
    std::filesystem::remove(path);
}

}  // namespace
}  // namespace sl
