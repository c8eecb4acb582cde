// SPDX-License-Identifier: MIT
#include "game/source_folder.h"

namespace sl {

std::filesystem::path game_folder() {
    const std::filesystem::path source = SL_SOURCE_FOLDER "/game";
    if (std::filesystem::exists(source)) return source;
    return std::filesystem::canonical("/proc/self/exe").parent_path();
}

}  // namespace sl
