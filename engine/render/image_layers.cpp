// SPDX-License-Identifier: MIT
#include "engine/render/image_layers.h"

#include "shared/octahedral.h"

namespace sl {

void want_linear_layers(Renderer::Request& request) {
    request.wanted.insert(request.wanted.end(), {"hdr", "direct", "albedo", "normal", "depth"});
    request.want_irradiance = true;
}

std::vector<ImageLayer> linear_layers(const Renderer& renderer, const FrameOutput& images) {
    const Image radiance = renderer.read(images.hdr);
    const uvec2 size(radiance.width, radiance.height);
    return {{"", without_alpha(radiance)},
            {"direct", without_alpha(renderer.read(images.direct))},
            {"irradiance", without_alpha(at_least(renderer.read(images.irradiance), size))},
            {"albedo", without_alpha(renderer.read(images.gbuffer.albedo))},
            {"normal", decoded_normals(renderer.read(images.gbuffer.normal))},
            {"depth", renderer.read(renderer.find_image("depth"))}};
}

Image without_alpha(const Image& image) {
    Image result(image.width, image.height, 3);
    for (std::size_t i = 0; i < std::size_t{image.width} * image.height; ++i) {
        for (std::size_t c = 0; c < 3; ++c) result.data[i * 3 + c] = image.data[i * image.channels + c];
    }
    return result;
}

Image at_least(Image image, uvec2 size) {
    const bool single = image.width == 1 && image.height == 1;
    return single ? Image(size.x, size.y, image.channels) : image;
}

Image decoded_normals(const Image& encoded) {
    Image result(encoded.width, encoded.height, 3);
    for (std::size_t i = 0; i < std::size_t{encoded.width} * encoded.height; ++i) {
        const vec3 n = octahedral_decode(vec2(encoded.data[i * 2], encoded.data[i * 2 + 1]) * 2.0f - 1.0f);
        for (int c = 0; c < 3; ++c) result.data[i * 3 + static_cast<std::size_t>(c)] = n[c];
    }
    return result;
}

}  // namespace sl
