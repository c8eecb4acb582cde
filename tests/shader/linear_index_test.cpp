// SPDX-License-Identifier: MIT
// lib/linear_index.glsl: invocations in rows of work groups are numbered through, each once.
#include "tests/shader/library_fixture.h"

namespace sl {
namespace {

TEST_F(LibraryTest, LinearIndexNumbersEachInvocationOnce) {
    constexpr std::size_t count = 1500;
    for (const std::uint32_t across : {1u, 5u, 7u, 64u}) {  // among them a last row that is not full
        const auto numbers = compute("", "    result.x = float(i);", count, across);
        for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(numbers[i].x, static_cast<float>(i)) << across << " groups a row";
    }
}

}  // namespace
}  // namespace sl
