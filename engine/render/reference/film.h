// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/image.h"
#include "engine/render/trace/path_tracer.h"

namespace sl {

/// A rectangle of pixels and a range of sample numbers: one piece of a reference's work.
struct FilmBlock {
    uvec2 low{0}, high{0};            ///< pixels, high exclusive
    std::uint32_t first = 0, last = 0;  ///< sample numbers, last exclusive

    bool operator==(const FilmBlock&) const = default;
    bool overlaps(const FilmBlock& other) const;
};

/// What all samples of one pixel add up to, in double precision. Every sum is over samples, so films add.
struct PixelSums {
    double samples = 0, surfaces = 0, odd_surfaces = 0;
    double squares = 0;  ///< of the irradiance's luminance
    glm::dvec3 direct{0}, indirect{0}, lights{0}, sky{0}, emission{0};
    glm::dvec3 odd{0};   ///< irradiance of the samples with odd numbers

    void add(const PathSample& sample, bool is_odd);
    void add(const PixelSums& other);
};
inline constexpr std::size_t pixel_sum_count = sizeof(PixelSums) / sizeof(double);

/// A reference picture while it grows.
class Film {
  public:
    explicit Film(uvec2 size);

    uvec2 size() const { return size_; }
    PixelSums& at(uvec2 pixel) { return sums_[std::size_t{pixel.y} * size_.x + pixel.x]; }
    const PixelSums& at(uvec2 pixel) const { return const_cast<Film*>(this)->at(pixel); }
    FirstSurface& first_surface(uvec2 pixel) { return first_[std::size_t{pixel.y} * size_.x + pixel.x]; }
    const FirstSurface& first_surface(uvec2 pixel) const { return const_cast<Film*>(this)->first_surface(pixel); }

    /// What was traced so far; blocks that continue each other are one.
    const std::vector<FilmBlock>& blocks() const { return blocks_; }
    /// Notes what has been traced, so that no sample is traced twice.
    void add_block(const FilmBlock& block);
    /// Adds another film's samples. Throws Error when sizes differ or the same samples are in both.
    void add(const Film& other);

    /// Estimated error of the mean irradiance: root mean square standard error of all pixels over their mean; infinite
    /// before two samples.
    double noise() const;
    /// Linear layers: "" (radiance), direct, indirect, irradiance with its parts by source, one half of it (so that the
    /// difference of the two halves tells the noise), its standard error, albedo, normal, position, depth, samples.
    std::vector<ImageLayer> layers() const;

  private:
    uvec2 size_;
    std::vector<PixelSums> sums_;
    std::vector<FirstSurface> first_;
    std::vector<FilmBlock> blocks_;
};

/// Noise of a finished reference from its two independent halves: root mean square of half their difference, over the
/// mean. Images are the layers "irradiance" and "irradiance_half".
double noise_of_halves(const Image& whole, const Image& half, const std::vector<float>& mask);

}  // namespace sl
