// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_uri.h"

#include <algorithm>
#include <array>
#include <optional>

namespace sl {

namespace {

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

std::string in_small_letters(std::string_view text) {
    std::string small(text);
    for (char& c : small) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return small;
}

std::optional<unsigned> hex_digit(char c) {
    if (is_digit(c)) return static_cast<unsigned>(c - '0');
    if (c >= 'a' && c <= 'f') return static_cast<unsigned>(c - 'a' + 10);
    if (c >= 'A' && c <= 'F') return static_cast<unsigned>(c - 'A' + 10);
    return std::nullopt;
}

/// "%20" becomes a space. Nothing where a '%' stands alone.
std::optional<std::string> without_escapes(std::string_view text) {
    std::string plain;
    plain.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            plain += text[i];
            continue;
        }
        if (text.size() - i < 3) return std::nullopt;
        const auto high = hex_digit(text[i + 1]), low = hex_digit(text[i + 2]);
        if (!high || !low) return std::nullopt;
        plain += static_cast<char>(*high * 16 + *low);
        i += 2;
    }
    return plain;
}

constexpr std::uint8_t no_base64 = 64;
constexpr std::array<std::uint8_t, 256> base64_values = [] {
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::array<std::uint8_t, 256> values{};
    values.fill(no_base64);
    for (std::size_t i = 0; i < letters.size(); ++i) {
        values[static_cast<std::uint8_t>(letters[i])] = static_cast<std::uint8_t>(i);
    }
    return values;
}();

std::optional<std::vector<std::byte>> from_base64(std::string_view text) {
    if (text.size() % 4 != 0) return std::nullopt;
    for (int padding = 0; padding < 2 && text.ends_with('='); ++padding) text.remove_suffix(1);
    std::vector<std::byte> bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    unsigned bit_count = 0;
    for (const char c : text) {
        const std::uint8_t value = base64_values[static_cast<std::uint8_t>(c)];
        if (value == no_base64) return std::nullopt;
        bits = bits << 6 | value;
        bit_count += 6;
        if (bit_count < 8) continue;
        bit_count -= 8;
        bytes.push_back(static_cast<std::byte>(bits >> bit_count & 0xFF));
    }
    return bytes;
}

/// "application/octet-stream;base64,AA==", what follows "data:".
GltfUri data_uri(std::string_view text) {
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos) return {};
    std::string_view head = text.substr(0, comma), content = text.substr(comma + 1);
    const bool is_base64 = in_small_letters(head.substr(head.size() - std::min<std::size_t>(head.size(), 7))) == ";base64";
    if (is_base64) head.remove_suffix(7);
    const std::string_view type = head.substr(0, head.find(';'));
    // Parameters, each a name and a value.
    std::string_view rest = head.substr(type.size());
    while (!rest.empty()) {
        rest.remove_prefix(1);
        const std::string_view parameter = rest.substr(0, rest.find(';'));
        if (parameter.find('=') == std::string_view::npos || parameter.front() == '=') return {};
        rest.remove_prefix(parameter.size());
    }
    if (!type.empty() && type.find('/') == std::string_view::npos) return {};
    GltfUri uri{.kind = GltfUri::Kind::data, .media_type = in_small_letters(type)};
    // Most data have no escapes, and may be large.
    const bool has_escapes = content.find('%') != std::string_view::npos;
    const auto escaped = has_escapes ? without_escapes(content) : std::string();
    if (!escaped) return {};
    const std::string_view plain = has_escapes ? *escaped : content;
    if (is_base64) {
        auto bytes = from_base64(plain);
        if (!bytes) return {};
        uri.data = std::move(*bytes);
    } else {
        std::transform(plain.begin(), plain.end(), std::back_inserter(uri.data),
                       [](char c) { return static_cast<std::byte>(c); });
    }
    return uri;
}

}  // namespace

GltfUri read_gltf_uri(std::string_view text) {
    const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
    if (text.empty() || std::any_of(text.begin(), text.end(), is_control)) return {};
    const std::size_t colon = text.find(':');
    if (colon != std::string_view::npos && colon < text.find_first_of("/?#")) {
        const std::string_view scheme = text.substr(0, colon);
        const auto is_allowed = [](char c) { return is_letter(c) || is_digit(c) || c == '+' || c == '-' || c == '.'; };
        if (scheme.empty() || !is_letter(scheme.front()) || !std::all_of(scheme.begin(), scheme.end(), is_allowed)) return {};
        if (in_small_letters(scheme) == "data") return data_uri(text.substr(colon + 1));
        return {.kind = GltfUri::Kind::absolute};
    }
    auto path = without_escapes(text.substr(0, text.find_first_of("?#")));
    if (!path || path->empty() || path->find('\0') != std::string::npos) return {};
    if (path->starts_with('/')) return {.kind = GltfUri::Kind::absolute};
    return {.kind = GltfUri::Kind::relative, .path = std::move(*path)};
}

}  // namespace sl
