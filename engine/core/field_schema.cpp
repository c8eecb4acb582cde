// SPDX-License-Identifier: MIT
#include "engine/core/field_schema.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "engine/core/field_range.h"
#include "engine/core/fields_json.h"

namespace sl {

using nlohmann::ordered_json;

namespace {

/// As it stands in files.
template <class T>
ordered_json written(T value, const FieldInfo& info) {
    ordered_json object;
    JsonWriter writer(object);
    writer.field("value", value, info);
    return object["value"];
}

template <class T>
ordered_json number_schema(const FieldInfo& info) {
    ordered_json schema = {{"type", std::integral<T> ? "integer" : "number"}};
    const FieldRange<T> range = field_range<T>(info);
    if (std::integral<T> || range.low > std::numeric_limits<T>::lowest()) schema["minimum"] = written(range.low, info);
    if (std::integral<T> || range.high < std::numeric_limits<T>::max()) schema["maximum"] = written(range.high, info);
    return schema;
}

ordered_json array_schema(ordered_json items, int length) {
    return {{"type", "array"}, {"items", std::move(items)}, {"minItems", length}, {"maxItems", length}};
}

template <class Vector>
ordered_json vector_schema(const FieldInfo& info) {
    return array_schema(number_schema<typename Vector::value_type>(info), Vector::length());
}

std::string description(const FieldInfo& info) {
    return info.unit.empty() ? std::string(info.help) : fmt::format("{} Unit: {}.", info.help, info.unit);
}

}  // namespace

FieldSchema::FieldSchema(ordered_json& properties, std::string_view choice, std::size_t alternative)
    : properties_(properties), choice_(choice), alternative_(alternative) {
    properties_ = ordered_json::object();
}

template <class T>
void FieldSchema::add(std::string_view name, T& value, const FieldInfo& info, ordered_json schema) {
    ordered_json& property = properties_[std::string(name)] = {{"description", description(info)}};
    property.update(schema);
    property["default"] = written(value, info);
}

void FieldSchema::field(std::string_view name, bool& value, const FieldInfo& info) {
    add(name, value, info, {{"type", "boolean"}});
}
void FieldSchema::field(std::string_view name, std::int32_t& value, const FieldInfo& info) {
    add(name, value, info, number_schema<std::int32_t>(info));
}
void FieldSchema::field(std::string_view name, std::uint32_t& value, const FieldInfo& info) {
    add(name, value, info, number_schema<std::uint32_t>(info));
}
void FieldSchema::field(std::string_view name, float& value, const FieldInfo& info) {
    add(name, value, info, number_schema<float>(info));
}
void FieldSchema::field(std::string_view name, double& value, const FieldInfo& info) {
    add(name, value, info, number_schema<double>(info));
}
void FieldSchema::field(std::string_view name, vec2& value, const FieldInfo& info) {
    add(name, value, info, vector_schema<vec2>(info));
}
void FieldSchema::field(std::string_view name, vec3& value, const FieldInfo& info) {
    add(name, value, info, vector_schema<vec3>(info));
}
void FieldSchema::field(std::string_view name, dvec3& value, const FieldInfo& info) {
    add(name, value, info, vector_schema<dvec3>(info));
}
void FieldSchema::field(std::string_view name, quat& value, const FieldInfo& info) {
    add(name, value, info, array_schema({{"type", "number"}}, 4));
}
void FieldSchema::field(std::string_view name, std::string& value, const FieldInfo& info) {
    add(name, value, info, {{"type", "string"}});
}

void FieldSchema::choice(std::string_view name, std::size_t& index, std::span<const std::string_view> names,
                         const FieldInfo& info) {
    ordered_json& property = properties_[std::string(name)] = {{"description", description(info)}};
    if (name == choice_) {
        index = alternative_;
        property["const"] = names[index];
    } else {
        property["enum"] = std::vector<std::string_view>(names.begin(), names.end());
        property["default"] = names[std::min(index, names.size() - 1)];
    }
}

}  // namespace sl
