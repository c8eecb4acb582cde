// SPDX-License-Identifier: MIT
// What surfaces make of indirect light: exact where it comes evenly from everywhere.
#include <glm/gtc/matrix_transform.hpp>

#include "engine/render/trace/directions.h"
#include "engine/render/trace/mean_albedo.h"
#include "engine/render/trace/samples.h"
#include "shared/specular_lobe.h"
#include "tests/support/gl_test.h"
#include "tests/support/scene_builder.h"

namespace sl {
namespace {

constexpr float sky = 1000.0f;

Surface surface_of(const Material& material, vec3 normal) {
    return {.base_colour = vec4(material.base_colour, material.roughness), .normal = vec4(normal, material.metallic), .specular = vec4(material.specular, 0, 0, 0)};
}

/// The BRDF's own integral, by directions that know nothing of its lobe.
vec3 albedo_towards(const Surface& surface, vec3 to_eye) {
    constexpr std::uint32_t count = 1 << 17;
    const mat3 basis = basis_around(vec3(surface.normal));
    dvec3 sum(0.0);
    for (std::uint32_t i = 0; i < count; ++i) {
        const vec3 local = cosine_direction(SampleSequence(1, uvec2(0), i).pair());
        if (local.z > 0.0f) sum += dvec3(reflected(surface, basis * local, to_eye) * (pi / local.z));
    }
    return vec3(sum / double{count});
}

/// A floor under a sky and nothing else.
class EvenLight : public GlTest {
  protected:
    void look_at(const Material& material, vec3 direction) {
        builder.emplace();
        builder->add(make_shape_mesh({Shape::Kind::box, vec3(400, 1, 400)}), glm::translate(mat4(1.0f), vec3(0, -0.5f, 0)), material);
        builder->scene().sky_radiance = vec3(sky);
        builder->look(-3.0f * direction, direction, vec3(0, 0, -1), 0.02f);
        builder->use(Facets{});
    }
    Image draw(const std::string& image) {
        renderer.render(builder->scene(), {.width = 9, .height = 9, .wanted = {image}});
        return renderer.read(renderer.find_image(image));
    }
    bool has_pass(const std::string& name) const {
        return std::ranges::any_of(renderer.steps(), [&](const Step& step) { return renderer.graph().passes()[static_cast<std::size_t>(step.pass)].name == name; });
    }

    std::optional<SceneBuilder> builder;
    Renderer renderer{shader_folder()};
};

TEST_F(EvenLight, IsReflectedAsTheBrdfSays) {
    const vec3 steep(0, -1, 0), slanting = glm::normalize(vec3(0.3f, -0.5f, 1)), grazing = glm::normalize(vec3(1, -0.2f, 0.1f));
    // Colours that 8 bits hold.
    const vec3 white(1), copper(1.0f, 0.5029f, 0.1095f);
    struct Case {
        Material material;
        vec3 direction;
    };
    for (const Case& it : {Case{{.base_colour = white, .metallic = 1, .roughness = 1.0f}, steep}, Case{{.base_colour = copper, .metallic = 1, .roughness = 0.6f}, slanting},
                           Case{{.base_colour = copper, .metallic = 1, .roughness = 0.4f}, grazing}, Case{{.base_colour = copper, .metallic = 0, .roughness = 0.4f}, grazing},
                           Case{{.base_colour = vec3(0), .metallic = 0, .roughness = 0.6f}, slanting}, Case{{.base_colour = copper, .metallic = 0.4f, .roughness = 0.8f, .specular = 0.6f}, slanting},
                           Case{{.base_colour = copper, .specular = 0}, slanting}}) {
        look_at(it.material, it.direction);
        const Image drawn = draw("hdr");
        const vec3 expected = sky * albedo_towards(surface_of(it.material, vec3(0, 1, 0)), -it.direction);
        const float* pixel = drawn.pixel(4, 4);
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(pixel[i], expected[i], 0.01f * sky) << "channel " << i << ", roughness " << it.material.roughness << ", metallic " << it.material.metallic;
    }
}

TEST_F(EvenLight, AMatteSceneNeedsNoLobe) {
    look_at(SceneBuilder::matte(vec3(0.5f)), vec3(0, -1, 0));
    draw("hdr");
    EXPECT_FALSE(has_pass("specular_lobe"));
}

TEST_F(EvenLight, TheLobeIsDrawnOnce) {
    look_at(Material{}, vec3(0, -1, 0));
    draw("hdr");
    EXPECT_TRUE(has_pass("specular_lobe"));
    draw("hdr");
    EXPECT_FALSE(has_pass("specular_lobe"));
}

TEST_F(EvenLight, AllViewsTogetherAreTheMeanAlbedo) {
    look_at(Material{}, vec3(0, -1, 0));
    const Image lobe = draw("specular_lobe");
    ASSERT_EQ(lobe.width, specular_lobe_size);
    const Material metal{.base_colour = vec3(0.5f), .metallic = 1};
    for (const std::uint32_t row : {0u, 10u, 20u, 31u}) {
        Surface surface = surface_of(metal, vec3(0, 0, 1));
        surface.base_colour.w = 1.0f - static_cast<float>(row) / (specular_lobe_size - 1);  // images begin above
        float sum = 0.0f;
        for (std::uint32_t i = 0; i + 1 < specular_lobe_size; ++i) {
            // Views in proportion to their cosine: between two columns lies the difference of n·v squared.
            const auto cosine_squared = [](std::uint32_t column) { return std::pow(static_cast<float>(column) / (specular_lobe_size - 1), 4.0f); };
            const auto albedo = [&](std::uint32_t column) { return albedo_in_even_light(surface, vec3(lobe.pixel(column, row)[0], lobe.pixel(column, row)[1], 0.0f)).x; };
            sum += (cosine_squared(i + 1) - cosine_squared(i)) * 0.5f * (albedo(i) + albedo(i + 1));
        }
        EXPECT_NEAR(sum, mean_albedo(surface).x, 0.005f) << surface.base_colour.w;
    }
}

}  // namespace
}  // namespace sl
