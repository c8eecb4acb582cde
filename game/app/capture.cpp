// SPDX-License-Identifier: MIT
#include <chrono>

#include "engine/core/error.h"
#include "engine/core/log.h"
#include "engine/render/capture.h"
#include "engine/render/refined_share.h"
#include "game/app/headless.h"
#include "game/app/progress.h"
#include "game/voxel_content.h"

namespace sl {

namespace {

struct CaptureFlags {
    SceneChoice choice;
    std::string size = "640x360";
    std::uint32_t frame = 0;
    std::string png, exr, show;
    std::string print_graph;
    bool print_schedule = false;
    bool stats = false;
};

using Watch = std::chrono::steady_clock;

/// How long it took, s.
struct CaptureTimes {
    double opening = 0.0, drawing = 0.0;
};

double seconds_since(Watch::time_point start) { return std::chrono::duration<double>(Watch::now() - start).count(); }

void print_stats(App& app, Headless& headless, const Capture& captured, const CaptureTimes& times) {
    const auto& voxels = app.world.resource<VoxelStats>();
    fmt::print("{:<28}{}\n", "to open the scene, to draw", fmt::format("{:.2f} s, {:.2f} s", times.opening, times.drawing));
    fmt::print("{:<28}{}\n", "triangles drawn, culled",
               fmt::format("{}, {}", captured.result.triangles_drawn, captured.result.triangles_culled));
    fmt::print("{:<28}{}\n", "lights short of map memory", captured.result.lights_without_maps);
    fmt::print("{:<28}{}\n", "voxel chunks, blocks", fmt::format("{}, {}", voxels.chunks, voxels.total.blocks));
    fmt::print("{:<28}{}\n", "as naive cubes, faces", voxels.total.naive_faces);
    fmt::print("{:<28}{}\n", "visible faces, merged quads", fmt::format("{}, {}", voxels.total.visible_faces, voxels.total.quads));
    fmt::print("{:<28}{:.1f} MiB\n", "meshes and textures", static_cast<double>(headless.renderer.gpu_bytes()) / 1048576.0);
    fmt::print("{:<28}{} ({})\n", "renderer", headless.context->renderer(), headless.context->version());
    if (const auto share = refined_share(headless.renderer)) fmt::print("{:<28}{:.2f} %\n", "pixels gathered in full", 100.0 * *share);
    for (const gl::SpanTime& pass : headless.renderer.executor().finished_timings()) {
        fmt::print("{:<28}{:.2f} ms\n", pass.name, pass.milliseconds);
    }
}

int run_capture(const GlobalFlags& global, const CaptureFlags& flags) {
    const uvec2 size = parse_size(flags.size);
    if (!flags.print_graph.empty() && flags.print_graph != "table" && flags.print_graph != "mermaid") {
        fail("--print-graph '{}': choose table or mermaid", flags.print_graph);
    }
    check_output(flags.png, ".png");
    check_output(flags.exr, ".exr");
    CaptureTimes times;
    const auto opening = Watch::now();
    App app = open_scene(flags.choice);
    times.opening = seconds_since(opening);
    if (flags.print_schedule) fmt::print("{}", app.schedule.describe());
    Headless headless(global);
    headless.renderer.executor().set_timing(flags.stats);
    Progress progress(fmt::format("capturing {}", flags.choice.scene));
    const auto drawing = Watch::now();
    const Capture captured = capture(app, headless.renderer,
                                     {.width = size.x, .height = size.y, .frame = flags.frame, .show = flags.show,
                                      .layers = !flags.exr.empty(), .keep_refined = flags.stats,
                                      .on_step = [&](std::size_t step, std::size_t steps, const std::string&) { progress.update(step, steps); }});
    times.drawing = seconds_since(drawing);
    if (captured.empty) log::warn("scene '{}' has no active camera: the picture is black", flags.choice.scene);
    if (flags.print_graph == "table") fmt::print("{}", headless.renderer.graph().table(headless.renderer.steps()));
    if (flags.print_graph == "mermaid") fmt::print("{}", headless.renderer.graph().mermaid(headless.renderer.steps()));
    if (flags.stats) print_stats(app, headless, captured, times);
    if (!flags.png.empty()) write_png(flags.png, captured.picture);
    if (!flags.exr.empty()) write_exr(flags.exr, captured.layers);
    headless.check_errors();
    if (flags.png.empty() && flags.exr.empty() && flags.print_graph.empty() && !flags.print_schedule && !flags.stats) {
        log::warn("the frame was drawn, and nothing asked for: name a file with -o or --exr");
    }
    return 0;
}

}  // namespace

void add_capture_command(const Flags& program, const GlobalFlags& global) {
    auto flags = std::make_shared<CaptureFlags>();
    const Flags command = program.command("capture", "Render one frame without a display into PNG and EXR files");
    add_scene_flags(command, flags->choice);
    command.add("--size", flags->size, "WIDTHxHEIGHT in pixels");
    command.add("--frame", flags->frame, "Simulate this many frames of 1/60 s first; the last is kept").within(0, 1000000);
    command.add("-o,--output", flags->png, "PNG of the tonemapped picture, or of what --show names");
    command.add("--exr", flags->exr, "EXR with the linear layers: the picture's radiance (unnamed), direct, irradiance, albedo, normal, depth");
    command.add("--show", flags->show, "An image of the frame instead of the picture (see `secondlight list passes`), e.g. irradiance or rsm_flux.0");
    command.add_or_alone("--print-graph", flags->print_graph, "table", "Print the compiled frame graph: table or mermaid");
    command.toggle("--print-schedule", flags->print_schedule, "Print stages, systems, and what they read, write and wait for");
    command.toggle("--stats", flags->stats, "Print how long it took to open the scene and to draw, triangles, memory, GPU time per pass, and the share of pixels gathered in full");
    command.runs([&global, flags] { return run_capture(global, *flags); });
}

}  // namespace sl
