// SPDX-License-Identifier: MIT
#include "engine/core/fields_json.h"

#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

#include "engine/core/closest_name.h"
#include "engine/core/error.h"
#include "engine/core/field_clamp.h"
#include "engine/core/field_range.h"

namespace sl {

using nlohmann::json;
using nlohmann::ordered_json;

JsonReader::JsonReader(const json& object, std::string where) : object_(object), where_(std::move(where)) {
    if (!object.is_object()) fail("{}: must be an object {{…}}, not {}", where_, object.type_name());
}

void JsonReader::check_all_used() const {
    for (const auto& item : object_.items()) {
        if (std::find(known_.begin(), known_.end(), item.key()) != known_.end()) continue;
        fail("{}: {}", where_, no_such_name("field", item.key(), known_));
    }
}

bool JsonReader::has(std::string_view name) {
    known_.emplace_back(name);
    return object_.contains(name);
}

bool JsonReader::read_bool(std::string_view name) {
    const json& value = *object_.find(name);
    if (!value.is_boolean()) fail("{}: must be true or false, not {}", place(name), value.type_name());
    return value.get<bool>();
}

void JsonReader::read_numbers(std::string_view name, std::span<double> numbers, const FieldInfo&) {
    const json& value = *object_.find(name);
    if (numbers.size() == 1) {
        if (!value.is_number()) fail("{}: must be a number, not {}", place(name), value.type_name());
        numbers[0] = value.get<double>();
        return;
    }
    if (!value.is_array() || value.size() != numbers.size()) {
        fail("{}: must be an array of {} numbers, not {}{}", place(name), numbers.size(),
             value.is_array() ? "of " : "",
             value.is_array() ? std::to_string(value.size()) : value.type_name());
    }
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (!value[i].is_number())
            fail("{}/{}: must be a number, not {}", place(name), i, value[i].type_name());
        numbers[i] = value[i].get<double>();
    }
}

std::string JsonReader::read_text(std::string_view name) {
    const json& value = *object_.find(name);
    if (!value.is_string()) fail("{}: must be a text, not {}", place(name), value.type_name());
    return value.get<std::string>();
}

std::string JsonReader::place(std::string_view name) const {
    return fmt::format("{}/{}", where_, name);
}

double shortest_double(float value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    double number = 0.0;
    std::from_chars(text.data(), end, number);
    // Rounding the digits first to double and then to float could end on the neighbour.
    return static_cast<float>(number) == value ? number : static_cast<double>(value);
}

namespace {

/// 100 rather than 100.0. Not so for -0, whose sign a whole number would lose.
ordered_json json_number(double value) {
    constexpr double exact_whole = 1e15;
    const bool whole = std::trunc(value) == value && std::abs(value) < exact_whole;
    if (whole && (value != 0.0 || !std::signbit(value))) return static_cast<std::int64_t>(value);
    return value;
}
ordered_json json_number(float value, const FieldInfo& info) {
    return json_number(shortest_double(clamped_to_range(value, info)));
}
ordered_json json_number(double value, const FieldInfo& info) {
    return json_number(clamped_to_range(value, info));
}

template <class Vector>
ordered_json json_array(const Vector& value, const FieldInfo& info) {
    ordered_json array = ordered_json::array();
    for (int axis = 0; axis < Vector::length(); ++axis) array.push_back(json_number(value[axis], info));
    return array;
}

}  // namespace

JsonWriter::JsonWriter(ordered_json& object) : object_(object) {
    object_ = ordered_json::object();
}

void JsonWriter::field(std::string_view name, bool& value, const FieldInfo&) {
    object_[std::string(name)] = value;
}
void JsonWriter::field(std::string_view name, std::int32_t& value, const FieldInfo& info) {
    object_[std::string(name)] = clamped_to_range(value, info);
}
void JsonWriter::field(std::string_view name, std::uint32_t& value, const FieldInfo& info) {
    object_[std::string(name)] = clamped_to_range(value, info);
}
void JsonWriter::field(std::string_view name, float& value, const FieldInfo& info) {
    object_[std::string(name)] = json_number(value, info);
}
void JsonWriter::field(std::string_view name, double& value, const FieldInfo& info) {
    object_[std::string(name)] = json_number(value, info);
}
void JsonWriter::field(std::string_view name, vec2& value, const FieldInfo& info) {
    object_[std::string(name)] = json_array(value, info);
}
void JsonWriter::field(std::string_view name, vec3& value, const FieldInfo& info) {
    object_[std::string(name)] = json_array(value, info);
}
void JsonWriter::field(std::string_view name, dvec3& value, const FieldInfo& info) {
    object_[std::string(name)] = json_array(value, info);
}
void JsonWriter::field(std::string_view name, quat& value, const FieldInfo&) {
    const quat unit = nearest_rotation(value);
    ordered_json& array = object_[std::string(name)] = ordered_json::array();
    for (const float number : {unit.x, unit.y, unit.z, unit.w}) {
        array.push_back(json_number(shortest_double(number)));
    }
}
void JsonWriter::field(std::string_view name, std::string& value, const FieldInfo&) {
    object_[std::string(name)] = value;
}
void JsonWriter::choice(std::string_view name, std::size_t& index, std::span<const std::string_view> names,
                        const FieldInfo&) {
    object_[std::string(name)] = std::string(names[std::min(index, names.size() - 1)]);
}

}  // namespace sl
