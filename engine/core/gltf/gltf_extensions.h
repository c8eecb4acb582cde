// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "engine/core/gltf/gltf_schema.h"

namespace sl {

/// What an extension adds to one kind of object.
struct GltfExtension {
    std::string_view name;
    std::string_view owner;  ///< name of the object in whose "extensions" it stands; empty: it has no object of its own
    const GltfObject* object = nullptr;
};

/// Extensions whose properties are known.
std::span<const GltfExtension> gltf_extensions();
/// Whether the checker knows what it may hold, which says nothing of who can show it.
bool is_known_gltf_extension(std::string_view name);

}  // namespace sl
