// SPDX-License-Identifier: MIT
// What a path-traced picture's EXR says of itself.
#include "engine/core/check.h"
#include "engine/core/error.h"
#include "engine/render/reference/reference_file.h"
#include "tests/fuzz/input_folder.h"

namespace sl {
namespace {

struct Files : InputFolder {
    std::vector<ImageLayer> layers;

    Files() {
        write_reference(path() / "whole.exr", {.scene = "a", .content = 1, .size = uvec2(2, 1), .transport = {}}, Film(uvec2(2, 1)));
        layers = read_exr(path() / "whole.exr");
    }
};

}  // namespace
}  // namespace sl

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const sl::Files files;
    const auto path = files.path() / "input.exr";
    sl::write_exr(path, files.layers, std::string(sl::text_of(data, size)));
    try {
        const sl::ReferenceFile file = sl::read_reference(path);
        for (const sl::FilmBlock& block : file.film.blocks()) {
            CHECK(glm::all(glm::lessThanEqual(block.high, file.film.size())) && block.first < block.last, "a block lies outside the picture");
        }
    } catch (const sl::Error&) {
        // Refused: that is an answer.
    }
    return 0;
}
