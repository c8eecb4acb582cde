// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace sl {

/// Something that people should look at, in a colour of its own, wrapped.
void warning_text(const char* text);

/// How the last thing that was asked for went, for the place where it was asked.
struct Outcome {
    std::string text;  ///< empty: nothing was asked for yet
    bool failed = false;
};
void show(const Outcome& outcome);

}  // namespace sl
