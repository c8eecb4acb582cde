// SPDX-License-Identifier: MIT
// rsm_exact and the path tracer agree where both claim the same: one diffuse bounce that nothing blocks.
#include "engine/measure/metrics.h"
#include "engine/render/reference/reference.h"
#include "engine/render/scene/extract.h"
#include "game/app/bench_truth.h"
#include "tests/support/gl_test.h"

namespace sl {
namespace {

constexpr uvec2 size{64, 36};

class OpenTruth : public GlTest {
  protected:
    /// Errors of irradiance, in maps of so many texels, against so many paths a pixel.
    ErrorMetrics errors(const std::string& scene, std::uint32_t rsm_size, std::uint32_t samples) {
        const SceneChoice choice{.scene = scene, .gi = "rsm_exact", .sets = {fmt::format("gi.rsm_size={}", rsm_size), "camera.antialias=false"}};
        Renderer fresh(shader_folder());  // a renderer belongs to one world's meshes
        const Image drawn = draw_once(choice, fresh, size).irradiance;
        App app = open_scene(choice);
        RenderScene extracted;
        extract(app.world, extracted);
        const auto layers = trace_film(extracted, size, {.bounces = 1, .occlusion = false, .reflection = Reflection::diffuse, .pixel_area = false}, samples).layers();
        const auto layer = [&](std::string_view name) -> const Image& { return std::ranges::find(layers, name, &ImageLayer::name)->image; };
        return image_errors(drawn, layer("irradiance_lights"), layer("depth").data);
    }
};

TEST_F(OpenTruth, PlatesAgreeWithinOnePercent) {
    for (const char* scene : {"plates", "plates_parallel", "plates_disc"}) EXPECT_LT(errors(scene, 128, 2048).nrmse, 0.01) << scene;
}

TEST_F(OpenTruth, ARoomAgreesButForWhatIsNearerToLitSurfacesThanATexel) {
    // At the foot of the blocks a map's texel is larger than its distance to the floor. There are few such pixels: the
    // rest agree within the tracer's noise of about 1 %.
    const ErrorMetrics found = errors("cornell", 512, 2048);
    EXPECT_LT(found.p95, 0.03);
    EXPECT_LT(std::abs(found.bias), 0.01);
}

}  // namespace
}  // namespace sl
