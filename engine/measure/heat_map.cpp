// SPDX-License-Identifier: MIT
#include "engine/measure/heat_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/check.h"
#include "engine/measure/pixel_text.h"

namespace sl {

namespace {

/// Colours of the ramp (8 bits, sRGB), each at the place that its own lightness L* has between the first and the last:
/// that is what makes lightness rise evenly.
struct Stop {
    float at;
    vec3 colour;
};
constexpr std::array stops{Stop{0.0f, {4, 4, 18}},        Stop{0.1204f, {40, 16, 92}},    Stop{0.2507f, {98, 22, 128}},
                           Stop{0.3715f, {158, 38, 118}}, Stop{0.4975f, {212, 66, 82}},   Stop{0.6209f, {242, 112, 40}},
                           Stop{0.7554f, {252, 168, 36}}, Stop{0.8926f, {250, 222, 110}}, Stop{1.0f, {255, 255, 224}}};

constexpr vec3 ignored_colour(0.42f);
constexpr vec3 paper(0.09f);
constexpr vec3 ink(0.93f);
constexpr std::uint32_t quarters = 4;
constexpr const char* ignored_label = "not compared";

bool compared(const std::vector<float>& mask, std::size_t i) {
    return mask.empty() || mask[i] != 0.0f;
}

void fill(Image& picture, uvec2 corner, uvec2 size, vec3 colour) {
    for (std::uint32_t y = corner.y; y < std::min(corner.y + size.y, picture.height); ++y) {
        for (std::uint32_t x = corner.x; x < std::min(corner.x + size.x, picture.width); ++x) {
            for (int c = 0; c < 3; ++c) picture.pixel(x, y)[c] = colour[c];
        }
    }
}

/// Sizes of the legend in pixels. Everything is a multiple of `scale`, one dot of the font.
struct Legend {
    std::uint32_t scale, margin, bar_height, height;

    explicit Legend(std::uint32_t width)
        : scale(std::clamp(width / 320u, 1u, 8u)),
          margin(6 * scale),
          bar_height(10 * scale),
          height(margin + text_height * scale + 4 * scale + bar_height + 5 * scale + text_height * scale + margin) {}

    std::uint32_t bar_y() const { return margin + (text_height + 4) * scale; }
    /// The first and last label are centred on the bar's ends, so it begins half a label in from the edge.
    std::uint32_t bar_x() const { return margin + 15 * scale; }
};

std::string tick_label(double value, const HeatMapSettings& settings, bool beyond) {
    const std::string number = settings.percent ? fmt::format("{:.4g}%", 100.0 * value) : fmt::format("{:.4g}", value);
    return number + (beyond ? "+" : "");
}

/// Rows from `top` down: title and grey swatch, bar, ticks, labels.
void draw_legend(Image& picture, std::uint32_t top, const HeatMapSettings& settings, bool some_ignored,
                 bool some_beyond) {
    const Legend legend(picture.width);
    const std::uint32_t scale = legend.scale;
    fill(picture, {0, top}, {picture.width, legend.height}, paper);
    draw_text(picture, legend.margin, top + legend.margin, scale, ink, settings.title);
    if (some_ignored) {
        const std::uint32_t x = picture.width - legend.margin - text_width(ignored_label) * scale;
        draw_text(picture, x, top + legend.margin, scale, ink, ignored_label);
        fill(picture, {x - 11 * scale, top + legend.margin}, {8 * scale, text_height * scale}, ignored_colour);
    }
    const std::uint32_t left = legend.bar_x(), width = picture.width - 2 * left, bar = top + legend.bar_y();
    fill(picture, {left - 1, bar - 1}, {width + 2, legend.bar_height + 2}, ink);
    for (std::uint32_t x = 0; x < width; ++x) {
        fill(picture, {left + x, bar}, {1, legend.bar_height},
             heat_colour((static_cast<float>(x) + 0.5f) / static_cast<float>(width)));
    }
    for (std::uint32_t i = 0; i <= quarters; ++i) {
        const std::uint32_t x = left + (width - 1) * i / quarters;
        fill(picture, {x, bar + legend.bar_height}, {scale, 3 * scale}, ink);
        const std::string label = tick_label(settings.top * i / quarters, settings, some_beyond && i == quarters);
        const auto half = static_cast<std::int64_t>(text_width(label) * scale / 2);
        const std::int64_t last = std::int64_t{picture.width} - 2 * half - scale;
        draw_text(picture, std::clamp<std::int64_t>(x - half, scale, last), bar + legend.bar_height + 5 * scale, scale,
                  ink, label);
    }
}

}  // namespace

vec3 heat_colour(float value) {
    const float t = std::clamp(value, 0.0f, 1.0f);
    std::size_t next = 1;
    while (next + 1 < stops.size() && t > stops[next].at) ++next;
    const Stop &a = stops[next - 1], &b = stops[next];
    return glm::mix(a.colour, b.colour, (t - a.at) / (b.at - a.at)) / 255.0f;
}

Image heat_map(const Image& map, const std::vector<float>& mask, const HeatMapSettings& settings) {
    const std::size_t pixels = std::size_t{map.width} * map.height;
    CHECK(map.channels == 1 && pixels > 0 && (mask.empty() || mask.size() == pixels),
          "{} channels, {} mask values for {} pixels", map.channels, mask.size(), pixels);
    CHECK(settings.top > 0.0, "a scale that ends at {}", settings.top);
    const std::uint32_t width = std::max(map.width, text_width(settings.title) + text_width(ignored_label) + 40);
    Image picture(width, map.height + Legend(width).height, 3);
    fill(picture, {0, 0}, {picture.width, picture.height}, paper);
    bool some_ignored = false, some_beyond = false;
    for (std::size_t i = 0; i < pixels; ++i) {
        const double value = double{map.data[i]} / settings.top;
        const bool shown = compared(mask, i);
        some_ignored = some_ignored || !shown;
        some_beyond = some_beyond || (shown && value > 1.0);
        const vec3 colour = shown ? heat_colour(static_cast<float>(std::min(value, 1.0))) : ignored_colour;
        float* pixel =
            picture.pixel(static_cast<std::uint32_t>(i % map.width), static_cast<std::uint32_t>(i / map.width));
        for (int c = 0; c < 3; ++c) pixel[c] = colour[c];
    }
    draw_legend(picture, map.height, settings, some_ignored, some_beyond);
    return picture;
}

double suggested_top(const Image& map, const std::vector<float>& mask) {
    CHECK(map.channels == 1, "{} channels", map.channels);
    std::vector<float> values;
    for (std::size_t i = 0; i < map.data.size(); ++i) {
        if (compared(mask, i)) values.push_back(map.data[i]);
    }
    if (values.empty()) return 1.0;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) * 95 / 100);
    std::nth_element(values.begin(), at, values.end());
    const double high = double{*at};
    if (!std::isfinite(high) || high <= 0.0) return 1.0;
    const double power = std::pow(10.0, std::floor(std::log10(high)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (high <= step * power) return step * power;
    }
    return 10.0 * power;
}

}  // namespace sl
