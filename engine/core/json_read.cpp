// SPDX-License-Identifier: MIT
#include "engine/core/json_read.h"

#include <fmt/format.h>

#include "engine/core/closest_name.h"

namespace sl {

using nlohmann::json;

namespace {

constexpr std::size_t longest_reason = 240;
/// What a value takes, as an element and on the heap; a key with its node in the object's tree.
constexpr std::size_t value_bytes = sizeof(json), structure_bytes = 48, key_bytes = 80;

/// What must be known before the parser runs: it has no bound on depth, and takes a zero for the end of the text.
std::optional<JsonFault> fault_before_parsing(std::string_view text, int deepest) {
    int depth = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '\0') return JsonFault{i, "a zero byte stands in it"};
        if (c == '\\' && in_string) {
            ++i;
        } else if (c == '"') {
            in_string = !in_string;
        } else if (!in_string && (c == '{' || c == '[')) {
            if (++depth > deepest) return JsonFault{i, fmt::format("nested deeper than {} levels", deepest)};
        } else if (!in_string && (c == '}' || c == ']')) {
            --depth;
        }
    }
    return std::nullopt;
}

/// The part of a message of the JSON library that is for people: "[json.exception…] parse error at …: THIS".
std::string_view reason(std::string_view message) {
    const std::size_t tag = message.find("] ");
    if (tag != std::string_view::npos) message.remove_prefix(tag + 2);
    const std::size_t place = message.find(": ");
    if (message.starts_with("parse error") && place != std::string_view::npos) message.remove_prefix(place + 2);
    return message;
}

/// Builds the document out of the parser's events. The library's own way to watch them, a callback, takes time with the
/// square of an array's length.
class Builder : public nlohmann::json_sax<json> {
  public:
    explicit Builder(std::size_t most_memory) : memory_left_(most_memory) {}

    bool null() override { return put(nullptr); }
    bool boolean(bool value) override { return put(value); }
    bool number_integer(std::int64_t value) override { return put(value); }
    bool number_unsigned(std::uint64_t value) override { return put(value); }
    bool number_float(double value, const std::string&) override { return put(value); }
    bool string(std::string& value) override { return put(std::move(value)); }
    bool binary(json::binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(json::object()); }
    bool start_array(std::size_t) override { return open(json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(std::string& name) override {
        if (!afford(key_bytes)) return false;
        const auto [member, is_new] = open_.back()->get_ref<json::object_t&>().try_emplace(name);
        if (!is_new && !read.repeated_key) read.repeated_key = std::move(name);
        member_ = &member->second;
        return true;
    }

    bool parse_error(std::size_t byte, const std::string& last, const json::exception& error) override {
        // Of what is no JSON, the byte is the one after the wrong one; of a number out of range, the one after its last.
        const bool is_number = dynamic_cast<const json::out_of_range*>(&error) != nullptr;
        const std::size_t back = is_number ? last.size() : 1;
        read.fault = JsonFault{byte < back ? 0 : byte - back, for_message(reason(error.what()), longest_reason)};
        return false;
    }

    JsonRead read;

  private:
    bool afford(std::size_t bytes) {
        if (bytes > memory_left_) {
            read.fault = JsonFault{0, "it holds more values than are read"};
            return false;
        }
        memory_left_ -= bytes;
        return true;
    }
    /// Into the innermost array or object that is open. What is open lies in no array that still grows.
    json* place(json value) {
        if (open_.empty()) return &(read.document = std::move(value));
        if (auto* elements = open_.back()->get_ptr<json::array_t*>()) return &elements->emplace_back(std::move(value));
        return &(*member_ = std::move(value));
    }
    bool put(json value) { return afford(value_bytes) && place(std::move(value)) != nullptr; }
    bool open(json value) {
        if (!afford(value_bytes + structure_bytes)) return false;
        open_.push_back(place(std::move(value)));
        return true;
    }
    bool close() {
        open_.pop_back();
        return true;
    }

    std::size_t memory_left_;
    std::vector<json*> open_;
    json* member_ = nullptr;  ///< where the value of the last key goes
};

}  // namespace

JsonRead read_json(std::string_view text, const JsonBounds& bounds) {
    if (auto fault = fault_before_parsing(text, bounds.deepest))
        return {.document = {}, .fault = std::move(fault), .repeated_key = {}};
    Builder builder(bounds.most_memory);
    json::sax_parse(text, &builder);
    if (builder.read.fault) builder.read.document = nullptr;
    return std::move(builder.read);
}

}  // namespace sl
