// SPDX-License-Identifier: MIT
// Shadows of point lights in pictures, beside what rays say of the same pixels.
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "engine/render/reference/reference.h"
#include "tests/support/gl_test.h"
#include "tests/support/scene_builder.h"

namespace sl {
namespace {

using Light = RenderScene::Light;

constexpr std::uint32_t size = 96;

mat4 at(vec3 place, const mat4& turn = mat4(1.0f)) { return glm::translate(mat4(1.0f), place) * turn; }

class PointShadow : public GlTest {
  protected:
    /// A closed room of 6 m with walls of half a metre.
    void add_room() {
        for (int axis = 0; axis < 3; ++axis) {
            for (const float side : {-3.25f, 3.25f}) {
                vec3 place(0.0f), extent(7.0f);
                place[axis] = side;
                extent[axis] = 0.5f;
                builder.add({Shape::Kind::box, extent}, at(place), vec3(0.5f));
            }
        }
    }
    /// Cubes round a place: one in the middle of each face of a shadow map, one across each of its edges and corners.
    void surround(vec3 middle) {
        for (int x = -1; x <= 1; ++x) {
            for (int y = -1; y <= 1; ++y) {
                for (int z = -1; z <= 1; ++z) {
                    const vec3 direction(x, y, z);
                    if (direction == vec3(0.0f)) continue;
                    builder.add({Shape::Kind::box, vec3(0.25f)}, at(middle + 1.1f * glm::normalize(direction), glm::rotate(mat4(1.0f), 0.5f, vec3(1, 2, 3))), vec3(0.5f));
                }
            }
        }
    }
    Light& add_light(vec3 place) {
        builder.add({.kind = Light::Kind::point, .position = place, .intensity = vec3(100.0f), .casts_shadow = true, .shadow_size = 1024});
        return builder.scene().lights.back();
    }
    void look(vec3 from, vec3 forward) { builder.look(from, forward, glm::abs(forward.y) > 0.9f ? vec3(0, 0, 1) : vec3(0, 1, 0), 1.7f); }
    Renderer::Result draw() { return renderer->render(builder.scene(), {.width = size, .height = size}); }

    Image drawn_light() { return renderer->read(renderer->render(builder.scene(), {.width = size, .height = size, .wanted = {"direct"}}).images.direct); }
    Image traced_light() {
        const auto layers = trace_film(builder.scene(), uvec2(size), {.bounces = 0, .pixel_area = false}, 1).layers();
        return std::ranges::find(layers, "direct", &ImageLayer::name)->image;
    }
    struct Agreement {
        int lit = 0, dark = 0, wrong = 0;
    };
    /// Of pixels that face the light, with no shadow's edge within a pixel round them: what the tracer calls lit or dark, and how often
    /// the picture says otherwise.
    Agreement compare() {
        const Image drawn = drawn_light(), traced = traced_light();
        Light& light = builder.scene().lights[0];
        const bool casts = std::exchange(light.casts_shadow, false);
        const Image drawn_open = drawn_light(), traced_open = traced_light();
        light.casts_shadow = casts;
        Agreement result;
        for (std::uint32_t y = 1; y + 1 < size; ++y) {
            for (std::uint32_t x = 1; x + 1 < size; ++x) {
                int dark = 0, lit = 0;
                for (std::uint32_t i = 0; i < 9; ++i) {
                    const uvec2 pixel(x + i % 3 - 1, y + i / 3 - 1);
                    if (*traced_open.pixel(pixel.x, pixel.y) > 0.0f) ++(*traced.pixel(pixel.x, pixel.y) == 0.0f ? dark : lit);
                }
                if (dark != 9 && lit != 9) continue;
                ++(lit == 9 ? result.lit : result.dark);
                if (*drawn.pixel(x, y) != (lit == 9 ? *drawn_open.pixel(x, y) : 0.0f)) ++result.wrong;
            }
        }
        return result;
    }
    std::size_t faces_drawn() const {
        return static_cast<std::size_t>(std::ranges::count_if(renderer->steps(), [&](const Step& step) {
            return renderer->graph().passes()[static_cast<std::size_t>(step.pass)].name.starts_with("shadow_point");
        }));
    }

    SceneBuilder builder;
};

const std::vector<vec3> six_ways{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

TEST_F(PointShadow, PicturesDarkenWhatRaysSayIsDarkInAllDirections) {
    const vec3 light(0.4f, -0.3f, 0.6f);
    add_room();
    surround(light);
    add_light(light);
    for (const vec3 way : six_ways) {
        // Beside the light, so that the shadows can be seen past what throws them.
        look(light - 2.2f * way + 0.3f * vec3(way.y, way.z, way.x), way);
        const Agreement agreement = compare();
        EXPECT_GT(agreement.lit, 2000);
        EXPECT_GT(agreement.dark, 300);
        EXPECT_EQ(agreement.wrong, 0) << "towards " << way.x << ' ' << way.y << ' ' << way.z;
    }
}

TEST_F(PointShadow, ARoomWithNothingInItHasNoSeamAndNoShadowOfItsOwn) {
    add_room();
    Light& light = add_light(vec3(0));
    // In the middle, where the faces' edges run through those of the walls, and near a wall and a corner, where light grazes.
    for (const vec3 place : {vec3(0), vec3(0.4f, -0.3f, 0.6f), vec3(2.7f, 0.2f, -0.1f), vec3(-2.6f, -2.7f, 2.8f)}) {
        light.position = place;
        for (const std::uint32_t shadow_size : {1024u, 64u}) {
            light.shadow_size = shadow_size;
            for (const vec3 way : six_ways) {
                look(vec3(0.1f, 0.2f, -0.1f) - 2.5f * way, way);
                const Agreement agreement = compare();
                EXPECT_EQ(agreement.dark, 0);
                EXPECT_GT(agreement.lit, 8000);
                EXPECT_EQ(agreement.wrong, 0) << "light at " << place.x << ' ' << place.y << ' ' << place.z << ", " << shadow_size << " texels, towards " << way.x << ' ' << way.y << ' ' << way.z;
            }
        }
    }
}

TEST_F(PointShadow, NoLightLeaksUnderWhatStandsOnAFloor) {
    builder.add({Shape::Kind::box, vec3(20, 1, 20)}, at(vec3(0, -0.5f, 0)), vec3(0.5f));
    builder.add({Shape::Kind::box, vec3(6, 2, 0.3f)}, at(vec3(0, 1, 0)), vec3(0.5f));
    add_light(vec3(0.3f, 1.5f, 2));
    // Down at the foot of the wall's dark side: 2 cm of the floor to a pixel.
    look(vec3(0, 0.9f, -0.7f), vec3(0, -1, 0));
    const Agreement agreement = compare();
    EXPECT_GT(agreement.dark, 6000);
    EXPECT_EQ(agreement.wrong, 0);
}

TEST_F(PointShadow, ALightWithoutShadowsShinesThroughInPictureAndTruth) {
    const vec3 place(0.4f, -0.3f, 0.6f);
    add_room();
    surround(place);
    add_light(place).casts_shadow = false;
    look(vec3(-2, 0, 0.6f), vec3(1, 0, 0));
    const Agreement agreement = compare();
    EXPECT_GT(agreement.lit, 4000);
    EXPECT_EQ(agreement.wrong, 0);
    EXPECT_EQ(faces_drawn(), 0u);
}

TEST_F(PointShadow, FacesAreDrawnAgainOnlyWhereSomethingChanges) {
    add_room();
    builder.add({Shape::Kind::box, vec3(0.5f)}, at(vec3(-1.5f, 0, 0)), vec3(0.5f));
    builder.add({Shape::Kind::box, vec3(0.5f)}, at(vec3(0, 40, 0)), vec3(0.5f));
    const std::size_t inside = builder.scene().draws.size() - 2, far_off = inside + 1;
    Light& light = add_light(vec3(0));
    light.range = 8.0f;
    look(vec3(-2.8f, -0.5f, 0), vec3(1, 0.2f, 0));
    (void)draw();
    EXPECT_GE(faces_drawn(), 5u);
    (void)draw();
    EXPECT_EQ(faces_drawn(), 0u) << "nothing has changed";
    light.intensity *= 2.0f;
    builder.move(far_off, at(vec3(0, 41, 0)));
    (void)draw();
    EXPECT_EQ(faces_drawn(), 0u) << "neither brightness nor what is out of range is seen";
    builder.move(inside, at(vec3(-1.5f, 0.1f, 0)));
    (void)draw();
    EXPECT_EQ(faces_drawn(), 1u) << "the face that it lies in";
    light.position.x += 0.1f;
    (void)draw();
    EXPECT_GE(faces_drawn(), 5u);
    look(vec3(0), vec3(0, 1, 0));
    light.position.x += 0.1f;
    (void)draw();
    const std::size_t ahead = faces_drawn();
    EXPECT_LT(ahead, 6u) << "those in view";
    look(vec3(0), vec3(0, -1, 0));
    (void)draw();
    EXPECT_GE(faces_drawn(), 1u) << "those that come into view";
    look(vec3(0), vec3(0, 1, 0));
    (void)draw();
    EXPECT_EQ(faces_drawn(), 0u) << "they are known";
}

TEST_F(PointShadow, LightsWithoutRoomForMapsAreCountedToldOnceAndShine) {
    const vec3 place(0.4f, -0.3f, 0.6f);
    add_room();
    surround(place);
    add_light(place).mapped = false;
    look(vec3(-2, 0, 0.6f), vec3(1, 0, 0));
    testing::internal::CaptureStdout();
    EXPECT_EQ(draw().lights_without_maps, 1u);
    EXPECT_NE(testing::internal::GetCapturedStdout().find("1 of 1 lights cast no shadow in the picture"), std::string::npos);
    EXPECT_EQ(faces_drawn(), 0u);
    testing::internal::CaptureStdout();
    EXPECT_EQ(draw().lights_without_maps, 1u);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    const Agreement agreement = compare();
    EXPECT_EQ(agreement.wrong, agreement.dark) << "light where rays know of a shadow";
    EXPECT_GT(agreement.dark, 100);
}

}  // namespace
}  // namespace sl
