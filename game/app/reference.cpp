// SPDX-License-Identifier: MIT
#include <charconv>
#include <csignal>
#include <filesystem>

#include "engine/core/error.h"
#include "engine/core/log.h"
#include "engine/render/displayable.h"
#include "engine/render/passes/exposure.h"
#include "engine/render/reference/reference.h"
#include "engine/render/reference/reference_file.h"
#include "engine/render/scene/extract.h"
#include "game/app/commands.h"
#include "game/app/progress.h"

namespace sl {

namespace {

struct ReferenceFlags {
    SceneChoice choice;
    std::string size = "640x360", bounces = "full", reflection = "full", pixel = "area", region, samples, output = "reference.exr", png;
    std::uint32_t spp = 256, seed = 1;
    double noise = 0.0;
    bool no_occlusion = false, overwrite = false;
};

volatile std::sig_atomic_t stop_wanted = 0;

/// The first signal lets the pass that runs come to its end, so that it is saved; the second ends at once.
void ask_to_stop(int signal) {
    if (stop_wanted != 0) std::_Exit(128 + signal);
    stop_wanted = signal;
}

FilmBlock block_of(const ReferenceFlags& flags, uvec2 size) {
    FilmBlock block{.high = size, .last = flags.spp};
    if (!flags.region.empty()) {
        const auto r = whole_numbers<std::uint32_t>(flags.region, ',', 4, "--region", "X,Y,WIDTH,HEIGHT in pixels from the upper left, for example 0,0,320,180");
        block.low = {r[0], r[1]};
        block.high = block.low + uvec2(r[2], r[3]);
        if (r[2] == 0 || r[3] == 0 || r[0] >= size.x || r[1] >= size.y || r[2] > size.x - r[0] || r[3] > size.y - r[1]) {
            fail("--region {}: it is empty or reaches beyond the picture of {}x{}", flags.region, size.x, size.y);
        }
    }
    if (!flags.samples.empty()) {
        const auto range = whole_numbers<std::uint32_t>(flags.samples, ':', 2, "--samples", "FIRST:LAST, for example 128:256 for samples 128 to 255");
        if (range[0] >= range[1]) fail("--samples {}: the range is empty", flags.samples);
        block.first = range[0];
        block.last = range[1];
    }
    if (block.last == 0) fail("--spp 0: a reference needs a sample at least");
    return block;
}

TransportSettings transport_of(const ReferenceFlags& flags) {
    TransportSettings transport{.occlusion = !flags.no_occlusion, .seed = flags.seed};
    if (flags.bounces != "full") transport.bounces = static_cast<int>(whole_numbers<std::uint32_t>(flags.bounces, ' ', 1, "--bounces", "a number of reflections, or full")[0]);
    if (transport.bounces > 10000) fail("--bounces {}: more than 10000 are the same as full", flags.bounces);
    transport.reflection = flags.reflection == "full" ? Reflection::full : Reflection::diffuse;
    transport.pixel_area = flags.pixel == "area";
    if (flags.no_occlusion && (flags.bounces != "1" && flags.bounces != "full")) fail("--no-occlusion is the model of a reflective shadow map, which has one bounce: leave --bounces out");
    if (flags.no_occlusion) transport.bounces = 1;
    return transport;
}

Film film_to_continue(const ReferenceFlags& flags, const ReferenceInfo& info, const FilmBlock& block) {
    if (flags.overwrite || !std::filesystem::exists(flags.output)) return Film(info.size);
    ReferenceFile file = [&] {
        try {
            return read_reference(flags.output);
        } catch (const Error& error) {
            fail("{}; choose another -o, or --overwrite", error.what());
        }
    }();
    ReferenceInfo::check_same(file.info, flags.output, info, "what is asked for (choose another -o, or --overwrite)");
    for (const FilmBlock& known : file.film.blocks()) {
        const bool continues = known.low == block.low && known.high == block.high && known.first == block.first;
        if (!continues && known.overlaps(block)) {
            fail("{}: it holds other pixels or samples of the picture; choose another -o and merge them, or --overwrite", flags.output);
        }
    }
    if (!file.film.blocks().empty()) log::info("{}: continues", flags.output);
    return std::move(file.film);
}

void write_picture(const std::string& path, const Film& film, const RenderScene::View& view) {
    const Image radiance = film.layers().front().image;
    write_png(path, displayable("hdr", radiance, exposure_for(view, radiance)));
}

int run_reference(const ReferenceFlags& flags) {
    const uvec2 size = parse_size(flags.size);
    check_output(flags.output, ".exr");
    check_output(flags.png, ".png");
    const FilmBlock block = block_of(flags, size);
    App app = open_scene(flags.choice);
    RenderScene scene;
    extract(app.world, scene);
    if (!scene.view) fail("scene '{}' has no active camera to look from", flags.choice.scene);
    const PathTracer tracer(scene, size, transport_of(flags));
    const ReferenceInfo info{.scene = flags.choice.scene, .content = tracer.content_hash(), .size = size, .transport = transport_of(flags)};
    Film film = film_to_continue(flags, info, block);

    std::signal(SIGINT, &ask_to_stop);
    std::signal(SIGTERM, &ask_to_stop);
    Progress progress(fmt::format("tracing {}", flags.choice.scene));
    const auto done = trace_reference(
        tracer, film, {.block = block, .noise = flags.noise},
        [&](const ReferenceProgress& now) {
            progress.update(static_cast<std::size_t>(now.share * 1e6), 1000000, fmt::format("{} samples, noise {:.2f} %", now.samples, 100.0 * now.noise));
            return stop_wanted == 0;
        },
        [&] { write_reference(flags.output, info, film); });
    progress.clear();
    const double rate = done.seconds > 0.0 ? static_cast<double>(done.rays) / done.seconds * 1e-6 : 0.0;
    fmt::print("{}: {} samples a pixel, noise at most {:.3f} % of the mean irradiance; {:.1f} s, {:.1f} million rays, {:.2f} million a second\n", flags.output,
               done.samples, 100.0 * done.noise, done.seconds, static_cast<double>(done.rays) * 1e-6, rate);
    if (!flags.png.empty()) write_picture(flags.png, film, *scene.view);
    if (stop_wanted == 0) return 0;
    fmt::print(stderr, "stopped; the same command continues {}\n", flags.output);
    return 128 + stop_wanted;
}

int run_merge(const std::vector<std::string>& inputs, const std::string& output) {
    check_output(output, ".exr");
    ReferenceFile merged = read_reference(inputs.front());
    for (std::size_t i = 1; i < inputs.size(); ++i) {
        const ReferenceFile next = read_reference(inputs[i]);
        ReferenceInfo::check_same(merged.info, inputs.front(), next.info, inputs[i]);
        try {
            merged.film.add(next.film);
        } catch (const Error& error) {
            fail("{}: {}", inputs[i], error.what());
        }
    }
    write_reference(output, merged.info, merged.film);
    fmt::print("{}: {} files, noise at most {:.3f} % of the mean irradiance\n", output, inputs.size(), 100.0 * merged.film.noise());
    return 0;
}

}  // namespace

void add_reference_command(const Flags& program) {
    auto flags = std::make_shared<ReferenceFlags>();
    const Flags command = program.command("reference", "Path-trace a scene: the truth that methods are measured against. An interrupted run continues from its file");
    add_scene_flags(command, flags->choice);
    command.add("--size", flags->size, "WIDTHxHEIGHT in pixels");
    command.add("--spp", flags->spp, "Samples per pixel, at most; without effect beside --samples");
    command.add("--noise", flags->noise, "Also stop when irradiance is this exact: RMS standard error over mean, e.g. 0.01; reckoned as if samples were random, so that the true error (see compare) is less").not_negative();
    command.add("--bounces", flags->bounces, "Reflections of light before the first surface: 0 is direct light alone; full: until the rest is nothing");
    command.toggle("--no-occlusion", flags->no_occlusion, "One bounce that passes through everything: the model of a reflective shadow map");
    command.add("--reflection", flags->reflection, "full: surfaces reflect with their highlights; diffuse: as a reflective shadow map takes them").one_of({"full", "diffuse"});
    command.add("--pixel", flags->pixel, "area: samples spread over the pixel; centre: through its centre, as a rasterizer does").one_of({"area", "centre"});
    command.add("--seed", flags->seed, "Other random numbers of the same picture");
    command.add("--region", flags->region, "X,Y,WIDTH,HEIGHT: only these pixels; `secondlight merge` joins regions");
    command.add("--samples", flags->samples, "FIRST:LAST: only these sample numbers, instead of --spp; `secondlight merge` joins ranges");
    command.add("-o,--output", flags->output, "EXR to write, and to continue from where it exists");
    command.add("--png", flags->png, "Also write the picture with the camera's exposure");
    command.toggle("--overwrite", flags->overwrite, "Begin anew where the file exists");
    command.runs([flags] { return run_reference(*flags); });
}

void add_merge_command(const Flags& program) {
    struct MergeFlags {
        std::vector<std::string> inputs;
        std::string output = "merged.exr";
    };
    auto flags = std::make_shared<MergeFlags>();
    const Flags command = program.command("merge", "Join references of one picture that hold other pixels or other samples");
    command.add("FILES", flags->inputs, "EXR files written by `secondlight reference`").required();
    command.add("-o,--output", flags->output, "EXR to write");
    command.runs([flags] { return run_merge(flags->inputs, flags->output); });
}

}  // namespace sl
