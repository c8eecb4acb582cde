// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "game/flashlight.h"
#include "game/fly_camera.h"
#include "game/notice.h"
#include "game/player/player.h"
#include "game/player/voxel_surroundings.h"
#include "tests/game/streaming/endless_world.h"

namespace sl {
namespace {

class LandToStandOn : public EndlessWorld {
  protected:
    LandToStandOn() {
        add_fly_camera(app_);
        add_player(app_);
        app_.world.resource<FrameClock>().step = 1.0 / 60.0;
        look_from({0.25, 1.7, 0.25});
        run();
    }
    const Player& player() { return app_.world.resource<Player>(); }
};

TEST_F(LandToStandOn, APlayerStandsOnIt) {
    for (int frame = 0; frame < 60; ++frame) run();
    EXPECT_FALSE(player().flying);
    EXPECT_NEAR(player().body.feet.y, 0.0, 0.01);
}

TEST_F(LandToStandOn, APlayerWaitsWhereItIsStillToCome) {
    app_.world.resource<TerrainView>().at_once = false;
    const dvec3 far(3000, 60, 0);
    look_from(far);
    ASSERT_FALSE(stream().is_loaded(column_of({6000, 0, 0})));
    EXPECT_EQ(app_.world.get<Transform>(camera_).translation, far);
    EXPECT_FALSE(land_is_there(app_.world, player().body.box()));
    settle();
    for (int frame = 0; frame < 300; ++frame) run();
    EXPECT_LT(player().body.feet.y, far.y - 5.0);
    EXPECT_TRUE(player().body.grounded || player().body.swimming);
}

TEST_F(LandToStandOn, NobodyWalksIntoWhatIsStillToCome) {
    const auto around = voxel_surroundings(app_.world);
    EXPECT_TRUE(around.solid({{200, 30, 0}, {201, 32, 1}}));
    EXPECT_FALSE(around.solid({{0, 30, 0}, {1, 32, 1}}));
}

}  // namespace
}  // namespace sl
