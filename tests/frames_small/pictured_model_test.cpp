// SPDX-License-Identifier: MIT
// Surfaces with pictures, holes and two sides: what is drawn is what is traced.
#include "engine/core/image.h"
#include "engine/ecs/query.h"
#include "engine/render/capture.h"
#include "engine/render/gl/context.h"
#include "engine/render/trace/trace_scene.h"
#include "engine/render/scene/extract.h"
#include "game/session.h"
#include "tests/model/model_fixture.h"

namespace sl {
namespace {

class PicturedModelTest : public ModelTest {
  protected:
    /// A square with a picture of 4 x 1: red, green, blue, and a hole.
    std::filesystem::path square_with_picture(const char* alpha_mode, bool two_sided) {
        Image picture(4, 1, 4);
        for (std::uint32_t x = 0; x < 4; ++x) {
            if (x < 3) picture.pixel(x, 0)[x] = 1.0f;
            picture.pixel(x, 0)[3] = x < 3 ? 1.0f : 0.0f;
        }
        write_png(folder / "picture.png", picture);
        json["images"] = {{{"uri", "picture.png"}}};
        json["samplers"] = {{{"magFilter", 9728}}};
        json["textures"] = {{{"source", 0}, {"sampler", 0}}};
        json["materials"] = {{{"alphaMode", alpha_mode}, {"doubleSided", two_sided}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}, {"metallicFactor", 0}}}}};
        show(square({{"material", 0}}));
        return write();
    }
    /// The albedo of the square's four quarters, from left to right; black where it is not.
    std::array<vec3, 4> drawn(const std::filesystem::path& file, double z) {
        std::array<vec3, 4> colours{};
        auto context = gl::create_context(gl::ContextKind::egl);
        {
            Renderer renderer(shader_folder());
            App app = open_scene({.scene = file.string(), .gi = "facets"});
            look(app, z);
            const Capture captured = capture(app, renderer, {.width = 64, .height = 64, .layers = true});
            for (const ImageLayer& layer : captured.layers) {
                for (std::size_t i = 0; i < 4 && layer.name == "albedo"; ++i) {
                    const float* pixel = layer.image.pixel(static_cast<std::uint32_t>(8 + 16 * i), 32);
                    colours[i] = vec3(pixel[0], pixel[1], pixel[2]);
                }
            }
        }
        EXPECT_TRUE(context->errors().empty());
        return colours;
    }
    /// The same by rays through the same places.
    std::array<vec3, 4> traced(const std::filesystem::path& file, double z) {
        App app = open_scene({.scene = file.string()});
        look(app, z);
        RenderScene scene;
        app.schedule.run(app.world);
        extract(app.world, scene);
        const TraceScene trace(scene);
        std::array<vec3, 4> colours{};
        for (std::size_t i = 0; i < 4; ++i) {
            const float x = z > 0.0 ? 0.125f + 0.25f * static_cast<float>(i) : 0.875f - 0.25f * static_cast<float>(i);
            const auto hit = trace.intersect_front({.origin = vec3(x, 0.5f, static_cast<float>(z)), .direction = vec3(0, 0, z > 0.0 ? -1 : 1)});
            if (hit) colours[i] = vec3(trace.surface_at(*hit).surface.base_colour);
        }
        return colours;
    }
    /// From before the square, or from behind it, so that it fills the picture.
    static void look(App& app, double z) {
        auto& transform = app.world.get<Transform>(active_camera(app.world));
        transform.translation = dvec3(0.5, 0.5, z);
        transform.rotation = z > 0.0 ? quat(1, 0, 0, 0) : quat(0, 0, 1, 0);
        auto& camera = app.world.get<Camera>(active_camera(app.world));
        camera.fov_y = 2.0f * std::atan(0.5f / static_cast<float>(std::abs(z)));
    }
    static void expect_stripes(const std::array<vec3, 4>& colours, bool hole, bool mirrored) {
        const std::array<vec3, 4> stripes{vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1), vec3(0.0f)};
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t stripe = mirrored ? 3 - i : i;
            if (stripe == 3 && !hole) continue;
            EXPECT_LT(glm::length(colours[i] - stripes[stripe]), 0.05f) << "stripe " << i << ": " << colours[i].x << " " << colours[i].y << " " << colours[i].z;
        }
    }
};

TEST_F(PicturedModelTest, APictureIsWhereItsCoordinatesPutIt) {
    const auto file = square_with_picture("MASK", false);
    expect_stripes(drawn(file, 1.0), true, false);
    expect_stripes(traced(file, 1.0), true, false);
}

TEST_F(PicturedModelTest, FromBehindItIsSeenWhereItHasTwoSidesAlone) {
    const auto both = square_with_picture("MASK", true);
    expect_stripes(drawn(both, -1.0), true, true);
    expect_stripes(traced(both, -1.0), true, true);
    json["materials"][0]["doubleSided"] = false;
    const auto one = write("one.gltf");
    for (const vec3 colour : drawn(one, -1.0)) EXPECT_EQ(colour, vec3(0.0f));
    for (const vec3 colour : traced(one, -1.0)) EXPECT_EQ(colour, vec3(0.0f));
}

TEST_F(PicturedModelTest, AModelWithoutLightGetsASunAndOneThatGlowsDoesNot) {
    const auto suns = [&](const std::filesystem::path& file) {
        App app = open_scene({.scene = file.string()});
        std::size_t count = 0;
        Query<const DirectionalLight>(app.world).each([&](const DirectionalLight&) { ++count; });
        return count;
    };
    EXPECT_EQ(suns(square_with_picture("OPAQUE", false)), 1u);
    json["materials"][0]["emissiveFactor"] = {1, 1, 1};
    EXPECT_EQ(suns(write("glows.gltf")), 0u);
}

TEST_F(PicturedModelTest, OpaqueMaterialsHaveNoHoles) {
    const auto file = square_with_picture("OPAQUE", false);
    RenderScene scene;
    App app = open_scene({.scene = file.string()});
    extract(app.world, scene);
    const TraceScene trace(scene);
    EXPECT_TRUE(trace.occluded({.origin = vec3(0.9f, 0.5f, 1), .direction = vec3(0, 0, -1)}));
}

TEST_F(PicturedModelTest, LightPassesAHoleAndHalfOfItWhatIsHalfSeeThrough) {
    auto passed = [&](const std::filesystem::path& file, float x) {
        App app = open_scene({.scene = file.string()});
        RenderScene scene;
        extract(app.world, scene);
        const TraceScene trace(scene);
        int count = 0;
        for (int i = 0; i < 1000; ++i) count += !trace.occluded({.origin = vec3(x + 1e-4f * static_cast<float>(i % 100), 0.1f + 8e-4f * static_cast<float>(i), 1), .direction = vec3(0, 0, -1)});
        return count;
    };
    const auto mask = square_with_picture("MASK", false);
    EXPECT_EQ(passed(mask, 0.1f), 0);
    EXPECT_EQ(passed(mask, 0.87f), 1000);
    json["materials"][0] = {{"alphaMode", "BLEND"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0.5}}}}};
    EXPECT_NEAR(passed(write("blend.gltf"), 0.1f), 500, 60);
}

}  // namespace
}  // namespace sl
