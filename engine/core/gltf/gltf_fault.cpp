// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_fault.h"

#include "engine/core/closest_name.h"

namespace sl {

namespace {

/// Part of a JSON pointer, in which '~' and '/' are written as "~0" and "~1".
std::string escaped(std::string_view key) {
    std::string text;
    for (const char c : for_message(key)) {
        if (c == '~' || c == '/') {
            text += c == '~' ? "~0" : "~1";
        } else {
            text += c;
        }
    }
    return text;
}

}  // namespace

void GltfFaults::add(std::string where, std::string message, bool fatal) {
    if (is_full()) list_.pop_back();
    list_.push_back({.where = std::move(where), .message = std::move(message), .fatal = fatal});
    has_fatal_ = has_fatal_ || fatal;
}

std::string GltfPlace::text() const {
    if (!owner_) return {};
    return fmt::format("{}/{}", owner_->text(), is_element_ ? std::to_string(index_) : escaped(key_));
}

}  // namespace sl
