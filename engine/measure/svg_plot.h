// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace sl {

/// One mark of a plot.
struct PlotPoint {
    double x = 0.0, y = 0.0;
    std::string label;      ///< shown when the pointer rests on it
    bool frontier = false;  ///< marked, and joined with the others that are
};

/// Points of one name and colour, joined in their order.
struct PlotSeries {
    std::string name;
    std::vector<PlotPoint> points;
};

/// A scatter plot with logarithmic axes as an SVG element, for a page; points that are not positive are left out.
std::string svg_plot(const std::string& title, const std::string& x_label, const std::string& y_label, const std::vector<PlotSeries>& series);

/// Text with the characters that HTML reads as its own escaped.
std::string html_text(const std::string& text);

}  // namespace sl
