// SPDX-License-Identifier: MIT
#include <cmath>

#include "engine/core/text_file.h"
#include "game/app/growth_point.h"
#include "game/app/own_process.h"
#include "game/app/progress.h"
#include "game/app/spread_json.h"

namespace sl {

namespace {

struct GrowthFlags {
    std::vector<std::string> methods{"facets", "rsm_disc"};
    std::vector<std::string> sets;
    std::string scene = "outdoor", size = "320x180", json, only;
    double minutes = 5.0;
};

/// One thing that grows, in steps; each is a point apart from its method.
struct GrowthAxis {
    std::string name, about;
    std::vector<std::pair<std::string, GrowthPoint>> steps;
};

std::vector<GrowthAxis> axes(const GrowthFlags& flags) {
    const GrowthPoint base{.choice = {.scene = flags.scene, .gi = {}, .sets = flags.sets}, .size = parse_size(flags.size)};
    GrowthAxis pixels{"pixels", fmt::format("pixels of the picture, scene '{}'", flags.scene), {}};
    GrowthAxis lights{"lights", fmt::format("lamps over the ground within 16 m of the camera, besides the lights of '{}': spot and point lights in turn, for methods "
                                            "with reflective shadow maps spot lights only", flags.scene), {}};
    GrowthAxis world{"world", "blocks of hills in the sun, all within reach of light", {}};
    GrowthAxis edits{"edits", fmt::format("blocks placed before each frame, all over the picture of '{}'", flags.scene), {}};
    const auto with = [&](auto member, auto value) {
        GrowthPoint point = base;
        point.*member = value;
        return point;
    };
    for (const char* size : {"160x90", "320x180", "640x360", "1280x720"}) pixels.steps.emplace_back(size, with(&GrowthPoint::size, parse_size(size)));
    for (const std::uint32_t count : {1u, 4u, 16u, 64u, 256u}) lights.steps.emplace_back(fmt::format("{} lamp{}", count, count == 1 ? "" : "s"), with(&GrowthPoint::lamps, count));
    for (const int power : {4, 5, 6, 7}) {
        world.steps.emplace_back(fmt::format("10^{} blocks", power), with(&GrowthPoint::blocks, static_cast<std::uint64_t>(std::pow(10.0, power))));
    }
    for (const std::uint32_t count : {0u, 1u, 4u, 16u}) edits.steps.emplace_back(fmt::format("{} a frame", count), with(&GrowthPoint::edits, count));
    std::vector<GrowthAxis> all{pixels, lights, world, edits};
    std::erase_if(all, [&](const GrowthAxis& axis) { return !flags.only.empty() && axis.name != flags.only; });
    return all;
}

nlohmann::json json_of(const GrowthCost& cost) {
    return {{"renderer", cost.renderer}, {"gi_ms", json_of(cost.gi_ms)}, {"anew_ms", cost.anew_ms}, {"behind", cost.behind}, {"catch_up_ms", cost.catch_up_ms},
            {"memory_mb", cost.memory_mb}, {"blocks", cost.blocks}, {"triangles", cost.triangles}};
}

void print(const nlohmann::json& row) {
    fmt::print("  {:<12}{:<14}", row["gi"].get<std::string>(), row["at"].get<std::string>());
    if (row.contains("error")) {
        fmt::print("  {}\n", row["error"].get<std::string>());
    } else {
        const nlohmann::json& time = row["gi_ms"];
        fmt::print("{:>10.2f}{:>10.2f}{:>10.2f}{:>12.0f}{:>9.1f} %{:>13.0f}{:>10.1f}{:>12}{:>12}\n", time["median"].get<double>(), time["quartile_1"].get<double>(),
                   time["quartile_3"].get<double>(), row["anew_ms"].get<double>(), 100.0 * row["behind"].get<double>(), row["catch_up_ms"].get<double>(), row["memory_mb"].get<double>(),
                   row["blocks"].get<std::uint64_t>(), row["triangles"].get<std::uint64_t>());
    }
    std::fflush(stdout);
}

/// The rows of one method along an axis. A point that takes too much ends them: the next ones would take more.
void measure(const GlobalFlags& global, const GrowthFlags& flags, const GrowthAxis& axis, const std::string& gi, nlohmann::json& rows, const std::function<void(const std::string&)>& tell) {
    for (const auto& [label, step] : axis.steps) {
        tell(fmt::format("{}, {}", gi, label));
        GrowthPoint point = step;
        point.choice.gi = gi;
        nlohmann::json row{{"gi", gi}, {"at", label}};
        bool enough = false;
        try {
            row.update(nlohmann::json::parse(in_own_process([&] { return json_of(measure_growth(global, point)).dump(); }, 60.0 * flags.minutes)));
        } catch (const Error& error) {
            row["error"] = error.what();
            enough = dynamic_cast<const LimitReached*>(&error) != nullptr;
        }
        print(row);
        rows.push_back(std::move(row));
        if (enough) break;
    }
}

int run_growth(const GlobalFlags& global, const GrowthFlags& flags) {
    for (const std::string& gi : flags.methods) (void)make_gi_method(gi.substr(0, gi.find(':')));
    const std::vector<GrowthAxis> all = axes(flags);
    nlohmann::json results = nlohmann::json::array();
    Progress progress("growth");
    std::size_t done = 0, points = 0;
    for (const GrowthAxis& axis : all) points += axis.steps.size() * flags.methods.size();
    for (const GrowthAxis& axis : all) {
        progress.clear();
        fmt::print("\n{}: {}\n  {:<12}{:<14}{:>10}{:>10}{:>10}{:>12}{:>11}{:>13}{:>10}{:>12}{:>12}\n", axis.name, axis.about, "", "", "GI ms", "q1", "q3", "anew ms", "behind", "catch-up ms", "MB", "blocks",
                   "triangles");
        nlohmann::json rows = nlohmann::json::array();
        for (const std::string& gi : flags.methods) {
            measure(global, flags, axis, gi, rows, [&](const std::string& what) {
                progress.clear();
                progress.update(done++, points, fmt::format("{}, {}", axis.name, what));
            });
        }
        results.push_back({{"axis", axis.name}, {"about", axis.about}, {"rows", std::move(rows)}});
        // After each axis: nothing of a long run is lost.
        if (!flags.json.empty()) write_text_file(flags.json, nlohmann::json{{"size", flags.size}, {"scene", flags.scene}, {"axes", results}}.dump(2) + "\n");
    }
    return 0;
}

}  // namespace

void add_bench_growth_command(const Flags& bench, const GlobalFlags& global) {
    auto flags = std::make_shared<GrowthFlags>();
    const Flags command = bench.command("growth", "How the time and memory of GI grow with pixels, lights, the world and edits; minutes to an hour without a GPU");
    command.add("--gi", flags->methods, "GI methods; repeatable");
    command.add("--set", flags->sets, "component.field=value, for each method; repeatable");
    command.add("--scene,PATH", flags->scene, "Scene in which pixels, lights and edits grow; the world grows in hills of its own");
    command.add("--size", flags->size, "WIDTHxHEIGHT in pixels where not pixels grow");
    command.add("--only", flags->only, "One of them alone").one_of({"pixels", "lights", "world", "edits"});
    command.add("--minutes", flags->minutes, "What takes longer is given up, and what is larger is left out").within(0.01, 1e6);
    command.add("--json", flags->json, "Also write the figures into this file");
    command.footer("Each point is measured in a process of its own. GI ms: median and quartiles over 16 frames as a window draws them, the camera moving\n"
                   "3 cm and turning a quarter of a degree per frame, after all was lit. Anew: from nothing until everything that is wanted is known.\n"
                   "Behind: NRMSE of the last of these frames against what it comes to when all stops; catch-up: until then.\n"
                   "MB: what the method took beyond a frame without it.");
    command.runs([&global, flags] { return run_growth(global, *flags); });
}

}  // namespace sl
