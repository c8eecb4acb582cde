// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_json.h"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <unordered_set>

#include "engine/core/closest_name.h"

namespace sl {

using nlohmann::json;

namespace {

constexpr std::size_t longest_reason = 240;

/// Walks a text before anything is built of it. The library's own filter while parsing takes time with the square of
/// an array's length, and its errors come as exceptions.
class TextCheck : public nlohmann::json_sax<json> {
  public:
    TextCheck(std::size_t first_byte, GltfFaults& faults) : first_byte_(first_byte), faults_(faults) {}

    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(std::int64_t) override { return true; }
    bool number_unsigned(std::uint64_t) override { return true; }
    bool number_float(double, const std::string&) override { return true; }
    bool string(std::string&) override { return true; }
    bool binary(json::binary_t&) override { return true; }
    bool start_object(std::size_t) override { return enter(); }
    bool end_object() override { return leave(); }
    bool start_array(std::size_t) override { return enter(); }
    bool end_array() override { return leave(); }

    bool key(std::string& name) override {
        if (!keys_.back().insert(name).second) {
            faults_.note("", "an object has the key '{}' twice; the last one counts", for_message(name));
        }
        return true;
    }

    bool parse_error(std::size_t byte, const std::string&, const json::exception& error) override {
        std::string_view reason = error.what();
        // "[json.exception.parse_error.101] parse error at line 1, column 2: THIS".
        if (const auto tag = reason.find("] "); tag != std::string_view::npos) reason.remove_prefix(tag + 2);
        const auto place = reason.find(": ");
        if (reason.starts_with("parse error") && place != std::string_view::npos) reason.remove_prefix(place + 2);
        faults_.fatal(fmt::format("byte {}", first_byte_ + (byte == 0 ? 0 : byte - 1)), "is no JSON: {}",
                      for_message(reason, longest_reason));
        return false;
    }

  private:
    bool enter() {
        keys_.emplace_back();
        if (keys_.size() <= deepest_gltf) return true;
        faults_.fatal("", "the JSON is nested deeper than {} levels", deepest_gltf);
        return false;
    }
    bool leave() {
        keys_.pop_back();
        return true;
    }

    std::size_t first_byte_;
    GltfFaults& faults_;
    std::vector<std::unordered_set<std::string>> keys_;
};

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
    // The library takes a zero for the end of the text: what follows would be dropped without a word.
    if (const auto zero = text.find('\0'); zero != std::string_view::npos) {
        faults.fatal(fmt::format("byte {}", first_byte + zero), "is no JSON: a zero stands in it");
        return {};
    }
    TextCheck check(first_byte, faults);
    if (!json::sax_parse(text, &check)) return {};
    return json::parse(text, nullptr, false);
}

}  // namespace sl
