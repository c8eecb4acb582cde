// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace sl {

/// What a text may ask for.
struct JsonBounds {
    int deepest;                                                        ///< levels of arrays and objects
    std::size_t most_memory = std::numeric_limits<std::size_t>::max();  ///< of the document, its texts apart, bytes
};

/// Why a text is no JSON, or not read.
struct JsonFault {
    std::size_t byte;     ///< in the text
    std::string message;  ///< in one line
};

/// What was read of a text.
struct JsonRead {
    nlohmann::json document;  ///< null where there is a fault
    std::optional<JsonFault> fault;
    std::optional<std::string> repeated_key;  ///< the first that an object names twice; the last value counts
};

/// Parses a text that may be anything, in time and memory that are in proportion to its length. Throws nothing but
/// std::bad_alloc.
JsonRead read_json(std::string_view text, const JsonBounds& bounds);

}  // namespace sl
