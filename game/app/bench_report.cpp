// SPDX-License-Identifier: MIT
#include "game/app/bench_report.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "engine/core/json_text.h"
#include "engine/core/text_file.h"
#include "engine/ecs/components/gi_settings.h"
#include "engine/measure/frontier.h"
#include "engine/measure/svg_plot.h"

namespace sl {

namespace {

using Json = nlohmann::ordered_json;

/// The figures of a row under the names that all three files use.
std::vector<std::pair<std::string, double>> figures(const BenchRow& row) {
    std::vector<std::pair<std::string, double>> result{{"gi_ms", row.gi_ms.median}, {"gi_ms_q1", row.gi_ms.first}, {"gi_ms_q3", row.gi_ms.third},
                                                       {"gi_anew_ms", row.gi_anew_ms.median}, {"gi_anew_ms_q1", row.gi_anew_ms.first}, {"gi_anew_ms_q3", row.gi_anew_ms.third},
                                                       {"frame_ms", row.frame_ms.median}, {"frame_ms_q1", row.frame_ms.first}, {"frame_ms_q3", row.frame_ms.third},
                                                       {"runs", static_cast<double>(row.runs)}};
    const auto add = [&](const std::string& truth, const ErrorMetrics* errors) {
        const double none = std::nan("");
        result.emplace_back(truth + "_nrmse", errors != nullptr ? errors->nrmse : none);
        result.emplace_back(truth + "_relmse", errors != nullptr ? errors->rel_mse : none);
        result.emplace_back(truth + "_p95", errors != nullptr ? errors->p95 : none);
        result.emplace_back(truth + "_bias", errors != nullptr ? errors->bias : none);
    };
    add("sampling", row.sampling ? &*row.sampling : nullptr);
    add("open", &row.open);
    add("one", &row.one);
    add("full", &row.full);
    result.emplace_back("flip", row.flip);
    return result;
}

std::string csv(const BenchReport& report) {
    std::string text = "commit,processor,renderer,date,size,scene,method,candidate,settings";
    for (const auto& [name, value] : figures(BenchRow{})) text += "," + name;
    text += "\n";
    for (const BenchRow& row : report.rows) {
        text += fmt::format("{},\"{}\",\"{}\",{},{},{},{},{},{}", report.commit, report.processor, report.renderer, report.date, report.size, row.scene, row.method, row.candidate, row.settings);
        for (const auto& [name, value] : figures(row)) text += std::isfinite(value) ? fmt::format(",{:.6g}", value) : ",";
        text += "\n";
    }
    return text;
}

Json json(const BenchReport& report) {
    Json views = Json::array(), rows = Json::array();
    for (const BenchView& view : report.views) {
        views.push_back({{"scene", view.scene}, {"open_noise", view.open_noise}, {"one_noise", view.one_noise}, {"full_noise", view.full_noise}});
    }
    for (const BenchRow& row : report.rows) {
        Json one{{"scene", row.scene}, {"method", row.method}, {"candidate", row.candidate}, {"settings", row.settings}};
        for (const auto& [name, value] : figures(row)) one[name] = std::isfinite(value) ? Json(value) : Json(nullptr);
        rows.push_back(std::move(one));
    }
    return {{"commit", report.commit}, {"processor", report.processor}, {"renderer", report.renderer}, {"date", report.date},
            {"size", report.size}, {"command", report.command}, {"views", views}, {"rows", rows}};
}

std::string base64(const std::string& bytes) {
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k) three = three << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? digits[three >> (18 - 6 * k) & 63u] : '=';
    }
    return text;
}

std::string picture(const std::filesystem::path& file, const std::string& what) {
    return fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">", html_text(what), base64(read_text_file(file, 64u << 20)));
}

constexpr const char* page_head = R"(<!doctype html>
<html lang="en"><meta charset="utf-8"><title>Secondlight: speed against error</title>
<style>
body{font:15px/1.45 system-ui,sans-serif;max-width:1320px;margin:2em auto;padding:0 1em;color:#1b1b1b}
h2{margin-top:2em}table{border-collapse:collapse;font-variant-numeric:tabular-nums}
td,th{padding:.15em .7em;text-align:right;border-bottom:1px solid #ddd}td:first-child,th:first-child{text-align:left}
tr.best td{background:#eef6ea}figure{margin:1em 0}img{max-width:100%;image-rendering:pixelated}
figcaption,.note{color:#555}.plots{display:flex;flex-wrap:wrap;gap:1em}
svg text{font:12px system-ui,sans-serif}svg .title{font-weight:bold;font-size:14px}.tick{stroke:#f0f0f0}.decade{stroke:#d4d4d4}
.curve{fill:none;stroke-width:1.5;opacity:.7}.ring{fill:none;stroke:#111}.frontier{fill:none;stroke:#111;stroke-dasharray:4 3}
</style>
<h1>Speed against error</h1>
)";

constexpr const char* explanation = R"(<p class="note">Time is that of all passes which the method asks for, each finished before the next, and of what it traces on the CPU; median (quartiles).
The camera turns at each frame, so nothing that depends on the view is reused; light and blocks stand still, so what was made of them
(reflective shadow maps, facets) is. <b>Lit anew</b> is a frame after all of that was forgotten: as if every light had moved.
Errors are of indirect irradiance, background left out, as NRMSE (root mean square error over the reference's mean):
<b>sampling</b> against the sum over every texel of the same maps; <b>open</b> against path-traced one diffuse bounce that passes through everything;
<b>one bounce</b> the same, blocked by what stands between; <b>full</b> against all transport, sky and glowing surfaces included.
Bias is the mean signed error over the mean, against full. FLIP is of the tonemapped pictures, against full.
A reference's own noise stands beside it: an error near it is not a measurement. Green rows: no other is both faster and nearer to full.</p>
)";

std::string percent(double value) { return std::isfinite(value) ? fmt::format("{:.1f} %", 100.0 * value) : "–"; }

std::string table(const BenchReport& report, const BenchView& view, const std::vector<bool>& best) {
    std::string html = fmt::format("<table><tr><th>method</th><th>GI, ms</th><th>lit anew, ms</th><th>frame, ms</th><th>sampling</th><th>open<br>(noise {})</th><th>one bounce<br>(noise {})</th>"
                                   "<th>full<br>(noise {})</th><th>bias</th><th>p95</th><th>relMSE</th><th>FLIP</th></tr>\n",
                                   percent(view.open_noise), percent(view.one_noise), percent(view.full_noise));
    for (std::size_t i = 0; i < report.rows.size(); ++i) {
        const BenchRow& row = report.rows[i];
        if (row.scene != view.scene) continue;
        html += fmt::format("<tr{}><td>{}</td><td>{:.1f} ({:.1f}–{:.1f})</td><td>{:.1f}</td><td>{:.1f}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{:.3g}</td><td>{:.3f}</td></tr>\n",
                            best[i] ? " class=\"best\"" : "", html_text(row.candidate), row.gi_ms.median, row.gi_ms.first, row.gi_ms.third, row.gi_anew_ms.median, row.frame_ms.median,
                            row.sampling ? percent(row.sampling->nrmse) : "–", percent(row.open.nrmse), percent(row.one.nrmse), percent(row.full.nrmse), percent(row.full.bias),
                            percent(row.full.p95), row.full.rel_mse, row.flip);
    }
    return html + "</table>\n";
}

std::string plot(const BenchReport& report, const BenchView& view, const char* title, const std::vector<bool>& best, double (*error)(const BenchRow&)) {
    std::vector<PlotSeries> series;
    for (std::size_t i = 0; i < report.rows.size(); ++i) {
        const BenchRow& row = report.rows[i];
        if (row.scene != view.scene || row.method == "off") continue;
        auto found = std::ranges::find(series, row.method, &PlotSeries::name);
        if (found == series.end()) found = series.insert(series.end(), {row.method, {}});
        found->points.push_back({row.gi_ms.median, 100.0 * error(row), fmt::format("{}: {:.1f} ms, {:.1f} %", row.candidate, row.gi_ms.median, 100.0 * error(row)), best[i]});
    }
    for (PlotSeries& one : series) std::ranges::sort(one.points, {}, &PlotPoint::x);
    return svg_plot(title, "GI time per frame, ms", "NRMSE of irradiance, %", series);
}

std::string html(const BenchReport& report) {
    const std::vector<bool> best = on_frontier(report.rows);
    std::string page = page_head;
    page += fmt::format("<p>{} · {} · {} · {} pixels · commit {} · <code>{}</code></p>\n", html_text(report.date), html_text(report.processor), html_text(report.renderer),
                        report.size, html_text(report.commit), html_text(report.command));
    page += explanation;
    for (const BenchView& view : report.views) {
        page += fmt::format("<h2>{}</h2>\n<div class=\"plots\">\n", html_text(view.scene));
        page += plot(report, view, "Against the full transport", best, [](const BenchRow& row) { return row.full.nrmse; });
        page += plot(report, view, "Against what the methods claim: one bounce, open", std::vector<bool>(best.size()), [](const BenchRow& row) { return row.open.nrmse; });
        page += "</div>\n" + table(report, view, best);
        for (const BenchStrip& strip : report.strips) {
            if (strip.scene != view.scene) continue;
            page += fmt::format("<figure>{}<br>{}<figcaption>{}</figcaption></figure>\n", picture(strip.strip, strip.caption), picture(strip.crop, "worst part"), html_text(strip.caption));
        }
    }
    return page + "</html>\n";
}

}  // namespace

std::vector<bool> on_frontier(const std::vector<BenchRow>& rows) {
    std::vector<bool> result(rows.size());
    std::map<std::string, std::vector<std::size_t>> by_scene;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].method != "off") by_scene[rows[i].scene].push_back(i);
    }
    for (const auto& [scene, indices] : by_scene) {
        std::vector<CostError> points;
        for (const std::size_t i : indices) points.push_back({rows[i].gi_ms.median, rows[i].full.nrmse});
        for (const std::size_t best : frontier(points)) result[indices[best]] = true;
    }
    return result;
}

std::string chosen_presets(const BenchReport& report) {
    struct Candidate {
        std::string method, name;
        double log_time = 0.0, log_error = 0.0;
        int scenes = 0;
    };
    std::vector<Candidate> candidates;
    for (const BenchRow& row : report.rows) {
        if (row.method == "off") continue;
        auto found = std::ranges::find(candidates, row.candidate, &Candidate::name);
        if (found == candidates.end()) found = candidates.insert(candidates.end(), {row.method, row.candidate});
        found->log_time += std::log(std::max(row.gi_ms.median, 1e-3));
        // Each method is judged by what it claims: all transport, or one bounce that nothing blocks.
        found->log_error += std::log(std::max(row.method == Facets::name ? row.full.nrmse : row.open.nrmse, 1e-6));
        ++found->scenes;
    }
    Json methods = Json::object();
    for (const Candidate& first : candidates) {
        if (methods.contains(first.method)) continue;
        std::vector<const Candidate*> own;
        std::vector<CostError> points;
        for (const Candidate& candidate : candidates) {
            if (candidate.method != first.method) continue;
            own.push_back(&candidate);
            points.push_back({std::exp(candidate.log_time / candidate.scenes), std::exp(candidate.log_error / candidate.scenes)});
        }
        const std::vector<std::size_t> best = frontier(points);
        const auto knee = *std::ranges::min_element(best, {}, [&](std::size_t i) { return points[i].cost * points[i].error; });
        for (const auto& [step, index] : {std::pair("low", best.front()), std::pair("medium", knee), std::pair("high", best.back())}) {
            Json fields = Json::object();
            // "method a=1 b=2"
            const std::string& name = own[index]->name;
            for (std::size_t at = name.find(' '); at != std::string::npos;) {
                const std::size_t next = name.find(' ', at + 1);
                const std::string field = name.substr(at + 1, next == std::string::npos ? next : next - at - 1);
                fields[field.substr(0, field.find('='))] = field.substr(field.find('=') + 1);
                at = next;
            }
            methods[first.method][step] = {{"settings", fields}, {"gi_ms", std::round(points[index].cost * 100.0) / 100.0}, {"nrmse", std::round(points[index].error * 1e4) / 1e4}};
        }
    }
    return json_text(Json{{"secondlight_presets", 1},
                          {"from", fmt::format("{} on {}, {}, commit {}, {}; gi_ms and nrmse are geometric means over the scenes, nrmse against what the method claims: one open bounce, for facets all transport", report.command,
                                               report.processor, report.renderer, report.commit, report.date)},
                          {"size", report.size},
                          {"methods", methods}}) + "\n";
}

void write_report(const BenchReport& report, const std::filesystem::path& folder) {
    write_text_file(folder / "report.csv", csv(report));
    write_text_file(folder / "report.json", json(report).dump(1) + "\n");
    write_text_file(folder / "report.html", html(report));
}

}  // namespace sl
