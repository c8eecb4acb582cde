// SPDX-License-Identifier: MIT
#include "editor/see/see_view.h"

#include <gmock/gmock.h>

#include "tests/support/gl_test.h"
#include "tests/support/scene_builder.h"

namespace sl {
namespace {

using testing::HasSubstr;

/// A floor of albedo 0.5 seen from 2 m above, under a point light of 450 cd, 3 m above it, and a spot that bounces.
class SeeViewTest : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        builder.add({Shape::Kind::box, vec3(8, 1, 8)}, glm::translate(mat4(1.0f), vec3(0, -0.5f, 0)), vec3(0.5f));
        builder.add({.kind = RenderScene::Light::Kind::point, .position = vec3(0, 3, 0), .intensity = vec3(450.0f), .casts_shadow = true});
        builder.look(vec3(0, 2, 0), vec3(0, -1, 0), vec3(0, 0, -1), 1.0f);
        builder.scene().draws[0].entity = floor;
    }
    void draw(uvec2 size = uvec2(64, 36)) {
        Renderer::Request request{.width = size.x, .height = size.y};
        view.prepare(request);
        meter.update(builder.scene());
        const Renderer::Result result = renderer->render(builder.scene(), request);
        view.update({builder.scene(), *renderer, result, size, 1.0, &meter});
    }
    void add_spot() {
        builder.add({.kind = RenderScene::Light::Kind::spot, .position = vec3(0, 3, 0), .direction = vec3(0, -1, 0), .intensity = vec3(100.0f), .casts_shadow = true, .bounces = true});
        std::ranges::stable_sort(builder.scene().lights, {}, &RenderScene::Light::kind);
    }

    const Entity floor{7, 1};
    SceneBuilder builder;
    LightMeter meter;
    SeeView view;
};

TEST_F(SeeViewTest, TheProbeFindsThePointAndItsLight) {
    view.probe.pick(vec2(0.5f));
    for (int i = 0; i < 4; ++i) draw();
    const auto& reading = view.probe.reading();
    ASSERT_TRUE(reading);
    EXPECT_EQ(reading->entity, floor);
    EXPECT_NEAR(glm::length(reading->point.position), 0.0, 0.05);
    EXPECT_NEAR(reading->point.normal.y, 1.0f, 1e-3f);
    EXPECT_NEAR(reading->distance, 2.0f, 0.01f);
    ASSERT_TRUE(reading->live);
    EXPECT_NEAR(reading->live->albedo.x, 0.5f, 0.005f);
    EXPECT_NEAR(arriving(reading->lights).x, 50.0f, 0.2f);
    EXPECT_NEAR(reading->live->direct.x, 50.0f * 0.5f / pi, 0.1f);
    EXPECT_TRUE(reading->shadowed);
    EXPECT_FALSE(reading->texels) << "light off";
    ASSERT_TRUE(reading->truth);
    EXPECT_EQ(reading->truth->irradiance, vec3(0.0f)) << "nothing reflects onto a lone floor";
}

TEST_F(SeeViewTest, TheProbeReadsTheMapsOfAMethodThatHasSome) {
    add_spot();
    builder.add({Shape::Kind::box, vec3(1, 4, 8)}, glm::translate(mat4(1.0f), vec3(2, 1, 0)), vec3(0.8f));
    builder.use(RsmExact{.rsm_size = 64});
    view.probe.pick(vec2(0.6f, 0.5f));
    for (int i = 0; i < 2; ++i) draw();
    ASSERT_TRUE(view.probe.reading() && view.probe.reading()->texels && view.probe.reading()->live);
    // The frame itself takes nearby texels for what they are, patches; the probe takes all for discs.
    const float live = view.probe.reading()->live->irradiance.x;
    EXPECT_GT(live, 0.0f);
    EXPECT_NEAR(view.probe.reading()->texels->sum.x, live, 0.05f * live);
    EXPECT_EQ(view.probe.reading()->texels->strongest.size(), PixelProbe::most_texels);
    builder.use(GiOff{});
    draw();
    draw();
    EXPECT_FALSE(view.probe.reading()->texels);
    EXPECT_EQ(view.probe.reading()->live->irradiance, vec3(0.0f));
}

TEST_F(SeeViewTest, ThePointStaysWhereItIsWhenTheCameraTurnsAway) {
    view.probe.pick(vec2(0.5f));
    draw();
    draw();
    const ProbedPoint point = view.probe.reading()->point;
    builder.look(vec3(0, 2, 0), vec3(0, 1, 0), vec3(0, 0, -1), 1.0f);
    draw();
    EXPECT_EQ(view.probe.reading()->point, point);
    EXPECT_FALSE(view.probe.reading()->live);
    view.probe.pick(vec2(0.5f));
    draw();
    EXPECT_FALSE(view.probe.reading());
    EXPECT_TRUE(view.probe.missed());
}

TEST_F(SeeViewTest, AnyImageOfTheFrameCanBeShown) {
    add_spot();
    for (const GiMethod& method : {GiMethod{RsmDisc{.rsm_size = 32}}, GiMethod{RsmGrid{.rsm_size = 32}}, GiMethod{RsmExact{.rsm_size = 32}}, GiMethod{GiOff{}}, GiMethod{Facets{}}}) {
        builder.use(method);
        draw();
        EXPECT_FALSE(view.image.listed().empty());
        for (const ListedImage& image : std::vector(view.image.listed())) {
            view.image.name = image.name;
            view.image.layer = 99;
            draw();
            // A map that is still good was not drawn anew, and what it was drawn with is gone.
            EXPECT_TRUE(view.image.range().empty() || view.image.layer < std::max(image.layers, 1u)) << image.name;
        }
    }
}

TEST_F(SeeViewTest, AnImageMayGoAndComeAgain) {
    add_spot();
    view.image.name = "rsm_flux";
    builder.use(RsmDisc{.rsm_size = 32});
    draw();
    EXPECT_THAT(view.image.range(), HasSubstr("lm"));
    builder.use(GiOff{});
    draw();
    EXPECT_EQ(view.image.range(), "");
    EXPECT_EQ(view.image.chosen(), nullptr);
    builder.use(RsmDisc{.rsm_size = 16});
    draw(uvec2(21, 13));
    EXPECT_NE(view.image.range(), "");
    view.image.name.clear();
    draw();
    EXPECT_EQ(view.image.range(), "");
}

TEST_F(SeeViewTest, WithoutACameraNothingIsShownAndNothingFails) {
    view.image.name = "hdr";
    view.facets.on = true;
    view.probe.pick(vec2(2.0f, -1.0f));
    draw();
    draw();
    builder.scene().view.reset();
    draw();
    EXPECT_TRUE(view.image.listed().empty());
    EXPECT_EQ(view.image.range(), "");
    EXPECT_EQ(view.facets.size(), 0u);
}

TEST_F(SeeViewTest, FacetsHaveOutlinesWhileTheirMethodRuns) {
    add_spot();
    view.facets.on = true;
    builder.use(Facets{});
    draw();
    draw();
    EXPECT_GT(view.facets.size(), 0u);
    view.facets.colour = FacetOutlines::Colour::noise;
    draw();
    EXPECT_GT(view.facets.size(), 0u);
    builder.use(RsmDisc{.rsm_size = 32});
    draw();
    EXPECT_EQ(view.facets.size(), 0u);
}

}  // namespace
}  // namespace sl
