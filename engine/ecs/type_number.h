// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>

namespace sl {

/// A number that the family has not given yet.
template <class Family>
std::uint32_t next_type_number() {
    static std::atomic<std::uint32_t> next{0};
    return next++;
}

/// Numbers the types of a family 0, 1, 2 … in the order in which the program first asks. Good as an index
/// into a table, never as something to write to a file.
template <class Family, class T>
std::uint32_t type_number() {
    static const std::uint32_t number = next_type_number<Family>();
    return number;
}

}  // namespace sl
