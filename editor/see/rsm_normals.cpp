// SPDX-License-Identifier: MIT
#include "editor/see/rsm_normals.h"

#include "shared/rsm_texel.h"

namespace sl {

Image rsm_normals(const Image& flux) {
    Image result(flux.width, flux.height, 2);
    for (std::size_t i = 0; i < std::size_t{flux.width} * flux.height; ++i) {
        const vec2 encoded = octahedral_encode(unpack_texel_normal(flux.data[i * flux.channels + 3])) * 0.5f + 0.5f;
        result.data[2 * i] = encoded.x;
        result.data[2 * i + 1] = encoded.y;
    }
    return result;
}

}  // namespace sl
