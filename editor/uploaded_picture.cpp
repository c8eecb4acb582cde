// SPDX-License-Identifier: MIT
#include "editor/uploaded_picture.h"

#include <algorithm>

namespace sl {

void UploadedPicture::upload(const Image& picture) {
    const TextureDesc desc{.width = picture.width, .height = picture.height, .format = Format::rgba8};
    if (texture_.desc() != desc || !texture_) texture_ = gl::Texture(desc, "shown picture");
    std::vector<std::byte> bytes(std::size_t{4} * picture.width * picture.height, std::byte{255});
    for (std::uint32_t y = 0; y < picture.height; ++y) {
        for (std::uint32_t x = 0; x < picture.width; ++x) {
            const float* pixel = picture.pixel(x, picture.height - 1 - y);
            std::byte* out = &bytes[4 * (std::size_t{y} * picture.width + x)];
            for (int c = 0; c < 3; ++c) out[c] = static_cast<std::byte>(std::clamp(pixel[c], 0.0f, 1.0f) * 255.0f + 0.5f);
        }
    }
    texture_.upload(0, 0, bytes);
}

}  // namespace sl
