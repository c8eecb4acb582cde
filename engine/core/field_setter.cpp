// SPDX-License-Identifier: MIT
#include "engine/core/field_setter.h"

#include <charconv>
#include <numbers>

#include "engine/core/closest_name.h"
#include "engine/core/error.h"

namespace sl {

namespace {

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::vector<std::string_view> split_at_commas(std::string_view text) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t comma = text.find(',');
        parts.push_back(trimmed(text.substr(0, comma)));
        if (comma == std::string_view::npos) return parts;
        text.remove_prefix(comma + 1);
    }
}

std::optional<double> number_from(std::string_view text, bool is_angle) {
    constexpr std::string_view degrees = "deg";
    const bool in_degrees = is_angle && text.ends_with(degrees);
    if (in_degrees) text = trimmed(text.substr(0, text.size() - degrees.size()));
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return in_degrees ? number * std::numbers::pi / 180.0 : number;
}

}  // namespace

void FieldSetter::check_found() const {
    if (!found_) fail("{}: {}", where_, no_such_name("field", name_, known_));
}

bool FieldSetter::has(std::string_view name) {
    known_.emplace_back(name);
    const bool is_it = name == name_;
    found_ |= is_it;
    return is_it;
}

bool FieldSetter::read_bool(std::string_view name) {
    const std::string_view text = trimmed(text_);
    if (text != "true" && text != "false") {
        fail("{}: must be true or false, is '{}'", place(name), for_message(text));
    }
    return text == "true";
}

void FieldSetter::read_numbers(std::string_view name, std::span<double> numbers, const FieldInfo& info) {
    const std::vector<std::string_view> parts = split_at_commas(text_);
    const bool is_angle = info.unit == "rad";
    if (parts.size() != numbers.size()) {
        fail("{}: needs {} with commas between, has {}", place(name),
             numbers.size() == 1 ? "1 number" : fmt::format("{} numbers", numbers.size()), parts.size());
    }
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::optional<double> number = number_from(parts[i], is_angle);
        if (!number) {
            fail("{}: '{}' is not a number{}", place(name), for_message(parts[i]),
                 is_angle ? "; write radians, or degrees as 30deg" : "");
        }
        numbers[i] = *number;
    }
}

std::string FieldSetter::read_text(std::string_view) {
    return text_;
}

std::string FieldSetter::place(std::string_view name) const {
    return fmt::format("{}.{}", where_, name);
}

}  // namespace sl
