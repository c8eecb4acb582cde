// SPDX-License-Identifier: MIT
// shared/facets.h on the GPU against the same text compiled as C++: a pixel must look in the very cell that was filled for it.
#include <random>

#include <glm/gtx/component_wise.hpp>

#include "engine/core/math.h"
#include "shared/facets.h"
#include "tests/shader/library_fixture.h"

namespace sl {
namespace {

constexpr std::size_t count = 20000;

class FacetCells : public LibraryTest {
  protected:
    std::vector<vec4> run(const std::string& body) {
        return compute("#include \"shared/facets.h\"\nlayout(std430) readonly buffer Positions { vec4 positions[]; };\n"
                       "layout(std430) readonly buffer Normals { vec4 normals[]; };\n",
                       "    vec4 position = positions[i];\n    vec4 normal = normals[i];\n" + body, count);
    }
    /// Places as far off as the renderer's coordinates go, and levels from millimetres to kilometres; among the normals the
    /// six axes and all that lie halfway between two.
    void SetUp() override {
        LibraryTest::SetUp();
        std::mt19937 engine(7);
        std::uniform_real_distribution<float> signed_one(-1.0f, 1.0f);
        std::uniform_int_distribution<int> level(-10, 10), step(-1, 1);
        for (std::size_t i = 0; i < count; ++i) {
            const float reach = std::exp2(signed_one(engine) * 10.0f);
            positions.emplace_back(reach * vec3(signed_one(engine), signed_one(engine), signed_one(engine)), static_cast<float>(level(engine)));
            vec3 normal(signed_one(engine), signed_one(engine), signed_one(engine));
            if (i % 4 == 0) normal = vec3(step(engine), step(engine), step(engine));
            if (glm::length(normal) < 0.1f) normal = vec3(0, 1, 0);
            normals.emplace_back(glm::normalize(normal), std::exp2(signed_one(engine) * 20.0f));
        }
        give("Positions", positions);
        give("Normals", normals);
    }

    std::vector<vec4> positions;  ///< w: level
    std::vector<vec4> normals;    ///< w: distance from the camera, m
};

/// Each half of a name in two parts that a float holds.
vec4 parts(uvec4 name) { return vec4(name.x >> 16, name.x & 0xffffu, name.y >> 16, name.y & 0xffffu); }

TEST_F(FacetCells, HaveTheSameNamesOnBothSides) {
    const auto names = run(
        "    uvec4 name = facet_cell(position.xyz, normal.xyz, position.w).name;\n"
        "    result = vec4(name.x >> 16, name.x & 0xffffu, name.y >> 16, name.y & 0xffffu);\n");
    std::size_t on_a_plane = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const vec3 position(positions[i]), normal(normals[i]);
        if (names[i] == parts(facet_cell(position, normal, positions[i].w).name)) continue;
        // Right on a plane of the lattice the last bit decides, and a compiler may round once where another rounds twice.
        const float height = facet_axes(position, facet_axis(normal)).z * std::exp2(3.0f - positions[i].w);
        const float off = height + (facet_axes(normal, facet_axis(normal)).z < 0.0f ? -0.2929f : 0.2929f);
        EXPECT_LT(std::abs(off - std::round(off)), 1e-6f * std::max(std::abs(off), 1.0f)) << "point " << i;
        ++on_a_plane;
    }
    EXPECT_LT(on_a_plane, count / 1000);
}

TEST_F(FacetCells, HavePointsAtTheSamePlacesOnBothSides) {
    const auto places = run("    result = facet_cell(position.xyz, normal.xyz, position.w).within;\n");
    for (std::size_t i = 0; i < count; ++i) {
        const vec4 within = facet_cell(vec3(positions[i]), vec3(normals[i]), positions[i].w).within;
        ASSERT_EQ(places[i], within) << "point " << i;
        ASSERT_TRUE(within.x >= 0.0f && within.x <= 1.0f && within.y >= 0.0f && within.y <= 1.0f) << "point " << i;
    }
}

TEST_F(FacetCells, HaveTheSameSizeOnBothSides) {
    const auto levels = run("    result.x = facet_level(normal.w, 0.0123);\n    result.y = float(facet_axis(normal.xyz));\n");
    for (std::size_t i = 0; i < count; ++i) {
        EXPECT_EQ(levels[i].y, static_cast<float>(facet_axis(vec3(normals[i])))) << "point " << i;
        const float level = facet_level(normals[i].w, 0.0123f);
        if (levels[i].x == level) continue;
        // Graphics cards take the logarithm of what is nearly a power of two for that of the power.
        const float exact = std::log2(normals[i].w * 0.0123f);
        EXPECT_LT(std::abs(exact - std::round(exact)), 1e-5f) << "distance " << normals[i].w;
    }
}

TEST_F(FacetCells, AreLookedForFromTheSameSlots) {
    const auto slots = run(
        "    uvec4 name = facet_cell(position.xyz, normal.xyz, position.w).name;\n    uint slot = facet_slot(name.x, name.y);\n"
        "    result = vec4(slot >> 16, slot & 0xffffu, facet_slot(i * 2654435761u, i) >> 16, facet_slot(i * 2654435761u, i) & 0xffffu);\n");
    const auto names = run(
        "    uvec4 name = facet_cell(position.xyz, normal.xyz, position.w).name;\n"
        "    result = vec4(name.x >> 16, name.x & 0xffffu, name.y >> 16, name.y & 0xffffu);\n");
    for (std::size_t i = 0; i < count; ++i) {
        const uvec4 name(names[i]);
        const std::uint32_t slot = facet_slot((name.x << 16) | name.y, (name.z << 16) | name.w), other = facet_slot(static_cast<std::uint32_t>(i) * 2654435761u, static_cast<std::uint32_t>(i));
        ASSERT_EQ(slots[i], vec4(slot >> 16, slot & 0xffffu, other >> 16, other & 0xffffu)) << "point " << i;
    }
}

TEST_F(FacetCells, HoldTheSameLightOnBothSides) {
    const auto light = run("    result = vec4(facet_light(facet_word(abs(position.xyz))), 0.0);\n");
    for (std::size_t i = 0; i < count; ++i) {
        const vec3 given = abs(vec3(positions[i])), held = facet_light(facet_word(given));
        ASSERT_EQ(vec3(light[i]), held) << "point " << i;
        const float off = glm::compMax(glm::abs(held - given)), brightest = glm::compMax(given);
        ASSERT_LE(off, std::max(brightest / 512.0f, std::exp2(-24.0f))) << "point " << i;
    }
}

TEST(FacetWord, HoldsTheDarkestAndTheBrightest) {
    EXPECT_EQ(facet_light(facet_word(vec3(0.0f))), vec3(0.0f));
    EXPECT_EQ(facet_light(facet_word(vec3(1.0f, 0.5f, 0.25f))), vec3(1.0f, 0.5f, 0.25f));
    EXPECT_EQ(facet_light(facet_word(vec3(65535.0f))), vec3(65408.0f));
    EXPECT_EQ(facet_light(facet_word(vec3(1e9f))), vec3(65408.0f));
    EXPECT_NEAR(facet_light(facet_word(vec3(1e-6f))).x, 1e-6f, 6e-8f);
}

}  // namespace
}  // namespace sl
