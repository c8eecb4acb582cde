// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/model/gltf_model.h"

namespace sl {

/// Whether a path is that of a model, by its ending: .gltf, .glb, .vox, in letters of any size.
bool is_model(const std::filesystem::path& path);

/// Reads a model of any of these formats. Throws Error like read_gltf.
Model read_model(const std::filesystem::path& path, const ModelReading& reading = {});

}  // namespace sl
