// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/model/gltf_model.h"

namespace sl {

/// Edge of a voxel of a MagicaVoxel file, m: the format has no unit.
inline constexpr float vox_voxel_size = 0.1f;
/// Luminance of a palette colour that emits wholly, at the format's flux 0; each step of flux is ten times as much. The format has no unit.
inline constexpr float vox_emission = 100.0f;

/// Reads a MagicaVoxel file (.vox, versions 150 and 200) with its palette, emissive materials and scene of placed models. Y is up. Throws
/// Error like read_gltf, naming the byte.
Model read_vox(const std::filesystem::path& path, const ModelReading& reading = {});

}  // namespace sl
