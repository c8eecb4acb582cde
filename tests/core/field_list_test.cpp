// SPDX-License-Identifier: MIT
#include "engine/core/field_list.h"

#include <gtest/gtest.h>

#include "tests/core/every_field.h"

namespace sl {
namespace {

FieldRow row(std::string_view name) {
    for (FieldRow& row : list_fields(EveryField{})) {
        if (row.name == name) return row;
    }
    ADD_FAILURE() << name;
    return {};
}

TEST(FieldList, HasARowPerFieldInOrder) {
    const std::vector<FieldRow> rows = list_fields(EveryField{});
    ASSERT_EQ(rows.size(), 14u);
    EXPECT_EQ(rows.front().name, "flag");
    EXPECT_EQ(rows.back().name, "mood");
}

TEST(FieldList, TellsValueRangeAndUnit) {
    EXPECT_EQ(row("angle").range, "0.001 to 1.5533");
    EXPECT_EQ(row("angle").unit, "rad");
    EXPECT_EQ(row("strength").value, "0.3");
    EXPECT_EQ(row("colour").value, "1,0.5,0.25");
    EXPECT_EQ(row("size").min, 4.0);
    EXPECT_EQ(row("size").max, 1024.0);
    EXPECT_EQ(row("precise").range, "at least 0");
    EXPECT_EQ(row("rotation").type, "rotation");
    EXPECT_EQ(row("mood").value, "calm");
    EXPECT_EQ(row("mood").choices, (std::vector<std::string>{"calm", "windy", "stormy"}));
}

TEST(FieldList, TellsWhichTextsNameFiles) {
    FieldLister lister;
    std::string text = "a.glb";
    lister.field("text", text, {});
    lister.field("file", text, {.look = FieldLook::file});
    EXPECT_EQ(lister.rows[0].type, "text");
    EXPECT_EQ(lister.rows[1].type, "file");
    EXPECT_EQ(lister.rows[1].value, "a.glb");
}

TEST(FieldList, MarkdownEscapesBars) {
    const std::string table = markdown_table(list_fields(EveryField{}));
    EXPECT_NE(table.find("| `size` | 64 | 4 to 1024 | texels | Size \\| side. |\n"), std::string::npos)
        << table;
}

}  // namespace
}  // namespace sl
