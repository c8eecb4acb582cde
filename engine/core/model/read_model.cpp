// SPDX-License-Identifier: MIT
#include "engine/core/model/read_model.h"

#include <algorithm>
#include <cctype>

#include "engine/core/error.h"
#include "engine/core/model/vox_model.h"

namespace sl {

namespace {

std::string ending_of(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return ending;
}

}  // namespace

bool is_model(const std::filesystem::path& path) {
    const std::string ending = ending_of(path);
    return ending == ".gltf" || ending == ".glb" || ending == ".vox";
}

Model read_model(const std::filesystem::path& path, const ModelReading& reading) {
    if (!is_model(path)) fail("{}: models are files whose names end in .gltf, .glb or .vox", path.string());
    return ending_of(path) == ".vox" ? read_vox(path, reading) : read_gltf(path, reading);
}

}  // namespace sl
