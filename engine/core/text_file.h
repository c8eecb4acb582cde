// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace sl {

/// The whole file. Throws Error naming it where it is missing, no regular file, or larger than `most_bytes`.
std::string read_text_file(const std::filesystem::path& path, std::uint64_t most_bytes);

/// Replaces the file by `text`, or leaves it as it was: written beside, synced to the disk, renamed. Keeps its mode and,
/// where it may, its owner; follows symbolic links to the file that they name, be it there or not. Throws Error naming
/// the file.
void write_text_file(const std::filesystem::path& path, std::string_view text);

}  // namespace sl
