// SPDX-License-Identifier: MIT
#include "engine/core/closest_name.h"

#include <gtest/gtest.h>

#include <array>

namespace sl {
namespace {

constexpr std::array<std::string_view, 3> known{"camera", "spot_light", "gi"};

TEST(ClosestName, GuessesOnlyWhatIsNear) {
    EXPECT_EQ(no_such_name("component", "spotlight", known),
              "there is no component 'spotlight'; did you mean 'spot_light'? Known: camera, spot_light, gi");
    EXPECT_EQ(no_such_name("component", "tree", known),
              "there is no component 'tree'. Known: camera, spot_light, gi");
    EXPECT_EQ(no_such_name("component", "tree", std::span<const std::string_view>()),
              "there is no component 'tree'");
}

TEST(ClosestName, CutsWhatIsLong) {
    const std::vector<std::string> many(1000, "entity");
    EXPECT_TRUE(no_such_name("entity", "entitx", many).ends_with("entity and 976 more"));
    EXPECT_LT(no_such_name("entity", std::string(1'000'000, 'x'), many).size(), 400u);
}

TEST(ForMessage, IsOneLineOfWholeCharacters) {
    EXPECT_EQ(for_message("a\nb\x7f"), "a?b?");
    EXPECT_EQ(for_message("üü", 3), "ü…");
    EXPECT_EQ(for_message("üü", 4), "üü");
}

}  // namespace
}  // namespace sl
