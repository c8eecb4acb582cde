// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/gltf/gltf_check.h"
#include "engine/core/model/model.h"

namespace sl {

/// Bytes that a model may take beyond what its file asks for by what it stores: many meshes, morph targets, skins and
/// animations may share the same numbers, and each has its own of them once it is read.
inline constexpr double most_shared_bytes = 256.0 * (1 << 20);

/// Counts, before anything is made, what a model's meshes, skins and animations take. Throws Error where that is more than twice
/// what its accessors would take if each were used once, and `most_shared_bytes`. For a file without a fatal fault; `materials`
/// are its own.
void check_gltf_expansion(const GltfChecked& file, const std::vector<ModelMaterial>& materials);

}  // namespace sl
