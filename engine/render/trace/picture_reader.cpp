// SPDX-License-Identifier: MIT
#include "engine/render/trace/picture_reader.h"

#include "engine/core/math.h"
#include "engine/core/srgb.h"

namespace sl {

PictureReader::PictureReader(std::shared_ptr<const TextureLayers> layers, Encoding encoding) : layers_(std::move(layers)) {
    for (std::size_t i = 0; i < decoded_.size(); ++i) {
        const float encoded = static_cast<float>(i) / 255.0f;
        decoded_[i] = encoding == Encoding::linear ? encoded : linear_from_srgb(encoded);
    }
}

vec4 PictureReader::texel(const std::uint8_t* pixels, ivec2 at) const {
    const auto size = static_cast<int>(layers_->size);
    at = (at % size + size) % size;
    const std::uint8_t* pixel = pixels + (static_cast<std::size_t>(at.y) * layers_->size + static_cast<std::size_t>(at.x)) * 4;
    return {decoded_[pixel[0]], decoded_[pixel[1]], decoded_[pixel[2]], static_cast<float>(pixel[3]) / 255.0f};
}

vec4 PictureReader::at(std::uint32_t layer, vec2 place) const {
    if (layers_ == nullptr || layer >= layers_->layers.size()) return vec4(1.0f);
    const vec2 inside = place - glm::floor(place);
    if (!(inside.x >= 0.0f && inside.y >= 0.0f)) return vec4(1.0f);  // NaN
    const vec2 at = inside * static_cast<float>(layers_->size) - 0.5f, low = glm::floor(at), part = at - low;
    const std::uint8_t* pixels = layers_->layers[layer].data();
    const ivec2 corner(low);
    const vec4 above = glm::mix(texel(pixels, corner), texel(pixels, corner + ivec2(1, 0)), part.x);
    const vec4 below = glm::mix(texel(pixels, corner + ivec2(0, 1)), texel(pixels, corner + ivec2(1, 1)), part.x);
    return glm::mix(above, below, part.y);
}

std::uint64_t PictureReader::hash(std::uint64_t hash) const {
    if (layers_ == nullptr) return hash;
    for (const auto& layer : layers_->layers) hash = hash_bytes(hash, layer.data(), layer.size());
    return hash;
}

}  // namespace sl
