// SPDX-License-Identifier: MIT
#include "engine/core/field_list.h"

#include <fmt/ranges.h>

#include "engine/core/field_range.h"

namespace sl {

namespace {

template <class Vector>
std::string vector_text(const Vector& value) {
    std::string text;
    for (int axis = 0; axis < Vector::length(); ++axis)
        text += fmt::format("{}{}", axis > 0 ? "," : "", value[axis]);
    return text;
}

FieldRow row_without_range(std::string_view name, std::string_view type, std::string value,
                           const FieldInfo& info) {
    FieldRow row;
    row.name = name;
    row.type = type;
    row.value = std::move(value);
    row.unit = info.unit;
    row.help = info.help;
    return row;
}

std::string table_cell(std::string_view text) {
    std::string cell;
    for (const char c : text) {
        if (c == '|') cell += '\\';
        cell += c;
    }
    return cell;
}

}  // namespace

template <class T>
void FieldLister::add_number(std::string_view name, std::string_view type, std::string value,
                             const FieldInfo& info) {
    FieldRow row = row_without_range(name, type, std::move(value), info);
    row.min = std::integral<T> ? static_cast<double>(field_range<T>(info).low) : info.min;
    row.max = std::integral<T> ? static_cast<double>(field_range<T>(info).high) : info.max;
    FieldInfo without_unit = info;
    without_unit.unit = "";
    row.range = range_text<T>(without_unit);
    rows.push_back(std::move(row));
}

void FieldLister::field(std::string_view name, bool& value, const FieldInfo& info) {
    rows.push_back(row_without_range(name, "bool", value ? "true" : "false", info));
    rows.back().range = "true or false";
}
void FieldLister::field(std::string_view name, std::int32_t& value, const FieldInfo& info) {
    add_number<std::int32_t>(name, "int", fmt::format("{}", value), info);
}
void FieldLister::field(std::string_view name, std::uint32_t& value, const FieldInfo& info) {
    add_number<std::uint32_t>(name, "uint", fmt::format("{}", value), info);
}
void FieldLister::field(std::string_view name, float& value, const FieldInfo& info) {
    add_number<float>(name, "float", fmt::format("{}", value), info);
}
void FieldLister::field(std::string_view name, double& value, const FieldInfo& info) {
    add_number<double>(name, "double", fmt::format("{}", value), info);
}
void FieldLister::field(std::string_view name, vec2& value, const FieldInfo& info) {
    add_number<float>(name, "vec2", vector_text(value), info);
}
void FieldLister::field(std::string_view name, vec3& value, const FieldInfo& info) {
    add_number<float>(name, "vec3", vector_text(value), info);
}
void FieldLister::field(std::string_view name, dvec3& value, const FieldInfo& info) {
    add_number<double>(name, "dvec3", vector_text(value), info);
}
void FieldLister::field(std::string_view name, quat& value, const FieldInfo& info) {
    std::string text = fmt::format("{},{},{},{}", value.x, value.y, value.z, value.w);
    rows.push_back(row_without_range(name, "rotation", std::move(text), info));
}
void FieldLister::field(std::string_view name, std::string& value, const FieldInfo& info) {
    rows.push_back(row_without_range(name, info.look == FieldLook::file ? "file" : "text", value, info));
}
void FieldLister::choice(std::string_view name, std::size_t& index, std::span<const std::string_view> names,
                         const FieldInfo& info) {
    const std::size_t known = std::min(index, names.size() - 1);
    rows.push_back(row_without_range(name, "choice", std::string(names[known]), info));
    rows.back().choices.assign(names.begin(), names.end());
    rows.back().range = fmt::format("{}", fmt::join(names, ", "));
}

std::string markdown_table(std::span<const FieldRow> rows) {
    std::string table =
        "| field | default | range | unit | what it does |\n| --- | --- | --- | --- | --- |\n";
    for (const FieldRow& row : rows) {
        table += fmt::format("| `{}` | {} | {} | {} | {} |\n", row.name, table_cell(row.value),
                             table_cell(row.range), table_cell(row.unit), table_cell(row.help));
    }
    return table;
}

}  // namespace sl
