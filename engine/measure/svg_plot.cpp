// SPDX-License-Identifier: MIT
#include "engine/measure/svg_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sl {

namespace {

constexpr double width = 620, height = 360, left = 64, right = 170, top = 34, bottom = 46;
// Okabe & Ito's colours: told apart by every kind of colour vision.
constexpr std::array colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#999999"};

bool plottable(const PlotPoint& p) { return std::isfinite(p.x) && std::isfinite(p.y) && p.x > 0.0 && p.y > 0.0; }

/// One logarithmic axis, with whole decades at its ends where the values span more than one.
struct Axis {
    double low = 1.0, high = 10.0, from = 0.0, to = 1.0;

    Axis(std::vector<double> values, double from_, double to_) : from(from_), to(to_) {
        if (values.empty()) return;
        const auto [least, most] = std::ranges::minmax(values);
        low = std::pow(10.0, std::floor(std::log10(least * 0.95)));
        high = std::pow(10.0, std::ceil(std::log10(most * 1.05)));
    }
    double at(double value) const { return from + (to - from) * std::log(value / low) / std::log(high / low); }
    template <class Visit>
    void ticks(Visit&& visit) const {
        for (double decade = low; decade <= high * 1.001; decade *= 10.0) {
            visit(decade, true);
            for (int i = 2; i < 10 && decade < high * 0.999; ++i) visit(decade * i, false);
        }
    }
};

}  // namespace

std::string html_text(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '&') result += "&amp;";
        else if (c == '<') result += "&lt;";
        else if (c == '>') result += "&gt;";
        else if (c == '"') result += "&quot;";
        else result += c;
    }
    return result;
}

std::string svg_plot(const std::string& title, const std::string& x_label, const std::string& y_label, const std::vector<PlotSeries>& series) {
    std::vector<double> xs, ys;
    for (const PlotSeries& one : series) {
        for (const PlotPoint& p : one.points) {
            if (!plottable(p)) continue;
            xs.push_back(p.x);
            ys.push_back(p.y);
        }
    }
    const Axis x(xs, left, width - right), y(ys, height - bottom, top);
    std::string svg = fmt::format("<svg viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" role=\"img\">\n<text x=\"{2}\" y=\"18\" class=\"title\">{3}</text>\n", width, height, left, html_text(title));
    x.ticks([&](double value, bool decade) {
        svg += fmt::format("<line class=\"{}\" x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{}\" y2=\"{}\"/>", decade ? "decade" : "tick", x.at(value), x.at(value), top, height - bottom);
        if (decade) svg += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{:g}</text>\n", x.at(value), height - bottom + 16, value);
    });
    y.ticks([&](double value, bool decade) {
        svg += fmt::format("<line class=\"{}\" x1=\"{}\" x2=\"{}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>", decade ? "decade" : "tick", left, width - right, y.at(value), y.at(value));
        if (decade) svg += fmt::format("<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{:g}</text>\n", left - 6, y.at(value) + 4, value);
    });
    svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", (left + width - right) / 2, height - 10, html_text(x_label));
    svg += fmt::format("<text transform=\"translate(16 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n", (top + height - bottom) / 2, html_text(y_label));
    std::vector<PlotPoint> best;
    for (std::size_t i = 0; i < series.size(); ++i) {
        const char* colour = colours[i % colours.size()];
        std::string line;
        for (const PlotPoint& p : series[i].points) {
            if (!plottable(p)) continue;
            line += fmt::format("{:.1f},{:.1f} ", x.at(p.x), y.at(p.y));
            svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"{}\"><title>{}</title></circle>\n", x.at(p.x), y.at(p.y), colour, html_text(p.label));
            if (p.frontier) best.push_back(p);
        }
        svg += fmt::format("<polyline points=\"{}\" stroke=\"{}\" class=\"curve\"/>\n", line, colour);
        const double row = top + 14 + 18 * static_cast<double>(i);
        svg += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"4\" fill=\"{}\"/><text x=\"{}\" y=\"{}\">{}</text>\n", width - right + 16, row - 4, colour, width - right + 26, row, html_text(series[i].name));
    }
    std::ranges::sort(best, {}, &PlotPoint::x);
    std::string line;
    for (const PlotPoint& p : best) {
        line += fmt::format("{:.1f},{:.1f} ", x.at(p.x), y.at(p.y));
        svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"8\" class=\"ring\"/>\n", x.at(p.x), y.at(p.y));
    }
    svg += fmt::format("<polyline points=\"{}\" class=\"frontier\"/>\n", line);
    const double row = top + 20 + 18 * static_cast<double>(series.size());
    svg += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"6\" class=\"ring\"/><text x=\"{}\" y=\"{}\">frontier</text>\n</svg>\n", width - right + 16, row - 4, width - right + 26, row);
    return svg;
}

}  // namespace sl
