// SPDX-License-Identifier: MIT
#pragma once

#include "editor/compare/compare_figures.h"
#include "editor/compare/compare_side.h"

namespace sl {

/// Two pictures of one view, left and right of a bar that can be dragged: the live one, a frozen one, any other method's,
/// and the path-traced truth, which grows in the background; and how far the live one is from that.
class CompareView {
  public:
    bool on = false;
    bool blink = false;   ///< both whole, in turns
    float split = 0.5f;   ///< of the width
    CompareSide left, right;

    CompareView() { right.source = CompareSource::reference; }

    /// Before the live picture is drawn: what it must keep for comparing. Both sides have its exposure; where it adapts, that is held
    /// from the reference's first picture on, so that another light is not made up for.
    void prepare(RenderScene& scene, Renderer::Request& request) const;
    /// After it was drawn.
    void update(const RenderScene& scene, const Renderer::Request& request, Renderer& renderer, const Renderer::Result& result, double seconds);
    /// The live picture as it is now is what "frozen" shows from the next frame on.
    void freeze() { freeze_wanted_ = true; }

    /// A picture and the part of the window's width that it fills.
    struct Part {
        ShownPicture picture;
        float from = 0.0f, to = 1.0f;
    };
    std::vector<Part> parts();

    const LiveReference* reference() const { return reference_.get(); }
    const std::optional<CompareFigures>& figures() { return worker_.figures(); }
    std::string problem() const;

  private:
    bool shows(CompareSource source) const { return left.source == source || right.source == source; }
    void follow_reference(const RenderScene& scene, uvec2 size, double seconds, float exposure);
    void measure(Renderer& renderer, const Renderer::Result& result, float exposure);
    ShownPicture picture_of(CompareSide& side);

    std::unique_ptr<LiveReference> reference_;  ///< while comparing
    std::shared_ptr<const LiveReference::Picture> shown_reference_;
    std::optional<float> held_exposure_;
    CompareWorker worker_;
    std::uint32_t measured_samples_ = 0;
    double since_measured_ = 0.0, blinked_ = 0.0;  ///< s
    UploadedPicture frozen_, truth_, error_;
    std::uint32_t error_of_ = 0;  ///< samples of the figures that the error map shows
    ShownPicture live_;
    bool freeze_wanted_ = false;
};

/// The tab "Compare" of the panel. Inside a window.
void compare_tab(CompareView& view);
/// The bar between both sides, with what they are: over the picture, where the mouse can take it.
void draw_compare_bar(CompareView& view, float scale);

}  // namespace sl
