// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "engine/measure/spread.h"

namespace sl {

/// A spread as all files of figures hold it.
inline nlohmann::json json_of(const Spread& s) {
    return {{"median", s.median}, {"quartile_1", s.first}, {"quartile_3", s.third}, {"min", s.low}, {"max", s.high}};
}

}  // namespace sl
