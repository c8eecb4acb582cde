// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "editor/uploaded_picture.h"
#include "engine/render/renderer.h"

namespace sl {

/// What one side of a comparison shows. Methods follow: `method` + n is the n-th of gi_method_names().
enum class CompareSource : std::size_t { live, frozen, reference, error, method };

std::string compare_source_name(CompareSource source);
std::size_t compare_source_count();

/// One side's source, and the renderer that draws another method than the live one for it.
class CompareSide {
  public:
    CompareSource source = CompareSource::live;

    /// Draws the same scene by this side's method, if it has one of its own; `exposure` multiplies nit.
    void draw(RenderScene scene, const Renderer::Request& request, float exposure);
    ShownPicture drawn();
    /// Lets go of what drawing needs.
    void rest();

  private:
    std::unique_ptr<Renderer> renderer_;  ///< while the source is a method
    Renderer::Result result_;
    uvec2 size_{0};
};

}  // namespace sl
