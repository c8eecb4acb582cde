// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace sl {

/// All bytes of a file. Throws Error that names it where it is missing, no regular file (a pipe or a device might never end), larger
/// than `most`, or cannot be read.
std::vector<std::byte> file_bytes(const std::filesystem::path& file, std::uint64_t most);

}  // namespace sl
