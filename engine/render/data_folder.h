// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace sl {

/// Where the engine's shaders (shader/) and the game's scenes (game/) lie: in share/secondlight beside the folder of the running
/// program, as they are installed, or else where they lay when the program was built: in the source tree, or where the
/// engine was installed. CMake tells each program the latter.
std::filesystem::path data_folder(const char* when_built = SECONDLIGHT_DATA_FOLDER);

/// Where the engine's shaders lie: $SECONDLIGHT_SHADERS, or shader/ in the data folder.
std::filesystem::path shader_folder(const char* when_built = SECONDLIGHT_DATA_FOLDER);

}  // namespace sl
