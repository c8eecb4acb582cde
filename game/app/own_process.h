// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "engine/core/error.h"

namespace sl {

/// Work in a process of its own was ended because it took too much.
class LimitReached : public Error {
  public:
    using Error::Error;
};

/// What `work` returns, done in a copy of this process: the memory that it takes is its own, and what does not fit ends
/// alone. Call it before this process starts threads or a context, which no copy has. Throws Error with the message of
/// the work's own, and LimitReached when it takes longer than `seconds` or leaves this machine almost no memory.
std::string in_own_process(const std::function<std::string()>& work, double seconds);

/// Memory of this process that is in use, in MB of 10⁶ bytes.
double resident_megabytes();

}  // namespace sl
