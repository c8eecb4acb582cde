// SPDX-License-Identifier: MIT
#include "engine/ecs/large_vector.h"

#include <gtest/gtest.h>

#include <string>

namespace sl {
namespace {

TEST(LargeVector, keeps_its_values_while_it_grows_past_a_huge_page) {
    LargeVector<std::string> words;
    constexpr std::size_t count = 3 * HugePageAllocator<std::string>::huge_page / sizeof(std::string);
    for (std::size_t i = 0; i < count; ++i) words.push_back(std::to_string(i));
    for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(words[i], std::to_string(i));
    const LargeVector<std::string> copy = words;
    words.clear();
    words.shrink_to_fit();
    EXPECT_EQ(copy[count - 1], std::to_string(count - 1));
}

TEST(LargeVector, refuses_what_no_memory_could_hold) {
    EXPECT_THROW(HugePageAllocator<int>().allocate(~std::size_t{0} / 8), std::bad_alloc);
}

}  // namespace
}  // namespace sl
