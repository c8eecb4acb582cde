// SPDX-License-Identifier: MIT
// What a method gives up on purpose. Each test pins by how much on one fixed scene, so that the documentation's figure is
// measured and a repair does not go unnoticed.
#include <glm/gtc/matrix_transform.hpp>

#include "tests/relations/relation_test.h"

namespace sl {
namespace {

using Kind = RenderScene::Light::Kind;

const ScenePlan plan{.things = {{.kind = Shape::Kind::box, .size = vec3(1.2f, 2, 1), .place = vec3(-1, 1.3f, 0.5f), .albedo = vec3(0.7f, 0.2f, 0.2f)},
                                {.kind = Shape::Kind::sphere, .size = vec3(1.4f), .place = vec3(1.2f, 1, -0.4f), .albedo = vec3(0.3f, 0.6f, 0.3f)}},
                     .lamps = {{.azimuth = 0.8f, .elevation = 0.9f, .intensity = vec3(1000)}, {.kind = Kind::spot, .azimuth = 2.5f, .intensity = vec3(3000)}},
                     .eye_azimuth = 0.9f};

/// These break relations on purpose; the others must keep them on this scene as well.
class ByDesign : public Relations {
  protected:
    static std::string percent(double change) { return fmt::format("{:+.0f} %", 100.0 * change); }
    /// Change of the mean brightness, entered into the table.
    double change_of(const std::string& relation, const Picture& changed_picture) {
        const double change = deviation(changed_picture, draw(plan)).mean;
        relation_table().say(relation, method().name, "fails by design: " + percent(change));
        return change;
    }
    LightMethod grid(std::uint32_t rsm_size, std::uint32_t step) const {
        LightMethod result = method();
        result.gi = RsmGrid{.rsm_size = rsm_size, .step = step};
        return result;
    }
};

class GridByDesign : public ByDesign {};
class DiscByDesign : public ByDesign {};

TEST_P(GridByDesign, MoreTexelsAreMoreLight) {
    // A texel's area is nowhere in its sum: four times the texels, four times the light. What is left over are texels at
    // outlines.
    EXPECT_NEAR(change_of("mean brightness: `rsm_size` 64 → 128", draw(plan, {}, grid(128, 1))), 3.0, 0.1);
    EXPECT_NEAR(change_of("mean brightness: `step` 1 → 2", draw(plan, {}, grid(64, 2))), -0.75, 0.02);
}

TEST_P(GridByDesign, AttenuationHasALengthInIt) {
    // 1 / (1 + k d²) with k in 1/m². In a tiny scene nothing is attenuated; from 10 m on the cutoff takes all.
    const auto scaled = [&](float scale) { return deviation(draw(plan, {.scale = scale}), draw(plan)).mean; };
    const double tiny = scaled(1e-3f), twice = scaled(2.0f), huge = scaled(1e3f);
    relation_table().say("scaled by 2⁻¹⁰ to 2¹⁰", method().name, "fails by design: " + percent(twice) + " at 2");
    relation_table().say("scaled by 10⁻³ to 10³", method().name, "fails by design: " + percent(tiny) + " at 10⁻³, " + percent(huge) + " at 10³");
    EXPECT_GT(tiny, 3.0);
    EXPECT_LT(twice, -0.3);
    EXPECT_LT(huge, -0.99);
}

TEST_P(GridByDesign, ATurnThatFitsTheMapAnewChangesBrightness) {
    // The map is fitted to the scene's box in world axes; a larger box leaves fewer texels for each square metre. The sun
    // stands square to the floor's edge at first, and the box is as large as the floor.
    ScenePlan square = plan;
    square.lamps.front().azimuth = 0.0f;
    const double change = deviation(draw(square, {.place = glm::rotate(mat4(1.0f), 0.25f * pi, vec3(0, 1, 0))}), draw(square)).mean;
    relation_table().say("turned by any angle", method().name, "fails by design: " + percent(change) + " at 45°");
    EXPECT_LT(change, -0.2);
}

TEST_P(DiscByDesign, ASmallDiscLosesWhatLiesOutside) {
    LightMethod small = finer(64), wide = finer(64);
    small.gi->get<RsmDisc>().radius = 0.3f;
    const double change = deviation(draw(plan, {}, small), draw(plan, {}, wide)).mean;
    relation_table().say("mean brightness: `radius` 1.5 → 0.3", method().name, "fails by design: " + percent(change));
    EXPECT_LT(change, -0.1);
    EXPECT_GT(change, -0.6);
}

/// A scene that grows lays the texels of a map that holds the whole scene anew; here by a black plate beside the floor.
TEST_P(ByDesign, AThingThatMakesTheSceneLarger) {
    ScenePlan larger = plan;
    larger.things.push_back({.kind = Shape::Kind::quad, .size = vec3(8), .place = vec3(8, 0, 0), .albedo = vec3(0)});
    const std::string relation = "an unlit, unseen entity that makes the scene larger";
    if (method().traced()) return expect_within_noise(relation, trace(larger), trace(plan));
    const double change = deviation(draw(larger, {}, finer(64)), draw(plan, {}, finer(64))).mean;
    if (is("rsm_grid")) {
        relation_table().say(relation, method().name, "fails by design: " + percent(change));
        EXPECT_LT(change, -0.2);
        return;
    }
    relation_table().say(relation, method().name, fmt::format("{:+.1f} %", 100.0 * change));
    // Patches that are seen by other patches are as large as a share of the scene.
    EXPECT_LT(std::abs(change), method().facets() ? 0.5 * facets_apart : 0.15) << "texels twice as large sample the same light";
}

std::vector<LightMethod> only(std::string_view name) {
    std::vector<LightMethod> methods = small_methods();
    std::erase_if(methods, [&](const LightMethod& m) { return m.name != name; });
    return methods;
}
INSTANTIATE_TEST_SUITE_P(All, ByDesign, testing::ValuesIn(small_methods()), method_name_of);
INSTANTIATE_TEST_SUITE_P(All, GridByDesign, testing::ValuesIn(only("rsm_grid")), method_name_of);
INSTANTIATE_TEST_SUITE_P(All, DiscByDesign, testing::ValuesIn(only("rsm_disc")), method_name_of);

}  // namespace
}  // namespace sl
