// SPDX-License-Identifier: MIT
// Orthographic cameras of models: what is far away is as large as what is near, drawn and traced.
#include "tests/frames_small/square_model.h"

namespace sl {
namespace {

class OrthographicCameraTest : public SquareModelTest {
  protected:
    void SetUp() override {
        SquareModelTest::SetUp();
        // Two squares beside each other, a near one on the left and a far one on the right.
        json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 0, 1}}}}}, {{"pbrMetallicRoughness", {{"baseColorFactor", {0, 1, 0, 1}}}}}};
        show(square({{"material", 0}}));
        show(square({{"material", 1}}));
        json["nodes"][0]["translation"] = {-1.25, -0.5, 0};
        json["nodes"][1]["translation"] = {0.25, -0.5, -6};
        json["cameras"] = {{{"type", "orthographic"}, {"orthographic", {{"xmag", 1.5}, {"ymag", 1.5}, {"znear", 0.1}, {"zfar", 100}}}}};
        json["nodes"].push_back({{"camera", 0}, {"translation", {0, 0, 2}}});
        json["scenes"][0]["nodes"].push_back(2);
    }
    static constexpr float pixel = 3.0f / static_cast<float>(side);
    static const Prepare& nothing() {
        static const Prepare prepare = [](App&) {};
        return prepare;
    }
};

TEST_F(OrthographicCameraTest, WhatIsFarAwayIsAsLarge) {
    const auto file = write();
    Seen seen = drawn(file, nothing(), "off");
    const Traced rays = traced(file, nothing());
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            const vec2 at = (vec2(x, y) + 0.5f) * pixel - 1.5f;
            const bool high = std::abs(at.y) < 0.5f, near = high && at.x > -1.25f && at.x < -0.25f, far = high && at.x > 0.25f && at.x < 1.25f;
            const vec3 colour(near, far, 0);
            const float* albedo = seen.layers.at("albedo").pixel(x, y);
            EXPECT_EQ(vec3(albedo[0], albedo[1], albedo[2]), colour) << x << " " << y;
            const FirstSurface first = rays.tracer->first_surface({x, y});
            EXPECT_LT(glm::length(first.albedo - colour), 1e-5f) << x << " " << y;
            const vec3 place = near || far ? vec3(at.x, -at.y, near ? 0.0f : -6.0f) : first.position;
            EXPECT_LT(glm::length(first.position - place), 0.2f * pixel) << x << " " << y;
        }
    }
}

TEST_F(OrthographicCameraTest, ItsLightIsThatOfThePathTracer) {
    // The sun that is added casts the near square's shadow nowhere into sight; all else is as bright as rays find it.
    const auto file = write();
    Seen seen = drawn(file, nothing(), "off");
    const Traced rays = traced(file, nothing());
    for (const std::uint32_t x : {12u, 48u}) {
        const float* here = seen.layers.at("direct").pixel(x, side / 2);
        // The sky lights nothing by this method: the sun's part alone.
        EXPECT_GT(here[x == 12u ? 0 : 1], 0.0f);
        EXPECT_LT(here[x == 12u ? 0 : 1], rays.tracer->sample({x, side / 2}, 0).direct[x == 12u ? 0 : 1] * 1.001f);
    }
}

TEST_F(OrthographicCameraTest, FacetsFindTheirLight) {
    Seen seen = drawn(write(), nothing(), "facets");
    for (const std::uint32_t x : {12u, 48u}) EXPECT_GT(seen.layers.at("irradiance").pixel(x, side / 2)[0], 0.0f) << x;
}

TEST_F(OrthographicCameraTest, NothingIsDrawnBeforeItsNearPlane) {
    json["cameras"][0]["orthographic"]["znear"] = 2.5;
    const auto file = write();
    Seen seen = drawn(file, nothing(), "off");
    const Traced rays = traced(file, nothing());
    EXPECT_EQ(seen.layers.at("albedo").pixel(12, side / 2)[0], 0.0f);
    EXPECT_EQ(seen.layers.at("albedo").pixel(48, side / 2)[1], 1.0f);
    EXPECT_EQ(rays.tracer->first_surface({12, side / 2}).albedo, vec3(0.0f));
    EXPECT_EQ(rays.tracer->first_surface({48, side / 2}).albedo, vec3(0, 1, 0));
}

}  // namespace
}  // namespace sl
