// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "engine/core/image.h"
#include "engine/measure/metrics.h"
#include "engine/measure/spread.h"

namespace sl {

/// One candidate in one view: what it costs, and how far it is from each truth.
struct BenchRow {
    std::string scene, method, candidate;
    std::string settings;  ///< all of the method's: "rsm_size=128 samples=64 ..."
    Spread gi_ms, gi_anew_ms, frame_ms;
    std::size_t runs = 0;
    std::optional<ErrorMetrics> sampling;  ///< against the sum over every texel of the same maps; none for methods without samples
    ErrorMetrics open, one, full;          ///< against the path-traced truths (bench_truth.h)
    double flip = 0.0;                     ///< of the picture, against the full transport's
};

/// A view's truths as the report tells of them.
struct BenchView {
    std::string scene;
    double open_noise = 0.0, one_noise = 0.0, full_noise = 0.0;
};

/// Three pictures side by side under a caption, as PNG files in the report's folder.
struct BenchStrip {
    std::string scene, caption;
    std::filesystem::path strip, crop;  ///< method | reference | error; the worst part of the first two, enlarged
};

/// All that a run found.
struct BenchReport {
    std::string commit, processor, renderer, date, size, command;
    std::vector<BenchView> views;
    std::vector<BenchRow> rows;
    std::vector<BenchStrip> strips;
};

/// report.csv, report.json and report.html (self-contained) in a folder. Throws Error naming the file.
void write_report(const BenchReport& report, const std::filesystem::path& folder);

/// Rows of `scene` that no other of that scene beats in time and error against the full transport.
std::vector<bool> on_frontier(const std::vector<BenchRow>& rows);

/// Settings per method and quality step, chosen from a report: over all scenes (geometric means of time and of error
/// against the transport that the methods claim), the cheapest of the method's frontier, the one with the least product
/// of both, and the one with the least error. As the text of a presets file that says which run it is from.
std::string chosen_presets(const BenchReport& report);

}  // namespace sl
