// SPDX-License-Identifier: MIT
#include "engine/render/data_folder.h"

#include <cstdlib>

namespace sl {

std::filesystem::path data_folder(const char* when_built) {
    std::error_code ignored;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored);
    const auto installed = program.parent_path().parent_path() / SL_DATA;
    return std::filesystem::is_directory(installed, ignored) ? installed : std::filesystem::path(when_built);
}

std::filesystem::path shader_folder(const char* when_built) {
    if (const char* chosen = std::getenv("SECONDLIGHT_SHADERS")) return chosen;
    return data_folder(when_built) / "shader";
}

}  // namespace sl
