// SPDX-License-Identifier: MIT
#include "engine/core/error.h"
#include "engine/core/text_file.h"
#include "engine/ecs/query.h"
#include "engine/measure/metrics.h"
#include "engine/render/capture.h"
#include "game/app/bench_side.h"
#include "game/app/progress.h"
#include "game/app/spread_json.h"

namespace sl {

namespace {

struct BenchFlags {
    std::string size = "640x360";
    std::uint32_t pairs = 10;
    std::vector<std::string> scenes{"outdoor", "indoor"};
    std::string gi;
    std::vector<std::string> sets;
    std::string json;
    bool error = false;
};

std::string row(const Spread& s) { return fmt::format("{:>10.2f}{:>10.2f}{:>10.2f}{:>10.2f}{:>10.2f}", s.median, s.first, s.third, s.low, s.high); }

nlohmann::json report(const std::string& scene, const std::string& method, const BenchSide& off, const BenchSide& on) {
    std::vector<double> ratios, differences;
    for (std::size_t i = 0; i < off.frames.size(); ++i) {
        ratios.push_back(on.frames[i] / off.frames[i]);
        differences.push_back(on.frames[i] - off.frames[i]);
    }
    const std::string head = fmt::format("{:>10}{:>10}{:>10}{:>10}{:>10}", "median", "q1", "q3", "min", "max");
    fmt::print("\n{} · off against {} · {} pairs · ms\n{:<28}{}\n", scene, method, off.frames.size(), "", head);
    fmt::print("{:<28}{}\n{:<28}{}\n", "frame, GI off", row(spread_of(off.frames)), "frame, GI on", row(spread_of(on.frames)));
    fmt::print("{:<28}{}\n{:<28}{}\n", "extra time of GI", row(spread_of(differences)), "ratio on / off", row(spread_of(ratios)));
    nlohmann::json json{{"scene", scene}, {"method", method}, {"pairs", off.frames.size()}, {"frame_off_ms", json_of(spread_of(off.frames))},
                        {"frame_on_ms", json_of(spread_of(on.frames))}, {"extra_ms", json_of(spread_of(differences))}, {"ratio", json_of(spread_of(ratios))}};
    json["gi_passes_ms"] = json_of(spread_of(on.gi));
    fmt::print("{:<28}{}\n", "all passes for GI", row(spread_of(on.gi)));
    fmt::print("  passes with GI on, each finished before the next:\n");
    for (const std::string& name : on.order) {
        fmt::print("  {:<26}{}\n", name, row(spread_of(on.passes.at(name))));
        json["passes_ms"][name] = json_of(spread_of(on.passes.at(name)));
    }
    return json;
}

/// One frame's indirect irradiance by a method, and which pixels show a surface.
struct Irradiance {
    Image image;
    std::vector<float> surface;
};

Irradiance irradiance_of(const SceneChoice& choice, uvec2 size) {
    App app = open_scene(choice);
    Renderer renderer(shader_folder());
    Progress progress(fmt::format("{}, {}, one frame", choice.scene, choice.gi));
    const Capture captured = capture(app, renderer, {.width = size.x, .height = size.y, .layers = true,
                                                     .on_step = [&](std::size_t step, std::size_t steps, const std::string&) { progress.update(step, steps); }});
    Irradiance result;
    for (const ImageLayer& layer : captured.layers) {
        if (layer.name == "irradiance") result.image = layer.image;
        if (layer.name == "depth") result.surface = layer.image.data;
    }
    return result;
}

/// Sampling error: the method against the sum over every texel of the same maps.
double sampling_error(const SceneChoice& choice, uvec2 size, std::uint32_t rsm_size) {
    const Irradiance exact = irradiance_of({.scene = choice.scene, .gi = "rsm_exact", .sets = {fmt::format("gi.rsm_size={}", rsm_size)}}, size);
    return image_errors(irradiance_of(choice, size).image, exact.image, exact.surface).nrmse;
}

/// The map size of a method in rsm_exact's units. Throws Error for the others.
std::uint32_t comparable_map_size(const GiSettings& settings) {
    if (const auto* disc = settings.method.get_if<RsmDisc>()) return disc->rsm_size;
    if (const auto* exact = settings.method.get_if<RsmExact>()) return exact->rsm_size;
    fail("--error compares with rsm_exact, and {} is not in its units", settings.method.name());
}

int run_onoff(const GlobalFlags& global, const BenchFlags& flags) {
    const uvec2 size = parse_size(flags.size);
    Headless headless(global);
    fmt::print("{} · {} · {}x{}\n", headless.context->renderer(), headless.context->version(), size.x, size.y);
    nlohmann::json results = nlohmann::json::array();
    for (const std::string& scene : flags.scenes) {
        BenchSide off(open_scene({.scene = scene, .gi = "off"}));
        BenchSide on(open_scene({.scene = scene, .gi = flags.gi, .sets = flags.sets}));
        const auto* settings = on.app.world.find<GiSettings>(active_camera(on.app.world));
        const std::string method(settings != nullptr ? settings->method.name() : "off");
        if (flags.error) (void)comparable_map_size(settings != nullptr ? *settings : GiSettings{GiOff{}});
        Progress progress(fmt::format("{}, {}", scene, method));
        for (std::uint32_t warm_up = 0; warm_up < 2; ++warm_up) {
            off.draw(size, warm_up, false);
            on.draw(size, warm_up, false);
        }
        for (std::uint32_t pair = 0; pair < flags.pairs; ++pair) {
            off.measure(size, pair);
            on.measure(size, pair);
            progress.update(pair + 1, flags.pairs);
        }
        results.push_back(report(scene, method, off, on));
        if (flags.error) {
            const double error = sampling_error({.scene = scene, .gi = flags.gi.empty() ? method : flags.gi, .sets = flags.sets}, size, comparable_map_size(*settings));
            fmt::print("  sampling error against rsm_exact, NRMSE of irradiance: {:.1f} %\n", 100.0 * error);
            results.back()["sampling_nrmse"] = error;
        }
    }
    headless.check_errors();
    if (!flags.json.empty()) {
        const nlohmann::json all{{"renderer", headless.context->renderer()}, {"version", headless.context->version()},
                                 {"width", size.x}, {"height", size.y}, {"results", results}};
        write_text_file(flags.json, all.dump(2) + "\n");
    }
    return 0;
}

}  // namespace

void add_bench_onoff_command(const Flags& bench, const GlobalFlags& global) {
    auto flags = std::make_shared<BenchFlags>();
    const Flags command = bench.command("onoff", "Frame time with GI off and on, alternating in one process, camera turning");
    command.add("--scene,PATH", flags->scenes, "Scenes to measure");
    command.add("--gi", flags->gi, "GI method of the on side; default: the scene's own");
    command.add("--set", flags->sets, "component.field=value for the on side; repeatable");
    command.add("--size", flags->size, "WIDTHxHEIGHT in pixels");
    command.add("--pairs", flags->pairs, "Pairs of frames").within(1, 100000);
    command.toggle("--error", flags->error, "Also measure the method's sampling error against rsm_exact; takes minutes");
    command.add("--json", flags->json, "Also write the figures into this file");
    command.runs([&global, flags] { return run_onoff(global, *flags); });
}

}  // namespace sl
