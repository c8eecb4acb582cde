// SPDX-License-Identifier: MIT
#include "engine/core/json_text.h"

#include <algorithm>

#include "engine/core/closest_name.h"
#include "engine/core/error.h"
#include "engine/core/json_read.h"

namespace sl {

using nlohmann::json;
using nlohmann::ordered_json;

namespace {

/// "file:line:column" of a byte.
std::string position(std::string_view text, std::size_t byte, std::string_view file) {
    const std::string_view before = text.substr(0, std::min(byte, text.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t line_start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
    return fmt::format("{}:{}:{}", file, line, before.size() - line_start + 1);
}

constexpr std::size_t widest_line = 110;
constexpr std::size_t indent_step = 2;

std::string scalar(const ordered_json& value) {
    return value.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

std::string on_one_line(const ordered_json& value) {
    if (!value.is_structured()) return scalar(value);
    std::string text;
    for (const auto& [key, item] : value.items()) {
        if (!text.empty()) text += ", ";
        if (value.is_object()) text += scalar(key) + ": ";
        text += on_one_line(item);
    }
    return value.is_object() ? fmt::format("{{{}}}", text) : fmt::format("[{}]", text);
}

bool holds_object(const ordered_json& value) {
    return std::any_of(value.begin(), value.end(), [](const auto& item) {
        return item.is_object() || (item.is_array() && holds_object(item));
    });
}

void append(std::string& text, const ordered_json& value, std::size_t indent, std::size_t column) {
    if (!value.is_structured() || !holds_object(value)) {
        const std::string flat = on_one_line(value);
        if (!value.is_structured() || value.empty() || column + flat.size() <= widest_line) {
            text += flat;
            return;
        }
    }
    const std::string margin(indent + indent_step, ' ');
    text += value.is_object() ? "{" : "[";
    const char* separator = "\n";
    for (const auto& [key, item] : value.items()) {
        const std::string head = value.is_object() ? scalar(key) + ": " : "";
        text += fmt::format("{}{}{}", separator, margin, head);
        append(text, item, indent + indent_step, margin.size() + head.size() + 1);
        separator = ",\n";
    }
    text += fmt::format("\n{}{}", std::string(indent, ' '), value.is_object() ? '}' : ']');
}

}  // namespace

json parse_json(std::string_view text, std::string_view file) {
    JsonRead read = read_json(text, {.deepest = deepest_json, .most_memory = most_json_memory});
    if (read.fault) fail("{}: {}", position(text, read.fault->byte, file), read.fault->message);
    if (read.repeated_key) fail("{}: an object has the key '{}' twice", file, for_message(*read.repeated_key));
    return std::move(read.document);
}

std::string json_text(const ordered_json& value) {
    std::string text;
    append(text, value, 0, 0);
    return text + "\n";
}

std::string without_comments(std::string text) {
    bool in_string = false;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] == '"') in_string = !in_string;
        if (in_string && text[at] == '\\') ++at;
        if (in_string || text[at] != '/' || at + 1 == text.size()) continue;
        const bool line = text[at + 1] == '/', block = text[at + 1] == '*';
        if (!line && !block) continue;
        const std::size_t close = line ? std::min(text.find('\n', at), text.size()) : text.find("*/", at + 2);
        if (close == std::string::npos) return text;
        const std::size_t end = line ? close : close + 2;
        for (std::size_t i = at; i < end; ++i) {
            if (text[i] != '\n') text[i] = ' ';
        }
        at = end - 1;
    }
    return text;
}

}  // namespace sl
