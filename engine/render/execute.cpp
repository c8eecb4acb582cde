// SPDX-License-Identifier: MIT
#include "engine/render/execute.h"

#include <algorithm>

#include "engine/core/mesh_data.h"

namespace sl {

namespace {

constexpr std::uint64_t frames_until_freed = 4;

/// With what PicturedVertex holds, from a buffer of its own, or without.
GLuint make_vertex_array(bool pictured) {
    GLuint id = 0;
    glCreateVertexArrays(1, &id);
    const auto attribute = [&](GLuint index, GLint count, std::size_t offset, GLuint buffer = 0, GLenum type = GL_FLOAT) {
        glEnableVertexArrayAttrib(id, index);
        glVertexArrayAttribFormat(id, index, count, type, GL_TRUE, static_cast<GLuint>(offset));
        glVertexArrayAttribBinding(id, index, buffer);
    };
    const auto integer = [&](GLuint index, std::size_t offset) {
        glEnableVertexArrayAttrib(id, index);
        glVertexArrayAttribIFormat(id, index, 1, GL_UNSIGNED_INT, static_cast<GLuint>(offset));
        glVertexArrayAttribBinding(id, index, 0);
    };
    // Locations as in shader/lib/vertex.glsl.
    attribute(0, 3, offsetof(Vertex, position));
    integer(1, offsetof(Vertex, normal));
    attribute(2, 2, offsetof(Vertex, uv));
    integer(3, offsetof(Vertex, material));
    integer(4, offsetof(Vertex, colour));
    if (!pictured) return id;
    // As in shader/passes/pictured_apart.vert.
    attribute(5, 2, offsetof(PicturedVertex, uv), 1);
    attribute(6, 2, offsetof(PicturedVertex, tangent), 1, GL_SHORT);
    attribute(7, 1, offsetof(PicturedVertex, hand), 1);
    return id;
}

/// A named group of calls in the driver's messages and in frame debuggers.
class DebugGroup {
  public:
    explicit DebugGroup(const std::string& name) { glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name.c_str()); }
    ~DebugGroup() { glPopDebugGroup(); }
    DebugGroup(const DebugGroup&) = delete;
    DebugGroup& operator=(const DebugGroup&) = delete;
};

}  // namespace

Executor::Executor(std::filesystem::path shader_folder) : programs_(std::move(shader_folder)) {
    vertex_array_ = make_vertex_array(false);
    pictured_vertex_array_ = make_vertex_array(true);
    glCreateVertexArrays(1, &empty_vertex_array_);
}

Executor::~Executor() {
    for (const auto& [key, framebuffer] : framebuffers_) glDeleteFramebuffers(1, &framebuffer);
    glDeleteVertexArrays(1, &vertex_array_);
    glDeleteVertexArrays(1, &pictured_vertex_array_);
    glDeleteVertexArrays(1, &empty_vertex_array_);
}

void Executor::run(FrameGraph& graph, std::span<const Step> steps, const OnStep& on_step) {
    ++frame_;
    next_param_buffer_ = 0;
    // What the last frame left readable is free now.
    for (auto& [index, texture] : live_textures_) free_textures_.push_back({std::move(texture), frame_});
    live_textures_.clear();
    live_buffers_.clear();
    if (timing_) timers_.begin_frame();
    try {
        run_steps(graph, steps, on_step);
    } catch (...) {  // a shader that does not build, or a caller who wants to stop
        timers_.abandon_frame();
        throw;
    }
    if (timing_) timers_.end_frame();
    graph.commit(steps);
    const auto stale = [&](const Pooled& pooled) { return pooled.last_frame + frames_until_freed < frame_; };
    for (const Pooled& pooled : free_textures_) {
        if (stale(pooled)) forget_framebuffers_of(pooled.texture->id());
    }
    std::erase_if(free_textures_, stale);
}

void Executor::run_steps(const FrameGraph& graph, std::span<const Step> steps, const OnStep& on_step) {
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const PassRecord& pass = graph.passes()[static_cast<std::size_t>(steps[i].pass)];
        if (on_step) {
            glFinish();  // told of what is done, not of what was asked for
            on_step(i, steps.size(), pass.name);
        }
        if (timing_) timers_.begin_span(pass.name, pass.group);
        {
            const DebugGroup group(pass.name);
            allocate(graph, pass);
            run_pass(graph, pass);
        }
        if (timing_) timers_.end_span();
        release(graph, steps[i]);
    }
}

const std::vector<gl::SpanTime>& Executor::finished_timings() {
    timers_.finish();
    return timers_.newest();
}

void Executor::run_pass(const FrameGraph& graph, const PassRecord& pass) {
    const gl::Program& program = programs_.get(pass.program);
    glUseProgram(program.id());
    bind_inputs(graph, pass, program);
    bind_params(pass, program);
    if (pass.kind != PassKind::compute) bind_targets(graph, pass, program);
    issue(pass, program);
}

void Executor::bind_inputs(const FrameGraph& graph, const PassRecord& pass, const gl::Program& program) {
    for (const ImageRead& read : pass.reads) {
        const auto unit = program.samplers().find(read.sampler);
        CHECK(unit != program.samplers().end(), "pass '{}' reads '{}', but its shader has no such sampler", pass.name, read.sampler);
        glBindTextureUnit(unit->second, native(graph, read.image));
        glBindSampler(unit->second, samplers_.id(read.sampling));
    }
    for (const auto& [name, unit] : program.samplers()) {
        CHECK(std::ranges::any_of(pass.reads, [&, &wanted = name](const ImageRead& read) { return read.sampler == wanted; }),
              "the shader of pass '{}' has a sampler '{}' that nobody reads into", pass.name, name);
    }
    for (const ImageStore& store : pass.stores) {
        const auto unit = program.images().find(store.name);
        CHECK(unit != program.images().end(), "pass '{}' stores '{}', but its shader has no such image", pass.name, store.name);
        const Format format = graph.resources()[store.image.index].image.format;
        glBindImageTexture(unit->second, native(graph, store.image), 0, GL_TRUE, 0, GL_READ_WRITE, gl::format_names(format).internal);
    }
    for (const StorageUse& use : pass.storage) {
        const auto binding = program.storage_blocks().find(use.block);
        CHECK(binding != program.storage_blocks().end(), "pass '{}' uses storage '{}', but its shader has no such block", pass.name, use.block);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding->second, native(graph, use.buffer));
    }
    for (const auto& [name, binding] : program.storage_blocks()) {
        CHECK(std::ranges::any_of(pass.storage, [&, &wanted = name](const StorageUse& use) { return use.block == wanted; }),
              "the shader of pass '{}' has a storage block '{}' that nobody gives", pass.name, name);
    }
}

void Executor::bind_params(const PassRecord& pass, const gl::Program& program) {
    for (const ParamBlock& params : pass.params) {
        const auto binding = program.uniform_blocks().find(params.block);
        CHECK(binding != program.uniform_blocks().end(), "pass '{}' gives '{}', but its shader has no such block", pass.name, params.block);
        // One small buffer per block and frame, reused: updating a buffer that a pass in flight reads would stall.
        if (next_param_buffer_ == param_buffers_.size()) param_buffers_.emplace_back();
        gl::Buffer& buffer = param_buffers_[next_param_buffer_++];
        buffer.upload(params.bytes, "params");
        glBindBufferBase(GL_UNIFORM_BUFFER, binding->second, buffer.id());
    }
    for (const auto& [name, binding] : program.uniform_blocks()) {
        CHECK(std::ranges::any_of(pass.params, [&, &wanted = name](const ParamBlock& params) { return params.block == wanted; }),
              "the shader of pass '{}' has a block '{}' that nobody gives", pass.name, name);
    }
}

void Executor::bind_targets(const FrameGraph& graph, const PassRecord& pass, const gl::Program& program) {
    CHECK(program.outputs().size() == pass.targets.size(), "pass '{}' writes {} images, its shader {}", pass.name,
          pass.targets.size(), program.outputs().size());
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer(graph, pass));
    const TextureDesc& size = graph.resources()[pass.targets.empty() ? pass.depth.image.index : pass.targets[0].image.index].image;
    glViewport(0, 0, static_cast<GLsizei>(size.width), static_cast<GLsizei>(size.height));
    for (std::size_t i = 0; i < pass.targets.size(); ++i) {
        const Target& target = pass.targets[i];
        const auto output = program.outputs().find(target.output);
        CHECK(output != program.outputs().end(), "pass '{}' writes '{}', but its shader has no such output", pass.name, target.output);
        CHECK(output->second == static_cast<GLint>(i), "pass '{}': output '{}' is at location {}, not {}", pass.name, target.output, output->second, i);
        if (target.load == Load::clear) glClearBufferfv(GL_COLOR, static_cast<GLint>(i), target.clear.data());
    }
    if (pass.depth.image && pass.depth.load == Load::clear) {
        glDepthMask(GL_TRUE);
        glClearBufferfv(GL_DEPTH, 0, pass.depth.clear.data());
    }
}

void Executor::issue(const PassRecord& pass, const gl::Program& program) {
    const auto enable = [](GLenum what, bool on) { on ? glEnable(what) : glDisable(what); };
    enable(GL_DEPTH_TEST, pass.depth_test);
    glDepthFunc(GL_GREATER);
    glDepthMask(pass.depth.image ? GL_TRUE : GL_FALSE);
    enable(GL_CULL_FACE, pass.kind == PassKind::draws && pass.cull_back);
    enable(GL_BLEND, pass.blend_add);
    glBlendFunc(GL_ONE, GL_ONE);
    enable(GL_POLYGON_OFFSET_FILL, pass.depth_bias_slope != 0.0f);
    glPolygonOffset(-pass.depth_bias_slope, 0.0f);
    switch (pass.kind) {
        case PassKind::compute:
            glDispatchCompute(pass.groups[0], pass.groups[1], pass.groups[2]);
            glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
            break;
        case PassKind::fullscreen:
            glBindVertexArray(empty_vertex_array_);
            glDrawArrays(GL_TRIANGLES, 0, 3);
            break;
        case PassKind::draws: {
            const auto draw_index = program.uniforms().find("draw_index");
            if (!pass.draws) break;
            for (const DrawCall& call : *pass.draws) {
                const bool pictured = call.pictured_vertex_buffer != 0;
                const GLuint array = pictured ? pictured_vertex_array_ : vertex_array_;
                glBindVertexArray(array);
                glVertexArrayVertexBuffer(array, 0, call.vertex_buffer, 0, sizeof(Vertex));
                if (pictured) glVertexArrayVertexBuffer(array, 1, call.pictured_vertex_buffer, 0, sizeof(PicturedVertex));
                glVertexArrayElementBuffer(array, call.index_buffer);
                glFrontFace(call.mirrored ? GL_CW : GL_CCW);
                if (draw_index != program.uniforms().end()) glUniform1ui(draw_index->second, call.draw_index);
                const std::uintptr_t first = call.first_index * sizeof(std::uint32_t);
                glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(call.index_count), GL_UNSIGNED_INT, reinterpret_cast<const void*>(first));
            }
            break;
        }
    }
}

}  // namespace sl
