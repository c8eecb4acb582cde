// SPDX-License-Identifier: MIT
#include "engine/render/displayable.h"

#include <algorithm>
#include <cmath>

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

/// The radiance times exposure from which on the screen shows full white.
constexpr float exposed_white = 12.0f;

const char* unit_of(const std::string& name) {
    if (name.starts_with("rsm_flux")) return "lm";
    return name.starts_with("rsm_position") ? "m" : "";
}

}  // namespace

DisplayMapping DisplayMapping::brighter(float stops) const {
    DisplayMapping result = *this;
    result.exposure *= std::exp2(stops);
    result.top *= std::exp2(-stops);
    return result;
}

std::string DisplayMapping::range(const std::string& name) const {
    switch (kind) {
        case Kind::encoded: return "0 to 1";
        case Kind::directions: return "-1 to 1 along x, y, z as red, green, blue";
        case Kind::radiance: return fmt::format("0 to {:.2g} nit, as the camera shows it", exposed_white / exposure);
        case Kind::irradiance: return fmt::format("0 to {:.2g} lux, as the camera shows white under it", pi * exposed_white / exposure);
        case Kind::scaled: break;
    }
    return fmt::format("0 to {:.2g} {}", top, unit_of(name));
}

DisplayMapping display_mapping(const std::string& name, const Image& image, float exposure) {
    using Kind = DisplayMapping::Kind;
    if (is_any_of(name, {"final", "ldr", "material", "refined"})) return {.kind = Kind::encoded};
    if (name.ends_with("normal")) return {.kind = Kind::directions};
    if (is_any_of(name, {"hdr", "hdr_water", "direct", "emission"})) return {.kind = Kind::radiance, .exposure = exposure};
    if (name.starts_with("irradiance") || name.ends_with("_partial")) return {.kind = Kind::irradiance, .exposure = exposure};
    return {.kind = Kind::scaled, .top = name == "albedo" ? 1.0f : bright_end(image)};
}

Image displayable(const Image& image, const DisplayMapping& mapping) {
    using Kind = DisplayMapping::Kind;
    Image result(image.width, image.height, 3);
    const float scale = 1.0f / mapping.top;
    for (std::size_t i = 0; i < std::size_t{image.width} * image.height; ++i) {
        vec3 value = pixel_of(image, i);
        switch (mapping.kind) {
            case Kind::encoded: break;
            case Kind::directions: value = octahedral_decode(vec2(value) * 2.0f - 1.0f) * 0.5f + 0.5f; break;
            case Kind::radiance: value = display_from_radiance(value, mapping.exposure); break;
            case Kind::irradiance: value = display_from_radiance(value / pi, mapping.exposure); break;
            case Kind::scaled: value = srgb_encode(glm::clamp(glm::abs(value) * scale, 0.0f, 1.0f)); break;
        }
        for (int c = 0; c < 3; ++c) result.data[i * 3 + static_cast<std::size_t>(c)] = value[c];
    }
    return result;
}

}  // namespace sl
