// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace sl {

/// The words as one line that a POSIX shell takes apart into just these.
std::string shell_line(std::span<const std::string> words);

}  // namespace sl
