// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/model/model.h"

namespace sl {

/// What a file from a stranger may do.
struct ModelReading {
    bool files_anywhere = false;                          ///< it may name files outside its own folder
    std::uint64_t most_bytes = std::uint64_t{1} << 30;  ///< of itself, and of each file that it names
};

/// Reads a glTF 2.0 file, .gltf or .glb, with the buffers and pictures that it names. What is wrong in it but can be left out, or
/// is not understood, stands in `warnings`. Throws Error, in one line that begins with the file and the place in it, for all else:
/// a fault that leaves nothing sensible, an unknown extension that it requires, a file that is missing or outside its folder.
Model read_gltf(const std::filesystem::path& path, const ModelReading& reading = {});

}  // namespace sl
