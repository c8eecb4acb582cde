// SPDX-License-Identifier: MIT
#include "editor/compare/compare_view.h"

#include <chrono>
#include <thread>

#include "tests/support/gl_test.h"
#include "tests/support/scene_builder.h"

namespace sl {
namespace {

/// A white floor and wall in the sun.
class CompareViewTest : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        builder.add({Shape::Kind::box, vec3(8, 1, 8)}, mat4(1.0f), vec3(0.7f));
        builder.add({Shape::Kind::box, vec3(1, 6, 8)}, mat4(1.0f), vec3(0.7f, 0.2f, 0.2f));
        builder.add({.kind = RenderScene::Light::Kind::directional, .direction = glm::normalize(vec3(-1, -2, -0.5f)), .intensity = vec3(10000.0f), .casts_shadow = true, .bounces = true});
        builder.look(vec3(4, 3, 4), glm::normalize(vec3(-3, -2, -4)), vec3(0, 1, 0), 1.0f);
        builder.use(Facets{});
        view.on = true;
    }
    void frame(uvec2 size = uvec2(48, 32)) {
        Renderer::Request request{.width = size.x, .height = size.y, .frame_index = number++};
        RenderScene scene = builder.scene();
        view.prepare(scene, request);
        const auto result = renderer.render(scene, request);
        view.update(scene, request, renderer, result, 0.2);
    }
    template <class Condition>
    bool frames_until(Condition condition) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (!condition() && std::chrono::steady_clock::now() < end) {
            frame();
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        return condition();
    }
    ShownPicture shown_on(CompareSource source) {
        view.right.source = source;
        frame();
        return view.parts()[1].picture;
    }

    /// Of its bytes, 0 to 1.
    static double mean(const ShownPicture& picture) {
        std::vector<std::uint8_t> bytes(std::size_t{picture.size.x} * picture.size.y * 4);
        glGetTextureImage(picture.texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(bytes.size()), bytes.data());
        double sum = 0.0;
        for (std::size_t i = 0; i < bytes.size(); ++i) sum += i % 4 < 3 ? bytes[i] / 255.0 : 0.0;
        return sum / (0.75 * static_cast<double>(bytes.size()));
    }

    SceneBuilder builder;
    Renderer renderer{shader_folder()};
    CompareView view;
    std::uint32_t number = 0;
};

TEST_F(CompareViewTest, TellsHowFarTheLiveLightIsFromTheTruth) {
    ASSERT_TRUE(frames_until([&] { return view.figures() && view.figures()->truth_noise < 0.06; }));
    const CompareFigures good = *view.figures();
    EXPECT_LT(good.irradiance.nrmse, 0.3);
    EXPECT_LT(std::abs(good.irradiance.bias), 0.1);
    EXPECT_EQ(view.problem(), "");
    // The truth does not care by which method the live picture is drawn, and goes on.
    builder.use(GiOff{});
    const std::uint32_t samples = good.samples;
    ASSERT_TRUE(frames_until([&] { return view.figures() && view.figures()->irradiance.bias < -0.99; }));
    EXPECT_GE(view.figures()->samples, samples);
    EXPECT_GT(view.figures()->flip, good.flip);
}

TEST_F(CompareViewTest, EachSourceHasAPicture) {
    frame();
    EXPECT_NE(view.parts()[0].picture.texture, 0u) << "live";
    EXPECT_EQ(shown_on(CompareSource::frozen).texture, 0u) << "nothing was frozen";
    view.freeze();
    EXPECT_NE(shown_on(CompareSource::frozen).texture, 0u);
    for (std::size_t i = static_cast<std::size_t>(CompareSource::method); i < compare_source_count(); ++i) {
        const ShownPicture picture = shown_on(static_cast<CompareSource>(i));
        EXPECT_NE(picture.texture, 0u) << compare_source_name(static_cast<CompareSource>(i));
        EXPECT_EQ(picture.size, uvec2(48, 32));
    }
    ASSERT_TRUE(frames_until([&] { return view.figures().has_value(); }));
    EXPECT_NE(shown_on(CompareSource::reference).texture, 0u);
    EXPECT_NE(shown_on(CompareSource::error).texture, 0u);
}

TEST_F(CompareViewTest, BeginsAnewAfterAMoveAndAResize) {
    ASSERT_TRUE(frames_until([&] { return view.figures().has_value(); }));
    builder.scene().view->position.x += 0.5f;
    frame();
    EXPECT_FALSE(view.figures());
    EXPECT_EQ(shown_on(CompareSource::reference).texture, 0u);
    ASSERT_TRUE(frames_until([&] { return view.figures().has_value(); }));
    for (const uvec2 size : {uvec2(1, 1), uvec2(64, 16), uvec2(7, 33)}) {
        for (int i = 0; i < 5; ++i) frame(size);
    }
    EXPECT_EQ(view.problem(), "");
    ASSERT_TRUE(frames_until([&] { return view.figures().has_value(); }));
}

TEST_F(CompareViewTest, BothSidesHaveTheExposureOfAPictureThatAdapts) {
    builder.scene().view->auto_exposure = true;
    builder.scene().view->ev100 = 2.0f;
    ASSERT_TRUE(frames_until([&] { return view.figures() && view.figures()->truth_noise < 0.1; }));
    EXPECT_GT(mean(view.parts()[0].picture), 0.05);
    EXPECT_LT(mean(view.parts()[0].picture), 0.9) << "at EV 2 all of it would be white";
    EXPECT_NEAR(mean(view.parts()[1].picture), mean(view.parts()[0].picture), 0.05);
    EXPECT_LT(view.figures()->flip, 0.2);
    // What makes the live side darker is not made up for.
    const double before = mean(view.parts()[0].picture);
    builder.use(GiOff{});
    for (int i = 0; i < 30; ++i) frame();
    EXPECT_LT(mean(view.parts()[0].picture), before - 0.01);
}

TEST_F(CompareViewTest, PartsFillTheWidth) {
    frame();
    view.split = 0.25f;
    const auto parts = view.parts();
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[0].from, 0.0f);
    EXPECT_EQ(parts[0].to, 0.25f);
    EXPECT_EQ(parts[1].from, 0.25f);
    EXPECT_EQ(parts[1].to, 1.0f);
    view.blink = true;
    EXPECT_EQ(view.parts().size(), 1u);
}

TEST_F(CompareViewTest, CostsNothingWhileItIsOff) {
    ASSERT_TRUE(frames_until([&] { return view.figures().has_value(); }));
    view.on = false;
    frame();
    EXPECT_EQ(view.reference(), nullptr);
    EXPECT_FALSE(view.figures());
}

TEST(CompareFigures, SayWhatIsNoNumber) {
    CompareWorker worker;
    auto picture = std::make_shared<LiveReference::Picture>();
    for (const char* name : {"", "irradiance"}) picture->layers.push_back({name, Image(4, 4, 3)});
    picture->layers.push_back({"depth", Image(4, 4, 1)});
    for (auto& layer : picture->layers) std::ranges::fill(layer.image.data, 1.0f);
    Image broken(4, 4, 3);
    broken.data[7] = std::numeric_limits<float>::quiet_NaN();
    worker.begin({.reference = picture, .irradiance = broken, .picture = Image(4, 4, 3)});
    while (worker.problem().empty() && worker.busy()) worker.figures();
    EXPECT_NE(worker.problem(), "");
    EXPECT_FALSE(worker.figures());
}

}  // namespace
}  // namespace sl
