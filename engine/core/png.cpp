// SPDX-License-Identifier: MIT
#include "engine/core/png.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>

#include "engine/core/check.h"
#include "engine/core/error.h"

namespace sl {

std::string png_bytes(const Image& image) {
    CHECK(image.width > 0 && image.height > 0 && image.channels >= 1 && image.channels <= 4, "a PNG of {} x {} x {}", image.width, image.height, image.channels);
    OIIO::ImageSpec spec(static_cast<int>(image.width), static_cast<int>(image.height), static_cast<int>(image.channels), OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("oiio:UnassociatedAlpha", 1);
    std::vector<std::uint8_t> values(image.data.size());
    std::ranges::transform(image.data, values.begin(), [](float value) {
        const float inside = value > 0.0f ? std::min(value, 1.0f) : 0.0f;  // not a number becomes 0
        return static_cast<std::uint8_t>(std::lround(inside * 255.0f));
    });
    OIIO::Filesystem::IOVecOutput memory;
    const auto output = OIIO::ImageOutput::create("png");
    if (!output || !output->set_ioproxy(&memory) || !output->open("picture.png", spec) || !output->write_image(OIIO::TypeDesc::UINT8, values.data()) || !output->close()) {
        const std::string why = output ? output->geterror() : OIIO::geterror();
        fail("a PNG cannot be made: {}", why.substr(0, why.find('\n')));
    }
    const auto& bytes = memory.buffer();
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace sl
