// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "engine/render/capture.h"
#include "shared/octahedral.h"
#include "shared/tonemap.h"

namespace sl {

namespace {

vec3 pixel_of(const Image& image, std::size_t i) {
    const float* p = &image.data[i * image.channels];
    return image.channels >= 3 ? vec3(p[0], p[1], p[2]) : image.channels == 2 ? vec3(p[0], p[1], 0.0f) : vec3(p[0]);
}

/// The value that all but the brightest 1 % stay under, so that one outlier does not blacken the rest.
float bright_end(const Image& image) {
    std::vector<float> values;
    for (std::size_t i = 0; i < std::size_t{image.width} * image.height; ++i) {
        const vec3 p = glm::abs(pixel_of(image, i));
        const float largest = std::max({p.x, p.y, p.z});
        if (std::isfinite(largest) && largest > 0.0f) values.push_back(largest);
    }
    if (values.empty()) return 1.0f;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 99 / 100);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

bool is_any_of(const std::string& name, std::initializer_list<const char*> names) {
    return std::ranges::find(names, name) != names.end();
}

}  // namespace

Image displayable(const std::string& name, const Image& image, float exposure) {
    Image result(image.width, image.height, 3);
    const bool encoded = is_any_of(name, {"final", "ldr", "material", "refined"});
    const bool normals = name == "normal";
    const bool radiance = is_any_of(name, {"hdr", "direct", "emission"});
    const bool lux = name.starts_with("irradiance") || name.ends_with("_partial");
    const float scale = encoded || normals || radiance || lux ? 1.0f : name == "albedo" ? 1.0f : 1.0f / bright_end(image);
    for (std::size_t i = 0; i < std::size_t{image.width} * image.height; ++i) {
        vec3 value = pixel_of(image, i);
        if (normals) value = octahedral_decode(vec2(value) * 2.0f - 1.0f) * 0.5f + 0.5f;
        // Irradiance is shown as the radiance of a white surface under it.
        else if (radiance || lux) value = display_from_radiance(lux ? value / pi : value, exposure);
        else if (!encoded) value = srgb_encode(glm::clamp(glm::abs(value) * scale, 0.0f, 1.0f));
        for (int c = 0; c < 3; ++c) result.data[i * 3 + static_cast<std::size_t>(c)] = value[c];
    }
    return result;
}

}  // namespace sl
