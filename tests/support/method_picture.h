// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/render/reference/reference.h"
#include "engine/render/renderer.h"

namespace sl {

/// A way to indirect light under test: a GI method of the renderer, or the path tracer.
struct LightMethod {
    std::string name;
    std::optional<GiMethod> gi;  ///< none: the path tracer
    TransportSettings transport{.bounces = 1, .pixel_area = false};
    std::uint32_t samples = 16;  ///< of the path tracer, per pixel

    bool traced() const { return !gi.has_value(); }
    /// Its light has a noise of its own, and what earlier frames have left is used.
    bool facets() const { return gi && gi->is<Facets>(); }
};

/// What GoogleTest shows of a parameter.
inline void PrintTo(const LightMethod& method, std::ostream* out) { *out << method.name; }
inline const auto method_name_of = [](const testing::TestParamInfo<LightMethod>& info) { return info.param.name; };

/// All methods, small enough for many pictures a second. The disc reaches the whole map, so that it claims all light.
inline std::vector<LightMethod> small_methods(std::uint32_t rsm_size = 64) {
    return {{.name = "rsm_exact", .gi = RsmExact{.rsm_size = rsm_size}},
            {.name = "rsm_grid", .gi = RsmGrid{.rsm_size = rsm_size}},
            {.name = "rsm_disc", .gi = RsmDisc{.rsm_size = rsm_size, .samples = 1024, .radius = 1.5f, .low_resolution = 4}},
            {.name = "facets", .gi = Facets{}},
            {.name = "path_tracer"}};
}

/// Irradiance (lux, indirect) and radiance (nit) of each pixel, top row first.
struct Picture {
    std::uint32_t width = 0, height = 0;
    std::vector<vec3> irradiance, hdr;
    std::vector<char> surface;  ///< not background

    std::size_t size() const { return irradiance.size(); }
    glm::dvec3 mean() const {
        glm::dvec3 sum(0.0);
        double count = 0.0;
        for (std::size_t i = 0; i < size(); ++i) {
            if (surface[i] == 0) continue;
            sum += irradiance[i];
            count += 1.0;
        }
        return sum / std::max(count, 1.0);
    }
    double mean_brightness() const { return (mean().x + mean().y + mean().z) / 3.0; }
    /// The same picture seen in a mirror.
    Picture flipped() const {
        Picture result = *this;
        for (std::uint32_t y = 0; y < height; ++y) {
            const auto flip = [&](auto& row) { std::reverse(row.begin() + y * width, row.begin() + (y + 1) * width); };
            flip(result.irradiance);
            flip(result.hdr);
            flip(result.surface);
        }
        return result;
    }
};

/// `change` is applied to each colour, e.g. doubles it.
template <class Change>
Picture changed(Picture picture, Change&& change) {
    for (vec3& colour : picture.irradiance) colour = change(colour);
    for (vec3& colour : picture.hdr) colour = change(colour);
    return picture;
}

inline Picture traced_picture(const LightMethod& method, const RenderScene& scene, uvec2 size) {
    const auto layers = trace_film(scene, size, method.transport, method.samples).layers();
    const auto image = [&](std::string_view name) { return std::ranges::find(layers, name, &ImageLayer::name)->image; };
    const Image irradiance = image("irradiance"), radiance = image(""), depth = image("depth");
    Picture picture{.width = size.x, .height = size.y};
    for (std::size_t i = 0; i < depth.data.size(); ++i) {
        picture.irradiance.emplace_back(irradiance.data[3 * i], irradiance.data[3 * i + 1], irradiance.data[3 * i + 2]);
        picture.hdr.emplace_back(radiance.data[3 * i], radiance.data[3 * i + 1], radiance.data[3 * i + 2]);
        picture.surface.push_back(depth.data[i] > 0.0f ? 1 : 0);
    }
    return picture;
}

/// A frame of the scene as the method lights it; the scene's own GI settings are replaced.
inline Picture picture_of(const LightMethod& method, RenderScene& scene, Renderer& renderer, uvec2 size) {
    if (method.traced()) return traced_picture(method, scene, size);
    scene.gi = GiSettings{*method.gi};
    const auto result = renderer.render(scene, {.width = size.x, .height = size.y, .wanted = {"hdr", "depth"}, .want_irradiance = true});
    const Image irradiance = renderer.read(result.images.irradiance), hdr = renderer.read(result.images.hdr), depth = renderer.read(result.images.gbuffer.depth);
    Picture picture{.width = size.x, .height = size.y};
    for (std::uint32_t y = 0; y < size.y; ++y) {
        for (std::uint32_t x = 0; x < size.x; ++x) {
            // Without indirect light the image is one black pixel.
            const float* e = irradiance.pixel(std::min(x, irradiance.width - 1), std::min(y, irradiance.height - 1));
            const float* l = hdr.pixel(x, y);
            picture.irradiance.emplace_back(e[0], e[1], e[2]);
            picture.hdr.emplace_back(l[0], l[1], l[2]);
            picture.surface.push_back(*depth.pixel(x, y) > 0.0f ? 1 : 0);
        }
    }
    return picture;
}

/// How far two pictures' irradiance lies apart.
struct Deviation {
    double worst = 0.0;   ///< largest difference of one value, over that value or the second picture's mean if that is more
    double nrmse = 0.0;   ///< root mean square difference over the mean
    double inner = 0.0;   ///< the same without the worst 1 % of the pixels: those whose centre lies on an outline
    double mean = 0.0;    ///< first mean over second mean, less 1
    double outline = 0.0; ///< share of pixels that are a surface in one picture alone; they are left out above
};

inline Deviation deviation(const Picture& a, const Picture& b) {
    Deviation result;
    std::vector<double> squares;  // of the difference, per pixel
    glm::dvec3 sum_a(0.0), sum_b(0.0);
    const double typical = b.mean_brightness();
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a.surface[i] != b.surface[i]) result.outline += 1.0 / static_cast<double>(a.size());
        if (a.surface[i] == 0 || b.surface[i] == 0) continue;
        const glm::dvec3 difference = glm::dvec3(a.irradiance[i]) - glm::dvec3(b.irradiance[i]);
        for (int c = 0; c < 3; ++c) result.worst = std::max(result.worst, std::abs(difference[c]) / std::max({double{b.irradiance[i][c]}, typical, 1e-300}));
        squares.push_back(glm::dot(difference, difference) / 3.0);
        sum_a += a.irradiance[i];
        sum_b += b.irradiance[i];
    }
    const auto count = static_cast<double>(squares.size());
    const double total_a = sum_a.x + sum_a.y + sum_a.z, total = sum_b.x + sum_b.y + sum_b.z;
    if (total <= 0.0) {  // nothing to compare with: equal only if the other is dark as well
        result.worst = result.nrmse = result.inner = result.mean = total_a > 0.0 ? 1.0 : 0.0;
        return result;
    }
    std::ranges::sort(squares);
    const std::size_t kept = squares.size() - squares.size() / 100 - 1;
    double sum = 0.0;
    for (std::size_t i = 0; i < squares.size(); ++i) {
        sum += squares[i];
        if (i + 1 == kept) result.inner = std::sqrt(sum / count) / (total / 3.0 / count);
    }
    result.nrmse = std::sqrt(sum / count) / (total / 3.0 / count);
    result.mean = total_a / total - 1.0;
    return result;
}

inline bool same_bytes(const Picture& a, const Picture& b) { return a.irradiance == b.irradiance && a.hdr == b.hdr && a.surface == b.surface; }

/// What no pixel may be, for a message; empty when all is well.
inline std::string insane_pixel(const Picture& picture) {
    for (std::size_t i = 0; i < picture.size(); ++i) {
        for (const auto& [name, colour] : {std::pair("irradiance", picture.irradiance[i]), std::pair("hdr", picture.hdr[i])}) {
            for (int c = 0; c < 3; ++c) {
                if (std::isfinite(colour[c]) && colour[c] >= 0.0f) continue;
                return fmt::format("{} of pixel {},{} is {}", name, i % picture.width, i / picture.width, colour[c]);
            }
        }
    }
    return {};
}

}  // namespace sl
