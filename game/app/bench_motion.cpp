// SPDX-License-Identifier: MIT
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/core/text_file.h"
#include "engine/measure/heat_map.h"
#include "game/app/camera_path.h"
#include "game/app/headless.h"
#include "game/app/progress.h"

namespace sl {

namespace {

struct MotionFlags {
    std::vector<std::string> scenes{"outdoor", "indoor"}, methods{"rsm_disc", "facets"}, sets;
    std::string size = "320x180", reference_size = "160x90", json, pictures;
    std::uint32_t frames = 32, reference_frames = 8, reference_spp = 256;
    bool no_reference = false;
};

nlohmann::json json_of(const FlickerFigures& figures) { return {{"rms", figures.rms}, {"median", figures.median}, {"p99", figures.p99}}; }

nlohmann::json json_of(const Flicker& flicker) {
    const FlickerFigures deviation = flicker_figures(flicker.deviation, flicker.mask), change = flicker_figures(flicker.change, flicker.mask);
    return {{"deviation", json_of(deviation)}, {"change", json_of(change)}, {"pixels", deviation.pixels}, {"samples", flicker.samples}, {"unlit", flicker.unlit}};
}

void print_head(const CameraPath& path) {
    const std::string head = fmt::format("{:>9}{:>9}{:>9}", "RMS", "median", "99 %");
    fmt::print("\n{} · {}x{} · {} frames · relative, %\n  {:<34}{:<27}  {:<27}\n  {:<34}{}  {}{:>10}{:>10}{:>11}\n", path.scene, path.size.x, path.size.y, path.frames, "",
               "       over all frames", "       from frame to frame", "", head, head, "unlit", "pixels", "samples");
}

void print_row(const std::string& name, const nlohmann::json& row) {
    const auto text = [](const nlohmann::json& figures) {
        return fmt::format("{:>9.2f}{:>9.2f}{:>9.2f}", 100.0 * figures["rms"].get<double>(), 100.0 * figures["median"].get<double>(), 100.0 * figures["p99"].get<double>());
    };
    fmt::print("  {:<34}{}  {}{:>10.3f}{:>10}{:>11}\n", name, text(row["deviation"]), text(row["change"]), 100.0 * row["unlit"].get<double>(), row["pixels"].get<std::size_t>(), row["samples"].get<std::size_t>());
    std::fflush(stdout);
}

void write_picture(const MotionFlags& flags, const std::string& scene, const std::string& name, const Flicker& flicker) {
    if (flags.pictures.empty()) return;
    std::filesystem::create_directories(flags.pictures);
    const auto file = std::filesystem::path(flags.pictures) / fmt::format("{}_{}.png", std::filesystem::path(scene).stem().string(), name);
    write_png(file, heat_map(flicker.deviation, flicker.mask, {.title = "deviation over frames", .top = suggested_top(flicker.deviation, flicker.mask), .percent = true}));
    fmt::print("  {}\n", file.string());
}

nlohmann::json measure_methods(const CameraPath& path, const MotionFlags& flags, bool pictures) {
    nlohmann::json rows = nlohmann::json::object();
    for (const std::string& gi : flags.methods) {
        Progress progress(fmt::format("{}, {}", path.scene, gi));
        const Flicker measured = flicker(drawn_along(path, gi, flags.sets, [&](std::uint32_t done) { progress.update(done, path.frames); }));
        progress.clear();
        rows[gi] = json_of(measured);
        print_row(gi, rows[gi]);
        if (pictures) write_picture(flags, path.scene, gi, measured);
    }
    return rows;
}

/// A light that does not depend on the view, measured in the same way: what reprojection alone makes of it.
nlohmann::json measure_reference(const CameraPath& path, const MotionFlags& flags) {
    Progress progress(fmt::format("{}, reference", path.scene));
    const Flicker measured = flicker(traced_along(path, flags.reference_spp, [&](std::uint32_t done) { progress.update(done, path.frames); }));
    progress.clear();
    nlohmann::json row = json_of(measured);
    row["deviation"]["rms_less_noise"] = less_error(row["deviation"]["rms"], measured.deviation_of_error);
    row["change"]["rms_less_noise"] = less_error(row["change"]["rms"], measured.change_of_error);
    print_row(fmt::format("reference, {} spp", flags.reference_spp), row);
    fmt::print("  {:<34}{:>9.2f}{:>20}{:>9.2f}\n", "reference, less its own noise", 100.0 * row["deviation"]["rms_less_noise"].get<double>(), "",
               100.0 * row["change"]["rms_less_noise"].get<double>());
    write_picture(flags, path.scene, "reference", measured);
    return row;
}

int run_motion(const GlobalFlags& global, const MotionFlags& flags) {
    const uvec2 size = parse_size(flags.size), reference_size = parse_size(flags.reference_size);
    Headless headless(global);
    fmt::print("{} · {}\n", headless.context->renderer(), headless.context->version());
    nlohmann::json results = nlohmann::json::array();
    for (const std::string& scene : flags.scenes) {
        const CameraPath path{scene, size, flags.frames}, short_path{scene, reference_size, flags.reference_frames};
        print_head(path);
        nlohmann::json result{{"scene", scene}, {"methods", measure_methods(path, flags, true)}};
        if (!flags.no_reference) {
            print_head(short_path);
            result["beside_reference"] = measure_methods(short_path, flags, false);
            result["reference"] = measure_reference(short_path, flags);
        }
        results.push_back(std::move(result));
    }
    headless.check_errors();
    if (!flags.json.empty()) {
        const nlohmann::json all{{"renderer", headless.context->renderer()}, {"size", flags.size}, {"frames", flags.frames}, {"reference_size", flags.reference_size},
                                 {"reference_frames", flags.reference_frames}, {"reference_spp", flags.reference_spp}, {"results", results}};
        write_text_file(flags.json, all.dump(2) + "\n");
    }
    return 0;
}

}  // namespace

void add_bench_motion_command(const Flags& bench, const GlobalFlags& global) {
    auto flags = std::make_shared<MotionFlags>();
    const Flags command = bench.command("motion", "How much indirect light flickers on the surfaces of a still scene while the camera moves along a path");
    command.add("--scene,PATH", flags->scenes, "Scenes to measure");
    command.add("--gi", flags->methods, "GI methods");
    command.add("--set", flags->sets, "component.field=value, for each method; repeatable");
    command.add("--size", flags->size, "WIDTHxHEIGHT in pixels");
    command.add("--frames", flags->frames, "Frames of the path").within(3, 10000);
    command.toggle("--no-reference", flags->no_reference, "Leave out the path-traced reference, which takes most of the time");
    command.add("--reference-spp", flags->reference_spp, "Its samples per pixel and frame").within(2, 1 << 20);
    command.add("--reference-size", flags->reference_size, "WIDTHxHEIGHT at which it and the methods are compared");
    command.add("--reference-frames", flags->reference_frames, "Frames of the same path in that comparison").within(3, 10000);
    command.add("--json", flags->json, "Also write the figures into this file");
    command.add("--picture", flags->pictures, "Also write a heat map of each method and the reference into this folder");
    command.footer("The camera moves 3 cm sideways and turns a quarter of a degree per frame, drawn as in a window after the first frame was complete.\n"
                   "Each pixel of the middle frame is found again in the others by its place on the surface; light on a still surface does not\n"
                   "depend on the view, so all that changes is wrong, but for what finding it again between pixels adds: compare with the reference.\n"
                   "Unlit: share of the surface pixels of all frames without any indirect light.");
    command.runs([&global, flags] { return run_motion(global, *flags); });
}

}  // namespace sl
