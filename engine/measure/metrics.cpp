// SPDX-License-Identifier: MIT
#include "engine/measure/metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/check.h"
#include "engine/core/error.h"

namespace sl {

namespace {

constexpr double dark_share = 0.01;  // of the reference's mean: what counts as dark for relative errors

std::size_t pixel_count(const Image& image) {
    return std::size_t{image.width} * image.height;
}

bool compared(const std::vector<float>& mask, std::size_t i) {
    return mask.empty() || mask[i] != 0.0f;
}

/// 0/0 is no error, anything else over 0 is an infinite one.
double ratio(double numerator, double denominator) {
    if (numerator == 0.0) return 0.0;
    if (denominator > 0.0) return numerator / denominator;
    return std::copysign(std::numeric_limits<double>::infinity(), numerator);
}

void check_pair(const Image& image, const Image& reference, const std::vector<float>& mask) {
    CHECK(image.width == reference.width && image.height == reference.height, "{}x{} against {}x{}", image.width,
          image.height, reference.width, reference.height);
    CHECK(image.channels >= 3 && reference.channels >= 3, "{} channels against {}", image.channels, reference.channels);
    CHECK(mask.empty() || mask.size() == pixel_count(image), "{} mask values for {} pixels", mask.size(),
          pixel_count(image));
}

/// The value at the rank that 95 % of the others do not exceed (nearest rank: the ⌈0.95 n⌉-th smallest).
double percentile_95(std::vector<double> values) {
    const std::size_t rank = (values.size() * 95 + 99) / 100;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank - 1);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// The same over what relative_error_map shows, in double.
std::vector<double> relative_errors(const Image& image, const Image& reference, const std::vector<float>& mask) {
    double sum = 0.0, count = 0.0;
    for (std::size_t i = 0; i < pixel_count(reference); ++i) {
        if (!compared(mask, i)) continue;
        sum += luminance_at(reference, i);
        count += 1.0;
    }
    const double dark = count > 0.0 ? dark_share * std::max(sum / count, 0.0) : 0.0;
    std::vector<double> errors(pixel_count(reference));
    for (std::size_t i = 0; i < errors.size(); ++i) {
        if (!compared(mask, i)) continue;
        const double r = luminance_at(reference, i);
        errors[i] = ratio(std::abs(luminance_at(image, i) - r), std::abs(r) + dark);
    }
    return errors;
}

}  // namespace

ErrorMetrics image_errors(const Image& image, const Image& reference, const std::vector<float>& mask) {
    check_pair(image, reference, mask);
    check_finite("the image", image, mask);
    check_finite("the reference", reference, mask);
    ErrorMetrics result;
    double sum = 0.0, differences = 0.0, squares = 0.0;
    const auto for_each_value = [&](auto&& body) {
        for (std::size_t i = 0; i < pixel_count(image); ++i) {
            if (!compared(mask, i)) continue;
            for (std::size_t c = 0; c < 3; ++c)
                body(double{image.data[i * image.channels + c]}, double{reference.data[i * reference.channels + c]});
        }
    };
    for_each_value([&](double x, double r) {
        sum += r;
        differences += x - r;
        squares += (x - r) * (x - r);
        ++result.pixels;
    });
    if (result.pixels == 0) fail("there is no pixel to compare: the mask leaves none, or the images are empty");
    const auto count = static_cast<double>(result.pixels);
    result.pixels /= 3;
    const double mean = std::max(sum / count, 0.0);
    const double epsilon = (dark_share * mean) * (dark_share * mean);
    double relative_squares = 0.0;
    for_each_value([&](double x, double r) { relative_squares += ratio((x - r) * (x - r), r * r + epsilon); });
    result.rel_mse = relative_squares / count;
    result.nrmse = ratio(std::sqrt(squares / count), mean);
    result.bias = ratio(differences / count, mean);

    std::vector<double> errors = relative_errors(image, reference, mask);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        if (compared(mask, i)) errors[kept++] = errors[i];
    }
    errors.resize(kept);
    result.p95 = percentile_95(std::move(errors));
    return result;
}

Image relative_error_map(const Image& image, const Image& reference, const std::vector<float>& mask) {
    check_pair(image, reference, mask);
    const std::vector<double> errors = relative_errors(image, reference, mask);
    Image map(image.width, image.height, 1);
    std::ranges::transform(errors, map.data.begin(), [](double error) { return static_cast<float>(error); });
    return map;
}

void check_finite(const std::string& name, const Image& image, const std::vector<float>& mask) {
    std::size_t bad = 0, first = 0;
    for (std::size_t i = 0; i < pixel_count(image); ++i) {
        if (!compared(mask, i)) continue;
        const float* p = &image.data[i * image.channels];
        if (std::all_of(p, p + std::min(image.channels, 3u), [](float value) { return std::isfinite(value); }))
            continue;
        if (bad++ == 0) first = i;
    }
    if (bad == 0) return;
    fail(
        "{}: {} of {} pixels hold infinity or no number, the first at column {}, row {}; an error figure would hide "
        "them",
        name, bad, pixel_count(image), first % image.width, first / image.width);
}

double luminance_at(const Image& image, std::size_t pixel) {
    const float* p = &image.data[pixel * image.channels];
    return 0.2126 * double{p[0]} + 0.7152 * double{p[1]} + 0.0722 * double{p[2]};
}

double masked_mean(const Image& map, const std::vector<float>& mask) {
    CHECK(map.channels == 1 && (mask.empty() || mask.size() == pixel_count(map)),
          "{} channels, {} mask values for {} pixels", map.channels, mask.size(), pixel_count(map));
    double sum = 0.0, count = 0.0;
    for (std::size_t i = 0; i < pixel_count(map); ++i) {
        if (!compared(mask, i)) continue;
        sum += double{map.data[i]};
        count += 1.0;
    }
    return count > 0.0 ? sum / count : 0.0;
}

}  // namespace sl
