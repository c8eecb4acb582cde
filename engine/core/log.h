// SPDX-License-Identifier: MIT
#pragma once

#include <spdlog/spdlog.h>

namespace sl {

/// The log goes to standard error, so that standard output stays a program's answer.
namespace log {
using spdlog::debug;
using spdlog::error;
using spdlog::info;
using spdlog::warn;
}  // namespace log

/// Sets pattern and level ("trace" … "error"); called once by main.
void init_log(const char* level);

}  // namespace sl
