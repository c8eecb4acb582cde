// SPDX-License-Identifier: MIT
#include "editor/imgui_fields.h"

#include <gmock/gmock.h>

#include "editor/component_widgets.h"
#include "engine/core/field_clamp.h"
#include "engine/core/field_list.h"
#include "engine/core/field_random.h"
#include "engine/ecs/app.h"
#include "tests/editor/imgui_test.h"

namespace sl {
namespace {

struct Everything {
    bool flag = true;
    std::int32_t whole = -3;
    std::uint32_t count = 5;
    float number = 0.5f, angle = 1.0f, huge = 2e8f;
    double precise = 0.25;
    vec2 pair{0.1f, 0.2f};
    vec3 triple{1, 2, 3}, colour{0.2f, 0.5f, 0.8f};
    dvec3 place{1e6, 2.5, -3};
    quat rotation = glm::angleAxis(0.7f, glm::normalize(vec3(1, 2, 3)));
    std::string text = "name";
    std::size_t choice = 1;
};

constexpr std::array<std::string_view, 3> choices{"first", "second", "third"};

void visit_fields(FieldVisitor& visit, Everything& all) {
    visit.field("flag", all.flag, {.help = "On or off."});
    visit.field("whole", all.whole, {.min = -10, .max = 10});
    visit.field("count", all.count, {});
    visit.field("number", all.number, {.min = 0, .max = 1, .unit = "m"});
    visit.field("angle", all.angle, {.min = -3, .max = 3, .unit = "rad", .look = FieldLook::angle});
    visit.field("huge", all.huge, {.min = 0, .max = 1e9, .unit = "cd", .look = FieldLook::logarithmic});
    visit.field("precise", all.precise, {});
    visit.field("pair", all.pair, {.min = 0, .max = 1});
    visit.field("triple", all.triple, {});
    visit.field("colour", all.colour, {.min = 0, .max = 1, .look = FieldLook::colour});
    visit.field("place", all.place, {.min = -1e7, .max = 1e7, .unit = "m"});
    visit.field("rotation", all.rotation, {});
    visit.field("text", all.text, {});
    visit.choice("choice", all.choice, choices, {});
}

std::vector<std::string> values_of(const Everything& all) {
    std::vector<std::string> values;
    for (const FieldRow& row : list_fields(all)) values.push_back(row.value);
    return values;
}

class ImguiFieldsTest : public ImguiTest {
  protected:
    Everything all_;
    bool changed_ = false;
    std::size_t rows_ = 0;

    void draw() {
        ImguiFields fields;
        const FieldTable table("fields");
        ASSERT_TRUE(table);
        visit_fields(fields, all_);
        changed_ |= fields.changed();
        rows_ = fields.rows();
    }
    std::function<void()> drawing() {
        return [this] { draw(); };
    }
};

/// Draws one field only and learns where its widget is.
template <class Value>
struct OneField {
    Value value;
    FieldInfo info;
    bool changed = false;
    ImVec2 low{}, high{};

    std::function<void()> drawing() {
        return [this] {
            ImguiFields fields;
            const FieldTable table("fields");
            fields.field("field", value, info);
            changed |= fields.changed();
            low = ImGui::GetItemRectMin();
            high = ImGui::GetItemRectMax();
        };
    }
    ImVec2 at(float share) const { return {low.x + share * (high.x - low.x), 0.5f * (low.y + high.y)}; }
};

TEST_F(ImguiFieldsTest, DrawsEachKindOfFieldAndChangesNothing) {
    const std::vector<std::string> before = values_of(all_);
    for (int i = 0; i < 5; ++i) frame(drawing());
    EXPECT_EQ(values_of(all_), before);
    EXPECT_FALSE(changed_);
    EXPECT_EQ(rows_, before.size());
}

TEST_F(ImguiFieldsTest, ShowsNamesUnitsAndValues) {
    frame(drawing());
    const std::string text = text_of(drawing());
    for (const char* word :
         {"flag", "whole", "-3", "number", "0.5", "angle", "deg", "57.29", "huge", "cd", "2e+08", "place",
          "1000000", "2.5", "rotation", "yaw pitch roll", "choice", "second"}) {
        EXPECT_THAT(text, testing::HasSubstr(word));
    }
    EXPECT_THAT(text, testing::Not(testing::HasSubstr("rad")));
}

TEST_F(ImguiFieldsTest, AMouseAnywhereChangesNothingWithoutAClick) {
    const std::vector<std::string> before = values_of(all_);
    for (int y = 0; y < 400; y += 7) {
        mouse(ImVec2(600, static_cast<float>(y)), false);
        frame(drawing());
    }
    EXPECT_EQ(values_of(all_), before);
}

TEST_F(ImguiFieldsTest, AClickTogglesAFlag) {
    OneField<bool> flag{.value = false, .info = {}};
    frame(flag.drawing());
    frame(flag.drawing());
    click(flag.at(0.5f), flag.drawing());
    EXPECT_TRUE(flag.value);
    EXPECT_TRUE(flag.changed);
}

TEST_F(ImguiFieldsTest, ASliderGoesToWhereItIsClickedAndNoFurtherThanItsEnds) {
    OneField<float> number{.value = 2.0f, .info = {.min = 2, .max = 6}};
    frame(number.drawing());
    frame(number.drawing());
    click(number.at(0.5f), number.drawing());
    EXPECT_NEAR(number.value, 4.0f, 0.05f);
    mouse(number.at(0.5f), true);
    frame(number.drawing());
    mouse(ImVec2(990, number.at(0.5f).y), true);
    frame(number.drawing());
    EXPECT_EQ(number.value, 6.0f);
}

TEST_F(ImguiFieldsTest, ALogarithmicSliderHasThePowersOfTenEvenlySpread) {
    OneField<float> number{.value = 1.0f, .info = {.min = 0.01, .max = 100, .look = FieldLook::logarithmic}};
    frame(number.drawing());
    frame(number.drawing());
    click(number.at(0.75f), number.drawing());
    EXPECT_NEAR(std::log10(number.value), 1.0f, 0.05f);
}

TEST_F(ImguiFieldsTest, AnAngleIsSetInDegreesAndKeptInRadians) {
    OneField<float> angle{.value = 0.1f, .info = {.min = 0, .max = 3.14159265, .look = FieldLook::angle}};
    frame(angle.drawing());
    frame(angle.drawing());
    click(angle.at(0.5f), angle.drawing());
    EXPECT_NEAR(angle.value, 0.5f * pi, 0.02f);
}

TEST_F(ImguiFieldsTest, EveryComponentWithRandomValuesStaysAsItIs) {
    App app;
    EditHistory history;
    const EditedScene scene{app.world, app.registry(), history};
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        for (const ComponentType& type : app.registry().types()) {
            SCOPED_TRACE(fmt::format("{}, seed {}", type.name, seed));
            const Entity entity = app.world.create();
            type.add_default(app.world, entity);
            RandomFields random(seed);
            type.visit(app.world, entity, random);
            FieldClamp clamp;
            type.visit(app.world, entity, clamp);
            FieldLister before, after;
            type.visit_copy(app.world, entity, before);
            for (int i = 0; i < 2; ++i) {
                frame([&] { EXPECT_FALSE(edit_component(scene, type, entity)); });
            }
            type.visit_copy(app.world, entity, after);
            ASSERT_EQ(before.rows.size(), after.rows.size());
            for (std::size_t i = 0; i < before.rows.size(); ++i)
                EXPECT_EQ(before.rows[i].value, after.rows[i].value);
        }
    }
}

}  // namespace
}  // namespace sl
