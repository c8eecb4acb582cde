// SPDX-License-Identifier: MIT
#pragma once

#include <unistd.h>

#include <cstring>
#include <fstream>

#include "tests/support/gl_test.h"

namespace sl {

/// Runs small shaders that include library files. What they read is given by name beforehand, like a pass's inputs.
class LibraryTest : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        folder_ = std::filesystem::temp_directory_path() / fmt::format("sl_library_{}", ::getpid());
        std::filesystem::remove_all(folder_);
        std::filesystem::copy(shader_folder(), folder_, std::filesystem::copy_options::recursive);
    }
    void TearDown() override {
        buffers_.clear();
        textures_.clear();
        std::filesystem::remove_all(folder_);
        GlTest::TearDown();
    }

    /// A uniform block or a storage block; it replaces an earlier one of that name.
    template <class T>
    void give(const std::string& block, const std::vector<T>& values) { buffers_[block].upload(values); }
    template <class T>
    void give(const std::string& block, const T& value) { give(block, std::vector<T>{value}); }

    /// An image without content; layers and mips are uploaded by the caller.
    gl::Texture& give_image(const std::string& sampler, const TextureDesc& desc, Sampling sampling = Sampling::nearest) {
        textures_.erase(sampler);
        return textures_.emplace(sampler, Image{gl::Texture(desc), sampling}).first->second.texture;
    }
    template <class T>
    static void upload(gl::Texture& texture, const std::vector<T>& pixels, std::uint32_t layer = 0, std::uint32_t mip = 0) {
        texture.upload(mip, layer, std::as_bytes(std::span(pixels)));
    }

    /// `declarations` stand before main; `body` runs for each i below `count` and computes a vec4 `result`. With `across`, work
    /// groups lie in rows of that many, and i counts them by lib/linear_index.glsl.
    std::vector<vec4> compute(const std::string& declarations, const std::string& body, std::size_t count, std::uint32_t across = 0) {
        const std::string index = across > 0 ? "linear_index()" : "gl_GlobalInvocationID.x";
        const std::string include = across > 0 ? "#include \"lib/linear_index.glsl\"\n" : "";
        write("test.comp", declarations + "\nlayout(local_size_x = 64) in;\n" + include + "layout(std430) writeonly buffer Results { vec4 results[]; };\n"
                           "void main() {\n    uint i = " + index + ";\n    if (i >= uint(results.length())) { return; }\n"
                           "    vec4 result = vec4(0);\n" + body + "\n    results[i] = result;\n}\n");
        give("Results", std::vector<vec4>(count, vec4(-1)));  // what nobody computes shows
        gl::ProgramCache cache(folder_);
        bind(cache.get({.compute = "test.comp"}), count * sizeof(vec4));
        const auto groups = static_cast<GLuint>((count + 63) / 64);
        glDispatchCompute(across > 0 ? across : groups, across > 0 ? (groups + across - 1) / across : 1, 1);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        const std::vector<std::byte> bytes = buffers_["Results"].read(count * sizeof(vec4));
        std::vector<vec4> results(count);
        std::memcpy(results.data(), bytes.data(), bytes.size());
        return results;
    }

    /// What `issue` draws with the two shaders into an image of four floats, black before; bottom row first.
    template <class Issue>
    std::vector<vec4> draw(const std::string& vertex, const std::string& fragment, std::uint32_t width, std::uint32_t height, Issue&& issue) {
        const gl::Texture image({.width = width, .height = height, .format = Format::rgba32f});
        GLuint framebuffer = 0, vertex_array = 0;
        glCreateFramebuffers(1, &framebuffer);
        glCreateVertexArrays(1, &vertex_array);
        glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, image.id(), 0);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glBindVertexArray(vertex_array);
        glViewport(0, 0, static_cast<GLsizei>(width), static_cast<GLsizei>(height));
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_CULL_FACE);
        const float black[4] = {0, 0, 0, 0};
        glClearBufferfv(GL_COLOR, 0, black);
        gl::ProgramCache cache(folder_);
        const gl::Program& program = cache.get({.vertex = vertex, .fragment = fragment});
        bind(program, 0);
        issue(program);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glBindVertexArray(0);
        glDeleteFramebuffers(1, &framebuffer);
        glDeleteVertexArrays(1, &vertex_array);
        const std::vector<float> values = image.read();
        std::vector<vec4> pixels(std::size_t{width} * height);
        std::memcpy(pixels.data(), values.data(), values.size() * sizeof(float));
        return pixels;
    }

    /// Writes a shader beside the library.
    void write(const std::string& file, const std::string& text) const { std::ofstream(folder_ / file) << text; }

  private:
    struct Image {
        gl::Texture texture;
        Sampling sampling;
    };

    void bind(const gl::Program& program, std::size_t result_bytes) {
        glUseProgram(program.id());
        for (const auto& [name, unit] : program.samplers()) {
            ASSERT_TRUE(textures_.contains(name)) << "the test gives no image '" << name << "'";
            glBindTextureUnit(unit, textures_.at(name).texture.id());
            glBindSampler(unit, samplers_.id(textures_.at(name).sampling));
        }
        for (const auto& [name, binding] : program.uniform_blocks()) {
            ASSERT_TRUE(buffers_.contains(name)) << "the test gives no block '" << name << "'";
            glBindBufferBase(GL_UNIFORM_BUFFER, binding, buffers_.at(name).id());
        }
        for (const auto& [name, binding] : program.storage_blocks()) {
            ASSERT_TRUE(buffers_.contains(name)) << "the test gives no storage '" << name << "'";
            const gl::Buffer& buffer = buffers_.at(name);
            // A buffer is larger than what was asked for; the shader counts the results by its length.
            if (name == "Results") glBindBufferRange(GL_SHADER_STORAGE_BUFFER, binding, buffer.id(), 0, static_cast<GLsizeiptr>(result_bytes));
            else glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer.id());
        }
    }

    std::filesystem::path folder_;
    std::map<std::string, gl::Buffer> buffers_;
    std::map<std::string, Image> textures_;
    gl::Samplers samplers_;
};

/// Each component within `tolerance`, relative where the value is above 1.
inline void expect_close(const vec4& gpu, const vec4& cpu, float tolerance, std::size_t i) {
    for (int c = 0; c < 4; ++c) ASSERT_NEAR(gpu[c], cpu[c], tolerance * std::max(1.0f, std::abs(cpu[c]))) << "item " << i << ", component " << c;
}

}  // namespace sl
