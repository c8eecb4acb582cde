// SPDX-License-Identifier: MIT
#include "game/app/compare.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/core/text_file.h"
#include "engine/measure/heat_map.h"
#include "shared/tonemap.h"

namespace sl {

namespace {

/// As RenderScene::View::exposure, in double: the range of float is too small for the exposure of every float.
double exposure_of(double ev100) {
    return 1.0 / (1.2 * std::exp2(ev100));
}

/// The exposure at which the mean luminance of the pixels that count is shown as 18 % grey; 0 where that is black.
double grey_ev100(const Image& reference, const std::vector<float>& mask) {
    Image luminance(reference.width, reference.height, 1);
    for (std::size_t i = 0; i < luminance.data.size(); ++i) {
        const float* p = &reference.data[i * 3];
        luminance.data[i] = 0.2126f * p[0] + 0.7152f * p[1] + 0.0722f * p[2];
    }
    const double mean = masked_mean(luminance, mask);
    return mean > 0.0 ? std::log2(exposure_of(0.0) * mean / 0.18) : 0.0;
}

/// Exposed, cut at 1 and sRGB-encoded. No filmic curve: its shoulder would hide differences between bright pixels. What
/// is masked may hold no number, and stays none.
Image picture_of(const Image& linear, double exposure) {
    Image result(linear.width, linear.height, 3);
    for (std::size_t i = 0; i < linear.data.size(); ++i) {
        result.data[i] =
            srgb_encode_channel(static_cast<float>(std::clamp(double{linear.data[i]} * exposure, 0.0, 1.0)));
    }
    return result;
}

std::string percent(double fraction) {
    return fmt::format("{:.4g} %", 100.0 * fraction);
}

void print(const ImagePair& pair, const Comparison& result, const CompareFlags& flags) {
    const auto row = [](const char* name, const std::string& text) { fmt::print("{:<12}{}\n", name, text); };
    const std::size_t all = std::size_t{pair.image.width} * pair.image.height;
    row("image", pair.image_name);
    row("reference", pair.reference_name);
    std::string ignored = fmt::format("{} of {} compared", result.errors.pixels, all);
    if (result.errors.pixels < all) ignored += "; background (depth 0) left out";
    if (pair.background_differs > 0)
        ignored += fmt::format("; {} are background in one of the files only", pair.background_differs);
    row("pixels", ignored);
    row("relMSE", fmt::format("{:.4g}", result.errors.rel_mse));
    row("NRMSE", percent(result.errors.nrmse));
    if (pair.reference_noise) row("", fmt::format("of which the reference's own noise is {}", percent(*pair.reference_noise)));
    row("p95", percent(result.errors.p95));
    row("bias", fmt::format("{:+.4g} %", 100.0 * result.errors.bias));
    std::string view = fmt::format("{:g} pixels per degree", flags.pixels_per_degree);
    if (!pair.decoded)
        view += fmt::format(", EV100 {:.2f}{}", result.ev100, flags.ev100 ? "" : ": the reference's mean as 18 % grey");
    row("FLIP", fmt::format("{:.4g} ({})", result.flip.mean, view));
}

void write_figures(const ImagePair& pair, const Comparison& result, const CompareFlags& flags) {
    nlohmann::json json{{"image", pair.image_name},        {"reference", pair.reference_name},
                        {"width", pair.image.width},       {"height", pair.image.height},
                        {"pixels", result.errors.pixels},  {"background_differs", pair.background_differs},
                        {"relmse", result.errors.rel_mse}, {"nrmse", result.errors.nrmse},
                        {"p95", result.errors.p95},        {"bias", result.errors.bias},
                        {"flip", result.flip.mean},        {"pixels_per_degree", flags.pixels_per_degree}};
    if (!pair.decoded) json["ev100"] = result.ev100;
    if (pair.reference_noise) json["reference_noise"] = *pair.reference_noise;
    write_text_file(flags.json, json.dump(2) + "\n");
}

void write_heat_map(const ImagePair& pair, const Comparison& result, const CompareFlags& flags) {
    if (flags.heat == "flip") {
        write_png(flags.heat_map,
                  heat_map(result.flip.map, pair.mask, {.title = "FLIP", .top = flags.heat_max.value_or(1.0)}));
        return;
    }
    const Image map = relative_error_map(pair.image, pair.reference, pair.mask);
    const double top = flags.heat_max ? *flags.heat_max : suggested_top(map, pair.mask);
    write_png(flags.heat_map, heat_map(map, pair.mask, {.title = "relative error", .top = top, .percent = true}));
}

/// What the command line's own checks let through: "nan" and "inf" are numbers to it.
void check_flags(const CompareFlags& flags) {
    if (flags.ev100 && !(std::abs(*flags.ev100) <= 100.0))
        fail("--ev100 {} is no exposure; choose from -100 to 100", *flags.ev100);
    if (!(flags.pixels_per_degree >= 1.0f && flags.pixels_per_degree <= 1000.0f)) {
        fail("--pixels-per-degree {} is out of range; choose from 1 to 1000, for example 67", flags.pixels_per_degree);
    }
    if (flags.heat_max && !(*flags.heat_max > 0.0 && std::isfinite(*flags.heat_max))) {
        fail("--heat-max {} is no end of a scale; choose a number above 0", *flags.heat_max);
    }
}

/// Says on stderr which limits are exceeded. Written so that a figure that is no number exceeds every limit.
bool within_limits(const Comparison& result, const CompareFlags& flags) {
    struct Limit {
        const char* name;
        double value;
        std::optional<double> most;
    };
    const Limit limits[] = {{"relmse", result.errors.rel_mse, flags.max_rel_mse},
                            {"nrmse", result.errors.nrmse, flags.max_nrmse},
                            {"p95", result.errors.p95, flags.max_p95},
                            {"bias", std::abs(result.errors.bias), flags.max_bias},
                            {"flip", result.flip.mean, flags.max_flip}};
    bool within = true;
    for (const Limit& limit : limits) {
        if (!limit.most || limit.value <= *limit.most) continue;
        fmt::print(stderr, "secondlight: compare: {} {:.6g} exceeds --max-{} {:g} by {:.3g}\n", limit.name, limit.value,
                   limit.name, *limit.most, limit.value - *limit.most);
        within = false;
    }
    return within;
}

}  // namespace

Comparison compare(const ImagePair& pair, const CompareFlags& flags) {
    Comparison result{.errors = image_errors(pair.image, pair.reference, pair.mask), .flip = {}};
    double exposure = 1.0;
    if (!pair.decoded) {
        result.ev100 = flags.ev100 ? *flags.ev100 : grey_ev100(pair.reference, pair.mask);
        exposure = exposure_of(result.ev100);
    }
    result.flip = flip(picture_of(pair.image, exposure), picture_of(pair.reference, exposure), pair.mask,
                       flags.pixels_per_degree);
    return result;
}

int run_compare(const CompareFlags& flags) {
    check_flags(flags);
    const ImagePair pair = load_pair(flags);
    const Comparison result = compare(pair, flags);
    print(pair, result, flags);
    if (!flags.json.empty()) write_figures(pair, result, flags);
    if (!flags.heat_map.empty()) write_heat_map(pair, result, flags);
    std::fflush(stdout);
    return within_limits(result, flags) ? 0 : 1;
}

}  // namespace sl
