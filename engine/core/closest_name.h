// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sl {

/// "there is no field 'strenght'; did you mean 'strength'? Known: method, strength". The guess is left out
/// where no known name is near, and long lists are cut. For error messages.
std::string no_such_name(std::string_view kind, std::string_view wrong,
                         std::span<const std::string_view> known);
/// The same of names that are strings of their own.
std::string no_such_name(std::string_view kind, std::string_view wrong, std::span<const std::string> known);

/// Text from outside, fit for one line of a message: control characters become '?', what is longer than
/// `most_bytes` is cut.
std::string for_message(std::string_view text, std::size_t most_bytes = 80);

}  // namespace sl
