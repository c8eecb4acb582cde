// SPDX-License-Identifier: MIT
// Light is linear: twice the light, the sum of two lights, and colours that do not mix. And a frame is repeatable.
#include "tests/relations/relation_test.h"

namespace sl {
namespace {

TEST_P(Relations, TwiceTheLightGivesTwiceThePicture) {
    for_plans([&](const ScenePlan& plan) {
        const Picture once = draw(plan, {}, quick()), twice = draw(plan, {.light = 2.0f}, quick());
        // A factor of two only changes exponents: every bit must agree.
        const Picture doubled = changed(once, [](vec3 colour) { return 2.0f * colour; });
        expect_within("twice the light, twice the picture", deviation(twice, doubled).worst, 0.0);
        RC_ASSERT(same_bytes(twice, doubled));
    });
}

TEST_P(Relations, TwoLightsGiveTheSumOfEach) {
    for_plans([&](ScenePlan plan) {
        const std::string relation = "light A + light B = sum of the two pictures";
        ScenePlan::Lamp second = plan.lamps.front();
        second.azimuth += 2.0f;
        second.kind = RenderScene::Light::Kind::spot;
        plan.lamps = {plan.lamps.front(), second};
        ScenePlan a = plan, b = plan;
        a.lamps = {plan.lamps[0]};
        b.lamps = {plan.lamps[1]};
        if (method().traced()) {
            // Each path asks one light, drawn by chance: only the means agree.
            const TracedMean both = trace(plan), one = trace(a), other = trace(b);
            expect_within_noise(relation, both, {.mean = one.mean + other.mean, .error = glm::sqrt(one.error * one.error + other.error * other.error)});
            return;
        }
        // The lights share the samples of rsm_disc by their flux (shader/lib/rsm_disc.glsl): each alone is drawn with those
        // that it gets beside the other.
        const auto alone = [&](const ScenePlan::Lamp& lamp) {
            LightMethod result = method();
            auto* disc = result.gi->get_if<RsmDisc>();
            if (disc == nullptr) return result;
            SceneBuilder builder;
            build(plan, {}, builder);
            // The scene sorts its lights by kind; a directional first lamp stays first, and two spots keep their order.
            const LightTable table = build_light_table(builder.scene());
            const std::size_t row = &lamp == &plan.lamps[0] ? 0 : 1;
            disc->samples = std::max(static_cast<std::uint32_t>(static_cast<float>(disc->samples) * (0.125f + 0.75f * table.params[row].cone.z) + 0.5f), 1u);
            return result;
        };
        const Picture both = draw(plan), one = draw(a, {}, alone(plan.lamps[0])), other = draw(b, {}, alone(plan.lamps[1]));
        Picture sum = one;
        for (std::size_t i = 0; i < sum.size(); ++i) {
            sum.irradiance[i] += other.irradiance[i];
            sum.hdr[i] += other.hdr[i];
        }
        if (method().facets()) return expect_facets_agree(relation, both, sum);
        // The order of up to 8192 terms differs. Each addition rounds by up to 6e-8 in either direction, so errors grow with
        // the root of their number: 6e-8 · √8192 = 5e-6, and ten times that for the worst pixel of all.
        expect_within(relation, deviation(both, sum).worst, 5e-5);
    });
}

TEST_P(Relations, PermutedChannelsGiveAPermutedPicture) {
    for_plans([&](ScenePlan plan) {
        // The path tracer draws one of several lights by its luminance, in which green counts more than blue. With one
        // light there is no choice, and its points are the same as well.
        if (method().traced()) plan.lamps.resize(1);
        const Picture permuted = draw(plan, {.channels = uvec3(1, 2, 0)});
        const Picture expected = changed(draw_once(plan), [](vec3 v) { return vec3(v.y, v.z, v.x); });
        // Facets send rays towards what is bright, and end when luminance is known.
        if (method().facets()) return expect_facets_agree("permuted channels, permuted picture", permuted, expected);
        expect_within("permuted channels, permuted picture", deviation(permuted, expected).worst, 0.0);
    });
}

TEST_P(Relations, TheSameFrameTwiceGivesTheSameBytes) {
    for_plans([&](const ScenePlan& plan) {
        SceneBuilder builder;
        build(plan, {}, builder);
        const auto picture = [&](Renderer& with) { return picture_of(quick(), builder.scene(), with, size); };
        renderer->forget();
        const Picture first = picture(*renderer);
        RC_ASSERT(same_bytes(picture(*renderer), first));  // from cached maps and facets
        renderer->forget();
        RC_ASSERT(same_bytes(picture(*renderer), first));
        // After a frame of something else, on whose textures this one is drawn.
        ScenePlan other = plan;
        other.eye_azimuth += 1.0f;
        other.lamps.front().azimuth += 1.0f;
        (void)draw(other, {}, quick());
        RC_ASSERT(same_bytes(picture(*renderer), first));
        relation_table().say("the same frame twice, the same bytes", method().name, "0");
    });
    Renderer fresh(shader_folder());
    const ScenePlan plan{.things = {{}}, .lamps = {{.intensity = vec3(300, 200, 100)}}};
    SceneBuilder builder;
    build(plan, {}, builder);
    EXPECT_TRUE(same_bytes(picture_of(quick(), builder.scene(), fresh, size), picture_of(quick(), builder.scene(), *renderer, size)));
}

}  // namespace
}  // namespace sl
