// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>

#include "engine/ecs/components/mesh_instance.h"

namespace sl {

/// Reads layers of pictures as a shader does at their finest level: between texels, and repeated.
class PictureReader {
  public:
    enum class Encoding { srgb, linear };

    PictureReader() = default;
    PictureReader(std::shared_ptr<const TextureLayers> layers, Encoding encoding);

    /// White where there is no such layer.
    vec4 at(std::uint32_t layer, vec2 place) const;
    /// Of all texels.
    std::uint64_t hash(std::uint64_t hash) const;

  private:
    vec4 texel(const std::uint8_t* pixels, ivec2 at) const;

    std::shared_ptr<const TextureLayers> layers_;
    std::array<float, 256> decoded_{};
};

}  // namespace sl
