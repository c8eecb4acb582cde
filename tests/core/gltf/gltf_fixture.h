// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <map>

#include "engine/core/error.h"
#include "engine/core/gltf/gltf_check.h"

namespace sl {

inline std::span<const std::byte> bytes_of(std::string_view text) {
    return {reinterpret_cast<const std::byte*>(text.data()), text.size()};
}

/// Numbers as they lie in a file.
template <class Number>
std::string packed(std::initializer_list<Number> numbers) {
    std::string bytes(numbers.size() * sizeof(Number), '\0');
    std::memcpy(bytes.data(), numbers.begin(), bytes.size());
    return bytes;
}

using Files = std::map<std::string, std::string>;

/// "fatal /nodes/0: message" for each fault of a file with others beside it.
inline std::vector<std::string> gltf_faults(std::string_view file, const Files& beside = {}) {
    const auto load = [&](const std::string& path) {
        const auto found = beside.find(path);
        if (found == beside.end()) fail("{}: there is no such file", path);
        const auto bytes = bytes_of(found->second);
        return std::vector<std::byte>(bytes.begin(), bytes.end());
    };
    std::vector<std::string> lines;
    const GltfChecked checked = check_gltf(bytes_of(file), load);
    for (const GltfFault& fault : checked.faults.list()) {
        lines.push_back(fmt::format("{} {}: {}", fault.fatal ? "fatal" : "note", fault.where, fault.message));
    }
    return lines;
}

/// A document with an asset and these members.
inline std::string document_with(std::string_view members) {
    return fmt::format(R"({{"asset": {{"version": "2.0"}}{}{}}})", members.empty() ? "" : ", ", members);
}

inline std::vector<std::string> faults_with(std::string_view members, const Files& beside = {}) {
    return gltf_faults(document_with(members), beside);
}

/// The only fault, and what its message holds.
MATCHER_P2(IsOnly, head, part, "") {
    return arg.size() == 1 && arg[0].starts_with(std::string(head) + ": ") && arg[0].find(part) != std::string::npos;
}

inline std::string word(std::uint32_t value) {
    return packed<std::uint32_t>({value});
}
inline std::string chunk(std::string_view kind, std::string_view content) {
    return word(static_cast<std::uint32_t>(content.size())) + std::string(kind) + std::string(content);
}
inline std::string container(std::string_view chunks) {
    return "glTF" + word(2) + word(static_cast<std::uint32_t>(12 + chunks.size())) + std::string(chunks);
}
/// Padded with spaces.
inline std::string json_chunk(std::string text) {
    text.resize((text.size() + 3) / 4 * 4, ' ');
    return chunk("JSON", text);
}
inline const std::string binary_kind{"BIN\0", 4};

}  // namespace sl
