// SPDX-License-Identifier: MIT
#include "engine/core/error.h"
#include "engine/render/capture.h"
#include "game/app/headless.h"
#include "game/app/progress.h"

namespace sl {

namespace {

struct TourFlags {
    std::string size = "640x360";
    std::string folder = "out";
    std::string gi = "facets";
};

int run_tour(const GlobalFlags& global, const TourFlags& flags) {
    const uvec2 size = parse_size(flags.size);
    (void)make_gi_method(flags.gi.substr(0, flags.gi.find(':')));  // a wrong name is told before the first picture is drawn
    std::error_code error;
    std::filesystem::create_directories(flags.folder, error);
    if (error) fail("{}: this folder cannot be made ({}); choose another --folder", flags.folder, error.message());
    Headless headless(global);
    fmt::print("Rendering without a display on {}.\n", headless.context->renderer());
    for (const char* scene : {"outdoor", "indoor"}) {
        std::vector<Image> pictures;
        for (const std::string& gi : {std::string("off"), flags.gi}) {
            App app = open_scene({.scene = scene, .gi = gi});
            Progress progress(fmt::format("{}, {}", scene, gi));
            pictures.push_back(capture(app, headless.renderer,
                                       {.width = size.x, .height = size.y,
                                        .on_step = [&](std::size_t step, std::size_t steps, const std::string&) { progress.update(step, steps); }})
                                   .picture);
        }
        const auto path = std::filesystem::path(flags.folder) / fmt::format("{}.png", scene);
        write_png(path, side_by_side(pictures, 4));
        fmt::print("{}: left without, right with global illumination ({})\n", std::filesystem::absolute(path).string(), flags.gi);
    }
    headless.check_errors();
    return 0;
}

}  // namespace

void add_tour_command(const Flags& program, const GlobalFlags& global) {
    auto flags = std::make_shared<TourFlags>();
    const Flags command = program.command("tour", "Render outdoors and indoors, GI off and on side by side, without a display");
    command.add("--size", flags->size, "WIDTHxHEIGHT in pixels of each picture");
    command.add("--folder", flags->folder, "Where the pictures go");
    command.add("--gi", flags->gi, "GI method on the right");
    command.runs([&global, flags] { return run_tour(global, *flags); });
}

}  // namespace sl
