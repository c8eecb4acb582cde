// SPDX-License-Identifier: MIT
#include "engine/core/check.h"

#include <cstdio>
#include <cstdlib>

namespace sl {

void check_failed(std::string_view file, int line, std::string_view condition, std::string_view message) {
    fmt::print(stderr, "{}:{}: CHECK({}): {}\n", file, line, condition, message);
    std::fflush(stderr);
    std::abort();
}

}  // namespace sl
