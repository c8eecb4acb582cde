// SPDX-License-Identifier: MIT
// Shader files that include each other, a.glsl first, with a line of three dashes between them; and a driver's message about them.
#include "engine/core/error.h"
#include "engine/render/gl/program.h"
#include "tests/fuzz/input_folder.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const sl::InputFolder files;
    constexpr std::string_view between = "\n---\n";
    std::string_view rest = sl::text_of(data, size);
    for (const char* name : {"a.glsl", "b.glsl", "c.glsl"}) {
        const std::string_view file = rest.substr(0, rest.find(between));
        files.write(name, file);
        rest.remove_prefix(std::min(rest.size(), file.size() + between.size()));
    }
    try {
        const sl::gl::ShaderSource source = sl::gl::load_shader_source({files.path()}, "a.glsl", {{"SIZE", "8"}});
        (void)sl::gl::name_files_in_log(std::string(rest), source);
    } catch (const sl::Error&) {
        // Refused: that is an answer.
    }
    return 0;
}
