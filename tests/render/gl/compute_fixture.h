// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>

#include "engine/render/gl/buffer.h"
#include "engine/render/gl/program.h"
#include "tests/render/gl/gl_fixture.h"

namespace sl::gl {

/// Runs the body of a compute shader's main once, which fills `result[]`, and returns the first `count`
/// values. `declarations` stand before main; textures and samplers are bound by the caller.
inline std::vector<float> compute(const TempFolder& folder, const std::string& declarations,
                                  const std::string& body, std::size_t count) {
    folder.write("test.comp",
                 "layout(local_size_x = 1) in;\nlayout(std430) buffer Result { float result[]; };\n" +
                     declarations + "\nvoid main() {\n" + body + "\n}\n");
    ProgramCache cache(folder.path());
    const Program& program = cache.get({.vertex = "", .fragment = "", .compute = "test.comp", .defines = {}});
    Buffer buffer;
    buffer.upload(std::vector<float>(count));
    glUseProgram(program.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, program.storage_blocks().at("Result"), buffer.id());
    glDispatchCompute(1, 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    const auto bytes = buffer.read(count * sizeof(float));
    std::vector<float> values(count);
    std::memcpy(values.data(), bytes.data(), bytes.size());
    glUseProgram(0);
    return values;
}

}  // namespace sl::gl
