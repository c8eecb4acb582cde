// SPDX-License-Identifier: MIT
// What the method facets claims: the path tracer's light, kept on surfaces, and none of it through walls.
#include <glm/gtc/matrix_transform.hpp>

#include "tests/support/gl_test.h"
#include "tests/support/method_picture.h"
#include "tests/support/scene_builder.h"

namespace sl {
namespace {

using Light = RenderScene::Light;

mat4 at(vec3 place) { return glm::translate(mat4(1.0f), place); }

/// A house of two rooms with walls of half a metre, under sun and sky: one has no roof, the other no opening at all.
void build_rooms(SceneBuilder& builder) {
    builder.add({Shape::Kind::box, vec3(30, 0.5f, 30)}, at(vec3(0, -0.25f, 0)), vec3(0.3f, 0.7f, 0.3f));
    for (const float x : {-4.25f, 0.0f, 4.25f}) builder.add({Shape::Kind::box, vec3(0.5f, 3, 4)}, at(vec3(x, 1.5f, 0)), vec3(0.7f));
    for (const float z : {-2.25f, 2.25f}) builder.add({Shape::Kind::box, vec3(9, 3, 0.5f)}, at(vec3(0, 1.5f, z)), vec3(0.7f));
    builder.add({Shape::Kind::box, vec3(4.75f, 0.5f, 5)}, at(vec3(2.125f, 3.25f, 0)), vec3(0.7f));
    builder.add({.kind = Light::Kind::directional, .direction = glm::normalize(vec3(0.1f, -1, 0.15f)), .intensity = vec3(1e5f), .casts_shadow = true, .bounces = true});
    builder.scene().sky_radiance = vec3(5000.0f);
}

struct Errors {
    double nrmse = 0.0, bias = 0.0;  ///< over the mean
};
Errors errors_of(const Picture& picture, const Picture& truth) {
    double squares = 0.0, sum = 0.0, difference_sum = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const double difference = picture.irradiance[i].y - truth.irradiance[i].y;
        squares += difference * difference;
        difference_sum += difference;
        sum += truth.irradiance[i].y;
    }
    return {.nrmse = std::sqrt(squares / static_cast<double>(truth.size())) * static_cast<double>(truth.size()) / sum, .bias = difference_sum / sum};
}

class FacetsTest : public GlTest {
  protected:
    static constexpr uvec2 size{64, 36};

    Picture draw(RenderScene& scene, const Facets& settings = {}) { return picture_of({.name = "facets", .gi = settings}, scene, *renderer, size); }
};

TEST_F(FacetsTest, NoLightGetsThroughAWallOfOneBlock) {
    SceneBuilder builder;
    build_rooms(builder);
    // First the bright room, whose facets stay in the table, then the dark one.
    builder.look(vec3(-3.7f, 2.5f, -1.5f), glm::normalize(vec3(1, -0.7f, 0.8f)), vec3(0, 1, 0), 1.4f);
    const Picture bright = draw(builder.scene());
    builder.look(vec3(3.7f, 2.5f, -1.5f), glm::normalize(vec3(-1, -0.5f, 0.8f)), vec3(0, 1, 0), 1.4f);
    const Picture dark = draw(builder.scene());
    float most = 0.0f;
    for (const vec3& value : dark.irradiance) most = std::max({most, value.x, value.y, value.z});
    EXPECT_GT(bright.mean_brightness(), 1000.0);
    EXPECT_LT(most, 1e-3 * bright.mean_brightness());
}

TEST_F(FacetsTest, AgreeWithThePathTracer) {
    SceneBuilder builder;
    build_rooms(builder);
    builder.look(vec3(-3.7f, 2.5f, -1.5f), glm::normalize(vec3(1, -0.7f, 0.8f)), vec3(0, 1, 0), 1.4f);
    const Picture drawn = draw(builder.scene(), {.noise = 0.03f});
    const Picture truth = traced_picture({.name = "path_tracer", .transport = {.pixel_area = false}, .samples = 1024}, builder.scene(), size);
    const Errors errors = errors_of(drawn, truth);
    RecordProperty("nrmse", fmt::format("{:.4f}", errors.nrmse));
    RecordProperty("bias", fmt::format("{:+.4f}", errors.bias));
    EXPECT_LT(errors.nrmse, 0.10);
    EXPECT_LT(std::abs(errors.bias), 0.03);
}

TEST_F(FacetsTest, PixelsOfFineGeometryShowTheLightOfTheirOwnSurface) {
    // A fence in the sun, whose slats and gaps are as wide as a pixel or two: each has a bright side and a dark one.
    SceneBuilder builder;
    builder.add({Shape::Kind::box, vec3(20, 0.5f, 20)}, at(vec3(0, -0.25f, 0)), vec3(0.6f));
    builder.add({Shape::Kind::box, vec3(8, 3, 0.5f)}, at(vec3(0, 1.5f, -1.2f)), vec3(0.8f, 0.3f, 0.2f));
    for (int i = -16; i <= 16; ++i) builder.add({Shape::Kind::box, vec3(0.06f, 1.6f, 0.2f)}, at(vec3(0.15f * static_cast<float>(i), 0.8f, 0)), vec3(0.7f));
    builder.add({.kind = Light::Kind::directional, .direction = glm::normalize(vec3(1, -0.8f, -0.6f)), .intensity = vec3(1e5f), .casts_shadow = true, .bounces = true});
    builder.scene().sky_radiance = vec3(2000.0f);
    builder.look(vec3(1.5f, 1.2f, 3.5f), vec3(-0.4f, -0.1f, -1), vec3(0, 1, 0), 0.8f);
    const Errors errors = errors_of(draw(builder.scene()), traced_picture({.name = "path_tracer", .transport = {.pixel_area = false}, .samples = 1024}, builder.scene(), size));
    RecordProperty("nrmse", fmt::format("{:.4f}", errors.nrmse));
    RecordProperty("bias", fmt::format("{:+.4f}", errors.bias));
    EXPECT_LT(errors.nrmse, 0.10);
    EXPECT_LT(std::abs(errors.bias), 0.03);
}

TEST_F(FacetsTest, ALampRightBelowACeilingIsAsSmallAsItIs) {
    // From afar both lie in one cell of the lattice. A board between lamp and floor has a shadow with edges.
    SceneBuilder builder;
    builder.add({Shape::Kind::box, vec3(20, 0.5f, 20)}, at(vec3(0, -0.25f, 0)), vec3(0.6f));
    builder.add({Shape::Kind::box, vec3(20, 0.5f, 20)}, at(vec3(0, 6.25f, 0)), vec3(0.6f));
    builder.add({Shape::Kind::box, vec3(1.5f, 0.1f, 1.5f)}, at(vec3(0.2f, 2, 0)), vec3(0.6f));
    Material lamp = SceneBuilder::matte(vec3(0));
    lamp.emission = 1e4f;
    builder.add(make_shape_mesh({Shape::Kind::box, vec3(0.8f, 0.02f, 0.8f)}), at(vec3(0.2f, 5.98f, 0)), lamp);
    builder.look(vec3(3, 3, 3), vec3(-1, -0.9f, -1), vec3(0, 1, 0), 1.2f);
    const Picture drawn = draw(builder.scene(), {.bounces = 0});
    const Picture truth = traced_picture({.name = "path_tracer", .transport = {.bounces = 0, .pixel_area = false}, .samples = 256}, builder.scene(), size);
    const Errors errors = errors_of(drawn, truth);
    RecordProperty("nrmse", fmt::format("{:.4f}", errors.nrmse));
    RecordProperty("bias", fmt::format("{:+.4f}", errors.bias));
    EXPECT_LT(errors.nrmse, 0.12);
    EXPECT_LT(std::abs(errors.bias), 0.03);
}

TEST_F(FacetsTest, OneReflectionIsThePathTracersFirstBounce) {
    SceneBuilder builder;
    build_rooms(builder);
    builder.look(vec3(-3.7f, 2.5f, -1.5f), glm::normalize(vec3(1, -0.7f, 0.8f)), vec3(0, 1, 0), 1.4f);
    for (const std::uint32_t bounces : {1u, 2u}) {
        const Picture drawn = draw(builder.scene(), {.noise = 0.03f, .bounces = bounces});
        const Picture truth = traced_picture({.name = "path_tracer", .transport = {.bounces = static_cast<int>(bounces), .pixel_area = false}, .samples = 512}, builder.scene(), size);
        const Errors errors = errors_of(drawn, truth);
        RecordProperty(fmt::format("nrmse_{}", bounces), fmt::format("{:.4f}", errors.nrmse));
        RecordProperty(fmt::format("bias_{}", bounces), fmt::format("{:+.4f}", errors.bias));
        EXPECT_LT(errors.nrmse, 0.10) << bounces << " reflections";
        EXPECT_LT(std::abs(errors.bias), 0.03) << bounces << " reflections";
    }
}

TEST_F(FacetsTest, AThingInACornerOfASmallPictureIsLit) {
    // The first ray of a square of eight pixels passes it by.
    SceneBuilder builder;
    builder.add({Shape::Kind::box, vec3(1)}, at(vec3(0)), vec3(0.7f));
    builder.scene().sky_radiance = vec3(100.0f);
    for (const float yaw : {-0.35f, 0.35f}) {
        for (const float pitch : {-0.35f, 0.35f}) {
            builder.look(vec3(0, 0, 4), vec3(yaw, pitch, -1), vec3(0, 1, 0), 0.9f);
            renderer->forget();
            const Picture picture = picture_of({.name = "facets", .gi = Facets{}}, builder.scene(), *renderer, {8, 8});
            EXPECT_GT(picture.mean_brightness(), 10.0) << yaw << " " << pitch;
        }
    }
}

TEST_F(FacetsTest, AStillPictureNoLongerChangesAfterSixteenFrames) {
    SceneBuilder builder;
    build_rooms(builder);
    builder.look(vec3(-3.7f, 2.5f, -1.5f), glm::normalize(vec3(1, -0.7f, 0.8f)), vec3(0, 1, 0), 1.4f);
    (void)draw(builder.scene());
    builder.look(vec3(-3.6f, 2.4f, -1.4f), glm::normalize(vec3(1, -0.6f, 0.9f)), vec3(0, 1, 0), 1.4f);
    for (int frame = 0; frame < 16; ++frame) (void)draw(builder.scene());
    const Picture settled = draw(builder.scene());
    for (int frame = 0; frame < 3; ++frame) EXPECT_TRUE(same_bytes(draw(builder.scene()), settled));
}

TEST_F(FacetsTest, ABlockThatComesAndGoesIsSeenAndLeavesNoGhost) {
    SceneBuilder builder;
    build_rooms(builder);
    builder.look(vec3(-3.7f, 2.5f, -1.5f), glm::normalize(vec3(1, -0.7f, 0.8f)), vec3(0, 1, 0), 1.4f);
    RenderScene& scene = builder.scene();
    const std::vector<RenderScene::Draw> without = scene.draws;
    builder.add({Shape::Kind::box, vec3(0.5f)}, at(vec3(-2.2f, 0.25f, 0.3f)), vec3(0.8f, 0.2f, 0.2f));
    const std::vector<RenderScene::Draw> with_block = scene.draws;
    const Facets fine{.noise = 0.03f};
    scene.draws = without;
    const Picture before = draw(scene, fine);
    scene.draws = with_block;
    const Picture with = draw(scene, fine);
    Renderer fresh(shader_folder());
    const Errors errors = errors_of(with, picture_of({.name = "facets", .gi = fine}, scene, fresh, size));
    EXPECT_GT(errors.nrmse, 0.0) << "it was followed, and not begun anew";
    EXPECT_LT(errors.nrmse, 0.04);
    EXPECT_LT(std::abs(errors.bias), 0.01);
    EXPECT_GT(errors_of(with, before).nrmse, 0.05) << "it does change the light";
    scene.draws = without;
    const Errors after = errors_of(draw(scene, fine), before);
    EXPECT_LT(after.nrmse, 0.04);
    EXPECT_LT(std::abs(after.bias), 0.01);
    // Asks all corners for more, and must leave out those that were under the block.
    EXPECT_LT(errors_of(draw(scene, {.noise = 0.02f}), before).nrmse, 0.04);
}

TEST_F(FacetsTest, ManyChangesLeaveNoGhost) {
    SceneBuilder builder;
    build_rooms(builder);
    builder.look(vec3(-3.7f, 2.5f, -1.5f), glm::normalize(vec3(1, -0.7f, 0.8f)), vec3(0, 1, 0), 1.4f);
    RenderScene& scene = builder.scene();
    const std::vector<RenderScene::Draw> room = scene.draws;
    for (const float x : {-3.2f, -2.6f, -2.0f, -1.4f}) builder.add({Shape::Kind::box, vec3(0.4f)}, at(vec3(x, 0.2f, 0.6f * x + 1.4f)), vec3(0.8f));
    const std::vector<RenderScene::Draw> all = scene.draws;
    const auto with_blocks = [&](std::uint32_t bits) {
        scene.draws = room;
        for (std::uint32_t i = 0; i < 4; ++i) {
            if ((bits >> i & 1) != 0) scene.draws.push_back(all[room.size() + i]);
        }
    };
    const Facets fine{.noise = 0.03f};
    for (const std::uint32_t bits : {0, 1, 3, 2, 10, 15, 5, 4, 12}) {
        with_blocks(bits);
        (void)draw(scene, fine);
    }
    Renderer fresh(shader_folder());
    const Errors errors = errors_of(draw(scene, fine), picture_of({.name = "facets", .gi = fine}, scene, fresh, size));
    EXPECT_LT(errors.nrmse, 0.05);
    // Other patches than those of a fresh cache: each is about one percent from the truth, on its own side.
    EXPECT_LT(std::abs(errors.bias), 0.02);
}

TEST_F(FacetsTest, AnotherSceneWithOtherLightsIsNothingNew) {
    SceneBuilder builder;
    build_rooms(builder);
    builder.look(vec3(-3.7f, 2.5f, -1.5f), glm::normalize(vec3(1, -0.7f, 0.8f)), vec3(0, 1, 0), 1.4f);
    const Picture before = draw(builder.scene());
    RenderScene& scene = builder.scene();
    const std::vector<RenderScene::Draw> draws = scene.draws;
    const std::vector<Light> lights = scene.lights;
    scene.draws.erase(scene.draws.begin());  // the ground, and with it most of the scene's size
    scene.lights.push_back({.kind = Light::Kind::point, .position = vec3(0, 2, 5), .intensity = vec3(10.0f), .casts_shadow = true});
    (void)draw(scene);
    scene.draws = draws;
    scene.lights = lights;
    EXPECT_LT(errors_of(draw(scene), before).nrmse, 0.03);
}

TEST_F(FacetsTest, LightThatChangesIsSeenAndLeavesNoGhost) {
    SceneBuilder builder;
    build_rooms(builder);
    builder.look(vec3(-3.7f, 2.5f, -1.5f), glm::normalize(vec3(1, -0.7f, 0.8f)), vec3(0, 1, 0), 1.4f);
    (void)draw(builder.scene());
    builder.scene().lights[0].direction = glm::normalize(vec3(0.4f, -1, -0.3f));
    const Picture changed = draw(builder.scene());
    Renderer fresh(shader_folder());
    const Errors errors = errors_of(changed, picture_of({.name = "facets", .gi = Facets{}}, builder.scene(), fresh, size));
    // Not byte for byte: links are kept, and how many there are tells of both lights.
    EXPECT_LT(errors.nrmse, 0.03);
    EXPECT_LT(std::abs(errors.bias), 0.01);
}

}  // namespace
}  // namespace sl
