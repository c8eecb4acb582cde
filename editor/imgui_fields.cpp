// SPDX-License-Identifier: MIT
#include "editor/imgui_fields.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <string>

#include "editor/imgui_rotation.h"
#include "engine/core/field_range.h"
#include "engine/core/srgb.h"

namespace sl {

namespace {

/// A field's row: its name is written and its widget is next. Widgets inside need no names of their own.
class Row {
  public:
    Row(std::string_view name, std::string_view unit, const FieldInfo& info) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::PushID(name.data(), name.data() + name.size());
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(name.data(), name.data() + name.size());
        explain(info);
        if (!unit.empty()) {
            ImGui::SameLine();
            ImGui::TextDisabled("%.*s", static_cast<int>(unit.size()), unit.data());
            explain(info);
        }
        ImGui::TableNextColumn();
        ImGui::SetNextItemWidth(-std::numeric_limits<float>::min());
    }
    ~Row() { ImGui::PopID(); }
    Row(const Row&) = delete;
    Row& operator=(const Row&) = delete;

    static void explain(const FieldInfo& info) {
        if (info.help.empty() || !ImGui::IsItemHovered()) return;
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24.0f);
        ImGui::TextUnformatted(info.help.data(), info.help.data() + info.help.size());
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }
};

template <class T>
constexpr ImGuiDataType data_type = ImGuiDataType_Float;
template <>
constexpr ImGuiDataType data_type<std::int32_t> = ImGuiDataType_S32;
template <>
constexpr ImGuiDataType data_type<std::uint32_t> = ImGuiDataType_U32;
template <>
constexpr ImGuiDataType data_type<double> = ImGuiDataType_Double;

template <class T>
constexpr const char* number_format = "%.6g";
template <>
constexpr const char* number_format<std::int32_t> = "%d";
template <>
constexpr const char* number_format<std::uint32_t> = "%u";
template <>
constexpr const char* number_format<double> = "%.8g";

/// A range that a slider can show; anything wider is dragged without end.
bool has_slider(const FieldInfo& info) {
    const double extent = info.max - info.min;
    return extent <= 1e4 || (info.look == FieldLook::logarithmic && info.min >= 0 && extent <= 1e9);
}

/// `count` numbers side by side.
template <class T>
bool numbers(T* values, int count, const FieldInfo& info) {
    const FieldRange<T> range = field_range<T>(info);
    const bool logarithmic = info.look == FieldLook::logarithmic;
    ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp;
    if (count == 1 && has_slider(info)) {
        if (logarithmic) flags |= ImGuiSliderFlags_Logarithmic;
        return ImGui::SliderScalar("##value", data_type<T>, values, &range.low, &range.high, number_format<T>,
                                   flags);
    }
    // One pixel of dragging; a hundredth of the range where there is a small one.
    const double extent = info.max - info.min;
    const float speed = std::integral<T> ? 0.2f : extent <= 10 ? static_cast<float>(extent * 0.005) : 0.02f;
    return ImGui::DragScalarN("##value", data_type<T>, values, count, speed, &range.low, &range.high,
                              number_format<T>, flags);
}

/// Numbers of linear light, and a field of the colour as a screen shows it that opens a picker.
bool colour(vec3& linear, const FieldInfo& info) {
    vec3 shown(srgb_from_linear(linear.x), srgb_from_linear(linear.y), srgb_from_linear(linear.z));
    const float side = ImGui::GetFrameHeight();
    if (ImGui::ColorButton("##swatch", ImVec4(shown.x, shown.y, shown.z, 1.0f), ImGuiColorEditFlags_NoTooltip,
                           ImVec2(side, side))) {
        ImGui::OpenPopup("picker");
    }
    bool changed = false;
    if (ImGui::BeginPopup("picker")) {
        if (ImGui::ColorPicker3("##picker", &shown.x, ImGuiColorEditFlags_NoSidePreview)) {
            linear = vec3(linear_from_srgb(shown.x), linear_from_srgb(shown.y), linear_from_srgb(shown.z));
            changed = true;
        }
        ImGui::EndPopup();
    }
    ImGui::SameLine(0.0f, ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::SetNextItemWidth(-std::numeric_limits<float>::min());
    return numbers(&linear.x, 3, info) || changed;
}

/// Kept in radians, shown in degrees.
template <class T>
bool degrees(T& radians, const FieldInfo& info) {
    T shown = glm::degrees(radians);
    FieldInfo in_degrees = info;
    in_degrees.min = glm::degrees(std::max(info.min, -1e6));
    in_degrees.max = glm::degrees(std::min(info.max, 1e6));
    if (!numbers(&shown, 1, in_degrees)) return false;
    radians = glm::radians(shown);
    return true;
}

}  // namespace

void ImguiFields::field(std::string_view name, bool& value, const FieldInfo& info) {
    const Row row(name, info.unit, info);
    note(name, ImGui::Checkbox("##value", &value));
}

void ImguiFields::field(std::string_view name, std::int32_t& value, const FieldInfo& info) {
    const Row row(name, info.unit, info);
    note(name, numbers(&value, 1, info));
}

void ImguiFields::field(std::string_view name, std::uint32_t& value, const FieldInfo& info) {
    const Row row(name, info.unit, info);
    note(name, numbers(&value, 1, info));
}

void ImguiFields::field(std::string_view name, float& value, const FieldInfo& info) {
    const bool angle = info.look == FieldLook::angle;
    const Row row(name, angle ? "deg" : info.unit, info);
    note(name, angle ? degrees(value, info) : numbers(&value, 1, info));
}

void ImguiFields::field(std::string_view name, double& value, const FieldInfo& info) {
    const bool angle = info.look == FieldLook::angle;
    const Row row(name, angle ? "deg" : info.unit, info);
    note(name, angle ? degrees(value, info) : numbers(&value, 1, info));
}

void ImguiFields::field(std::string_view name, vec2& value, const FieldInfo& info) {
    const Row row(name, info.unit, info);
    note(name, numbers(&value.x, 2, info));
}

void ImguiFields::field(std::string_view name, vec3& value, const FieldInfo& info) {
    const Row row(name, info.unit, info);
    note(name, info.look == FieldLook::colour ? colour(value, info) : numbers(&value.x, 3, info));
}

void ImguiFields::field(std::string_view name, dvec3& value, const FieldInfo& info) {
    const Row row(name, info.unit, info);
    note(name, numbers(&value.x, 3, info));
}

void ImguiFields::field(std::string_view name, quat& value, const FieldInfo& info) {
    const Row row(name, "yaw pitch roll, deg", info);
    note(name, edit_rotation(value));
}

void ImguiFields::field(std::string_view name, std::string& value, const FieldInfo& info) {
    const Row row(name, info.unit, info);
    note(name, ImGui::InputText("##value", &value));
}

void ImguiFields::choice(std::string_view name, std::size_t& index, std::span<const std::string_view> names,
                         const FieldInfo& info) {
    const Row row(name, info.unit, info);
    const std::size_t before = index;
    const std::string shown(index < names.size() ? names[index] : "");
    if (ImGui::BeginCombo("##value", shown.c_str())) {
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (ImGui::Selectable(std::string(names[i]).c_str(), i == before)) index = i;
        }
        ImGui::EndCombo();
    }
    note(name, index != before);
}

FieldTable::FieldTable(const char* id) : open_(ImGui::BeginTable(id, 2, ImGuiTableFlags_SizingStretchProp)) {
    if (!open_) return;
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, 0.45f);
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch, 0.55f);
}

FieldTable::~FieldTable() {
    if (open_) ImGui::EndTable();
}

}  // namespace sl
