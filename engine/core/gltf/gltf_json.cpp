// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_json.h"

#include "engine/core/closest_name.h"
#include "engine/core/json_read.h"

namespace sl {

using nlohmann::json;

namespace {

/// Far more than a model needs: 12 million numbers, or some hundred thousand nodes.
constexpr std::size_t most_memory = std::size_t{3} << 26;

}  // namespace

json read_gltf_json(std::string_view text, std::size_t first_byte, GltfFaults& faults) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (text.starts_with(byte_order_mark)) {
        faults.note(fmt::format("byte {}", first_byte), "the JSON begins with a byte order mark, which it must not");
        text.remove_prefix(byte_order_mark.size());
        first_byte += byte_order_mark.size();
    }
    if (const auto end = text.find_last_not_of('\0'); end != std::string_view::npos && end + 1 < text.size()) {
        faults.note(fmt::format("byte {}", first_byte + end + 1), "the JSON is padded with zeros, not with spaces");
        text = text.substr(0, end + 1);
    }
    JsonRead read = read_json(text, {.deepest = deepest_gltf, .most_memory = most_memory});
    if (read.fault) {
        faults.fatal(fmt::format("byte {}", first_byte + read.fault->byte), "is no JSON that can be read: {}", read.fault->message);
    }
    if (read.repeated_key) {
        faults.note("", "an object has the key '{}' twice; the last one counts", for_message(*read.repeated_key));
    }
    return std::move(read.document);
}

}  // namespace sl
