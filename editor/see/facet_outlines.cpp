// SPDX-License-Identifier: MIT
#include "editor/see/facet_outlines.h"

#include <algorithm>

#include "editor/see/probed_point.h"
#include "engine/measure/heat_map.h"

namespace sl {

namespace {

constexpr double seconds_between = 0.25;
/// A list of widgets counts its corners with 16 bits, and each line has some.
constexpr std::size_t most_outlines = 2500;
/// The share of outlines whose values colours tell apart; one outlier would make all others dark.
constexpr double share_below_top = 0.95;
constexpr float line_width = 1.2f;

float value_of(const FacetOutline& outline, FacetOutlines::Colour colour) {
    return colour == FacetOutlines::Colour::noise ? outline.noise : luminance(outline.irradiance);
}

}  // namespace

void FacetOutlines::prepare(Renderer::Request& request) const {
    if (on) request.wanted_if_there.emplace_back("depth");
}

void FacetOutlines::update(const SeenFrame& frame) {
    const bool facets = frame.scene.gi && frame.scene.gi->method.is<Facets>();
    if (!on || !facets || !frame.renderer.readable(frame.result.images.gbuffer.depth)) return outlines_.clear();
    until_read_ -= frame.seconds;
    if (until_read_ <= 0.0 || shown_ != colour) read(frame);
}

void FacetOutlines::read(const SeenFrame& frame) {
    until_read_ = seconds_between;
    shown_ = colour;
    outlines_.clear();
    const Image depth = frame.renderer.read(frame.result.images.gbuffer.depth);
    const FrameParams params = frame.params();
    const auto is_seen = [&](const FacetOutline& outline) {
        const dvec3 middle = 0.25 * dvec3(outline.corners[0] + outline.corners[1] + outline.corners[2] + outline.corners[3]);
        const auto place = seen_at(params, dvec3(0.0), middle);
        return place && is_visible(params, *place, *depth.pixel(place->pixel.x, place->pixel.y));
    };
    // Some of those near the camera lie behind it or behind walls.
    std::vector<FacetOutline> seen = frame.renderer.facets().outlines_near(frame.scene.view->place(), 4 * most_outlines);
    std::erase_if(seen, [&](const FacetOutline& outline) { return !is_seen(outline); });
    seen.resize(std::min(seen.size(), most_outlines));
    if (seen.empty()) return;
    std::vector<float> values(seen.size());
    std::ranges::transform(seen, values.begin(), [&](const FacetOutline& outline) { return value_of(outline, colour); });
    const auto at_top = values.begin() + static_cast<std::ptrdiff_t>(share_below_top * static_cast<double>(values.size() - 1));
    std::ranges::nth_element(values, at_top);
    top_ = *at_top;
    for (const FacetOutline& outline : seen) {
        std::array<dvec3, 4> corners;
        std::ranges::transform(outline.corners, corners.begin(), [&](vec3 corner) { return frame.scene.origin + dvec3(corner); });
        outlines_.push_back({corners, top_ > 0.0f ? std::min(value_of(outline, colour) / top_, 1.0f) : 0.0f});
    }
}

void FacetOutlines::draw(const Projection& project, float scale) const {
    for (const Outline& outline : outlines_) {
        // The darkest colours would be lost on a dark picture.
        const vec3 tint = heat_colour(0.25f + 0.75f * outline.value);
        const ImU32 lines = ImGui::ColorConvertFloat4ToU32(ImVec4(tint.x, tint.y, tint.z, 1.0f));
        for (std::size_t i = 0; i < 4; ++i) project.line(outline.corners[i], outline.corners[(i + 1) % 4], lines, line_width * scale);
    }
}

}  // namespace sl
