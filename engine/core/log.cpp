// SPDX-License-Identifier: MIT
#include "engine/core/log.h"

#include <spdlog/sinks/stdout_color_sinks.h>

namespace sl {

void init_log(const char* level) {
    auto sink = std::make_shared<spdlog::sinks::stderr_color_sink_mt>();
    spdlog::set_default_logger(std::make_shared<spdlog::logger>("secondlight", sink));
    spdlog::set_pattern("%^%l%$: %v");
    spdlog::set_level(spdlog::level::from_str(level));
}

}  // namespace sl
