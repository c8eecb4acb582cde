// SPDX-License-Identifier: MIT
#include "engine/render/reference/film.h"

#include <algorithm>
#include <cmath>

#include "engine/core/error.h"

namespace sl {

namespace {

using glm::dvec3;

double luminance(dvec3 colour) { return glm::dot(colour, dvec3(0.2126, 0.7152, 0.0722)); }

dvec3 irradiance_sum(const PixelSums& sums) { return sums.lights + sums.sky + sums.emission; }

dvec3 mean(dvec3 sum, double count) { return count > 0.0 ? sum / count : dvec3(0.0); }

/// Standard error of the mean irradiance's luminance.
double standard_error(const PixelSums& sums) {
    if (sums.surfaces < 2.0) return 0.0;
    const double average = luminance(irradiance_sum(sums)) / sums.surfaces;
    const double variance = sums.squares / sums.surfaces - average * average;
    if (variance < 1e-10 * average * average) return 0.0;  // what rounding leaves of equal samples
    return std::sqrt(variance / (sums.surfaces - 1.0));
}

}  // namespace

bool FilmBlock::overlaps(const FilmBlock& other) const {
    return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y && other.low.y < high.y && first < other.last && other.first < last;
}

void PixelSums::add(const PathSample& sample, bool is_odd) {
    samples += 1.0;
    direct += sample.direct;
    indirect += sample.indirect;
    if (!sample.surface) return;
    surfaces += 1.0;
    lights += sample.irradiance_lights;
    sky += sample.irradiance_sky;
    emission += sample.irradiance_emission;
    const dvec3 irradiance = sample.irradiance();
    squares += luminance(irradiance) * luminance(irradiance);
    if (!is_odd) return;
    odd_surfaces += 1.0;
    odd += irradiance;
}

void PixelSums::add(const PixelSums& other) {
    auto* values = reinterpret_cast<double*>(this);
    const auto* added = reinterpret_cast<const double*>(&other);
    for (std::size_t i = 0; i < pixel_sum_count; ++i) values[i] += added[i];
}

Film::Film(uvec2 size) : size_(size), sums_(std::size_t{size.x} * size.y), first_(sums_.size()) {}

void Film::add_block(const FilmBlock& block) {
    for (FilmBlock& known : blocks_) {
        if (known.low != block.low || known.high != block.high) continue;
        if (known.last == block.first || block.last == known.first) {
            known.first = std::min(known.first, block.first);
            known.last = std::max(known.last, block.last);
            return;
        }
    }
    blocks_.push_back(block);
}

void Film::add(const Film& other) {
    if (size_ != other.size_) fail("references of {}x{} and {}x{} pixels cannot be merged", size_.x, size_.y, other.size_.x, other.size_.y);
    for (const FilmBlock& mine : blocks_) {
        for (const FilmBlock& theirs : other.blocks_) {
            if (!mine.overlaps(theirs)) continue;
            fail("both references hold samples {} to {} of pixel {},{}; merging would count them twice", std::max(mine.first, theirs.first),
                 std::min(mine.last, theirs.last) - 1, std::max(mine.low.x, theirs.low.x), std::max(mine.low.y, theirs.low.y));
        }
    }
    for (std::size_t i = 0; i < sums_.size(); ++i) {
        // A piece of a picture knows the first surfaces of its own pixels only.
        if (sums_[i].samples == 0.0) first_[i] = other.first_[i];
        sums_[i].add(other.sums_[i]);
    }
    for (const FilmBlock& block : other.blocks_) add_block(block);
}

double Film::noise() const {
    double squares = 0.0, sum = 0.0, count = 0.0, fewest = std::numeric_limits<double>::infinity();
    for (const PixelSums& pixel : sums_) {
        if (pixel.samples > 0.0) fewest = std::min(fewest, pixel.samples);
        if (pixel.surfaces < 2.0) continue;  // at an outline one sample may have met a surface, and tells no spread
        const double error = standard_error(pixel);
        squares += error * error;
        sum += luminance(irradiance_sum(pixel)) / pixel.surfaces;
        count += 1.0;
    }
    if (!std::isfinite(fewest) || fewest < 2.0) return std::numeric_limits<double>::infinity();
    return sum > 0.0 ? std::sqrt(squares / count) / (sum / count) : 0.0;
}

std::vector<ImageLayer> Film::layers() const {
    std::vector<ImageLayer> result;
    const auto layer = [&](const char* name, std::uint32_t channels, auto&& value) {
        Image image(size_.x, size_.y, channels);
        for (std::size_t i = 0; i < sums_.size(); ++i) {
            const dvec3 colour(value(sums_[i], first_[i]));
            for (std::uint32_t c = 0; c < channels; ++c) image.data[i * channels + c] = static_cast<float>(colour[static_cast<int>(c)]);
        }
        result.push_back({name, std::move(image)});
    };
    using P = PixelSums;
    using F = FirstSurface;
    layer("", 3, [](const P& p, const F&) { return mean(p.direct + p.indirect, p.samples); });
    layer("direct", 3, [](const P& p, const F&) { return mean(p.direct, p.samples); });
    layer("indirect", 3, [](const P& p, const F&) { return mean(p.indirect, p.samples); });
    layer("irradiance", 3, [](const P& p, const F&) { return mean(irradiance_sum(p), p.surfaces); });
    layer("irradiance_lights", 3, [](const P& p, const F&) { return mean(p.lights, p.surfaces); });
    layer("irradiance_sky", 3, [](const P& p, const F&) { return mean(p.sky, p.surfaces); });
    layer("irradiance_emission", 3, [](const P& p, const F&) { return mean(p.emission, p.surfaces); });
    layer("irradiance_half", 3, [](const P& p, const F&) { return mean(p.odd, p.odd_surfaces); });
    layer("irradiance_error", 1, [](const P& p, const F&) { return dvec3(standard_error(p)); });
    layer("albedo", 3, [](const P&, const F& f) { return dvec3(f.albedo); });
    layer("normal", 3, [](const P&, const F& f) { return dvec3(f.normal); });
    layer("position", 3, [](const P&, const F& f) { return dvec3(f.position); });
    layer("depth", 1, [](const P&, const F& f) { return dvec3(f.depth); });
    layer("samples", 1, [](const P& p, const F&) { return dvec3(p.samples); });
    return result;
}

double noise_of_halves(const Image& whole, const Image& half, const std::vector<float>& mask) {
    double squares = 0.0, sum = 0.0, count = 0.0;
    for (std::size_t i = 0; i < std::size_t{whole.width} * whole.height; ++i) {
        if (!mask.empty() && mask[i] == 0.0f) continue;
        for (std::size_t c = 0; c < 3; ++c) {
            // The halves a, b with mean m = (a + b) / 2: the mean's error is estimated by (a - b) / 2 = a - m.
            const double difference = double{half.data[i * half.channels + c]} - whole.data[i * whole.channels + c];
            squares += difference * difference;
            sum += whole.data[i * whole.channels + c];
            count += 1.0;
        }
    }
    return sum > 0.0 ? std::sqrt(squares / count) / (sum / count) : 0.0;
}

}  // namespace sl
