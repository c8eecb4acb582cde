// SPDX-License-Identifier: MIT
// Receivers where sums blow up, and walls that light must not pass.
#include "tests/hard_cases/hard_case_test.h"

namespace sl {
namespace {

/// A lit wall of 1 m in the plane z = 0, facing +z, a black floor at its foot.
void corner(SceneBuilder& builder, float scale = 1.0f) {
    builder.add({Shape::Kind::quad, vec3(scale)}, at(vec3(0, 0.5f * scale, 0), facing_front), vec3(0.5f));
    builder.add({Shape::Kind::quad, vec3(scale)}, at(vec3(0, 0, 0.5f * scale)), vec3(0.0f));
    builder.add(sun(vec3(0, 0, -1)));
}

/// Looks straight down on the floor at one spot so small that one value is right for the whole picture.
void look_at_floor(SceneBuilder& builder, vec3 spot, float scale = 1.0f) {
    builder.look((spot + vec3(0, 0.3f, 0)) * scale, vec3(0, -1, 0), vec3(0, 0, -1), 1e-4f);
    builder.scene().view->near = 1e-3f * scale;
}

TEST_P(HardCases, ReceiverInACorner) {
    for (const float distance : {0.1f, 0.001f}) {
        SceneBuilder builder;
        corner(builder);
        look_at_floor(builder, vec3(0.1f, 0, distance));
        const double truth = 500.0 * closed_form::perpendicular(-0.6, 0.4, 1.0, distance);
        // A texel of the 128² map is 1.6 cm. The patch correction makes the exact sum right below that as well; a disc of
        // a texel's area, which is what rsm_disc has, is not the wall at its foot, and most of the light is missing there.
        expect_value(fmt::format("receiver {} mm before a lit wall", 1000.0f * distance), draw(builder).mean_brightness(), truth, {0.02, distance < 0.01f ? 0.9 : 0.1, 0.02});
    }
}

TEST_P(HardCases, ReceiverOnTheTexelThatLightsIt) {
    // A plane does not light itself.
    SceneBuilder builder;
    builder.add({Shape::Kind::quad, vec3(2)}, glm::rotate(mat4(1.0f), 0.4f, glm::normalize(vec3(1, 0.3f, 2))), vec3(1.0f));
    builder.add(sun(vec3(0.2f, -1, 0.1f)));
    builder.look(vec3(0, 1, 0), vec3(0, -1, 0), vec3(0, 0, -1), 1.0f);
    const double share = draw(builder, {16, 12}).mean_brightness() / 1000.0;
    // Normals are rounded to 12 bits in maps and 16 in the G-buffer, so a plane sees itself under up to 10⁻³ rad.
    EXPECT_LT(share, 2e-3);
    survives("receiver on the very texel that lights it: share of its radiosity (truth: 0)", ResultTable::figure(share));
}

TEST_P(HardCases, NearPlaneCutsTheLitWall) {
    SceneBuilder builder;
    corner(builder);
    builder.look(vec3(0, 0.6f, 0.15f), vec3(0, -1, -0.1f), vec3(0, 0, -1), 1.2f);
    const Picture whole = draw(builder, {16, 16});
    builder.scene().view->near = 0.35f;
    const Picture cut = draw(builder, {16, 16});
    const Deviation change = deviation(cut, whole);
    // Maps know nothing of the camera. Depth's rounding moves receivers by 10⁻⁷ of their distance.
    EXPECT_GT(change.outline, 0.05) << "the near plane is meant to cut something off";
    // Facets that the camera does not see any longer are not there, and patches are those that the others' rays met first.
    EXPECT_LT(change.inner, is("facets") ? 0.09 : method().traced() ? 1e-3 : 1e-4);
    survives("near plane cuts the lit wall: change of what is still seen", ResultTable::figure(change.inner));
}

/// A room of 4 m × 3 m × 4 m with walls of 0.5 m round the point (0, 1.5, 0), without a roof.
void add_walls(SceneBuilder& builder) {
    for (const float side : {-2.25f, 2.25f}) {
        builder.add({Shape::Kind::box, vec3(0.5f, 3, 5)}, at(vec3(side, 1.5f, 0)), vec3(0.5f));
        builder.add({Shape::Kind::box, vec3(4, 3, 0.5f)}, at(vec3(0, 1.5f, side)), vec3(0.5f));
    }
}

TEST_P(HardCases, ThinWallsOfAClosedRoom) {
    SceneBuilder builder;
    add_walls(builder);
    builder.add({Shape::Kind::box, vec3(5, 0.5f, 5)}, at(vec3(0, 3.25f, 0)), vec3(0.5f));
    builder.add({Shape::Kind::box, vec3(20, 0.5f, 20)}, at(vec3(0, -0.25f, 0)), vec3(0.5f));
    Light light = sun(vec3(0.5f, -1, 0.3f));
    light.casts_shadow = true;
    builder.add(light);
    builder.look(vec3(-1, 1.5f, -1), vec3(1, 0.1f, 1), vec3(0, 1, 0), 1.2f);
    LightMethod every_bounce = method();
    every_bounce.transport.bounces = TransportSettings::until_converged;
    const double share = draw(builder, {16, 12}, every_bounce).mean_brightness() / (500.0 * std::abs(light.direction.y));
    if (method().traced() || is("facets")) {
        EXPECT_EQ(share, 0.0);
    } else {
        // By design: no texel's light is blocked. What is outside lights the walls inside like an open field.
        EXPECT_GT(share, 0.0);
    }
    EXPECT_LT(share, is("rsm_grid") ? 1e3 : 0.5) << "more than a wall sees of an endless field";
    survives("closed room, walls of 0.5 m: leak, over the radiosity outside (truth: 0)", ResultTable::figure(share));
}

TEST_P(HardCases, KeyholeRoomLitByOneBounce) {
    // Sun through a hole of 0.5 m × 0.5 m in the roof; a point of the ceiling sees the lit patch of the floor alone.
    SceneBuilder builder;
    add_walls(builder);
    for (const float side : {-1.375f, 1.375f}) {
        builder.add({Shape::Kind::box, vec3(2.25f, 0.5f, 5)}, at(vec3(side, 3.25f, 0)), vec3(0.5f));
        builder.add({Shape::Kind::box, vec3(0.5f, 0.5f, 2.25f)}, at(vec3(0, 3.25f, side)), vec3(0.5f));
    }
    builder.add({Shape::Kind::box, vec3(5, 0.5f, 5)}, at(vec3(0, -0.25f, 0)), vec3(0.5f));
    Light light = sun(vec3(0, -1, 0), 100000.0f);
    light.casts_shadow = true;
    builder.add(light);
    builder.look(vec3(1, 1, 0.5f), vec3(0, 1, 0), vec3(0, 0, 1), 1e-3f);
    const double truth = 50000.0 * closed_form::parallel(-1.25, -0.75, -0.75, -0.25, 3.0);
    // The hole is 12.6 texels wide in the map of 128²: one texel row more or less is 8 %, and 16 % in area.
    // Facets light a patch of a metre at 8 × 8 places, so that the hole is 4 wide and 12 on its rim are lit by chance: a
    // standard error of √12 · 0.4 / 16 = 9 %, and nearly three of them.
    expect_value("keyhole room lit by one bounce", draw(builder, {8, 8}, one_bounce()).mean_brightness(), truth, {0.2, 0.4, 0.05, 0.25});
}

TEST_P(HardCases, MillimetresAndKilometres) {
    for (const float scale : {1e-3f, 1e3f}) {
        SceneBuilder builder;
        corner(builder, scale);
        for (auto& light : builder.scene().lights) light.shadow_distance = 100.0f * scale;
        look_at_floor(builder, vec3(0.1f, 0, 0.1f), scale);
        expect_value(fmt::format("a wall of 1 {}", scale < 1.0f ? "mm" : "km"), draw(builder).mean_brightness(), 500.0 * closed_form::perpendicular(-0.6, 0.4, 1.0, 0.1), {0.02, 0.1, 0.02});
    }
}

}  // namespace
}  // namespace sl
