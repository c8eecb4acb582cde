// SPDX-License-Identifier: MIT
#pragma once

#include "editor/uploaded_picture.h"
#include "engine/render/renderer.h"

namespace sl {

/// An image that a frame makes.
struct ListedImage {
    std::string name;
    uvec2 size{0};
    std::uint32_t layers = 0;  ///< 0: it is no array
};

/// Of a frame's graph, by name; with the normals of reflective shadow maps.
std::vector<ListedImage> listed_images(const FrameGraph& graph);

/// Any image of the frame over the whole picture, read back and coloured a few times a second.
class ShownImage {
  public:
    std::string name;  ///< empty: the picture itself
    std::uint32_t layer = 0;
    float stops = 0.0f;  ///< how much brighter than a capture shows it

    /// Before the frame is drawn: it must keep the image.
    void prepare(Renderer::Request& request) const;
    /// After it was drawn.
    void update(const Renderer& renderer, double seconds);
    /// Over the picture and behind all widgets, in the proportions of the image. Nothing where there is no image.
    void draw(float scale) const;

    /// Those of the last frame; the chosen one may not be among them.
    const std::vector<ListedImage>& listed() const { return listed_; }
    /// The chosen one as the last frame has it; null where it has none.
    const ListedImage* chosen() const;
    /// What black and white stand for; empty while nothing is shown.
    const std::string& range() const { return range_; }
    /// Whether `stops` means anything for what is shown.
    bool has_exposure() const { return has_exposure_; }

  private:
    /// The image of the graph that holds the chosen one.
    std::string holder() const;
    void read(const Renderer& renderer, ImageId image);
    void clear();

    /// What the uploaded picture was made from.
    struct Source {
        std::string name;
        std::uint32_t layer = 0;
        float stops = 0.0f;

        bool operator==(const Source&) const = default;
    };

    std::vector<ListedImage> listed_;
    UploadedPicture picture_;
    std::string range_;
    bool has_exposure_ = false;
    Source source_;
    double until_read_ = 0.0;  ///< s
};

}  // namespace sl
