// SPDX-License-Identifier: MIT
#include "engine/ecs/scene_references.h"

#include <gtest/gtest.h>

#include "engine/core/math.h"

namespace sl {
namespace {

namespace fs = std::filesystem;

TEST(MovedReferences, NameTheSameFileFromAnywhere) {
    std::uint64_t state = 1;
    const auto folders = [&] {
        constexpr std::array<const char*, 5> pieces{"a", "b", "c d", "ü", ".."};
        fs::path path;
        for (state = hash_mix(state, 1); state % 4 != 0; state = hash_mix(state, 1)) path /= pieces[(state >> 8) % pieces.size()];
        return path;
    };
    const fs::path root = "/no/such/folder/as/this/one";
    for (int round = 0; round < 2000; ++round) {
        const fs::path from = root / folders(), to = root / folders();
        const std::string name = (folders() / "ship.glb").string();
        const fs::path file = (from / name).lexically_normal();
        const std::string moved = MovedReferences(from, to).moved(name);
        ASSERT_TRUE(fs::path(moved).is_relative()) << moved;
        ASSERT_EQ((to / moved).lexically_normal(), file) << from << " " << to << " " << name;
        ASSERT_EQ((from / MovedReferences(to, from).moved(moved)).lexically_normal(), file) << from << " " << to << " " << name;
    }
}

TEST(MovedReferences, LeaveWhatNeedNotMove) {
    const MovedReferences moves("/a/b", "/a/c"), stays("/a/b/../b", "/a/b");
    EXPECT_EQ(moves.moved(""), "");
    EXPECT_EQ(moves.moved("/full/ship.glb"), "/full/ship.glb");
    EXPECT_EQ(moves.moved("ship.glb"), "../b/ship.glb");
    EXPECT_EQ(moves.moved("../c/ship.glb"), "ship.glb");
    EXPECT_EQ(stays.moved("x/../ship.glb"), "x/../ship.glb");
    EXPECT_EQ(MovedReferences("", fs::current_path() / "in").moved("ship.glb"), "../ship.glb");
}

}  // namespace
}  // namespace sl
