// SPDX-License-Identifier: MIT
#include "engine/core/field_reader.h"

#include <algorithm>
#include <array>

#include "engine/core/closest_name.h"
#include "engine/core/error.h"
#include "engine/core/field_range.h"

namespace sl {

template <class T>
T FieldReader::checked(std::string_view name, double number, const FieldInfo& info) const {
    const std::optional<T> value = inside_range<T>(number, info);
    if (value) return *value;
    const bool fraction = std::integral<T> && std::isfinite(number) && std::trunc(number) != number;
    fail("{}: is {}, must be {}{}", place(name), number, fraction ? "a whole number, " : "",
         range_text<T>(info));
}

template <class Vector>
void FieldReader::read_vector(std::string_view name, Vector& value, const FieldInfo& info) {
    if (!has(name)) return;
    std::array<double, static_cast<std::size_t>(Vector::length())> numbers{};
    read_numbers(name, numbers, info);
    Vector read;
    for (int axis = 0; axis < Vector::length(); ++axis) {
        read[axis] =
            checked<typename Vector::value_type>(name, numbers[static_cast<std::size_t>(axis)], info);
    }
    value = read;
}

void FieldReader::field(std::string_view name, bool& value, const FieldInfo&) {
    if (has(name)) value = read_bool(name);
}

void FieldReader::field(std::string_view name, std::int32_t& value, const FieldInfo& info) {
    if (!has(name)) return;
    double number = 0.0;
    read_numbers(name, {&number, 1}, info);
    value = checked<std::int32_t>(name, number, info);
}

void FieldReader::field(std::string_view name, std::uint32_t& value, const FieldInfo& info) {
    if (!has(name)) return;
    double number = 0.0;
    read_numbers(name, {&number, 1}, info);
    value = checked<std::uint32_t>(name, number, info);
}

void FieldReader::field(std::string_view name, float& value, const FieldInfo& info) {
    if (!has(name)) return;
    double number = 0.0;
    read_numbers(name, {&number, 1}, info);
    value = checked<float>(name, number, info);
}

void FieldReader::field(std::string_view name, double& value, const FieldInfo& info) {
    if (!has(name)) return;
    double number = 0.0;
    read_numbers(name, {&number, 1}, info);
    value = checked<double>(name, number, info);
}

void FieldReader::field(std::string_view name, vec2& value, const FieldInfo& info) {
    read_vector(name, value, info);
}
void FieldReader::field(std::string_view name, vec3& value, const FieldInfo& info) {
    read_vector(name, value, info);
}
void FieldReader::field(std::string_view name, dvec3& value, const FieldInfo& info) {
    read_vector(name, value, info);
}

void FieldReader::field(std::string_view name, quat& value, const FieldInfo& info) {
    if (!has(name)) return;
    std::array<double, 4> numbers{};
    read_numbers(name, numbers, info);
    const std::optional<quat> rotation = unit_rotation(numbers);
    if (!rotation) {
        fail("{}: x, y, z, w = {}, {}, {}, {} is no rotation, because its length cannot be made 1",
             place(name), numbers[0], numbers[1], numbers[2], numbers[3]);
    }
    value = *rotation;
}

void FieldReader::field(std::string_view name, std::string& value, const FieldInfo&) {
    if (has(name)) value = read_text(name);
}

void FieldReader::choice(std::string_view name, std::size_t& index, std::span<const std::string_view> names,
                         const FieldInfo&) {
    if (!has(name)) return;
    const std::string text = read_text(name);
    const auto found = std::find(names.begin(), names.end(), text);
    if (found == names.end()) fail("{}: {}", place(name), no_such_name("choice", text, names));
    index = static_cast<std::size_t>(found - names.begin());
}

std::optional<quat> unit_rotation(std::span<const double, 4> numbers) {
    double square = 0.0;
    for (const double number : numbers) square += number * number;
    // Without the upper limit the square of a huge number is infinite.
    if (!(square > 1e-12 && square < 1e24)) return std::nullopt;
    // A float quaternion of length 1 is off by its rounding; dividing again would change what was saved.
    const double length = std::sqrt(square);
    const double factor = std::abs(length - 1.0) < 1e-6 ? 1.0 : 1.0 / length;
    const auto scaled = [&](std::size_t i) { return static_cast<float>(numbers[i] * factor); };
    return quat(scaled(3), scaled(0), scaled(1), scaled(2));
}

}  // namespace sl
