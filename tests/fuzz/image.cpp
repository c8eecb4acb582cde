// SPDX-License-Identifier: MIT
// An EXR or a picture that `secondlight compare` is given.
#include "engine/core/check.h"
#include "engine/core/error.h"
#include "engine/core/image.h"
#include "tests/fuzz/input_folder.h"
#include "tests/fuzz/png_mutator.h"

/// OpenImageIO 2.4 loses the text of each error that it has told. What has been freed is kept for a while, and pictures are large.
extern "C" const char* __asan_default_options() { return "detect_leaks=0:quarantine_size_mb=16"; }

namespace sl {
namespace {

void check(const Image& image) {
    CHECK(image.data.size() == std::size_t{image.width} * image.height * image.channels, "{} values for {} x {} x {}", image.data.size(), image.width, image.height, image.channels);
}

template <class Read>
void try_to(Read&& read) {
    try {
        read();
    } catch (const Error&) {
        // Refused: that is an answer.
    }
}

}  // namespace
}  // namespace sl

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const sl::InputFolder files;
    const auto exr = files.write("input.exr", sl::text_of(data, size)), png = files.write("input.png", sl::text_of(data, size));
    sl::try_to([&] {
        for (const sl::ImageLayer& layer : sl::read_exr(exr)) sl::check(layer.image);
        (void)sl::read_exr_note(exr);
    });
    sl::try_to([&] { sl::check(sl::read_png(png)); });
    return 0;
}
