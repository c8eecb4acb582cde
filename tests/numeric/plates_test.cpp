// SPDX-License-Identifier: MIT
// Closed forms: a plate lit evenly by parallel light is a uniform Lambertian emitter of radiosity B = ρE, and a receiver
// sees it under a form factor that is known exactly. Every method in physical units meets them as well as it claims to.
#include <glm/gtc/matrix_transform.hpp>

#include "tests/support/closed_forms.h"
#include "tests/support/gl_test.h"
#include "tests/support/scene_builder.h"

namespace sl {
namespace {

constexpr float albedo = 0.5f, illuminance = 1000.0f;

using closed_form::parallel;
using closed_form::perpendicular;

RenderScene::Light sun(vec3 direction) {
    return {.kind = RenderScene::Light::Kind::directional, .direction = glm::normalize(direction), .intensity = vec3(illuminance),
            .bounces = true, .shadow_size = 512, .shadow_distance = 100.0f};
}

struct Errors {
    double worst = 0.0, bias = 0.0;  ///< largest, and mean with its sign
    int count = 0;
};

/// Relative errors of a field against a closed form, over pixels where `expected` is not negative.
template <class Expected>
Errors errors_against(const IrradianceField& field, Expected&& expected) {
    Errors errors;
    for (std::size_t i = 0; i < field.position.size(); ++i) {
        const double truth = field.surface[i] ? expected(field.position[i]) : -1.0;
        if (truth < 0.0) continue;
        const double error = field.irradiance[i].y / truth - 1.0;
        errors.worst = std::max(errors.worst, std::abs(error));
        errors.bias += error;
        ++errors.count;
    }
    errors.bias /= std::max(errors.count, 1);
    return errors;
}

/// What a method claims of the plates, and where its claim ends.
struct PlateMethod {
    std::string name;
    GiMethod gi;
    std::uint32_t pixels = 12;  ///< side of the picture
    double parallel, disc, wall, corner;  ///< largest relative error of a pixel
    double bias;                          ///< of the mean relative error of any of these pictures
    float corner_from = 0.0004f;          ///< m before the wall, of which a texel is 2 mm
};
void PrintTo(const PlateMethod& method, std::ostream* out) { *out << method.name; }

class Plates : public GlTest, public testing::WithParamInterface<PlateMethod> {
  protected:
    const PlateMethod& method() const { return GetParam(); }
    /// A wall in the plane z = 0, x from -0.5 to 0.5, y from 0 to 1, facing +z, with a black floor at its foot.
    void corner_scene(SceneBuilder& builder, float scale) {
        builder.add({Shape::Kind::quad, vec3(scale)}, glm::rotate(glm::translate(mat4(1.0f), vec3(0, 0.5f * scale, 0)), glm::half_pi<float>(), vec3(1, 0, 0)),
                    vec3(albedo));
        builder.add({Shape::Kind::quad, vec3(scale, 0, 2 * scale)}, mat4(1.0f), vec3(0.0f));
        builder.add(sun(vec3(0, 0, -1)));
        builder.use(method().gi);
    }
    Errors corner_errors(SceneBuilder& builder, float scale, float nearest, float farthest) {
        const IrradianceField field = render_irradiance(*renderer, builder.scene(), method().pixels, method().pixels);
        return errors_against(field, [&](vec3 p) {
            const bool wanted = p.y < 1e-3f * scale && p.z > nearest && p.z < farthest && std::abs(p.x) < 0.4f * scale;
            return wanted ? albedo * illuminance * perpendicular(-0.5 * scale - p.x, 0.5 * scale - p.x, scale, p.z) : -1.0;
        });
    }
};

TEST_P(Plates, ParallelRectangle) {
    SceneBuilder builder;
    builder.add({Shape::Kind::quad, vec3(1)}, glm::rotate(glm::translate(mat4(1.0f), vec3(0, 0.5f, 0)), glm::pi<float>(), vec3(1, 0, 0)), vec3(albedo));
    builder.add({Shape::Kind::quad, vec3(1)}, mat4(1.0f), vec3(0.0f));
    // One-sided quads: light from below passes the floor and meets the plate's lower face.
    builder.add(sun(vec3(0, 1, 0)));
    builder.look(vec3(0, 0.45f, 0), vec3(0, -1, 0), vec3(0, 0, -1), 1.6f);
    builder.use(method().gi);
    const Errors errors = errors_against(render_irradiance(*renderer, builder.scene(), method().pixels, method().pixels), [&](vec3 p) {
        return albedo * illuminance * parallel(-0.5 - p.x, 0.5 - p.x, -0.5 - p.z, 0.5 - p.z, 0.5 - p.y);
    });
    EXPECT_GT(errors.count, 100);
    EXPECT_LT(errors.worst, method().parallel);
    EXPECT_LT(std::abs(errors.bias), method().bias);
}

TEST_P(Plates, DiscOnItsAxis) {
    SceneBuilder builder;
    builder.add({Shape::Kind::disc, vec3(1, 0, 1)}, glm::rotate(glm::translate(mat4(1.0f), vec3(0, 0.3f, 0)), glm::pi<float>(), vec3(1, 0, 0)), vec3(albedo));
    builder.add({Shape::Kind::quad, vec3(1)}, mat4(1.0f), vec3(0.0f));
    builder.add(sun(vec3(0, 1, 0)));
    builder.look(vec3(0, 0.25f, 0), vec3(0, -1, 0), vec3(0, 0, -1), 0.01f);
    builder.use(method().gi);
    const double truth = albedo * illuminance * closed_form::disc(0.5, 0.3);
    const Errors errors = errors_against(render_irradiance(*renderer, builder.scene(), 3, 3), [&](vec3) { return truth; });
    EXPECT_EQ(errors.count, 9);
    EXPECT_LT(errors.worst, method().disc) << "the mesh is a polygon of 64 corners, 0.16 % smaller than the disc";
    EXPECT_LT(std::abs(errors.bias), method().bias) << "the mesh is a polygon of 64 corners, 0.16 % smaller than the disc";
}

TEST_P(Plates, PerpendicularWallFromMidRoom) {
    SceneBuilder builder;
    corner_scene(builder, 1.0f);
    builder.look(vec3(0, 0.9f, 0.5f), vec3(0, -1, 0), vec3(0, 0, -1), 0.9f);
    const Errors errors = corner_errors(builder, 1.0f, 0.08f, 1.0f);
    EXPECT_GT(errors.count, 100);
    EXPECT_LT(errors.worst, method().wall);
    EXPECT_LT(std::abs(errors.bias), method().bias);
}

TEST_P(Plates, PerpendicularWallDownToTheCorner) {
    SceneBuilder builder;
    corner_scene(builder, 1.0f);
    // From 0.5 mm to 2 cm before the wall: a quarter of a texel to ten texels of the 512² map.
    builder.look(vec3(0.013f, 0.02f, 0.0101f), vec3(0, -1, 0), vec3(0, 0, -1), 0.9f);
    const Errors errors = corner_errors(builder, 1.0f, method().corner_from, 0.02f);
    EXPECT_GT(errors.count, 100);
    EXPECT_LT(errors.worst, method().corner);
    EXPECT_LT(std::abs(errors.bias), method().bias);
}

class LightMaps : public GlTest {};

TEST_F(LightMaps, SpotLightFluxIsRightOffTheAxis) {
    // A spot light on a plate: total reflected flux is ρ times what arrives, ∫ I cos³θ / h² dA over the plate.
    SceneBuilder builder;
    builder.add({Shape::Kind::quad, vec3(2)}, mat4(1.0f), vec3(albedo));
    builder.add({.kind = RenderScene::Light::Kind::spot, .position = vec3(0, 1, 0), .direction = vec3(0, -1, 0), .intensity = vec3(100.0f),
                 .inner_cone = 1.2f, .outer_cone = 1.2f, .bounces = true, .shadow_size = 512});
    builder.look(vec3(0, 3, 0), vec3(0, -1, 0), vec3(0, 0, -1), 1.0f);
    builder.use(RsmExact{.rsm_size = 512});
    (void)renderer->render(builder.scene(), {.width = 4, .height = 4, .wanted = {"rsm_flux"}});
    const Image flux = renderer->read(renderer->find_image("rsm_flux"), 0);
    double total = 0.0;
    for (std::size_t i = 0; i < flux.data.size(); i += 4) total += flux.data[i + 1];
    // From a point at height h over its centre a square of side 2h covers a sixth of the sphere.
    EXPECT_NEAR(total, albedo * 100.0 * 4.0 * M_PI / 6.0, 0.005 * albedo * 100.0 * 4.0 * M_PI / 6.0);
}

TEST_P(Plates, ScaleDoesNotMatter) {
    for (const float scale : {1e-3f, 1.0f, 1e3f}) {
        SceneBuilder builder;
        corner_scene(builder, scale);
        for (auto& light : builder.scene().lights) light.shadow_distance = 100.0f * scale;
        builder.look(vec3(0, 0.9f, 0.5f) * scale, vec3(0, -1, 0), vec3(0, 0, -1), 0.9f);
        builder.scene().view->near = 1e-3f * scale;
        const Errors errors = corner_errors(builder, scale, 0.08f * scale, scale);
        EXPECT_GT(errors.count, 100) << "scale " << scale;
        EXPECT_LT(errors.worst, method().wall) << "scale " << scale;
        EXPECT_LT(std::abs(errors.bias), method().bias) << "scale " << scale;
    }
}

std::vector<PlateMethod> plate_methods() {
    return {{.name = "rsm_exact", .gi = RsmExact{.rsm_size = 512}, .parallel = 0.005, .disc = 0.005, .wall = 0.005, .corner = 0.005, .bias = 0.003},
            // A spiral of 4096 points over 262,144 texels, dense round the receiver alone: measured 0.65 %, 0.13 % and 0.63 %.
            // Nearer to the wall than two texels the disc of a texel's area is no longer the wall at its foot, and nothing
            // corrects that: there it claims nothing. Just outside, measured 2.9 %.
            {.name = "rsm_disc", .gi = RsmDisc{.rsm_size = 512, .samples = 4096, .radius = 1.5f, .interpolate = false}, .parallel = 0.01, .disc = 0.003, .wall = 0.01, .corner = 0.05, .bias = 0.005, .corner_from = 0.004f},
            // A corner of a facet may be off by its standard error of 1.5 %, and the worst of some hundred are by 2.6 times that. Between corners a
            // chord stands for a curve: nine facets across the parallel plate's receiver cost 0.4 % of its light.
            {.name = "facets", .gi = Facets{.spacing = 4.0f, .noise = 0.015f}, .pixels = 36, .parallel = 0.04, .disc = 0.04, .wall = 0.04, .corner = 0.04, .bias = 0.01}};
}
INSTANTIATE_TEST_SUITE_P(All, Plates, testing::ValuesIn(plate_methods()), [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace sl
