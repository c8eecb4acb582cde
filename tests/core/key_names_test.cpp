// SPDX-License-Identifier: MIT
#include "engine/core/key_names.h"

#include <gtest/gtest.h>

#include <set>

namespace sl {
namespace {

TEST(KeyNames, EachKeyHasItsOwn) {
    const std::set<std::string_view> names(key_names().begin(), key_names().end());
    EXPECT_EQ(names.size(), key_count);
    EXPECT_EQ(key_name(Key::w), "w");
    EXPECT_EQ(key_name(Key::digit_0), "0");
    EXPECT_EQ(key_name(Key::f12), "f12");
    EXPECT_EQ(key_name(Key::comma), "comma");
    EXPECT_EQ(key_name(Key::control), "control");
    EXPECT_EQ(key_label(Key::left_bracket), "[");
    EXPECT_EQ(key_label(Key::page_up), "Page up");
}

}  // namespace
}  // namespace sl
