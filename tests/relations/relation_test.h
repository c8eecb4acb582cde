// SPDX-License-Identifier: MIT
#pragma once

// The test framework first: RapidCheck's header expects it.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "tests/relations/random_scene.h"
#include "tests/support/gl_test.h"
#include "tests/support/method_picture.h"
#include "tests/support/result_table.h"

namespace sl {

/// Random plans: 1 to 6 things, the first a box; 1 to 3 lights, the first one with a map.
rc::Gen<ScenePlan> scene_plans();

/// The table "relations" in docs/gi.md.
ResultTable& relation_table();

/// A picture's mean irradiance as the path tracer estimates it, with its standard error, from independent seeds.
struct TracedMean {
    static constexpr int seeds = 8;
    glm::dvec3 mean{0.0}, error{0.0};
};

/// Relations between pictures of one random scene, for one method. The path tracer's single pictures are drawn without
/// paths from the lights: where those go depends on the whole scene, and so does each picture's noise. Its means (`trace`)
/// are drawn with them.
class Relations : public GlTest, public testing::WithParamInterface<LightMethod> {
  public:
    static constexpr uvec2 size{16, 12};

    const LightMethod& method() const { return GetParam(); }
    bool is(std::string_view name) const { return method().name == name; }
    /// How far two pictures of facets may lie apart whose rays differ. A corner's standard error is 7 % at most (`noise`), and
    /// that of the difference of two √2 · 7 %. All corners send their rays in the same directions and err to the same side, so
    /// that a mean is not much surer than a pixel: it may be off by half of that.
    static constexpr double facets_apart = 0.1;
    /// The same where the lattice lies otherwise on the surfaces, for facets of 4 pixels: what lies between corners is mixed of
    /// others, in a picture of 16 pixels most where things nearly touch.
    /// Measured: 31 % at most; with seed=7 one scene of six has 42 %, and the others less than 32 %.
    static constexpr double other_lattice = 0.4;
    Picture draw(const ScenePlan& plan, const SceneChange& change = {}) { return draw(plan, change, method()); }
    Picture draw(const ScenePlan& plan, const SceneChange& change, const LightMethod& with);
    /// An unchanged scene's picture, by the finer method or the method itself, drawn for the first relation that asks for it.
    const Picture& draw_once(const ScenePlan& plan, bool fine = false);
    TracedMean trace(const ScenePlan& plan, const SceneChange& change = {}, std::uint32_t samples = 384) const;

    /// Checks a property of many random plans. The seed is fixed, so that a run does not depend on luck; look for more
    /// with RC_PARAMS="seed=1 max_success=500".
    void for_plans(const std::function<void(const ScenePlan&)>& property) const;

    /// The method as quick as it gets, for relations that hold to the last bit.
    LightMethod quick() const;

    /// The method with so many texels and, where it samples them, samples for nearly all of them. Facets are half as wide.
    LightMethod finer(std::uint32_t rsm_size) const;

    /// Requires that two pictures of facets agree as well as their noise allows.
    void expect_facets_agree(const std::string& relation, const Picture& a, const Picture& b, double most = facets_apart);
    /// Requires that a deviation is at most `bound`, and enters it into the table.
    void expect_within(const std::string& relation, double deviation, double bound) const;
    /// Requires that two of the path tracer's means agree within their noise.
    void expect_within_noise(const std::string& relation, const TracedMean& a, const TracedMean& b) const;
    /// Requires that changes of a picture's mean brightness, one per scene, are none on average, within four standard
    /// errors and half a percent.
    void expect_same_brightness(const std::string& relation, const std::vector<double>& changes) const;
};

}  // namespace sl
