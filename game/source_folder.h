// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace sl {

/// Where the game's data lies: in the source tree it was built from, or beside the program.
std::filesystem::path game_folder();

}  // namespace sl
