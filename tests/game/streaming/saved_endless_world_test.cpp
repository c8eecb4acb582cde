// SPDX-License-Identifier: MIT
// A world file of endless terrain keeps what was built and where the player was, however far from the origin.
#include <unistd.h>

#include "game/saved_world.h"
#include "tests/game/streaming/endless_world.h"

namespace sl {
namespace {

/// One game after another in a world file.
class Game : public EndlessWorld {
  public:
    void enter(std::unique_ptr<WorldFile> file) {
        run();
        app_.world.resource<TerrainView>().at_once = at_once;
        attach_world(app_, std::move(file));
    }
    void leave() {
        finish_world(app_.world);
        app_.world.resource<SavedWorld>().file.reset();
    }
    void walk_to(const dvec3& place) { look_from(place); }
    void wait_for(ivec2 column) {
        for (int frame = 0; frame < 20000 && !stream().is_loaded(column); ++frame) {
            run();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
    void build(ivec3 cell, Block block) {
        set_block(app_.world, terrain_, cell, block);
        run();
    }
    Block block_at(ivec3 cell) { return volume().get(cell); }
    bool has_mesh(ivec3 cell) {
        const ivec3 key = chunk_key_of(cell);
        return content().chunks.contains({key.x, key.y, key.z});
    }
    dvec3 player() { return app_.world.get<Transform>(camera_).translation; }

    bool at_once = true;

  private:
    void TestBody() override {}
};

class SavedEndlessWorldTest : public testing::Test {
  protected:
    std::filesystem::path path_ = std::filesystem::temp_directory_path() / fmt::format("secondlight_endless_{}.world", ::getpid());
    static constexpr dvec3 far{3000.25, 70.5, -1500.75};
    static constexpr ivec3 tower{6010, 150, -3010};  ///< in the air, above all land

    SavedEndlessWorldTest() {
        std::filesystem::remove(path_);
        Game game;
        game.enter(WorldFile::create(path_, "endless"));
        game.walk_to(far);
        game.build(tower, Block::gold);
        game.leave();
    }
    ~SavedEndlessWorldTest() override { std::filesystem::remove(path_); }
};

TEST_F(SavedEndlessWorldTest, WhoComesBackIsWhereTheyWereBesideWhatTheyBuilt) {
    Game game;
    game.enter(WorldFile::open(path_));
    EXPECT_EQ(game.player(), far);
    EXPECT_EQ(game.block_at(tower), Block::gold);
    EXPECT_TRUE(game.has_mesh(tower));
}

TEST_F(SavedEndlessWorldTest, JobThreadsBringWhatWasBuilt) {
    Game game;
    game.at_once = false;
    game.enter(WorldFile::open(path_));
    game.wait_for(column_of(tower));
    EXPECT_EQ(game.block_at(tower), Block::gold);
    EXPECT_TRUE(game.has_mesh(tower));
}

TEST_F(SavedEndlessWorldTest, WhatIsTakenAwayAgainIsGoneForGood) {
    {
        Game game;
        game.enter(WorldFile::open(path_));
        game.build(tower, Block::air);
        game.leave();
    }
    Game game;
    game.enter(WorldFile::open(path_));
    EXPECT_EQ(game.block_at(tower), Block::air);
    EXPECT_FALSE(game.has_mesh(tower));
}

}  // namespace
}  // namespace sl
