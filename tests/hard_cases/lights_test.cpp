// SPDX-License-Identifier: MIT
// Lights at the ends of their ranges.
#include "tests/hard_cases/hard_case_test.h"

namespace sl {
namespace {

TEST_P(HardCases, GrazingLight) {
    for (const float degrees : {10.0f, 0.5f}) {
        SceneBuilder builder;
        const float angle = glm::radians(degrees);
        builder.add({Shape::Kind::quad, vec3(1)}, at(vec3(0, 0.5f, 0), facing_front), vec3(0.5f));
        builder.add({Shape::Kind::quad, vec3(1, 0, 2)}, mat4(1.0f), vec3(0.0f));
        builder.add(sun(vec3(std::cos(angle), 0, -std::sin(angle))));
        builder.look(vec3(0.1f, 0.3f, 0.2f), vec3(0, -1, 0), vec3(0, 0, -1), 1e-4f);
        const double truth = 500.0 * std::sin(angle) * closed_form::perpendicular(-0.6, 0.4, 1.0, 0.2);
        // Seen under 10° the wall is 10 columns of texels wide in the map, under 0.5° half a column: then one column holds
        // all of it or nothing does.
        expect_value(fmt::format("light at {}° to the wall that it lights", degrees), draw(builder).mean_brightness(), truth, {degrees > 1.0f ? 0.15 : 3.0, degrees > 1.0f ? 0.3 : 3.0, 0.02});
    }
}

TEST_P(HardCases, LightParallelToItsUpVector) {
    for (const float tilt : {0.0f, 9e-4f, 1.1e-3f}) {  // its map picks another up vector below 10⁻³
        SceneBuilder builder;
        builder.add({Shape::Kind::quad, vec3(1)}, at(vec3(0, 0.5f, 0), facing_down), vec3(0.5f));
        builder.add({Shape::Kind::quad, vec3(1)}, mat4(1.0f), vec3(0.0f));
        builder.add(sun(vec3(tilt, 1, 0)));
        builder.look(vec3(0.1f, 0.3f, 0), vec3(0, -1, 0), vec3(0, 0, -1), 1e-4f);
        expect_value(fmt::format("light {} rad off its up vector", tilt), draw(builder).mean_brightness(), 500.0 * closed_form::parallel(-0.6, 0.4, -0.5, 0.5, 0.5), {0.03, 0.1, 0.02});
    }
}

/// A spot light shines down on a floor disc of radius 10 m; the picture is of a plate that faces down, 2 m over the floor.
/// Nothing stands in the light's way, but it casts shadows: only such lights does the path tracer send rays from.
void floor_and_ceiling(SceneBuilder& builder, Light light) {
    light.casts_shadow = true;
    builder.add({Shape::Kind::disc, vec3(20)}, mat4(1.0f), vec3(0.5f));
    builder.add({Shape::Kind::quad, vec3(1)}, at(vec3(0, 2, 0), facing_down), vec3(0.0f));
    builder.add(light);
    builder.look(vec3(0, 1.5f, 0), vec3(0, 1, 0), vec3(0, 0, 1), 1e-3f);
}

/// What arrives at that plate's middle from a light of one candela at height h: E = ∫ ρ/π · w h/(r²+h²)^1.5 · H²/(r²+H²)² dA,
/// with the weight w of the cone.
template <class Weight>
double ceiling_light(double h, double radius, Weight&& weight) {
    constexpr int steps = 100000;
    constexpr double height = 2.0;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double r = (i + 0.5) / steps * radius, d2 = r * r + h * h, e2 = r * r + height * height;
        sum += weight(r) * 0.5 * h / (d2 * std::sqrt(d2)) * height * height / (e2 * e2) * 2.0 * r * radius / steps;
    }
    return sum;
}

TEST_P(HardCases, ConeNearZero) {
    constexpr float cone = 0.005f;
    SceneBuilder hard, soft;
    Light light = spot(vec3(0, 1, 0), vec3(0, -1, 0), 1e6f, cone);
    floor_and_ceiling(hard, light);
    const double edge = std::tan(cone);
    // Facets spread a lit circle over all of its patch, here a square of a metre seen from two: its light seems to come from up
    // to 1.4 m beside the axis.
    constexpr double spread = 0.27;
    // The cone's rim runs through texels: 128 across it are 2.5 % of its area, of which half is in doubt.
    expect_value("spot cone of 0.3° half angle, hard edge", draw(hard).mean_brightness(), 1e6 * ceiling_light(1.0, edge, [](double) { return 1.0; }), {0.03, 0.1, 0.02, spread});
    light.inner_cone = 0.0f;
    floor_and_ceiling(soft, light);
    // glTF's edge: the square of a ramp in the cosine.
    const auto ramp = [&](double r) { return std::pow(1.0 - (1.0 - std::cos(std::atan(r))) / (1.0 - std::cos(double{cone})), 2.0); };
    expect_value("spot cone of 0.3° half angle, soft edge", draw(soft).mean_brightness(), 1e6 * ceiling_light(1.0, edge, ramp), {0.03, 0.1, 0.02, spread});
    // On the axis a narrow light is as bright as any other: E = I / h².
    soft.look(vec3(0, 0.5f, 0), vec3(0, -1, 0), vec3(0, 0, 1), 1e-5f);
    const double radiance = draw(soft).hdr[36].y, truth = 1e6 * 0.5 / pi;
    hard_case_table().say("the same, direct light on its axis", method().name, ResultTable::figure(std::abs(radiance / truth - 1.0)));
    EXPECT_NEAR(radiance, truth, 0.01 * truth) << "an albedo of 0.5 is stored in 8 bits as 0.497";
}

TEST_P(HardCases, NarrowCone) {
    constexpr float cone = 0.05f;
    SceneBuilder builder;
    floor_and_ceiling(builder, spot(vec3(0, 1, 0), vec3(0, -1, 0), 1e4f, cone));
    LightMethod with = method();
    with.samples = 8192;
    const double truth = 1e4 * ceiling_light(1.0, std::tan(cone), [](double) { return 1.0; });
    // The rest of the circle is left to scattered paths, of which one in 1600 meets any of it: 524,288 paths, 330 hits, 5 %
    // where rays from the light found nothing at all.
    expect_value("spot cone of 3° half angle, hard edge", draw(builder, {8, 8}, with).mean_brightness(), truth, {0.03, 0.1, 0.05, 0.27});
}

TEST_P(HardCases, ConeNear180Degrees) {
    constexpr float cone = 1.5533f;  // the largest that the component takes: 89°
    SceneBuilder builder;
    floor_and_ceiling(builder, spot(vec3(0, 1, 0), vec3(0, -1, 0), 1000.0f, cone));
    // A texel of this map is 0.9 m on a floor 1 m below: the brightest metre of the floor is four texels.
    expect_value("spot cone of 89° half angle", draw(builder).mean_brightness(), 1000.0 * ceiling_light(1.0, 10.0, [](double) { return 1.0; }), {0.1, 0.1, 0.01});
}

TEST_P(HardCases, LightTouchingASurface) {
    SceneBuilder above, on;
    // 10⁸ lux on a circle of 1 mm: more than half floats hold in any unit that is good for the rest of the scene.
    floor_and_ceiling(above, spot(vec3(0, 1e-3f, 0), vec3(0, -1, 0), 100.0f, 0.7f));
    expect_value("spot light 1 mm over the floor", draw(above).mean_brightness(), 100.0 * ceiling_light(1e-3, 1e-3 * std::tan(0.7), [](double) { return 1.0; }), {0.03, 0.1, 0.02, 0.27});  // spread as above
    floor_and_ceiling(on, spot(vec3(0, 0, 0), vec3(0, -1, 0), 100.0f, 0.7f));
    (void)draw(on);
    survives("spot light in the floor's plane");
}

TEST_P(HardCases, LightInsideABox) {
    const auto lit = [&](bool boxed) {
        SceneBuilder builder;
        Light light = spot(vec3(0, 1, 0), vec3(0, -1, 0), 1000.0f, 0.7f);
        light.casts_shadow = true;
        if (boxed) builder.add({Shape::Kind::box, vec3(0.2f)}, at(vec3(0, 1, 0)), vec3(0.5f));
        floor_and_ceiling(builder, light);
        builder.look(vec3(1, 1.5f, 1), vec3(-1, 0.5f, -1), vec3(0, 1, 0), 0.1f);
        return draw(builder).mean_brightness();
    };
    const double leak = lit(true) / lit(false);
    if (method().traced() || is("facets")) {
        EXPECT_EQ(leak, 0.0);
    }
    EXPECT_LE(leak, 1.01);
    survives("light inside a closed box: what gets out (truth: 0)", ResultTable::figure(leak));
}

TEST_P(HardCases, SunBesideACandle) {
    // The floor faces up like everything that the sun lights, so that its indirect light is the candle's, off the wall.
    const auto candle_light = [&](float sun_lux) {
        SceneBuilder builder;
        builder.add({Shape::Kind::quad, vec3(1)}, at(vec3(0, 0.5f, 0), facing_front), vec3(0.5f));
        builder.add({Shape::Kind::quad, vec3(4)}, mat4(1.0f), vec3(0.9f));
        if (sun_lux > 0.0f) builder.add(sun(vec3(0, -1, 0), sun_lux));
        builder.add(spot(vec3(0, 0.5f, 1), vec3(0, 0, -1), 1.0f, 0.4f));
        builder.look(vec3(0, 0.5f, 0.3f), vec3(0, -1, 0), vec3(0, 0, -1), 1e-4f);
        LightMethod with = one_bounce();
        // Two lights share the samples.
        if (auto* disc = is("rsm_disc") ? with.gi->get_if<RsmDisc>() : nullptr) disc->samples = sun_lux > 0.0f ? 4096 : 2048;
        return draw(builder, {8, 8}, with).mean_brightness();
    };
    const double alone = candle_light(0.0f);
    EXPECT_GT(alone, 0.0);
    // The path tracer draws one light per vertex, but the sun brings nothing to the wall.
    expect_value("candle of 1 cd beside a sun of 10⁵ lux", candle_light(1e5f), alone, {1e-3, 1e-3, 1e-3, 0.09});
}

TEST_P(HardCases, LightsThatChangeEveryFrame) {
    SceneBuilder builder;
    floor_and_ceiling(builder, spot(vec3(0, 1, 0), vec3(0, -1, 0), 1000.0f, 0.7f));
    builder.scene().lights.insert(builder.scene().lights.begin(), sun(vec3(0, -1, 0)));
    Light& lamp = builder.scene().lights[1];
    const std::vector<std::function<void()>> changes{
        [&] { lamp.position.y = 0.5f; }, [&] { lamp.intensity = vec3(1, 2, 3); }, [&] { lamp.outer_cone = 0.9f; }, [&] { lamp.range = 1.0f; },
        [&] { lamp.bounces = false; }, [&] { lamp.bounces = true; }, [&] { lamp.casts_shadow = true; },
        [&] { builder.scene().lights[0].direction = glm::normalize(vec3(1, -1, 0)); }, [&] { builder.scene().lights.pop_back(); }, [&] { builder.scene().lights.clear(); }};
    for (std::size_t i = 0; i < changes.size(); ++i) {
        changes[i]();
        const Picture cached = next_frame(builder, {8, 8}, rough());
        renderer->forget();
        expect_same(cached, draw(builder, {8, 8}, rough()), i);
    }
    survives("lights that change every frame", is("facets") ? "as drawn anew, within noise" : "same bytes as drawn anew");
}

TEST_P(HardCases, GeometryThatChangesEveryFrame) {
    SceneBuilder builder;
    builder.add({Shape::Kind::quad, vec3(4)}, mat4(1.0f), vec3(0.5f));
    builder.add({Shape::Kind::box, vec3(1)}, at(vec3(0.5f, 0.5f, 0)), vec3(0.7f, 0.2f, 0.2f));
    builder.add({Shape::Kind::box, vec3(0.5f)}, at(vec3(-0.6f, 0.25f, 0.4f)), vec3(0.2f, 0.7f, 0.2f));
    Light light = sun(vec3(-1, -1, -0.5f)), lamp = spot(vec3(0, 3, 1), vec3(0, -1, -0.3f), 1000.0f, 0.7f);
    light.casts_shadow = lamp.casts_shadow = true;
    builder.add(light);
    builder.add(lamp);
    builder.look(vec3(-1, 1.5f, 2), vec3(1, -0.8f, -2), vec3(0, 1, 0), 0.9f);
    const auto box = [](vec3 size) { return make_shape_mesh({Shape::Kind::box, size}); };
    const std::vector<std::function<void()>> changes{
        [&] { builder.move(1, at(vec3(0.3f, 0.5f, 0))); },
        [&] { builder.move(1, at(vec3(0.3f, 0.8f, 0.2f), glm::rotate(mat4(1.0f), 0.5f, vec3(1, 2, 3)))); },
        [&] { builder.replace(2, box(vec3(0.5f, 1.0f, 0.5f)), at(vec3(-0.6f, 0.5f, 0.4f))); },  // as a block put on another
        [&] { builder.replace(2, box(vec3(0.5f)), at(vec3(-0.6f, 0.25f, 0.4f))); },
        [&] { builder.move(2, glm::scale(at(vec3(-0.6f, 0.25f, 0.4f)), vec3(2, 1, 1))); },
        [&] { builder.move(2, at(vec3(-6, 0.25f, 0.4f))); },  // the scene, and with it the sun's map, grows
        [&] { builder.scene().draws.pop_back(); }};
    Picture before = draw(builder, {8, 8}, rough());
    for (std::size_t i = 0; i < changes.size(); ++i) {
        changes[i]();
        const Picture cached = next_frame(builder, {8, 8}, rough());
        renderer->forget();
        expect_same(cached, draw(builder, {8, 8}, rough()), i);
        EXPECT_FALSE(same_bytes(cached, before)) << "change " << i << " changes nothing";
        before = cached;
    }
    survives("geometry that changes every frame", is("facets") ? "as drawn anew, within noise" : "same bytes as drawn anew");
}

}  // namespace
}  // namespace sl
