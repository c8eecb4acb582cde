// SPDX-License-Identifier: MIT
#include <chrono>
#include <fstream>
#include <thread>

#include "engine/core/error.h"
#include "engine/core/field_list.h"
#include "engine/core/text_file.h"
#include "engine/measure/flip.h"
#include "engine/measure/heat_map.h"
#include "game/app/bench_plan.h"
#include "game/app/bench_report.h"
#include "game/app/bench_side.h"
#include "game/app/bench_truth.h"
#include "game/app/progress.h"

namespace sl {

namespace {

struct GiBenchFlags {
    bool quick = false;
    std::string size, folder = "out/bench_gi", presets;
    std::vector<std::string> scenes, methods;
    std::uint32_t rounds = 0, spp = 0;
};

SceneChoice choice_of(const std::string& scene, const BenchCandidate& candidate) {
    SceneChoice choice{.scene = scene, .gi = candidate.method, .sets = candidate.assignments()};
    choice.sets.push_back(no_antialiasing);
    return choice;
}

std::string first_line_of(const std::string& command) {
    std::string line;
    if (FILE* pipe = popen(command.c_str(), "r")) {
        for (int c = std::fgetc(pipe); c != EOF && c != '\n'; c = std::fgetc(pipe)) line += static_cast<char>(c);
        pclose(pipe);
    }
    return line;
}

std::string processor_name() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        if (line.starts_with("model name")) return fmt::format("{}, {} threads", line.substr(line.find(':') + 2), std::thread::hardware_concurrency());
    }
    return "unknown processor";
}

std::string today() {
    const std::time_t now = std::time(nullptr);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
    return text;
}

BenchPlan plan_of(const GiBenchFlags& flags) {
    BenchPlan plan = flags.quick ? quick_plan() : full_plan();
    if (!flags.size.empty()) plan.size = parse_size(flags.size);
    if (!flags.scenes.empty()) plan.scenes = flags.scenes;
    if (!flags.methods.empty()) {
        for (const std::string& method : flags.methods) (void)make_gi_method(method);
        std::erase_if(plan.candidates, [&](const BenchCandidate& candidate) { return std::ranges::find(flags.methods, candidate.method) == flags.methods.end(); });
    }
    if (flags.rounds > 0) plan.rounds = flags.rounds;
    if (flags.spp > 0) plan.spp = flags.spp;
    return plan;
}

std::string command_of(const GiBenchFlags& flags) {
    std::string text = "secondlight bench gi";
    if (flags.quick) text += " --quick";
    for (const std::string& scene : flags.scenes) text += " --scene " + scene;
    for (const std::string& method : flags.methods) text += " --gi " + method;
    if (!flags.size.empty()) text += " --size " + flags.size;
    if (flags.rounds > 0) text += fmt::format(" --rounds {}", flags.rounds);
    if (flags.spp > 0) text += fmt::format(" --spp {}", flags.spp);
    return text;
}

/// The map size of a candidate; 0 for methods without maps.
std::uint32_t candidate_map_size(const std::string& scene, const BenchCandidate& candidate) {
    App app = open_scene(choice_of(scene, candidate));
    const auto* settings = app.world.find<GiSettings>(active_camera(app.world));
    return settings != nullptr ? map_size(*settings) : 0;
}

/// All settings of a candidate's method, defaults included.
std::string settings_of(const std::string& scene, const BenchCandidate& candidate) {
    App app = open_scene(choice_of(scene, candidate));
    std::string text;
    const auto* settings = app.world.find<GiSettings>(active_camera(app.world));
    if (settings == nullptr) return text;
    for (const FieldRow& row : list_fields(GiSettings(*settings))) text += fmt::format("{}{}={}", text.empty() ? "" : " ", row.name, row.value);
    return text;
}

/// Frames in which each candidate is lit anew; they cost much more than others.
constexpr std::uint32_t rounds_lit_anew = 3;

/// One scene's measurement.
class ViewBench {
  public:
    ViewBench(const BenchPlan& plan, const std::string& scene, const std::filesystem::path& folder, BenchReport& report, Progress& progress, double first_share, double share)
        : plan_(plan), scene_(scene), folder_(folder), report_(report), progress_(progress), first_share_(first_share), share_(share) {}

    void run() {
        make_references();
        // Timing comes last and in one go, when nothing else of the run is going on.
        draw_candidates();
        time_candidates();
        for (BenchRow& row : rows_) report_.rows.push_back(std::move(row));
    }

  private:
    void tell(double share, const std::string& what) {
        progress_.update(static_cast<std::size_t>((first_share_ + share_ * share) * 1e6), 1000000, fmt::format("{}: {}", scene_, what));
    }

    void make_references() {
        truths_ = make_truths({.scene = scene_}, plan_.size, plan_.spp, folder_, [&](double share) { tell(0.5 * share, "references"); });
        report_.views.push_back({scene_, truths_.open.noise, truths_.one.noise, truths_.full.noise});
    }

    const Image& exact_sum(Renderer& renderer, std::uint32_t size) {
        auto& image = exact_[size];
        if (image.data.empty()) {
            BenchCandidate exact{.method = "rsm_exact", .sets = {}};
            exact.sets.push_back(fmt::format("rsm_size={}", size));
            image = draw_once(choice_of(scene_, exact), renderer, plan_.size).irradiance;
        }
        return image;
    }

    void draw_candidates() {
        Renderer renderer(shader_folder());
        std::map<std::string, std::pair<double, BenchStrip>> best;  // the strip of each method's best candidate
        for (std::size_t i = 0; i < plan_.candidates.size(); ++i) {
            const BenchCandidate& candidate = plan_.candidates[i];
            // What another setting has left in a cache may be finer than this one's.
            renderer.forget();
            const Drawn drawn = draw_once(choice_of(scene_, candidate), renderer, plan_.size);
            BenchRow row{.scene = scene_, .method = candidate.method, .candidate = candidate.label(), .settings = settings_of(scene_, candidate)};
            row.open = image_errors(drawn.irradiance, truths_.open.irradiance, truths_.mask);
            row.one = image_errors(drawn.irradiance, truths_.one.irradiance, truths_.mask);
            row.full = image_errors(drawn.irradiance, truths_.full.irradiance, truths_.mask);
            row.flip = flip(drawn.picture, truths_.picture, truths_.mask).mean;
            const std::uint32_t size = candidate_map_size(scene_, candidate);
            if (size > 0 && candidate.method != "rsm_exact") row.sampling = image_errors(drawn.irradiance, exact_sum(renderer, size), truths_.mask);
            auto& [error, strip] = best.try_emplace(candidate.method, std::numeric_limits<double>::infinity(), BenchStrip{}).first->second;
            if (row.full.nrmse < error) {
                error = row.full.nrmse;
                strip = draw_strip(candidate, drawn);
            }
            rows_.push_back(std::move(row));
            tell(0.5 + 0.25 * static_cast<double>(i + 1) / static_cast<double>(plan_.candidates.size()), "errors");
        }
        for (auto& [method, entry] : best) report_.strips.push_back(std::move(entry.second));
    }

    BenchStrip draw_strip(const BenchCandidate& candidate, const Drawn& drawn) const {
        const Image map = relative_error_map(drawn.irradiance, truths_.full.irradiance, truths_.mask);
        BenchStrip strip{.scene = scene_, .caption = fmt::format("{} | path-traced, full transport | relative error of irradiance, and below the worst part of the first two", candidate.label())};
        strip.strip = folder_ / fmt::format("{}_{}.png", scene_, candidate.method);
        strip.crop = folder_ / fmt::format("{}_{}_worst.png", scene_, candidate.method);
        Image heat = heat_map(map, truths_.mask, {.title = "relative error", .top = 1.0, .percent = true});
        const Image pair = side_by_side({drawn.picture, truths_.picture}, 4);
        // The heat map is taller by its legend: the pictures get white below them.
        Image wide(pair.width + 4 + heat.width, heat.height, 3);
        std::ranges::fill(wide.data, 1.0f);
        const auto paste = [](const Image& from, Image& to, std::uint32_t left) {
            for (std::uint32_t y = 0; y < from.height; ++y) std::copy_n(from.pixel(0, y), std::size_t{from.width} * 3, to.pixel(left, y));
        };
        paste(pair, wide, 0);
        paste(heat, wide, pair.width + 4);
        write_png(strip.strip, wide);
        write_png(strip.crop, worst_part(map, drawn.picture));
        return strip;
    }

    /// The square with the largest error, of method and reference, each pixel as four by four.
    Image worst_part(const Image& map, const Image& picture) const {
        const std::uint32_t side = std::min({48u, map.width, map.height});
        uvec2 worst(0);
        double largest = -1.0;
        for (std::uint32_t y = 0; y + side <= map.height; y += side / 2) {
            for (std::uint32_t x = 0; x + side <= map.width; x += side / 2) {
                double sum = 0.0;
                for (std::uint32_t j = 0; j < side; ++j) {
                    for (std::uint32_t i = 0; i < side; ++i) sum += std::min(*map.pixel(x + i, y + j), 4.0f);
                }
                if (sum > largest) {
                    largest = sum;
                    worst = {x, y};
                }
            }
        }
        const auto enlarged = [&](const Image& from) {
            Image crop(side * 4, side * 4, 3);
            for (std::uint32_t y = 0; y < crop.height; ++y) {
                for (std::uint32_t x = 0; x < crop.width; ++x) std::copy_n(from.pixel(worst.x + x / 4, worst.y + y / 4), 3, crop.pixel(x, y));
            }
            return crop;
        };
        return side_by_side({enlarged(picture), enlarged(truths_.picture)}, 4);
    }

    /// All candidates take turns, so that a busy moment hits all alike.
    void time_candidates() {
        std::vector<std::unique_ptr<BenchSide>> sides;
        std::vector<bool> slow, slow_anew;
        for (const BenchCandidate& candidate : plan_.candidates) {
            sides.push_back(std::make_unique<BenchSide>(open_scene(choice_of(scene_, candidate))));
            const double most = 1000.0 * plan_.longest_repeated;
            slow_anew.push_back(sides.back()->draw(plan_.size, 0, false) > most);  // warm-up: shaders, maps, textures, facets
            slow.push_back(slow_anew.back() && sides.back()->draw(plan_.size, 1, false) > most);
        }
        for (std::uint32_t round = 0; round < plan_.rounds; ++round) {
            for (std::size_t i = 0; i < sides.size(); ++i) {
                if (round == 0 || !slow[i]) sides[i]->measure(plan_.size, round + 2);
                tell(0.75 + 0.25 * static_cast<double>(round * sides.size() + i + 1) / static_cast<double>(plan_.rounds * sides.size()), "times");
            }
        }
        const std::uint32_t anew = std::min(rounds_lit_anew, plan_.rounds);
        for (std::uint32_t round = 0; round < anew; ++round) {
            for (std::size_t i = 0; i < sides.size(); ++i) {
                if (round == 0 || !slow_anew[i]) sides[i]->measure_anew(plan_.size, 2 * (plan_.rounds + round + 2));
            }
        }
        for (std::size_t i = 0; i < sides.size(); ++i) {
            rows_[i].gi_anew_ms = spread_of(sides[i]->gi_anew);
            rows_[i].gi_ms = spread_of(sides[i]->gi);
            rows_[i].frame_ms = spread_of(sides[i]->frames);
            rows_[i].runs = sides[i]->gi.size();
        }
    }

    const BenchPlan& plan_;
    std::string scene_;
    std::filesystem::path folder_;
    BenchReport& report_;
    Progress& progress_;
    double first_share_, share_;
    ViewTruths truths_;
    std::map<std::uint32_t, Image> exact_;
    std::vector<BenchRow> rows_;
};

void print(const BenchReport& report) {
    const std::vector<bool> best = on_frontier(report.rows);
    for (const BenchView& view : report.views) {
        fmt::print("\n{} · own noise of the references: open {:.1f} %, one bounce {:.1f} %, full {:.1f} %\n", view.scene, 100.0 * view.open_noise, 100.0 * view.one_noise, 100.0 * view.full_noise);
        fmt::print("  {:<58}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>8}\n", "NRMSE of irradiance, %", "GI ms", "lit anew", "sampling", "open", "one", "full", "FLIP");
        for (std::size_t i = 0; i < report.rows.size(); ++i) {
            const BenchRow& row = report.rows[i];
            if (row.scene != view.scene) continue;
            fmt::print("{} {:<58}{:>10.2f}{:>10.1f}{:>10}{:>10.1f}{:>10.1f}{:>10.1f}{:>8.3f}\n", best[i] ? "*" : " ", row.candidate, row.gi_ms.median, row.gi_anew_ms.median,
                       row.sampling ? fmt::format("{:.1f}", 100.0 * row.sampling->nrmse) : "-", 100.0 * row.open.nrmse, 100.0 * row.one.nrmse, 100.0 * row.full.nrmse, row.flip);
        }
    }
    fmt::print("\n* no other is both faster and nearer to the full transport\n");
}

int run_bench_gi(const GlobalFlags& global, const GiBenchFlags& flags) {
    const BenchPlan plan = plan_of(flags);
    std::filesystem::create_directories(flags.folder);
    Headless headless(global);
    BenchReport report;
    report.commit = first_line_of("git -C '" SL_SOURCE_FOLDER "' describe --always --dirty 2>/dev/null");
    if (report.commit.empty()) report.commit = "unknown";
    report.processor = processor_name();
    report.renderer = headless.context->renderer();
    report.date = today();
    report.size = fmt::format("{}x{}", plan.size.x, plan.size.y);
    report.command = command_of(flags);
    Progress progress("measuring");
    for (std::size_t i = 0; i < plan.scenes.size(); ++i) {
        const auto count = static_cast<double>(plan.scenes.size());
        ViewBench(plan, plan.scenes[i], flags.folder, report, progress, static_cast<double>(i) / count, 1.0 / count).run();
        write_report(report, flags.folder);  // after each scene: nothing of a long run is lost
    }
    progress.clear();
    headless.check_errors();
    print(report);
    if (!flags.presets.empty()) write_text_file(flags.presets, chosen_presets(report));
    fmt::print("{}\n", std::filesystem::absolute(std::filesystem::path(flags.folder) / "report.html").string());
    return 0;
}

}  // namespace

void add_bench_gi_command(const Flags& bench, const GlobalFlags& global) {
    auto flags = std::make_shared<GiBenchFlags>();
    const Flags command = bench.command("gi", "Speed against error of every GI method, into CSV, JSON and an HTML report; about an hour without a GPU");
    command.toggle("--quick", flags->quick, "A minute: small pictures, few settings");
    command.add("--scene,PATH", flags->scenes, "Scenes to measure instead of the plan's; repeatable");
    command.add("--gi", flags->methods, "Methods to measure instead of all; repeatable");
    command.add("--size", flags->size, "WIDTHxHEIGHT in pixels instead of the plan's");
    command.add("--rounds", flags->rounds, "Times that all candidates take turns; 0: the plan's");
    command.add("--spp", flags->spp, "Samples per pixel of the references; 0: the plan's");
    command.add("--folder", flags->folder, "Where the report and the references go; references found there continue");
    command.add("--write-presets", flags->presets, "Also choose a preset per method and quality step from the figures, into this file");
    command.runs([&global, flags] { return run_bench_gi(global, *flags); });
}

}  // namespace sl
