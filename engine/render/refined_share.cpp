// SPDX-License-Identifier: MIT
#include "engine/render/refined_share.h"

namespace sl {

std::optional<double> refined_share(const Renderer& renderer) {
    const ImageId refined = renderer.find_image(refined_image);
    if (!refined) return std::nullopt;
    const Image image = renderer.read(refined);
    double sum = 0.0;
    for (std::size_t i = 0; i < image.data.size(); i += image.channels) sum += image.data[i];
    return sum / (double(image.width) * image.height);
}

}  // namespace sl
