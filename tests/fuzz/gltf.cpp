// SPDX-License-Identifier: MIT
// A glTF file, .gltf or .glb, beside a buffer and a picture that it may name.
#include "engine/core/error.h"
#include "engine/core/model/gltf_model.h"
#include "tests/fuzz/input_folder.h"
#include "tests/fuzz/model_use.h"

namespace sl {
namespace {

struct Files : InputFolder {
    Files() {
        std::string bytes(1024, '\0');
        for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * i % 61);
        write("b.bin", bytes);
        write("p.png", "\x89PNG\r\n\x1a\n");
    }
};

}  // namespace
}  // namespace sl

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const sl::Files files;
    try {
        sl::use_model(sl::read_gltf(files.write("model.gltf", sl::text_of(data, size))));
    } catch (const sl::Error&) {
        // Refused: that is an answer.
    }
    return 0;
}
