// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include "engine/core/field_list.h"
#include "engine/render/capture.h"
#include "game/app/headless.h"
#include "game/gi_presets.h"

namespace sl {

namespace {

void list_scenes() {
    const auto scenes = scene_names();
    std::size_t longest = 0;
    for (const SceneListing& scene : scenes) longest = std::max(longest, scene.name.size());
    for (const SceneListing& scene : scenes) fmt::print("{:<{}}  {}\n", scene.name, longest, scene.description);
}

void list_methods() {
    const std::vector<GiPreset> presets = gi_presets();
    for (const std::string_view name : gi_method_names()) {
        fmt::print("{:<24}{}\n", name, make_gi_method(name).claims());
        for (const FieldRow& row : list_fields(GiSettings{make_gi_method(name)})) {
            if (row.name == "preset") fmt::print("  {:<22}{}\n", fmt::format("{}:PRESET", name), row.range);
        }
        for (const GiPreset& preset : presets) {
            if (preset.method != name) continue;
            fmt::print("  {:<22}{} ({:.3g} ms, NRMSE {:.0f} %, as measured)\n", fmt::format("{}:{}", name, preset.step), fmt::join(preset.settings, ", "), preset.gi_ms, 100.0 * preset.nrmse);
        }
    }
}

void print_rows(const std::string& component, const std::vector<FieldRow>& rows) {
    for (const FieldRow& row : rows) {
        const std::string unit = row.unit.empty() ? "" : " " + row.unit;
        fmt::print("{:<36}{:<14}{}\n    {}\n", component + "." + row.name, row.value, row.range + unit, row.help);
    }
}

void list_settings() {
    App app = empty_game();
    for (const ComponentType& type : app.registry().types()) {
        if (type.name == "gi") continue;
        FieldLister lister;
        type.visit_default(lister);
        print_rows(type.name, lister.rows);
    }
    // A method's settings are there while the method is chosen, so each method is asked for its own.
    for (const std::string_view name : gi_method_names()) {
        fmt::print("\nwith gi.method={}:\n", name);
        print_rows("gi", list_fields(GiSettings{make_gi_method(name)}));
    }
}

void list_passes(const GlobalFlags& global) {
    Headless headless(global);
    for (const std::string_view method : gi_method_names()) {
        App app = open_scene({.scene = "outdoor", .gi = std::string(method), .sets = {}});
        headless.renderer.forget();  // what another method has drawn would not be drawn again
        (void)capture(app, headless.renderer, {.width = 16, .height = 9});
        std::vector<std::string> passes;
        for (const Step& step : headless.renderer.steps()) {
            passes.push_back(headless.renderer.graph().passes()[static_cast<std::size_t>(step.pass)].name);
        }
        fmt::print("with gi.method={}:\n  passes: {}\n  images for --show: {}\n", method, fmt::join(passes, ", "),
                   fmt::join(image_names(headless.renderer.graph()), ", "));
    }
}

}  // namespace

void add_list_command(const Flags& program, const GlobalFlags& global) {
    const Flags command = program.command("list", "Tell what can be chosen");
    command.needs_command();
    const auto add = [&](const char* name, const char* help, std::function<void()> print) {
        command.command(name, help).runs([print = std::move(print)] {
            print();
            return 0;
        });
    };
    add("scenes", "Scenes that come with the game", list_scenes);
    add("methods", "GI methods and what each claims", list_methods);
    add("settings", "Every component's fields with default, range, unit and what they do", list_settings);
    add("passes", "Passes and images of a frame, per GI method", [&global] { list_passes(global); });
}

}  // namespace sl
