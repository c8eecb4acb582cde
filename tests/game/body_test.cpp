// SPDX-License-Identifier: MIT
#include "game/player/body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

namespace sl {
namespace {

/// Blocks of half a metre, some of water.
struct Blocks {
    static constexpr double size = 0.5;
    std::set<std::array<int, 3>> solid, water;

    void fill(std::set<std::array<int, 3>>& kind, ivec3 low, ivec3 high) {
        for (int x = low.x; x < high.x; ++x) {
            for (int y = low.y; y < high.y; ++y) {
                for (int z = low.z; z < high.z; ++z) kind.insert({x, y, z});
            }
        }
    }
    Surroundings surroundings() const {
        const auto any = [](const std::set<std::array<int, 3>>& kind, const BodyBox& box) {
            const dvec3 low = glm::floor(box.low / size + 1e-6), high = glm::ceil(box.high / size - 1e-6);
            for (int x = static_cast<int>(low.x); x < static_cast<int>(high.x); ++x) {
                for (int y = static_cast<int>(low.y); y < static_cast<int>(high.y); ++y) {
                    for (int z = static_cast<int>(low.z); z < static_cast<int>(high.z); ++z) {
                        if (kind.contains({x, y, z})) return true;
                    }
                }
            }
            return false;
        };
        return {.solid = [this, any](const BodyBox& box) { return any(solid, box); },
                .water = [this, any](const dvec3& at) { return any(water, {at - 1e-3, at + 1e-3}); }};
    }
};

class BodyTest : public testing::Test {
  protected:
    static constexpr double step = 1.0 / 120.0;
    Blocks blocks_;
    Body body_;

    /// A floor whose top is at y = 0.
    BodyTest() {
        blocks_.fill(blocks_.solid, {-40, -2, -40}, {40, 0, 40});
        body_.feet = dvec3(0.25, 0.0, 0.25);
    }
    void run(const BodyWish& wish, double seconds) {
        const Surroundings around = blocks_.surroundings();
        for (int i = 0; i < static_cast<int>(std::round(seconds / step)); ++i) move_body(body_, wish, step, around);
    }
    bool stuck() const { return blocks_.surroundings().solid(body_.box()); }
};

TEST_F(BodyTest, FallsAndStands) {
    body_.feet.y = 10.0;
    run({}, 3.0);
    EXPECT_NEAR(body_.feet.y, 0.0, 1e-3);
    EXPECT_TRUE(body_.grounded);
    EXPECT_FALSE(stuck());
}

TEST_F(BodyTest, FallsThroughNothingHoweverFast) {
    for (const double speed : {60.0, 300.0, 5000.0}) {
        body_ = {.feet = {0.25, 40.0, 0.25}, .velocity = {0.0, -speed, 0.0}};
        run({}, 3.0);
        EXPECT_NEAR(body_.feet.y, 0.0, 1e-3) << speed;
    }
}

TEST_F(BodyTest, WalksAndRunsAtTheirSpeeds) {
    run({.move = {0, 1}}, 1.0);
    dvec3 before = body_.feet;
    run({.move = {0, 1}}, 1.0);
    EXPECT_NEAR(before.z - body_.feet.z, 4.3, 0.05) << "along -z";
    EXPECT_NEAR(body_.feet.x, before.x, 1e-6);
    run({.move = {1, 1}, .run = true}, 1.0);
    before = body_.feet;
    run({.move = {1, 1}, .run = true}, 0.5);
    EXPECT_NEAR(glm::length(body_.feet - before), 3.5, 0.05) << "no faster askew";
}

TEST_F(BodyTest, AWallStopsAndLetsSlideAlong) {
    blocks_.fill(blocks_.solid, {-40, 0, -6}, {40, 8, -4});
    run({.move = {0.5f, 1}}, 3.0);
    EXPECT_NEAR(body_.feet.z, -2.0 + 0.5 * Body::width, 1e-3);
    EXPECT_GT(body_.feet.x, 2.0);
    EXPECT_FALSE(stuck());
}

TEST_F(BodyTest, WalksUpABlockAndNotUpTwo) {
    blocks_.fill(blocks_.solid, {-40, 0, -40}, {40, 1, -4});
    run({.move = {0, 1}}, 2.0);
    EXPECT_NEAR(body_.feet.y, 0.5, 1e-3);
    EXPECT_LT(body_.feet.z, -3.0);
    blocks_.fill(blocks_.solid, {-40, 1, -30}, {40, 3, -24});
    run({.move = {0, 1}}, 4.0);
    EXPECT_NEAR(body_.feet.y, 0.5, 1e-3);
    EXPECT_NEAR(body_.feet.z, -12.0 + 0.5 * Body::width, 1e-3);
}

TEST_F(BodyTest, EyesGlideUpSteps) {
    blocks_.fill(blocks_.solid, {-40, 0, -20}, {40, 1, -4});
    const Surroundings around = blocks_.surroundings();
    for (int i = 0; i < 240; ++i) {
        const double before = body_.eyes().y;
        move_body(body_, {.move = {0, 1}}, step, around);
        EXPECT_LT(std::abs(body_.eyes().y - before), 0.08);
    }
    EXPECT_NEAR(body_.eyes().y, 0.5 + 1.65, 0.01);
}

TEST_F(BodyTest, JumpsOverAMetreAndNotOverTwo) {
    double highest = 0.0;
    const Surroundings around = blocks_.surroundings();
    move_body(body_, {}, step, around);
    for (int i = 0; i < 200; ++i) {
        move_body(body_, {.jump = i == 0}, step, around);
        highest = std::max(highest, body_.feet.y);
    }
    EXPECT_GT(highest, 1.1);
    EXPECT_LT(highest, 1.4);
    EXPECT_TRUE(body_.grounded);
}

TEST_F(BodyTest, CrouchesUnderWhatIsLowAndStandsUpBehindIt) {
    blocks_.fill(blocks_.solid, {-40, 3, -12}, {40, 5, -4});  // 1.5 m over the floor
    run({.move = {0, 1}}, 1.5);
    EXPECT_NEAR(body_.feet.z, -2.0 + 0.5 * Body::width, 1e-3);
    run({.move = {0, 1}, .crouch = true}, 1.0);
    run({.move = {0, 1}}, 0.2);
    EXPECT_TRUE(body_.crouched) << "there is no room";
    run({.move = {0, 1}}, 4.0);
    EXPECT_FALSE(body_.crouched);
    EXPECT_LT(body_.feet.z, -6.0);
    EXPECT_FALSE(stuck());
}

TEST_F(BodyTest, SwimsAndClimbsOut) {
    blocks_.fill(blocks_.solid, {-20, -20, -20}, {20, 0, 20});
    for (int y = -18; y < 0; ++y) {
        for (int x = -6; x < 6; ++x) {
            for (int z = -6; z < 6; ++z) {
                blocks_.solid.erase({x, y, z});
                blocks_.water.insert({x, y, z});
            }
        }
    }
    body_.feet = {0.25, 3.0, 0.25};
    run({}, 1.5);
    EXPECT_TRUE(body_.swimming);
    EXPECT_GT(body_.velocity.y, -2.0) << "water slows a fall";
    run({.crouch = true}, 1.0);
    EXPECT_LT(body_.feet.y, -2.0) << "and lets dive";
    run({.move = {0, 1}, .jump = true}, 6.0);
    EXPECT_GT(body_.feet.y, -1e-3);
    EXPECT_LT(body_.feet.z, -3.0) << "out of the pool";
}

TEST_F(BodyTest, GetsOutOfWhatIsBuiltIntoIt) {
    run({}, 0.1);
    blocks_.fill(blocks_.solid, {-2, 0, -2}, {3, 2, 3});
    run({}, 0.5);
    EXPECT_FALSE(stuck());
    EXPECT_NEAR(body_.feet.y, 1.0, 1e-2);
}

TEST_F(BodyTest, NeverReachesIntoAnythingOnARandomWalk) {
    std::mt19937 random(7);
    const auto number = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
    for (int i = 0; i < 500; ++i) {
        const ivec3 low(number(-20, 18), number(0, 4), number(-20, 18));
        blocks_.fill(blocks_.solid, low, low + ivec3(number(1, 3), number(1, 3), number(1, 3)));
    }
    for (int y = 0; y < 4; ++y) blocks_.solid.erase({0, y, 0});
    body_.feet.y = 8.0;
    const Surroundings around = blocks_.surroundings();
    for (int walk = 0; walk < 300; ++walk) {
        const BodyWish wish{.move = vec2(number(-1, 1), number(-1, 1)), .heading = number(0, 62) * 0.1, .jump = number(0, 2) == 0, .run = number(0, 1) == 0, .crouch = number(0, 3) == 0};
        for (int i = 0; i < 40; ++i) {
            move_body(body_, wish, step, around);
            ASSERT_FALSE(stuck()) << "walk " << walk << " step " << i;
            ASSERT_TRUE(std::isfinite(glm::length(body_.feet)));
        }
        // Off the floor's edge: back again.
        if (body_.feet.y < -5.0) body_ = {.feet = {0.25, 8.0, 0.25}};
    }
}

}  // namespace
}  // namespace sl
