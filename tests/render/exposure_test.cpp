// SPDX-License-Identifier: MIT
#include <glm/gtc/matrix_transform.hpp>

#include "engine/render/passes/exposure.h"
#include "shared/tonemap.h"
#include "tests/support/gl_test.h"
#include "tests/support/scene_builder.h"

namespace sl {
namespace {

/// A glowing wall that fills the view.
class AutoExposure : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        builder.look(vec3(0), vec3(0, 0, -1), vec3(0, 1, 0), 0.5f);
        builder.scene().view->auto_exposure = true;
        builder.scene().view->ev100 = 8.0f;
        Material glowing = SceneBuilder::matte(vec3(0));
        glowing.emission = 1.0f;
        builder.add(make_shape_mesh({Shape::Kind::box, vec3(4, 4, 1)}), glm::translate(mat4(1.0f), vec3(0, 0, -2)), glowing);
    }
    float shown(float nit, float seconds = 1.0f / 60.0f) {
        builder.scene().materials[0].material.emission = nit;
        builder.scene().materials_hash = hash_bytes(1, &nit, sizeof nit);
        const auto result = renderer.render(builder.scene(), {.width = 33, .height = 21, .seconds = seconds});
        return *renderer.read(result.images.final).pixel(16, 10);
    }

    SceneBuilder builder;
    Renderer renderer{shader_folder()};
};

TEST_F(AutoExposure, ShowsTheFirstPictureAtOnce) {
    const float dim = shown(1.0f);
    renderer.forget();
    const float bright = shown(1e4f);
    EXPECT_GT(dim, 0.1f);
    EXPECT_LT(bright, 0.9f);
    EXPECT_LT(dim, bright) << "the dark is seen to be dark";
}

TEST_F(AutoExposure, IsToldOfAPictureThatIsThere) {
    for (const float nit : {0.5f, 30.0f, 2e4f}) {
        renderer.forget();
        Image radiance(33, 21, 3);
        std::ranges::fill(radiance.data, nit);
        EXPECT_NEAR(shown(nit), display_from_radiance(vec3(nit), exposure_for(*builder.scene().view, radiance)).x, 0.005f) << nit;
    }
    builder.scene().view->auto_exposure = false;
    EXPECT_EQ(exposure_for(*builder.scene().view, Image(1, 1, 3)), builder.scene().view->exposure());
}

TEST_F(AutoExposure, TheRendererTellsWhatThePictureHas) {
    const RenderScene::View& view = *builder.scene().view;
    Image radiance(33, 21, 3);
    for (const float nit : {0.5f, 2e4f}) {
        renderer.forget();
        std::ranges::fill(radiance.data, nit);
        shown(nit);
        const float wanted = exposure_for(view, radiance);
        EXPECT_NEAR(renderer.exposure(), wanted, 0.01f * wanted) << nit;
    }
    renderer.forget();
    EXPECT_EQ(shown(0.0f, std::numeric_limits<float>::infinity()), 0.0f);
    EXPECT_FLOAT_EQ(renderer.exposure(), view.exposure()) << "there is nothing to adapt to";
    builder.scene().view->auto_exposure = false;
    shown(2e4f);
    EXPECT_EQ(renderer.exposure(), view.exposure());
    builder.scene().view->held_exposure = 1e-3f;
    EXPECT_NEAR(shown(100.0f), display_from_radiance(vec3(100.0f), 1e-3f).x, 0.005f);
    EXPECT_EQ(renderer.exposure(), 1e-3f);
}

TEST_F(AutoExposure, TakesItsTimeWhateverTheFrameRate) {
    const float before = shown(100.0f);
    const float dazzled = shown(3000.0f);
    EXPECT_GT(dazzled, before + 0.2f);
    for (int frame = 0; frame < 60; ++frame) shown(3000.0f);
    const float after_a_second = shown(3000.0f);
    EXPECT_LT(after_a_second, dazzled);
    renderer.forget();
    shown(100.0f);
    shown(3000.0f);
    for (int frame = 0; frame < 6; ++frame) shown(3000.0f, 0.1f);
    for (int frame = 0; frame < 24; ++frame) shown(3000.0f);
    EXPECT_NEAR(shown(3000.0f), after_a_second, 0.02f);
}

TEST_F(AutoExposure, IsOffUnlessAsked) {
    builder.scene().view->auto_exposure = false;
    EXPECT_LT(shown(1.0f), 0.02f);
    EXPECT_GT(shown(1e4f), 0.98f);
}

TEST_F(AutoExposure, OutlivesDarknessAndWhatIsNoNumber) {
    const float before = shown(100.0f);
    EXPECT_EQ(shown(0.0f), 0.0f);
    shown(1e30f);
    for (int frame = 0; frame < 300; ++frame) shown(100.0f);
    EXPECT_NEAR(shown(100.0f), before, 0.01f);
}

}  // namespace
}  // namespace sl
