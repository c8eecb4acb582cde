// SPDX-License-Identifier: MIT
#include "editor/compare/compare_view.h"

#include <cmath>

#include "engine/measure/heat_map.h"
#include "engine/render/image_layers.h"

namespace sl {

namespace {

constexpr double seconds_between_figures = 1.0, seconds_per_blink = 0.7;
/// Noise of the reference's irradiance at which it is done: a twentieth tells methods apart, and a tenth of that takes days.
constexpr double truth_noise = 0.05;
/// Relative error that has the brightest colour of the error map.
constexpr float top_error = 1.0f;

Image coloured(const Image& error) {
    Image result(error.width, error.height, 3);
    for (std::size_t i = 0; i < error.data.size(); ++i) {
        const vec3 colour = heat_colour(std::min(error.data[i] / top_error, 1.0f));
        for (std::size_t c = 0; c < 3; ++c) result.data[3 * i + c] = colour[static_cast<int>(c)];
    }
    return result;
}

}  // namespace

void CompareView::prepare(RenderScene& scene, Renderer::Request& request) const {
    if (!on) return;
    if (scene.view && scene.view->auto_exposure && held_exposure_) {
        scene.view->auto_exposure = false;
        scene.view->held_exposure = held_exposure_;
    }
    request.want_irradiance = true;
}

void CompareView::update(const RenderScene& scene, const Renderer::Request& request, Renderer& renderer, const Renderer::Result& result, double seconds) {
    if (!on || !result.drawn) {
        reference_.reset();
        shown_reference_.reset();
        held_exposure_.reset();
        worker_.forget();
        left.rest();
        right.rest();
        return;
    }
    const uvec2 size(request.width, request.height);
    live_ = {renderer.executor().texture(renderer.graph(), result.images.final), size};
    blinked_ += seconds;
    since_measured_ += seconds;
    if (std::exchange(freeze_wanted_, false)) frozen_.upload(renderer.read(result.images.final));
    const float exposure = renderer.exposure();
    left.draw(scene, request, exposure);
    right.draw(scene, request, exposure);
    follow_reference(scene, size, seconds, exposure);
    measure(renderer, result, exposure);
}

void CompareView::follow_reference(const RenderScene& scene, uvec2 size, double seconds, float exposure) {
    // Through the middles of pixels, as the rasterizer's are: then the light can be compared pixel by pixel.
    if (reference_ == nullptr) reference_ = std::make_unique<LiveReference>(TransportSettings{.pixel_area = false}, truth_noise);
    reference_->follow(scene, size, seconds);
    const auto newest = reference_->picture();
    if (newest == shown_reference_) return;
    shown_reference_ = newest;
    if (newest != nullptr) {
        truth_.upload(shown(newest->layer(""), exposure));
        if (scene.view->auto_exposure) held_exposure_ = exposure;
    } else {
        held_exposure_.reset();
        truth_.clear();
        error_.clear();
        worker_.forget();
        measured_samples_ = error_of_ = 0;
    }
}

void CompareView::measure(Renderer& renderer, const Renderer::Result& result, float exposure) {
    const auto& figures = worker_.figures();
    if (figures && figures->samples != error_of_ && shown_reference_ != nullptr) {
        error_.upload(coloured(figures->error));
        error_of_ = figures->samples;
    }
    if (shown_reference_ == nullptr || worker_.busy() || since_measured_ < seconds_between_figures) return;
    since_measured_ = 0.0;
    const Image& truth = shown_reference_->layer("irradiance");
    worker_.begin({.reference = shown_reference_,
                   .irradiance = at_least(without_alpha(renderer.read(result.images.irradiance)), {truth.width, truth.height}),
                   .picture = without_alpha(renderer.read(result.images.final)),
                   .exposure = exposure});
}

ShownPicture CompareView::picture_of(CompareSide& side) {
    switch (side.source) {
        case CompareSource::live: return live_;
        case CompareSource::frozen: return frozen_.shown();
        case CompareSource::reference: return truth_.shown();
        case CompareSource::error: return error_.shown();
        case CompareSource::method: break;
    }
    return side.drawn();
}

std::vector<CompareView::Part> CompareView::parts() {
    const ShownPicture a = picture_of(left), b = picture_of(right);
    if (blink) return {{std::fmod(blinked_, 2.0 * seconds_per_blink) < seconds_per_blink ? a : b, 0.0f, 1.0f}};
    return {{a, 0.0f, split}, {b, split, 1.0f}};
}

std::string CompareView::problem() const {
    if (reference_ != nullptr && !reference_->problem().empty()) return reference_->problem();
    return worker_.problem();
}

}  // namespace sl
