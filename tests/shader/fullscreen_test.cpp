// SPDX-License-Identifier: MIT
// lib/fullscreen.vert: one triangle that covers each pixel once.
#include "tests/shader/library_fixture.h"

namespace sl {
namespace {

TEST_F(LibraryTest, FullscreenTriangleCoversEachPixelOnceAndKnowsWhereItIs) {
    write("where.frag", "in vec2 ndc;\nout vec4 colour;\nvoid main() { colour = vec4(ndc, 0.0, 1.0); }\n");
    for (const auto& [width, height] : {std::pair{1u, 1u}, std::pair{7u, 5u}, std::pair{320u, 3u}}) {
        const auto pixels = draw("lib/fullscreen.vert", "where.frag", width, height, [](const gl::Program&) {
            glEnable(GL_BLEND);  // adding up shows a pixel that is drawn twice
            glBlendFunc(GL_ONE, GL_ONE);
            glDrawArrays(GL_TRIANGLES, 0, 3);
            glDisable(GL_BLEND);
        });
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const vec2 centre = (vec2(static_cast<float>(i % width), static_cast<float>(i / width)) + 0.5f) / vec2(static_cast<float>(width), static_cast<float>(height));
            // Rasterizers interpolate with a few bits less than a float has.
            expect_close(pixels[i], vec4(centre * 2.0f - 1.0f, 0.0f, 1.0f), 1e-5f, i);
        }
    }
}

}  // namespace
}  // namespace sl
