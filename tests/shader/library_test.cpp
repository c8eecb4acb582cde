// SPDX-License-Identifier: MIT
// Each function of shader/shared on the GPU against the same text compiled as C++, or against what it must undo. The files of
// shader/lib have tests of their own beside this one.
#include <random>

#include "engine/core/math.h"
#include "shared/brdf.h"
#include "shared/lights.h"
#include "shared/octahedral.h"
#include "shared/rsm.h"
#include "shared/tonemap.h"
#include "tests/shader/library_fixture.h"

namespace sl {
namespace {

constexpr std::size_t count = 4096;

class ShaderLibrary : public LibraryTest {
  protected:
    /// Runs `body`, which turns vec4 a, b into `result`, over all pairs.
    std::vector<vec4> run(const std::string& includes, const std::string& body, const std::vector<vec4>& a, const std::vector<vec4>& b) {
        give("A", a);
        give("B", b);
        return compute(includes + "layout(std430) readonly buffer A { vec4 as[]; };\nlayout(std430) readonly buffer B { vec4 bs[]; };\n",
                       "    vec4 a = as[i];\n    vec4 b = bs[i];\n" + body, a.size());
    }

    std::vector<vec4> random_values(unsigned seed, float low, float high) {
        std::mt19937 engine(seed);
        std::uniform_real_distribution<float> value(low, high);
        std::vector<vec4> values(count);
        for (vec4& v : values) v = vec4(value(engine), value(engine), value(engine), value(engine));
        return values;
    }
    std::vector<vec4> random_directions(unsigned seed) {
        std::vector<vec4> values = random_values(seed, -1.0f, 1.0f);
        for (vec4& v : values) v = vec4(glm::normalize(vec3(v) + vec3(1e-4f)), v.w);
        // The six axes must come back exact, so they are in every set.
        const vec3 axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
        for (std::size_t i = 0; i < 6; ++i) values[i] = vec4(axes[i], 0);
        return values;
    }
};

TEST_F(ShaderLibrary, OctahedralRoundTrip) {
    const auto directions = random_directions(1);
    const auto back = run("#include \"shared/octahedral.h\"\n", "    result = vec4(octahedral_decode(octahedral_encode(a.xyz)), a.w + 0.0 * b.x);", directions, directions);
    for (std::size_t i = 0; i < count; ++i) {
        expect_close(back[i], directions[i], 1e-5f, i);
        expect_close(vec4(octahedral_decode(octahedral_encode(vec3(directions[i]))), 0), vec4(vec3(directions[i]), 0), 1e-5f, i);
    }
}

TEST_F(ShaderLibrary, OctahedralMatchesThePackedVertexNormal) {
    const auto directions = random_directions(2);
    for (std::size_t i = 0; i < count; ++i) {
        const vec3 unpacked = unpack_normal(pack_normal(vec3(directions[i])));
        ASSERT_NEAR(glm::dot(unpacked, vec3(directions[i])), 1.0f, 1e-6f);
        if (i < 6) {
            ASSERT_EQ(unpacked, vec3(directions[i])) << "axes are exact";
        }
    }
}

TEST_F(ShaderLibrary, PackedTexelNormalIsCloseAndExactOnAxes) {
    const auto directions = random_directions(3);
    const auto back = run("#include \"shared/rsm_texel.h\"\n", "    result = vec4(unpack_texel_normal(pack_texel_normal(a.xyz)), 0.0 * b.x);", directions, directions);
    for (std::size_t i = 0; i < count; ++i) {
        ASSERT_GT(glm::dot(vec3(back[i]), vec3(directions[i])), 0.999999f) << "within 0.08 degrees";
        if (i < 6) {
            expect_close(back[i], vec4(vec3(directions[i]), 0), 1e-7f, i);
        }
    }
}

TEST_F(ShaderLibrary, BrdfIsTheSameTextAndNumbers) {
    const auto lights = random_directions(4), eyes = random_directions(5);
    const auto gpu = run("#include \"shared/brdf.h\"\n",
                         "    Surface s = Surface(vec4(0.8, 0.5, 0.2, abs(a.w)), vec4(0, 1, 0, abs(b.w)), vec4(0.7));\n"
                         "    result = vec4(reflected(s, a.xyz, b.xyz), 0);", lights, eyes);
    for (std::size_t i = 0; i < count; ++i) {
        const Surface s{vec4(0.8f, 0.5f, 0.2f, std::abs(lights[i].w)), vec4(0, 1, 0, std::abs(eyes[i].w)), vec4(0.7f)};
        expect_close(gpu[i], vec4(reflected(s, vec3(lights[i]), vec3(eyes[i])), 0), 2e-3f, i);
    }
}

TEST_F(ShaderLibrary, DiffuseReflectionGivesBackItsAlbedo) {
    // ∫ f cos dω over the hemisphere, by a fine grid, is the albedo for a surface without specular part.
    const Surface s{vec4(0.6f, 0.3f, 0.1f, 1.0f), vec4(0, 1, 0, 0), vec4(0)};
    double sum = 0.0;
    constexpr int rings = 200, sectors = 64;
    for (int ring = 0; ring < rings; ++ring) {
        const double cos_theta = (ring + 0.5) / rings, sin_theta = std::sqrt(1 - cos_theta * cos_theta);
        for (int sector = 0; sector < sectors; ++sector) {
            const double phi = 2 * M_PI * sector / sectors;
            sum += reflected(s, vec3(sin_theta * std::cos(phi), cos_theta, sin_theta * std::sin(phi)), vec3(0, 1, 0)).x * 2 * M_PI / (rings * sectors);
        }
    }
    EXPECT_NEAR(sum, 0.6, 1e-4);
}

TEST_F(ShaderLibrary, LightFalloffIsGltfs) {
    LightParams spot{};
    spot.kind = uvec4(light_spot, no_layer, no_layer, 0);
    spot.position = vec4(0, 0, 0, 0);
    spot.direction = vec4(0, 0, -1, 0);
    spot.intensity = vec4(100, 100, 100, 0);
    const float inner = 0.3f, outer = 0.6f;
    const float scale = 1.0f / (std::cos(inner) - std::cos(outer));
    spot.cone = vec4(scale, (1.0f - std::cos(outer)) * scale, 0, 0);
    EXPECT_NEAR(incident_light(spot, vec3(0, 0, -2)).irradiance.x, 25.0f, 1e-4f) << "candela over distance squared";
    const auto at_angle = [&](float angle) { return incident_light(spot, 2.0f * vec3(std::sin(angle), 0, -std::cos(angle))).irradiance.x; };
    EXPECT_NEAR(at_angle(0.29f), 25.0f, 1e-3f);
    EXPECT_EQ(at_angle(0.61f), 0.0f);
    const float ramp = (std::cos(0.45f) - std::cos(outer)) / (std::cos(inner) - std::cos(outer));
    EXPECT_NEAR(at_angle(0.45f), 25.0f * ramp * ramp, 1e-3f);
    spot.position.w = 4.0f;
    EXPECT_NEAR(incident_light(spot, vec3(0, 0, -2)).irradiance.x, 25.0f * (1.0f - 1.0f / 16.0f), 1e-3f) << "the window of its range";
    EXPECT_EQ(incident_light(spot, vec3(0, 0, -4)).irradiance.x, 0.0f);
    EXPECT_TRUE(std::isfinite(incident_light(spot, vec3(0)).irradiance.x)) << "inside the light itself";
}

TEST_F(ShaderLibrary, TexelIrradianceMatchesAndIsBounded) {
    const auto offsets = random_values(6, -2.0f, 2.0f), normals = random_directions(7);
    const auto gpu = run("#include \"shared/rsm.h\"\n", "    result = vec4(texel_irradiance(vec3(3.0), a.xyz, b.xyz, 0.2, vec3(0), vec3(0, 1, 0)), 0);", offsets, normals);
    for (std::size_t i = 0; i < count; ++i) {
        const vec3 cpu = texel_irradiance(vec3(3.0f), vec3(offsets[i]), vec3(normals[i]), 0.2f, vec3(0), vec3(0, 1, 0));
        expect_close(gpu[i], vec4(cpu, 0), 1e-4f, i);
        ASSERT_LE(cpu.x, 3.0f / 0.2f) << "never more than the patch's own radiosity";
    }
    EXPECT_EQ(texel_irradiance(vec3(3.0f), vec3(0), vec3(0, -1, 0), 0.2f, vec3(0), vec3(0, 1, 0)), vec3(0)) << "on the very texel";
}

TEST_F(ShaderLibrary, ParallelogramFormFactorMatchesMonteCarlo) {
    std::mt19937 engine(8);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int trial = 0; trial < 20; ++trial) {
        const auto vector = [&] { return glm::dvec3(unit(engine), unit(engine), unit(engine)); };
        const glm::dvec3 centre = vector() * 1.5 + glm::dvec3(0, 0.6, 0), u = vector() * 0.5, v = vector() * 0.5;
        const glm::dvec3 cross = glm::cross(u, v);
        const double area = 4.0 * glm::length(cross);
        glm::dvec3 facing = glm::normalize(cross);
        if (glm::dot(facing, centre) > 0) facing = -facing;
        double sum = 0.0;
        constexpr int samples = 200000;
        for (int i = 0; i < samples; ++i) {
            const glm::dvec3 p = centre + u * unit(engine) + v * unit(engine);
            const double d2 = glm::dot(p, p);
            sum += std::max(0.0, -glm::dot(facing, p)) * std::max(0.0, p.y) / (M_PI * d2 * d2);
        }
        const double truth = sum / samples * area;
        const float closed = parallelogram_form_factor(vec3(centre), vec3(u), vec3(v), vec3(0, 1, 0));
        EXPECT_NEAR(closed, truth, 0.02 * truth + 2e-4) << "trial " << trial;
    }
}

TEST_F(ShaderLibrary, TonemapKeepsOrderAndRange) {
    float before = -1.0f;
    for (float x = 0.0f; x < 1e6f; x = x * 1.3f + 1e-3f) {
        const float shown = filmic(vec3(x)).x;
        ASSERT_GE(shown, before);
        ASSERT_LE(shown, 1.0f);
        before = shown;
    }
    EXPECT_EQ(filmic(vec3(0)).x, 0.0f);
    EXPECT_EQ(filmic(vec3(std::numeric_limits<float>::max())).x, 1.0f);
    EXPECT_NEAR(srgb_encode(vec3(0.2140411f)).x, 0.5f, 1e-4f);
}

TEST_F(ShaderLibrary, ViewRayUndoesTheProjection) {
    RenderScene scene;
    scene.view = RenderScene::View{.position = vec3(3, 2, 1), .forward = glm::normalize(vec3(1, -0.4f, 0.3f)), .fov_y = 1.1f, .near = 0.02f};
    const FrameParams frame = frame_params(scene, 64, 36, 0);
    for (const vec4& p : random_values(9, -30.0f, 30.0f)) {
        const vec4 clip = frame.clip_from_world * vec4(vec3(p), 1.0f);
        if (clip.w < 0.1f) continue;
        const vec3 back = vec3(frame.camera_position) + view_ray(frame, vec2(clip) / clip.w) * view_distance(clip.z / clip.w, 0.02f);
        ASSERT_LT(glm::length(back - vec3(p)), 1e-4f * (1.0f + clip.w));
    }
}

}  // namespace
}  // namespace sl
