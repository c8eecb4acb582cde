// SPDX-License-Identifier: MIT
// The path tracer against answers that are known exactly, in absolute units.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "engine/render/reference/reference.h"
#include "tests/support/closed_forms.h"
#include "tests/support/scene_builder.h"

namespace sl {
namespace {

using Light = RenderScene::Light;

constexpr float illuminance = 1000.0f;

/// Only where it casts shadows do paths from the light take part.
Light sun(vec3 direction, bool casts_shadow = false) {
    return {.kind = Light::Kind::directional, .direction = glm::normalize(direction), .intensity = vec3(illuminance), .casts_shadow = casts_shadow, .bounces = true};
}

const mat4 facing_down = glm::rotate(mat4(1.0f), glm::pi<float>(), vec3(1, 0, 0));
const mat4 facing_front = glm::rotate(mat4(1.0f), glm::half_pi<float>(), vec3(1, 0, 0));

mat4 at(vec3 place, const mat4& turn = mat4(1.0f)) { return glm::translate(mat4(1.0f), place) * turn; }

const ImageLayer& layer(const std::vector<ImageLayer>& layers, std::string_view name) { return *std::ranges::find(layers, name, &ImageLayer::name); }

/// Mean over all pixels of a layer's green channel.
double mean_of(const Film& film, std::string_view name) {
    const auto layers = film.layers();
    const Image& image = layer(layers, name).image;
    double sum = 0.0;
    for (std::size_t i = 0; i < image.data.size(); i += image.channels) sum += image.data[i + (image.channels > 1 ? 1 : 0)];
    return sum / (double(image.width) * image.height);
}

/// A sphere that is seen from inside.
MeshData hollow_sphere(float diameter) {
    MeshData mesh;
    constexpr std::uint32_t rings = 128, sectors = 256;
    for (std::uint32_t r = 0; r <= rings; ++r) {
        for (std::uint32_t s = 0; s <= sectors; ++s) {
            const float theta = pi * float(r) / rings, phi = 2.0f * pi * float(s) / sectors;
            const vec3 out(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
            mesh.vertices.push_back({.position = 0.5f * diameter * out, .normal = pack_normal(-out)});
            mesh.bounds.add(mesh.vertices.back().position);
        }
    }
    const auto index = [](std::uint32_t r, std::uint32_t s) { return r * (sectors + 1) + s; };
    for (std::uint32_t r = 0; r < rings; ++r) {
        for (std::uint32_t s = 0; s < sectors; ++s) {
            for (const std::uint32_t i : {index(r, s), index(r + 1, s), index(r, s + 1), index(r, s + 1), index(r + 1, s), index(r + 1, s + 1)}) mesh.indices.push_back(i);
        }
    }
    return mesh;
}

/// A disc of radius 1 that faces down, so fine that it lacks 3e-5 of its area.
MeshData fine_disc() {
    constexpr std::uint32_t sectors = 512;
    MeshData mesh;
    mesh.vertices.push_back({.position = vec3(0), .normal = pack_normal(vec3(0, -1, 0))});
    for (std::uint32_t s = 0; s < sectors; ++s) {
        const float phi = 2.0f * pi * float(s) / sectors;
        mesh.vertices.push_back({.position = vec3(std::cos(phi), 0, std::sin(phi)), .normal = pack_normal(vec3(0, -1, 0))});
        mesh.bounds.add(mesh.vertices.back().position);
        for (const std::uint32_t i : {0u, 1 + s, 1 + (s + 1) % sectors}) mesh.indices.push_back(i);
    }
    return mesh;
}

TEST(PathTracer, ParallelRectangle) {
    // Lit straight through the receiver, which blocks nothing; and past it, by a light that the receiver would block, so that
    // paths from the light take part. They add noise here: fewer pixels of more samples.
    for (const bool from_the_side : {false, true}) {
        SceneBuilder builder;
        builder.add({Shape::Kind::quad, vec3(1)}, at(vec3(0, 0.5f, 0), facing_down), vec3(0.5f));
        builder.add({Shape::Kind::quad, vec3(1)}, mat4(1.0f), vec3(0.0f));
        const Light light = from_the_side ? sun(vec3(1, 0.3f, 0), true) : sun(vec3(0, 1, 0));
        builder.add(light);
        builder.look(vec3(0, 0.45f, 0), vec3(0, -1, 0), vec3(0, 0, -1), 1.6f);
        const std::uint32_t side = from_the_side ? 4 : 8;
        const auto film_of = [&](bool light_paths, std::uint32_t samples) {
            return trace_film(builder.scene(), uvec2(side), {.bounces = 1, .pixel_area = false, .light_paths = light_paths}, samples);
        };
        const Film film = film_of(true, 1048576 / (side * side));
        const auto layers = film.layers();
        for (std::uint32_t y = 0; y < side; ++y) {
            for (std::uint32_t x = 0; x < side; ++x) {
                const float* p = layer(layers, "position").image.pixel(x, y);
                const double truth = 500.0 * light.direction.y * closed_form::parallel(-0.5 - p[0], 0.5 - p[0], -0.5 - p[2], 0.5 - p[2], 0.5 - p[1]);
                EXPECT_NEAR(layer(layers, "irradiance").image.pixel(x, y)[1], truth, 0.002 * truth) << x << ", " << y;
            }
        }
        const bool took_part = mean_of(film_of(true, 64), "irradiance") != mean_of(film_of(false, 64), "irradiance");
        EXPECT_EQ(took_part, from_the_side);
    }
}

TEST(PathTracer, DiscOnItsAxis) {
    for (const double height : {0.1, 0.6, 3.0}) {
        SceneBuilder builder;
        builder.add(fine_disc(), at(vec3(0, height, 0)), SceneBuilder::matte(vec3(0.5f)));
        builder.add({Shape::Kind::quad, vec3(1)}, mat4(1.0f), vec3(0.0f));
        builder.add(sun(vec3(0, 1, 0)));
        builder.look(vec3(0, 0.09f, 0), vec3(0, -1, 0), vec3(0, 0, -1), 0.001f);
        const double truth = 500.0 * closed_form::disc(1.0, height);
        const Film film = trace_film(builder.scene(), {2, 2}, {.bounces = 1, .pixel_area = false}, 65536);
        EXPECT_NEAR(mean_of(film, "irradiance"), truth, 0.002 * truth) << "height " << height;
    }
}

TEST(PathTracer, PerpendicularWallDownToTheCornerAtAnyScale) {
    for (const float scale : {1e-3f, 1.0f, 1e3f}) {
        SceneBuilder builder;
        builder.add({Shape::Kind::quad, vec3(scale)}, at(vec3(0, 0.5f, 0) * scale, facing_front), vec3(0.5f));
        builder.add({Shape::Kind::quad, vec3(scale, 0, 2 * scale)}, mat4(1.0f), vec3(0.0f));
        builder.add(sun(vec3(0, 0, -1)));
        // From 0.5 mm to 2 cm before a wall of 1 m.
        builder.look(vec3(0.013f, 0.02f, 0.0101f) * scale, vec3(0, -1, 0), vec3(0, 0, -1), 0.9f);
        builder.scene().view->near = 1e-3f * scale;
        const Film film = trace_film(builder.scene(), {8, 8}, {.bounces = 1, .pixel_area = false}, 8192);
        const auto layers = film.layers();
        int compared = 0;
        for (std::uint32_t y = 0; y < 8; ++y) {
            for (std::uint32_t x = 0; x < 8; ++x) {
                const float* p = layer(layers, "position").image.pixel(x, y);
                if (p[1] > 1e-4f * scale || p[2] < 4e-4f * scale) continue;
                const double truth = 500.0 * closed_form::perpendicular(-0.5 * scale - p[0], 0.5 * scale - p[0], scale, p[2]);
                EXPECT_NEAR(layer(layers, "irradiance").image.pixel(x, y)[1], truth, 0.002 * truth) << "scale " << scale << ", z " << p[2];
                ++compared;
            }
        }
        EXPECT_GT(compared, 40);
    }
}

TEST(PathTracer, PathsFromTheLightKeepTheMeanInACorner) {
    // They add noise here, where scattered rays alone meet the wall half the time: so the mean of all pixels is compared.
    SceneBuilder builder;
    builder.add({Shape::Kind::quad, vec3(1)}, at(vec3(0, 0.5f, 0), facing_front), vec3(0.5f));
    builder.add({Shape::Kind::quad, vec3(1, 0, 2)}, mat4(1.0f), vec3(0.0f));
    builder.add(sun(vec3(0, 0, -1), true));
    builder.look(vec3(0, 0.4f, 0.3f), vec3(0, -1, 0), vec3(0, 0, -1), 0.9f);
    for (const bool occlusion : {false, true}) {
        const Film film = trace_film(builder.scene(), {8, 8}, {.bounces = 1, .occlusion = occlusion, .pixel_area = false}, 8192);
        const auto layers = film.layers();
        double truth = 0.0;
        for (std::uint32_t y = 0; y < 8; ++y) {
            for (std::uint32_t x = 0; x < 8; ++x) {
                const float* p = layer(layers, "position").image.pixel(x, y);
                ASSERT_EQ(p[1], 0.0f);
                truth += 500.0 / 64.0 * closed_form::perpendicular(-0.5 - p[0], 0.5 - p[0], 1.0, p[2]);
            }
        }
        EXPECT_NEAR(mean_of(film, "irradiance"), truth, 0.002 * truth) << "occlusion " << occlusion;
    }
}

TEST(PathTracer, WithoutOcclusionEverySurfaceBehindEachOtherCounts) {
    // Two plates of one size over each other, both lit from below: the receiver gets the sum of both form factors.
    SceneBuilder builder;
    for (const float height : {0.5f, 0.8f}) builder.add({Shape::Kind::quad, vec3(1)}, at(vec3(0, height, 0), facing_down), vec3(0.5f));
    builder.add({Shape::Kind::quad, vec3(1)}, mat4(1.0f), vec3(0.0f));
    builder.add(sun(vec3(0, 1, 0)));
    builder.look(vec3(0, 0.45f, 0), vec3(0, -1, 0), vec3(0, 0, -1), 0.01f);
    const double near = closed_form::parallel(-0.5, 0.5, -0.5, 0.5, 0.5), far = closed_form::parallel(-0.5, 0.5, -0.5, 0.5, 0.8);
    const Film open = trace_film(builder.scene(), {2, 2}, {.bounces = 1, .occlusion = false}, 16384);
    EXPECT_NEAR(mean_of(open, "irradiance"), 500.0 * (near + far), 0.002 * 500.0 * (near + far));
    const Film blocked = trace_film(builder.scene(), {2, 2}, {.bounces = 1}, 16384);
    EXPECT_NEAR(mean_of(blocked, "irradiance"), 500.0 * near, 0.002 * 500.0 * near);
}

TEST(PathTracer, ClosedSphereWithALightInside) {
    // Whatever stands where: E₁ = ρΦ / (4πR²) everywhere, and the geometric series of it for all bounces.
    constexpr double albedo = 0.7, candela = 10.0, radius = 2.0;
    SceneBuilder builder;
    builder.add(hollow_sphere(2.0f * radius), mat4(1.0f), SceneBuilder::matte(vec3(albedo)));
    builder.add({.kind = Light::Kind::point, .position = vec3(0.4f, -0.7f, 0.9f), .intensity = vec3(candela)});
    builder.look(vec3(0.3f, 0.2f, 0.1f), vec3(1, 0.2f, 0.4f), vec3(0, 1, 0), 1.2f);
    const double direct = 4.0 * M_PI * candela / (4.0 * M_PI * radius * radius);
    const Film first = trace_film(builder.scene(), {8, 8}, {.bounces = 1}, 4096);
    EXPECT_NEAR(mean_of(first, "irradiance"), albedo * direct, 0.002 * albedo * direct);
    const Film all = trace_film(builder.scene(), {8, 8}, {}, 8192);
    const double every = albedo / (1.0 - albedo) * direct;
    EXPECT_NEAR(mean_of(all, "irradiance"), every, 0.002 * every);
}

TEST(PathTracer, WhiteFurnace) {
    // A closed room whose walls glow with L and reflect ρ: radiance is L / (1 - ρ) everywhere.
    for (const double albedo : {0.5, 0.9}) {
        SceneBuilder builder;
        Material wall = SceneBuilder::matte(vec3(albedo));
        wall.emission = 3.0f;
        builder.add(hollow_sphere(2.0f), mat4(1.0f), wall);
        builder.look(vec3(0.1f, 0.2f, 0.3f), vec3(1, 0, 0), vec3(0, 1, 0), 1.0f);
        const Film film = trace_film(builder.scene(), {8, 8}, {}, 1536);
        const double radiance = 3.0 / (1.0 - albedo);
        EXPECT_NEAR(mean_of(film, ""), radiance, 0.002 * radiance) << "albedo " << albedo;
        EXPECT_NEAR(mean_of(film, "irradiance"), M_PI * radiance, 0.002 * M_PI * radiance);
    }
}

TEST(PathTracer, WhiteFurnaceOfFiftyReflections) {
    // At an albedo of 0.98 light is reflected 50 times on average, and where a path ends is left to chance: what one brings
    // varies by 0.8 of its mean (measured), so 262,144 of them by 0.15 %, of which three are allowed. A wrong share of what
    // goes on at each reflection would be multiplied by 50. A box, because twelve triangles are met soonest.
    constexpr double albedo = 0.98;
    MeshData box = make_shape_mesh({Shape::Kind::box, vec3(2)});
    for (Vertex& vertex : box.vertices) vertex.normal = pack_normal(-unpack_normal(vertex.normal));
    for (std::size_t i = 0; i < box.indices.size(); i += 3) std::swap(box.indices[i + 1], box.indices[i + 2]);
    SceneBuilder builder;
    Material wall = SceneBuilder::matte(vec3(albedo));
    wall.emission = 3.0f;
    builder.add(box, mat4(1.0f), wall);
    builder.look(vec3(0.1f, 0.2f, 0.3f), vec3(1, 0, 0), vec3(0, 1, 0), 1.0f);
    const Film film = trace_film(builder.scene(), {8, 8}, {}, 4096);
    const double radiance = 3.0 / (1.0 - albedo);
    EXPECT_NEAR(mean_of(film, ""), radiance, 0.005 * radiance);
    EXPECT_NEAR(mean_of(film, "irradiance"), M_PI * radiance, 0.005 * M_PI * radiance);
}

TEST(PathTracer, SkyOnAnOpenPlain) {
    SceneBuilder builder;
    builder.add({Shape::Kind::quad, vec3(10)}, mat4(1.0f), vec3(0.6f));
    builder.scene().sky_radiance = vec3(100.0f);
    builder.look(vec3(0, 1, 0), vec3(0, -1, 0), vec3(0, 0, -1), 1.0f);
    const Film film = trace_film(builder.scene(), {4, 4}, {}, 256);
    EXPECT_NEAR(mean_of(film, "irradiance_sky"), M_PI * 100.0, 1e-3);
    EXPECT_NEAR(mean_of(film, ""), 60.0, 1e-3);
}

TEST(PathTracer, DirectLightInLuxCandelaAndNit) {
    // A plane of albedo 0.5, looked at from above its foot point; radiance is ρ E / π.
    const auto radiance_under = [](const Light& light) {
        SceneBuilder builder;
        builder.add({Shape::Kind::quad, vec3(10)}, mat4(1.0f), vec3(0.5f));
        builder.add(light);
        builder.look(vec3(0, 1, 0), vec3(0, -1, 0), vec3(0, 0, -1), 1e-3f);
        return mean_of(trace_film(builder.scene(), {1, 1}, {.bounces = 0, .pixel_area = false}, 4), "") * M_PI / 0.5;
    };
    EXPECT_NEAR(radiance_under(sun(vec3(0, -1, 0))), 1000.0, 1e-2);
    EXPECT_NEAR(radiance_under(sun(vec3(0, -1, 1))), 1000.0 * std::cos(M_PI / 4), 1e-2);
    // A point light: I cos θ / d².
    Light point{.kind = Light::Kind::point, .position = vec3(1.5f, 2, 0), .intensity = vec3(500)};
    const double d2 = 1.5 * 1.5 + 4.0;
    EXPECT_NEAR(radiance_under(point), 500.0 * (2.0 / std::sqrt(d2)) / d2, 1e-3);
    // With glTF's range: times clamp(1 - (d/r)⁴).
    point.range = 3.0f;
    EXPECT_NEAR(radiance_under(point), 500.0 * (2.0 / std::sqrt(d2)) / d2 * (1.0 - d2 * d2 / 81.0), 1e-3);
    // A spot light whose edge lies on the point: glTF's angular attenuation, squared.
    Light spot{.kind = Light::Kind::spot, .position = vec3(1.5f, 2, 0), .direction = vec3(0, -1, 0), .intensity = vec3(500), .inner_cone = 0.4f, .outer_cone = 0.9f};
    const double cosine = 2.0 / std::sqrt(d2);
    const double ramp = (cosine - std::cos(0.9)) / (std::cos(0.4) - std::cos(0.9));
    EXPECT_NEAR(radiance_under(spot), 500.0 * cosine / d2 * ramp * ramp, 1e-3);
    // A glowing square of 2 m, 1 m above: its radiosity π L times the form factor.
    SceneBuilder builder;
    Material lamp = SceneBuilder::matte(vec3(0.0f));
    lamp.emission = 200.0f;
    builder.add(make_shape_mesh({Shape::Kind::quad, vec3(2)}), at(vec3(0, 1, 0), facing_down), lamp);
    builder.add({Shape::Kind::quad, vec3(10)}, mat4(1.0f), vec3(0.5f));
    builder.look(vec3(0, 0.5f, 0), vec3(0, -1, 0), vec3(0, 0, -1), 1e-3f);
    const double lit = M_PI * 200.0 * closed_form::parallel(-1, 1, -1, 1, 1);
    const Film film = trace_film(builder.scene(), {2, 2}, {.bounces = 0}, 4096);
    EXPECT_NEAR(mean_of(film, "irradiance_emission"), lit, 0.002 * lit);
    EXPECT_NEAR(mean_of(film, "") * M_PI / 0.5, lit, 0.002 * lit);
}

TEST(PathTracer, ASmoothMetalInAUniformSkyNeverShinesMoreThanTheSky) {
    for (const float roughness : {0.05f, 0.3f, 0.7f, 1.0f}) {
        SceneBuilder builder;
        Material metal;
        metal.base_colour = vec3(1.0f);
        metal.metallic = 1.0f;
        metal.roughness = roughness;
        builder.add(make_shape_mesh({Shape::Kind::sphere, vec3(2)}), mat4(1.0f), metal);
        builder.scene().sky_radiance = vec3(1.0f);
        builder.look(vec3(0, 0, 3), vec3(0, 0, -1), vec3(0, 1, 0), 0.3f);
        const double radiance = mean_of(trace_film(builder.scene(), {4, 4}, {}, 4096), "");
        EXPECT_LT(radiance, 1.003) << "roughness " << roughness;
        // What bounces between its facets is lost: nothing for a mirror, at most ln 2 for alpha 1 (seen straight on).
        EXPECT_GT(radiance, roughness < 0.4f ? 0.97 : 1.0 - std::log(2.0)) << "roughness " << roughness;
    }
}

TEST(PathTracer, BlockedLightIsBlack) {
    // A roof over the receiver, the sun above it, nothing else: no light gets under it without a bounce.
    SceneBuilder builder;
    builder.add({Shape::Kind::box, vec3(20, 0.5f, 20)}, at(vec3(0, 2, 0)), vec3(0.5f));
    builder.add({Shape::Kind::quad, vec3(2)}, mat4(1.0f), vec3(0.5f));
    Light light = sun(vec3(0.3f, -1, 0));
    light.casts_shadow = true;
    builder.add(light);
    builder.look(vec3(0, 1, 0), vec3(0, -1, 0), vec3(0, 0, -1), 0.5f);
    const Film film = trace_film(builder.scene(), {4, 4}, {}, 64);
    EXPECT_EQ(mean_of(film, "direct"), 0.0);
}

}  // namespace
}  // namespace sl
