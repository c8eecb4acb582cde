// SPDX-License-Identifier: MIT
// A picture of a model: PNG, JPEG or WebP.
#include "engine/core/error.h"
#include "engine/core/model/picture.h"
#include "tests/fuzz/input_folder.h"
#include "tests/fuzz/png_mutator.h"

/// OpenImageIO 2.4 loses the text of each error that it has told. What has been freed is kept for a while, and pictures are large.
extern "C" const char* __asan_default_options() { return "detect_leaks=0:quarantine_size_mb=16"; }

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto* first = reinterpret_cast<const std::byte*>(data);
    const sl::ModelImage image{.name = "input", .bytes = {first, first + size}};
    try {
        (void)sl::picture_size(image);
        const sl::Picture picture = sl::decode_picture(image);
        if (picture.pixels.size() > (1 << 22)) return 0;  // that would take long
        (void)sl::picture_layer(picture, 8, sl::PictureKind::colour, true);
        (void)sl::picture_layer(picture, 8, sl::PictureKind::data, false);
    } catch (const sl::Error&) {
        // Refused: that is an answer.
    }
    return 0;
}
