// SPDX-License-Identifier: MIT
// Materials without light: drawn and traced in their colour, and black to all others.
#include "tests/frames_small/square_model.h"

namespace sl {
namespace {

class UnlitModelTest : public SquareModelTest {
  protected:
    void SetUp() override {
        SquareModelTest::SetUp();
        json["extensionsUsed"] = {"KHR_materials_unlit"};
        add_picture("colours.png", [](std::uint32_t x, std::uint32_t y) { return colour(x, y); });
        show_square({{"extensions", {{"KHR_materials_unlit", Json::object()}}}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    }
    static vec3 colour(std::uint32_t x, std::uint32_t y) { return {static_cast<float>(x) / 3.0f, static_cast<float>(y) / 3.0f, 0.6f}; }
    static constexpr vec3 eye{0.5f, 0.5f, 1};
};

TEST_F(UnlitModelTest, ItsColoursAreShownAsTheyAreWhateverTheExposure) {
    const auto file = write();
    // At 16 and more, white is brighter than the largest half float.
    for (const float ev100 : {5.0f, 12.0f, 16.0f, 24.0f}) {
        Seen seen = drawn(file, eye, "off", ev100);
        const Traced rays = traced(file, eye, ev100);
        for (std::uint32_t y = 0; y < 4; ++y) {
            for (std::uint32_t x = 0; x < 4; ++x) {
                // A byte of a picture, and one of the one that is drawn.
                EXPECT_LT(glm::length(seen.at("picture", x, y) - colour(x, y)), 0.01f) << x << " " << y;
                const vec3 truth = rays.tracer->sample({place_of(x), place_of(y)}, 0).direct, here = seen.at("direct", x, y);
                EXPECT_LT(glm::length(here - truth), 0.01f * glm::length(truth)) << x << " " << y;
                EXPECT_EQ(seen.at("albedo", x, y), vec3(0.0f)) << "nothing is left for light";
            }
        }
    }
}

TEST_F(UnlitModelTest, ItGivesNoLightAndThrowsNoneBack) {
    RenderScene scene;
    App app = open_scene({.scene = write().string()});
    extract(app.world, scene);
    const TraceScene trace(scene);
    const auto hit = trace.intersect_front({.origin = vec3(0.6f, 0.6f, 1), .direction = vec3(0, 0, -1)});
    ASSERT_TRUE(hit);
    const SurfacePoint point = trace.surface_at(*hit);
    EXPECT_EQ(point.emission, vec3(0.0f));
    EXPECT_EQ(diffuse_albedo(point.surface), vec3(0.0f));
    EXPECT_EQ(point.surface.specular.x, 0.0f);
    EXPECT_GT(point.unlit.z, 0.0f);
    EXPECT_FALSE(trace.glows(hit->draw));
}

TEST_F(UnlitModelTest, ACameraThatIsPlacedKeepsItsExposureWhereNothingIsLit) {
    const auto adapts = [&](const std::filesystem::path& file) {
        App app = open_scene({.scene = file.string()});
        return app.world.get<Camera>(active_camera(app.world)).auto_exposure;
    };
    EXPECT_FALSE(adapts(write()));
    json["materials"][0].erase("extensions");
    EXPECT_TRUE(adapts(write("lit.gltf")));
}

}  // namespace
}  // namespace sl
