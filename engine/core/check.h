// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <string_view>

namespace sl {

/// Prints "file:line: CHECK(condition): message" and aborts. Called by CHECK.
[[noreturn]] void check_failed(std::string_view file, int line, std::string_view condition, std::string_view message);

}  // namespace sl

/// Stops on a mistake of ours (never on bad input: that is sl::fail). On in every build: a wrong picture costs more
/// than a compare. CHECK(index < size, "index {} of {}", index, size).
#define CHECK(condition, ...)                                                                        \
    do {                                                                                             \
        if (!(condition)) [[unlikely]]                                                               \
            ::sl::check_failed(__FILE__, __LINE__, #condition, ::fmt::format(__VA_ARGS__));          \
    } while (false)
