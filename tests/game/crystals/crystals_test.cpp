// SPDX-License-Identifier: MIT
// The valley's crystals sleep as it is, and each wakes by what its hint says.
#include "game/crystals/crystals.h"

#include <gtest/gtest.h>

#include "engine/core/clock.h"
#include "engine/core/input.h"
#include "engine/ecs/components.h"
#include "engine/ecs/query.h"
#include "engine/render/scene/extract.h"
#include "engine/render/trace/light_meter.h"
#include "game/session.h"
#include "game/voxel/crystal_valley.h"
#include "game/voxel_content.h"

namespace sl {
namespace {

namespace valley = crystal_valley;

class Valley : public testing::Test {
  protected:
    void SetUp() override {
        app.world.emplace_resource<LightMeter>();
        set_hour(early_afternoon);
    }
    /// When the sun falls into all that is open above.
    static constexpr double early_afternoon = 13.567;

    Entity named(const std::string& wanted) {
        for (auto [entity, name] : Query<const Name>(app.world)) {
            if (name.value == wanted) return entity;
        }
        return {};
    }
    /// The player goes to a crystal, and some time passes there.
    CrystalSearch stay_at(const std::string& crystal, double seconds = 3.0) {
        auto& place = app.world.get<Transform>(active_camera(app.world));
        place.translation = app.world.get<Transform>(named(crystal)).translation + dvec3(0.7, 1.0, 0.7);
        for (double passed = 0.0; passed < seconds; passed += 0.05) {
            app.world.resource<FrameClock>().step = 0.05;
            app.schedule.run(app.world);
            extract(app.world, scene);
            app.world.resource<LightMeter>().update(scene);
        }
        return app.world.resource<CrystalSearch>();
    }
    void fill(ivec3 low, ivec3 high, Block block) {
        const Entity blocks = named("world");
        for (int y = low.y; y < high.y; ++y) {
            for (int z = low.z; z < high.z; ++z) {
                for (int x = low.x; x < high.x; ++x) set_block(app.world, blocks, {x, y, z}, block);
            }
        }
    }
    void set_hour(double hour) {
        for (auto [entity, day] : Query<DayCycle>(app.world)) {
            day.hour = hour;
            day.runs = false;
        }
    }
    bool awake(const std::string& crystal) { return app.world.get<Crystal>(named(crystal)).awake; }
    App app = open_scene({.scene = "crystals"});
    RenderScene scene;
};

constexpr const char* all_names[] = {"dawn", "ember", "deep", "moss", "dusk"};

TEST_F(Valley, SleepsAsItIs) {
    for (const char* name : all_names) {
        const auto search = stay_at(name);
        EXPECT_EQ(search.nearest, named(name));
        EXPECT_TRUE(search.light) << name;
        EXPECT_FALSE(awake(name));
        EXPECT_EQ(search.all, 5u);
    }
}

TEST_F(Valley, SleepsAsItIsAtEveryHour) {
    for (double hour = 0.0; hour < 24.0; hour += hour < 6.0 || hour > 18.0 ? 2.0 : 1.0) {
        set_hour(hour);
        for (const char* name : all_names) {
            stay_at(name, 2.0);
            EXPECT_FALSE(awake(name)) << name << " at " << hour;
        }
    }
}

TEST_F(Valley, DawnWakesByALampInTheBend) {
    fill(valley::dawn + ivec3(-3, 0, 1), valley::dawn + ivec3(-2, 1, 2), Block::glowstone);
    const auto search = stay_at("dawn");
    EXPECT_TRUE(awake("dawn"));
    EXPECT_EQ(search.awake, 1u);
    EXPECT_GT(search.celebration, 0.0);
    EXPECT_GT(app.world.get<Material>(named("dawn")).emission, 0.0f);
    EXPECT_EQ(awake_crystals(app.world), std::vector<std::string>{"dawn"});
}

TEST_F(Valley, EmberWakesByRedWoolWhereTheSunFalls) {
    fill({18, -1, -29}, {22, 0, -23}, Block::red_wool);
    stay_at("ember");
    EXPECT_FALSE(awake("ember")) << "the sun does not fall there";
    fill({22, -1, -23}, {28, 0, -17}, Block::red_wool);
    stay_at("ember");
    EXPECT_TRUE(awake("ember"));
}

TEST_F(Valley, DeepNeedsMoreThanABlueLamp) {
    fill({23, -5, 23}, {24, -4, 24}, Block::blue_lamp);
    stay_at("deep");
    EXPECT_FALSE(awake("deep")) << "orange walls swallow blue light";
    fill({18, -10, 28}, {29, -5, 29}, Block::white_wool);
    fill({28, -10, 18}, {29, -5, 29}, Block::white_wool);
    stay_at("deep");
    EXPECT_TRUE(awake("deep"));
}

TEST_F(Valley, MossWakesOnceTheLidIsOff) {
    fill({-27, 1, 14}, {-23, 2, 18}, Block::air);
    stay_at("moss");
    EXPECT_TRUE(awake("moss"));
}

TEST_F(Valley, DuskNeedsBothRooms) {
    fill({-31, -1, -30}, {-20, 0, -18}, Block::orange_wool);
    stay_at("dusk");
    EXPECT_FALSE(awake("dusk")) << "one coloured room is not enough";
    fill({-41, 0, -30}, {-40, 6, -20}, Block::orange_wool);
    stay_at("dusk");
    EXPECT_TRUE(awake("dusk"));
}

TEST_F(Valley, StraightLightDoesNotCount) {
    // A lamp right before the crystal, in a black cell.
    fill(valley::dawn - ivec3(2, 1, 2), valley::dawn + ivec3(3, 5, 3), Block::black_wool);
    fill(valley::dawn - ivec3(1, 0, 1), valley::dawn + ivec3(2, 4, 2), Block::air);
    fill(valley::dawn + ivec3(1, 1, 0), valley::dawn + ivec3(2, 2, 1), Block::glowstone);
    const auto search = stay_at("dawn");
    ASSERT_TRUE(search.light);
    EXPECT_FALSE(awake("dawn"));
}

TEST_F(Valley, GivesHints) {
    stay_at("moss", 0.2);
    app.world.resource<Input>().keys_pressed.set(static_cast<std::size_t>(Key::t));
    app.schedule.run(app.world);
    EXPECT_NE(app.world.resource<CrystalSearch>().hint.find("well"), std::string::npos);
}

TEST_F(Valley, NothingNearNothingMeasured) {
    app.world.get<Transform>(active_camera(app.world)).translation = dvec3(0, 500, 0);
    app.schedule.run(app.world);
    app.schedule.run(app.world);
    EXPECT_FALSE(app.world.resource<CrystalSearch>().nearest);
}

TEST(CrystalLight, SharesAreOfAmountAndColour) {
    const Crystal red{.colour = vec3(1, 0, 0), .need = 100.0f, .purity = 0.9f};
    EXPECT_EQ(crystal_light(red, vec3(0.0f)).share(red), 0.0f);
    EXPECT_EQ(crystal_light(red, vec3(0, 0, 1000)).share(red), 0.0f);
    EXPECT_EQ(crystal_light(red, vec3(1000, 0, 0)).share(red), 1.0f);
    const float white = crystal_light(red, vec3(1000)).share(red), pink = crystal_light(red, vec3(1000, 300, 300)).share(red);
    EXPECT_LT(white, pink);
    EXPECT_GT(pink, 0.9f);
}

}  // namespace
}  // namespace sl
