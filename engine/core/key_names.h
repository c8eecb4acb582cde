// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "engine/core/input.h"

namespace sl {

/// In the order of Key, as settings name them.
std::span<const std::string_view> key_names();

/// As in settings.json: "page_up".
inline std::string_view key_name(Key key) { return key_names()[static_cast<std::size_t>(key)]; }

/// For people: "Page up" for page_up, "[" for left_bracket.
std::string key_label(Key key);

}  // namespace sl
