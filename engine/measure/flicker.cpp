// SPDX-License-Identifier: MIT
#include "engine/measure/flicker.h"

#include <algorithm>
#include <cmath>

#include "engine/core/check.h"
#include "engine/measure/metrics.h"

namespace sl {

namespace {

constexpr float plane_tolerance = 0.002f;  // distance off a point's plane, over that to the camera
constexpr float least_cosine = 0.99f;      // of two normals of one surface
constexpr float least_share = 1e-3f;       // a neighbour with less is not looked at
constexpr double dark_share = 0.01;        // of the picture's mean, as for relative errors

vec2 ndc_of(vec2 place, const Image& image) {
    const vec2 size(image.width, image.height);
    return {2.0f * place.x / size.x - 1.0f, 1.0f - 2.0f * place.y / size.y};
}

vec3 vector_at(const Image& image, std::size_t pixel) {
    const float* p = &image.data[pixel * image.channels];
    return {p[0], p[1], p[2]};
}

double value_at(const Image& image, const Footprint& footprint) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        if (footprint.shares[i] > 0.0f) sum += double{footprint.shares[i]} * luminance_at(image, footprint.pixels[i]);
    }
    return sum;
}

/// What the frames show of one surface point, in their order; none where they do not show it.
struct Track {
    std::vector<std::optional<double>> values, errors;

    std::size_t seen() const { return static_cast<std::size_t>(std::ranges::count_if(values, [](const auto& value) { return value.has_value(); })); }
};

Track follow(const std::vector<PathFrame>& frames, vec3 position, vec3 normal) {
    Track track;
    for (const PathFrame& frame : frames) {
        const auto found = find_point(frame, position, normal);
        track.values.push_back(found ? std::optional(value_at(frame.value, *found)) : std::nullopt);
        track.errors.push_back(found && !frame.error.data.empty() ? std::optional(value_at(frame.error, *found)) : std::nullopt);
    }
    return track;
}

/// Mean of `body` over what is there.
template <class Body>
double mean_of(const std::vector<std::optional<double>>& values, const Body& body) {
    double sum = 0.0, count = 0.0;
    for (const auto& value : values) {
        if (!value) continue;
        sum += body(*value);
        count += 1.0;
    }
    return count > 0.0 ? sum / count : 0.0;
}

double mean_square_change(const std::vector<std::optional<double>>& values) {
    double sum = 0.0, count = 0.0;
    for (std::size_t i = 1; i < values.size(); ++i) {
        if (!values[i - 1] || !values[i]) continue;
        sum += (*values[i] - *values[i - 1]) * (*values[i] - *values[i - 1]);
        count += 1.0;
    }
    return count > 0.0 ? sum / count : 0.0;
}

double unlit_share(const std::vector<PathFrame>& frames) {
    double unlit = 0.0, all = 0.0;
    for (const PathFrame& frame : frames) {
        for (std::size_t i = 0; i < frame.depth.data.size(); ++i) {
            if (frame.depth.data[i] <= 0.0f) continue;
            unlit += luminance_at(frame.value, i) == 0.0 ? 1.0 : 0.0;
            all += 1.0;
        }
    }
    return all > 0.0 ? unlit / all : 0.0;
}

void check_frames(const std::vector<PathFrame>& frames) {
    CHECK(frames.size() >= 2, "a path of {} frames", frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const PathFrame& frame = frames[i];
        for (const Image* image : {&frame.depth, &frame.normal, &frame.value}) {
            CHECK(image->width == frames.front().depth.width && image->height == frames.front().depth.height, "frame {} has images of several sizes", i);
        }
        CHECK(frame.depth.channels == 1 && frame.normal.channels >= 3 && frame.value.channels >= 3, "frame {} lacks channels", i);
        check_finite(fmt::format("frame {}", i), frame.value, frame.depth.data);
    }
}

}  // namespace

vec3 seen_position(const PathFrame& frame, uvec2 pixel) {
    const float distance = view_distance(*frame.depth.pixel(pixel.x, pixel.y), frame.view.camera_position.w);
    return vec3(frame.view.camera_position) + distance * view_ray(frame.view, ndc_of(vec2(pixel) + 0.5f, frame.depth));
}

std::optional<Footprint> find_point(const PathFrame& frame, vec3 position, vec3 normal) {
    const vec3 right(frame.view.ray_right), up(frame.view.ray_up), away = position - vec3(frame.view.camera_position);
    const float distance = glm::dot(away, vec3(frame.view.ray_forward));
    if (distance <= frame.view.camera_position.w) return std::nullopt;
    const vec2 size(frame.depth.width, frame.depth.height);
    const vec2 ndc(glm::dot(away, right) / (glm::dot(right, right) * distance), glm::dot(away, up) / (glm::dot(up, up) * distance));
    const vec2 place = vec2(0.5f * (ndc.x + 1.0f), 0.5f * (1.0f - ndc.y)) * size - 0.5f;  // in pixels' middles
    if (!(glm::all(glm::greaterThan(place, vec2(-1.0f))) && glm::all(glm::lessThan(place, size)))) return std::nullopt;
    const vec2 low = glm::floor(place), within = place - low;
    Footprint result;
    float shares = 0.0f;
    for (std::size_t i = 0; i < 4; ++i) {
        const vec2 corner(static_cast<float>(i % 2), static_cast<float>(i / 2));
        const vec2 share = glm::mix(1.0f - within, within, corner), pixel = low + corner;
        if (share.x * share.y < least_share) continue;
        if (pixel.x < 0.0f || pixel.y < 0.0f || pixel.x >= size.x || pixel.y >= size.y) return std::nullopt;
        const uvec2 cell(pixel);
        const std::size_t index = std::size_t{cell.y} * frame.depth.width + cell.x;
        if (frame.depth.data[index] <= 0.0f || glm::dot(vector_at(frame.normal, index), normal) < least_cosine) return std::nullopt;
        if (std::abs(glm::dot(seen_position(frame, cell) - position, normal)) > plane_tolerance * distance) return std::nullopt;
        result.pixels[i] = index;
        result.shares[i] = share.x * share.y;
        shares += result.shares[i];
    }
    for (float& share : result.shares) share /= shares;
    return result;
}

Flicker flicker(const std::vector<PathFrame>& frames) {
    check_frames(frames);
    const PathFrame& middle = frames[frames.size() / 2];
    const std::uint32_t width = middle.depth.width, height = middle.depth.height;
    Image brightness(width, height, 1);
    for (std::size_t i = 0; i < brightness.data.size(); ++i) brightness.data[i] = middle.depth.data[i] > 0.0f ? static_cast<float>(luminance_at(middle.value, i)) : 0.0f;
    const double dark = dark_share * std::max(masked_mean(brightness, middle.depth.data), 0.0);

    Flicker result{.deviation = Image(width, height, 1), .change = Image(width, height, 1), .mask = std::vector<float>(brightness.data.size()), .unlit = unlit_share(frames)};
    double pixels = 0.0, error_squares = 0.0, error_changes = 0.0;
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const std::size_t pixel = std::size_t{y} * width + x;
            if (middle.depth.data[pixel] <= 0.0f) continue;
            const Track track = follow(frames, seen_position(middle, {x, y}), vector_at(middle.normal, pixel));
            const std::size_t seen = track.seen();
            if (seen < 2 || 2 * seen < frames.size()) continue;
            const double mean = mean_of(track.values, [](double value) { return value; });
            const double variance = mean_of(track.values, [&](double value) { return (value - mean) * (value - mean); }) * static_cast<double>(seen) / static_cast<double>(seen - 1);
            const double unit = std::abs(mean) + dark;
            result.mask[pixel] = 1.0f;
            result.samples += seen;
            pixels += 1.0;
            if (unit <= 0.0) continue;  // a black picture stands still
            result.deviation.data[pixel] = static_cast<float>(std::sqrt(variance) / unit);
            result.change.data[pixel] = static_cast<float>(std::sqrt(mean_square_change(track.values)) / unit);
            // Errors of different frames are independent: their mean square is what they add to the variance.
            error_squares += mean_of(track.errors, [](double error) { return error * error; }) / (unit * unit);
            error_changes += mean_square_change(track.errors) / (unit * unit);
        }
    }
    if (pixels > 0.0) {
        result.deviation_of_error = std::sqrt(error_squares / pixels);
        result.change_of_error = std::sqrt(error_changes / pixels);
    }
    return result;
}

FlickerFigures flicker_figures(const Image& map, const std::vector<float>& mask) {
    std::vector<double> values;
    double squares = 0.0;
    for (std::size_t i = 0; i < map.data.size(); ++i) {
        if (!mask.empty() && mask[i] == 0.0f) continue;
        values.push_back(map.data[i]);
        squares += values.back() * values.back();
    }
    if (values.empty()) return {};
    std::ranges::sort(values);
    // Nearest rank: the smallest value that the share of the pixels does not exceed.
    const auto at = [&](std::size_t percent) { return values[(values.size() * percent + 99) / 100 - 1]; };
    return {.rms = std::sqrt(squares / static_cast<double>(values.size())), .median = at(50), .p99 = at(99), .pixels = values.size()};
}

double less_error(double rms, double rms_of_error) { return std::sqrt(std::max(rms * rms - rms_of_error * rms_of_error, 0.0)); }

}  // namespace sl
