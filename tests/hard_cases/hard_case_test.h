// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "tests/support/closed_forms.h"
#include "tests/support/gl_test.h"
#include "tests/support/method_picture.h"
#include "tests/support/result_table.h"
#include "tests/support/scene_builder.h"

namespace sl {

/// The table "hard cases" in docs/hard_cases.md.
ResultTable& hard_case_table();

using Light = RenderScene::Light;
inline mat4 at(vec3 place, const mat4& turn = mat4(1.0f)) { return glm::translate(mat4(1.0f), place) * turn; }
inline const mat4 facing_down = glm::rotate(mat4(1.0f), pi, vec3(1, 0, 0));
inline const mat4 facing_front = glm::rotate(mat4(1.0f), 0.5f * pi, vec3(1, 0, 0));

/// Parallel light of so many lux that passes through backs, as RSM methods take it.
inline Light sun(vec3 direction, float lux = 1000.0f) {
    return {.kind = Light::Kind::directional, .direction = glm::normalize(direction), .intensity = vec3(lux), .bounces = true, .shadow_size = 256};
}
/// A spot light with a hard edge.
inline Light spot(vec3 position, vec3 direction, float candela, float cone) {
    return {.kind = Light::Kind::spot, .position = position, .direction = glm::normalize(direction), .intensity = vec3(candela), .inner_cone = cone,
            .outer_cone = cone, .bounces = true, .shadow_size = 256};
}

/// One method in cases that break renderers. Whatever the case, no pixel may be NaN, infinite or negative.
class HardCases : public GlTest, public testing::WithParamInterface<LightMethod> {
  public:
    const LightMethod& method() const { return GetParam(); }
    bool is(std::string_view name) const { return method().name == name; }

    /// The scene's picture; fails the test where a pixel is insane.
    Picture draw(SceneBuilder& builder, uvec2 size = {8, 8}) { return draw(builder, size, method()); }
    Picture draw(SceneBuilder& builder, uvec2 size, const LightMethod& with) {
        // Facets use what they have learned of the scene before, and that is another picture of it.
        if (with.facets()) renderer->forget();
        return next_frame(builder, size, with);
    }
    /// The same with all that earlier frames have left.
    Picture next_frame(SceneBuilder& builder, uvec2 size, const LightMethod& with) {
        Picture picture = picture_of(with, builder.scene(), *renderer, size);
        EXPECT_EQ(insane_pixel(picture), "") << with.name;
        return picture;
    }
    /// Enters the error against a known value into the table, and bounds it: rsm_grid is not in physical units and is only
    /// asked to survive.
    struct Bounds {
        double exact, disc, traced;
        /// Three standard errors of a corner (`noise` is 3 %): all rays of a small picture go in the same directions.
        double facets = 0.09;
    };
    /// Where no value is known, facets need not be precise and slow.
    LightMethod rough() const {
        LightMethod result = method();
        if (auto* facets = result.facets() ? result.gi->get_if<Facets>() : nullptr) facets->noise = 0.15f;
        return result;
    }
    /// Where the truth is that of one reflection: facets know all of them.
    LightMethod one_bounce() const {
        LightMethod result = method();
        if (auto* facets = result.facets() ? result.gi->get_if<Facets>() : nullptr) facets->bounces = 1;
        return result;
    }
    void expect_value(const std::string& name, double measured, double truth, const Bounds& most) {
        EXPECT_TRUE(std::isfinite(measured) && measured >= 0.0) << name;
        if (is("rsm_grid")) return survives(name);
        const double error = measured / truth - 1.0, bound = is("rsm_exact") ? most.exact : is("rsm_disc") ? most.disc : is("facets") ? most.facets : most.traced;
        hard_case_table().say(name, method().name, fmt::format("{}{}", error < 0.0 ? "-" : error > 0.0 ? "+" : "", ResultTable::figure(std::abs(error))));
        EXPECT_LT(std::abs(error), bound) << name << ": " << measured << " instead of " << truth;
    }
    /// A frame after another one against the same frame drawn anew.
    void expect_same(const Picture& next, const Picture& anew, std::size_t change) {
        if (is("facets")) {
            // Links are kept while light and blocks change, so that two frames know of the same light by other rays: the
            // difference of two of which each errs by 15 %.
            EXPECT_LT(deviation(next, anew).inner, 0.21) << "change " << change << " was not noticed";
        } else {
            EXPECT_TRUE(same_bytes(next, anew)) << "change " << change << " was not noticed";
        }
    }
    void survives(const std::string& name, const std::string& how = "survives") {
        hard_case_table().say(name, method().name, HasFailure() ? "**fails**" : how);
    }
};

}  // namespace sl
