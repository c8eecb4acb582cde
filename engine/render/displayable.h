// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/image.h"

namespace sl {

/// How the values of a frame's image become colours.
struct DisplayMapping {
    enum class Kind {
        encoded,     ///< as it is
        directions,  ///< octahedral unit vectors, whose parts from -1 to 1 go from dark to bright
        radiance,    ///< exposed like the camera's picture
        irradiance,  ///< as the radiance of a white surface under it
        scaled       ///< from 0 to `top`
    };
    Kind kind = Kind::encoded;
    float exposure = 1.0f;  ///< multiplies nit
    float top = 1.0f;

    bool has_exposure() const { return kind != Kind::encoded && kind != Kind::directions; }
    /// Brighter by as many stops, where there is an exposure.
    DisplayMapping brighter(float stops) const;
    /// What black and white stand for: "0 to 3.2e4 lux".
    std::string range(const std::string& name) const;
};

/// The mapping that suits an image of this name: radiance like the camera's picture, depth and other quantities by their
/// own range.
DisplayMapping display_mapping(const std::string& name, const Image& image, float exposure);

/// An image of a frame as people can look at it, sRGB-encoded.
Image displayable(const Image& image, const DisplayMapping& mapping);
/// The same with the mapping that its name asks for. `exposure` multiplies nit.
inline Image displayable(const std::string& name, const Image& image, float exposure) { return displayable(image, display_mapping(name, image, exposure)); }

}  // namespace sl
