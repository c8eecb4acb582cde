// SPDX-License-Identifier: MIT
#include "game/voxel/block_textures.h"

#include <algorithm>
#include <cmath>

namespace sl {
namespace {

using Linear = std::array<std::uint32_t, 3>;  // 65535 is white
constexpr std::uint32_t white = 65535;
constexpr int texel_count = block_texture_size * block_texture_size;

/// Linear value of each sRGB byte. Rounded to 16 bits, so the last bit of a library's pow does not matter.
const std::array<std::uint32_t, 256>& srgb_table() {
    static const auto table = [] {
        std::array<std::uint32_t, 256> values{};
        for (std::size_t code = 0; code < values.size(); ++code) {
            const double encoded = static_cast<double>(code) / 255.0;
            const double linear =
                encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
            values[code] = static_cast<std::uint32_t>(std::lround(linear * white));
        }
        return values;
    }();
    return table;
}

std::uint8_t encode(std::uint32_t linear) {
    const auto& table = srgb_table();
    const auto above = std::lower_bound(table.begin(), table.end(), linear);
    if (above == table.end()) return 255;
    const bool below_is_nearer = above != table.begin() && linear - *(above - 1) < *above - linear;
    return static_cast<std::uint8_t>(above - table.begin() - (below_is_nearer ? 1 : 0));
}

std::vector<std::uint8_t> encode(const std::vector<Linear>& texels) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(texels.size() * 4);
    for (const Linear& texel : texels) {
        for (const std::uint32_t channel : texel) bytes.push_back(encode(channel));
        bytes.push_back(255);
    }
    return bytes;
}

std::vector<Linear> paint(const LayerDesign& design, std::uint32_t seed) {
    std::vector<PatternTexel> drawing;
    drawing.reserve(texel_count);
    int light_sum = 0;
    for (int y = 0; y < block_texture_size; ++y) {
        for (int x = 0; x < block_texture_size; ++x) {
            drawing.push_back(design.pattern(seed, x, y));
            light_sum += drawing.back().light;
        }
    }
    std::vector<Linear> texels;
    texels.reserve(texel_count);
    const std::array base{design.base.red, design.base.green, design.base.blue};
    const std::array accent{design.accent.red, design.accent.green, design.accent.blue};
    for (const PatternTexel& texel : drawing) {
        Linear colour{};
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const int mixed = base[channel] * (256 - texel.accent) + accent[channel] * texel.accent;
            // Divided by the drawing's mean light: a pattern may change a layer's contrast but not its
            // albedo.
            const std::int64_t lit = std::int64_t{mixed} * std::max(texel.light, 0) * texel_count / light_sum;
            colour[channel] = static_cast<std::uint32_t>(std::min<std::int64_t>(lit * white / 256000, white));
        }
        texels.push_back(colour);
    }
    return texels;
}

std::vector<Linear> half_size(const std::vector<Linear>& texels, std::size_t size) {
    const std::size_t half = size / 2;
    std::vector<Linear> smaller(half * half);
    for (std::size_t y = 0; y < half; ++y) {
        for (std::size_t x = 0; x < half; ++x) {
            const std::size_t corner = 2 * y * size + 2 * x;
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const std::uint32_t sum = texels[corner][channel] + texels[corner + 1][channel] +
                                          texels[corner + size][channel] + texels[corner + size + 1][channel];
                smaller[y * half + x][channel] = (sum + 2) / 4;
            }
        }
    }
    return smaller;
}

}  // namespace

std::vector<BlockTexture> make_block_textures(std::uint32_t seed) {
    std::vector<BlockTexture> textures(block_layer_count);
    for (std::uint32_t layer = 0; layer < block_layer_count; ++layer) {
        const auto layer_seed = static_cast<std::uint32_t>(hash_mix(seed, layer));
        std::vector<Linear> texels = paint(layer_design(static_cast<BlockLayer>(layer)), layer_seed);
        std::size_t size = block_texture_size;
        for (std::vector<std::uint8_t>& level : textures[layer].mips) {
            level = encode(texels);
            if (size > 1) texels = half_size(texels, size);
            size /= 2;
        }
    }
    return textures;
}

vec3 average_albedo(const BlockTexture& texture) {
    dvec3 sum(0.0);
    const std::vector<std::uint8_t>& bytes = texture.mips[0];
    for (std::size_t texel = 0; texel < bytes.size(); texel += 4) {
        for (int channel = 0; channel < 3; ++channel) {
            sum[channel] += srgb_table()[bytes[texel + static_cast<std::size_t>(channel)]];
        }
    }
    return vec3(sum / (double{texel_count} * white));
}

}  // namespace sl
