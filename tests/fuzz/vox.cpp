// SPDX-License-Identifier: MIT
// A MagicaVoxel file.
#include "engine/core/error.h"
#include "engine/core/model/vox_model.h"
#include "tests/fuzz/input_folder.h"
#include "tests/fuzz/model_use.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const sl::InputFolder files;
    try {
        sl::use_model(sl::read_vox(files.write("model.vox", sl::text_of(data, size))));
    } catch (const sl::Error&) {
        // Refused: that is an answer.
    }
    return 0;
}
