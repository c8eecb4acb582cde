// SPDX-License-Identifier: MIT
// lib/row_list.glsl: no two rows share a place, and all fit into what gi/rsm_disc.cpp allocates.
#include <set>

#include "tests/shader/library_fixture.h"

namespace sl {
namespace {

TEST_F(LibraryTest, RowListGivesEachCountAndEntryAPlaceOfItsOwn) {
    constexpr std::uint32_t width = 37, rows = 23;
    // The first of each row asks for its count, the others for its entries.
    const std::string body = fmt::format(
        "    uint row = i / {0}u;\n    uint k = i % {0}u;\n"
        "    result.x = float(k == 0u ? row_list_count(row, {1}u) : row_list_entry(row, {1}u, k - 1u));\n", width + 1, width);
    std::set<float> places;
    for (const vec4& place : compute("#include \"lib/row_list.glsl\"\n", body, rows * (width + 1))) places.insert(place.x);
    EXPECT_EQ(places.size(), rows * (width + 1)) << "all different";
    EXPECT_EQ(*places.begin(), 0.0f);
    EXPECT_EQ(*places.rbegin(), rows * (width + 1) - 1) << "none past the end";
}

}  // namespace
}  // namespace sl
