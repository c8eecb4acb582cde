// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "engine/render/gl/buffer.h"
#include "engine/render/gl/program.h"
#include "engine/render/gl/texture.h"
#include "engine/render/gl/timer.h"
#include "engine/render/graph/frame_graph.h"

namespace sl {

/// Runs compiled frames on OpenGL: the one place where passes become GL calls. Owns transient and persistent textures.
class Executor {
  public:
    explicit Executor(std::filesystem::path shader_folder);
    ~Executor();

    /// Called before each step with its number and the count of steps; for progress on long frames.
    using OnStep = std::function<void(std::size_t step, std::size_t steps, const std::string& pass)>;

    /// Runs all steps and commits them to the graph. Stops when a shader's names and the pass's declarations differ.
    void run(FrameGraph& graph, std::span<const Step> steps, const OnStep& on_step = {});

    /// GL texture of an image of the last run (wanted, persistent or external); 0 when it no longer exists.
    GLuint texture(const FrameGraph& graph, ImageId image) const;
    /// One layer's pixels as floats, bottom row first.
    std::vector<float> read(const FrameGraph& graph, ImageId image, std::uint32_t layer = 0) const;
    /// The same of one texel, counted from the bottom left.
    std::vector<float> read_texel(const FrameGraph& graph, ImageId image, uvec2 texel, std::uint32_t layer = 0) const;
    /// A number of a persistent buffer's beginning. Slow.
    float read_number(const std::string& buffer) const;

    gl::ProgramCache& programs() { return programs_; }
    gl::SpanTimers& timers() { return timers_; }
    /// Off by default: a software rasterizer finishes each pass before the next to time it, which slows the frame.
    void set_timing(bool on) { timing_ = on; }
    /// Milliseconds per pass of the last frame; waits for it. Empty when timing is off.
    const std::vector<gl::SpanTime>& finished_timings();
    /// Bytes of all textures held.
    std::uint64_t texture_bytes() const;

  private:
    const gl::Texture& readable(const FrameGraph& graph, ImageId image) const;
    void run_steps(const FrameGraph& graph, std::span<const Step> steps, const OnStep& on_step);
    void run_pass(const FrameGraph& graph, const PassRecord& pass);
    void bind_inputs(const FrameGraph& graph, const PassRecord& pass, const gl::Program& program);
    void bind_params(const PassRecord& pass, const gl::Program& program);
    void bind_targets(const FrameGraph& graph, const PassRecord& pass, const gl::Program& program);
    void issue(const PassRecord& pass, const gl::Program& program);
    void allocate(const FrameGraph& graph, const PassRecord& pass);
    void release(const FrameGraph& graph, const Step& step);
    void forget_framebuffers_of(GLuint texture);
    GLuint native(const FrameGraph& graph, const ResourceId& id) const;
    GLuint framebuffer(const FrameGraph& graph, const PassRecord& pass);

    struct Pooled {
        std::unique_ptr<gl::Texture> texture;
        std::uint64_t last_frame = 0;
    };
    using FramebufferKey = std::vector<std::pair<GLuint, std::uint32_t>>;

    gl::ProgramCache programs_;
    gl::Samplers samplers_;
    gl::SpanTimers timers_;
    std::vector<Pooled> free_textures_;
    std::map<std::uint32_t, std::unique_ptr<gl::Texture>> live_textures_;  ///< resource index -> transient texture
    std::map<std::uint32_t, gl::Buffer> live_buffers_;
    std::map<std::string, Pooled> persistent_;
    std::map<std::string, gl::Buffer> persistent_buffers_;
    std::map<FramebufferKey, GLuint> framebuffers_;
    std::vector<gl::Buffer> param_buffers_;
    std::size_t next_param_buffer_ = 0;
    GLuint vertex_array_ = 0, pictured_vertex_array_ = 0, empty_vertex_array_ = 0;
    std::uint64_t frame_ = 0;
    bool timing_ = false;
};

}  // namespace sl
