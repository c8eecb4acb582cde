// SPDX-License-Identifier: MIT
#pragma once

#include <tiny_gltf.h>

#include <cmath>

namespace sl {

/// A member of an extension's object, or null.
inline const tinygltf::Value* gltf_member(const tinygltf::ExtensionMap& extensions, const char* extension, const char* member) {
    const auto found = extensions.find(extension);
    if (found == extensions.end() || !found->second.IsObject() || !found->second.Has(member)) return nullptr;
    return &found->second.Get(member);
}

/// A number of it, or `otherwise` where it is absent or none.
inline float gltf_number(const tinygltf::ExtensionMap& extensions, const char* extension, const char* member, float otherwise) {
    const tinygltf::Value* value = gltf_member(extensions, extension, member);
    if (value == nullptr || !value->IsNumber()) return otherwise;
    const auto number = static_cast<float>(value->GetNumberAsDouble());
    return std::isfinite(number) ? number : otherwise;
}

}  // namespace sl
