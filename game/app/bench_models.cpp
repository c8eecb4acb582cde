// SPDX-License-Identifier: MIT
#include "game/app/bench_models.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/core/text_file.h"
#include "game/app/model_point.h"
#include "game/app/own_process.h"
#include "game/app/progress.h"

namespace sl {

using nlohmann::json;

namespace {

json json_of(const ModelLoad& load) { return {{"load_s", load.load_s}, {"triangles", load.triangles}}; }

json json_of(const CaptureCost& cost) { return {{"capture_s", cost.capture_s}, {"peak_mb", cost.peak_mb}}; }

json json_of(const ModelErrors& errors) { return {{"nrmse", errors.nrmse}, {"bias", errors.bias}, {"reference_noise", errors.reference_noise}, {"flip", errors.flip}}; }

/// "box_textured/Box.glb" as the name of a folder.
std::string folder_name(std::string model) {
    std::ranges::replace(model, '/', '_');
    return model;
}

/// A message as a cell of a table.
std::string in_a_cell(const std::string& text) {
    std::string cell;
    for (const char c : text) cell += c == '|' ? "\\|" : c == '\n' ? " " : std::string(1, c);
    return cell;
}

/// A figure of a row; a dash where there is none, or it is no number.
std::string cell(const json& row, const char* name, double factor, fmt::format_string<double> form) {
    const auto found = row.find(name);
    return found != row.end() && found->is_number() ? fmt::format(form, factor * found->get<double>()) : "–";
}

/// What a step of a model's measurement adds to its row; an error where it fails, without the file's name, which the row has.
void add_step(json& row, const ModelPoint& point, const char* name, double minutes, const std::function<json()>& step) {
    if (row.contains("error")) return;
    try {
        row.update(json::parse(in_own_process([&] { return step().dump(); }, 60.0 * minutes)));
    } catch (const LimitReached& limit) {
        row["error"] = fmt::format("the {} {}", name, limit.what());
    } catch (const Error& error) {
        const std::string text = error.what(), file = point.choice.scene + ": ";
        row["error"] = text.starts_with(file) ? text.substr(file.size()) : text;
    }
}

void write_models_report(const ModelsFlags& flags, const json& rows) {
    const std::filesystem::path folder = flags.folder;
    const std::string about = fmt::format("{} pixels; error at {} pixels, against {} samples a pixel:", flags.size, flags.reference_size, flags.spp);
    const json report{{"size", flags.size}, {"reference_size", flags.reference_size}, {"spp", flags.spp}, {"minutes", flags.minutes}, {"gi", flags.gi}, {"rows", rows}};
    write_text_file(folder / "report.json", report.dump(1) + "\n");
    write_text_file(folder / "report.md", about + "\n\n" + models_table(rows));
}

}  // namespace

std::string models_table(const json& rows) {
    std::string text = "| model | triangles | to load, s | capture, s | peak memory, MB | NRMSE | bias | the reference's own noise | FLIP of the picture |\n"
                       "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
    for (const json& row : rows) {
        text += fmt::format("| {} | {} | {} | {} | {} | ", in_a_cell(row["model"].get<std::string>()), cell(row, "triangles", 1.0, "{:.0f}"), cell(row, "load_s", 1.0, "{:.2f}"),
                            cell(row, "capture_s", 1.0, "{:.1f}"), cell(row, "peak_mb", 1.0, "{:.0f}"));
        if (row.contains("error")) {
            text += fmt::format("{} | | | |\n", in_a_cell(row["error"].get<std::string>()));
        } else {
            text += fmt::format("{} | {} | {} | {} |\n", cell(row, "nrmse", 100.0, "{:.1f} %"), cell(row, "bias", 100.0, "{:+.1f} %"), cell(row, "reference_noise", 100.0, "{:.1f} %"),
                                cell(row, "flip", 1.0, "{:.3f}"));
        }
    }
    return text;
}

int run_bench_models(const GlobalFlags& global, const ModelsFlags& flags) {
    ModelPoint point{.size = parse_size(flags.size), .reference_size = parse_size(flags.reference_size), .spp = flags.spp};
    if (flags.spp == 0) fail("--spp 0: a reference needs a sample at least");
    if (!flags.gi.empty()) (void)make_gi_method(flags.gi.substr(0, flags.gi.find(':')));
    const std::vector<FoundModel> models = find_models(flags.paths);
    json rows = json::array();
    bool all = true;
    Progress progress("models");
    for (const FoundModel& model : models) {
        progress.clear();
        progress.update(rows.size(), models.size(), model.name);
        point.choice = {.scene = model.path.string(), .gi = flags.gi};
        point.folder = std::filesystem::path(flags.folder) / folder_name(model.name);
        std::filesystem::create_directories(point.folder);
        json row{{"model", model.name}};
        add_step(row, point, "loading", flags.minutes, [&] { return json_of(measure_model_load(point)); });
        add_step(row, point, "capture", flags.minutes, [&] { return json_of(measure_model_capture(global, point)); });
        add_step(row, point, "comparison", flags.minutes, [&] { return json_of(measure_model_errors(global, point)); });
        all &= !row.contains("error");
        rows.push_back(std::move(row));
        write_models_report(flags, rows);  // after each: nothing of a long run is lost
    }
    progress.clear();
    fmt::print("{}\nPictures are below {}.\n", models_table(rows), std::filesystem::absolute(flags.folder).string());
    return all ? 0 : 1;
}

void add_bench_models_command(const Flags& bench, const GlobalFlags& global) {
    auto flags = std::make_shared<ModelsFlags>();
    const Flags command = bench.command("models", "Time, memory and error of each model of a folder, as a table with pictures");
    command.add("PATHS", flags->paths, "Models (.gltf, .glb, .vox), and folders with models").required();
    command.add("--size", flags->size, "WIDTHxHEIGHT in pixels of the capture that is timed");
    command.add("--reference-size", flags->reference_size, "WIDTHxHEIGHT in pixels of what is compared with the path-traced truth");
    command.add("--spp", flags->spp, "Samples per pixel of the references");
    command.add("--gi", flags->gi, "GI method; default: facets, which scenes of models have");
    command.add("--minutes", flags->minutes, "Loading, a capture or a comparison that takes longer is given up, and its row says so").within(0.01, 1e6);
    command.add("--folder", flags->folder, "Where report.json, report.md and the pictures go; references found there continue");
    command.footer("To load: until the model can be drawn. Capture: all that `capture` does, from starting to load to the written picture.\n"
                   "Error: of indirect irradiance, as NRMSE (root mean square error over the reference's mean) and bias (mean error over that\n"
                   "mean), against path-traced full transport from the same camera. FLIP: how different the pictures look, 0 to 1.\n"
                   "Exits with 1 where a model could not be measured.");
    command.runs([&global, flags] { return run_bench_models(global, *flags); });
}

}  // namespace sl
