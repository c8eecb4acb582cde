// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "engine/render/gl/timer.h"

namespace sl {

/// Time of each kind of pass, in order of first execution: the numbered passes of one kind ("rsm_0", "rsm_1", the slices
/// of a sum) add up.
std::vector<gl::SpanTime> pass_times(std::span<const gl::SpanTime> spans);

/// Milliseconds of all passes that indirect light asked for; what a frame without GI does not run.
double gi_milliseconds(std::span<const gl::SpanTime> spans);

}  // namespace sl
