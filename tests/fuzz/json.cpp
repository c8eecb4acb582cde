// SPDX-License-Identifier: MIT
// A JSON text: what is read is what the library reads, and is written and read again the same.
#include "engine/core/json_text.h"

#include <nlohmann/json.hpp>

#include "engine/core/check.h"
#include "engine/core/error.h"
#include "tests/fuzz/input_folder.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = sl::text_of(data, size);
    nlohmann::json value;
    try {
        value = sl::parse_json(text, "input");
    } catch (const sl::Error&) {
        return 0;
    }
    CHECK(value == nlohmann::json::parse(text, nullptr, false), "the library reads it as something else");
    const std::string written = sl::json_text(nlohmann::ordered_json(value));
    CHECK(sl::parse_json(written, "written") == value, "it is written as something else");
    return 0;
}
