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

/// Lets the C library keep little of what is given back to it: large blocks go back to the system, and threads share few heaps.
/// By its own rules a long flight holds ever more. Before threads start.
void keep_little_memory();

/// Memory that this process holds, in MB of 10⁶ bytes.
double resident_megabytes();

/// The most that it ever held.
double peak_megabytes();

/// What of it was asked for and not given back, in MB of 10⁶ bytes; the rest is kept by the allocator, and code.
double allocated_megabytes();

/// What this process has had of its machine, all threads together.
struct ProcessUse {
    double seconds = 0.0;    ///< of processors: a frame that took longer than this waited for somebody
    double in_system = 0.0;  ///< of these, spent by the system for it
    long pages = 0;          ///< that it touched for the first time, or again after giving them back
    long from_disk = 0;      ///< of these, that had to be read
};
ProcessUse process_use();
/// What came since.
inline ProcessUse operator-(const ProcessUse& now, const ProcessUse& before) {
    return {.seconds = now.seconds - before.seconds, .in_system = now.in_system - before.in_system, .pages = now.pages - before.pages, .from_disk = now.from_disk - before.from_disk};
}

}  // namespace sl
