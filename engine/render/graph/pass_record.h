// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "engine/render/graph/resources.h"
#include "engine/render/program_desc.h"

namespace sl {

/// One triangle over the screen, work groups, or meshes.
enum class PassKind { fullscreen, compute, draws };

/// One mesh in a geometry pass. Buffers are GL names; draw_index selects the row of the draws' storage block.
struct DrawCall {
    std::uint32_t vertex_buffer = 0;
    std::uint32_t index_buffer = 0;
    std::uint32_t first_index = 0, index_count = 0;
    std::uint32_t draw_index = 0;
    bool mirrored = false;  ///< its matrix turns counter-clockwise triangles clockwise
    std::uint32_t pictured_vertex_buffer = 0;  ///< of PicturedVertex; 0: it has none
};
/// Shared: many passes draw the same.
using DrawList = std::shared_ptr<const std::vector<DrawCall>>;

/// What happens to a target's old contents when a pass starts.
enum class Load { clear, keep, discard };

/// An image, or a layer of one, that a pass draws into.
struct Target {
    std::string output;  ///< the shader's own name; empty for depth
    ImageId image;       ///< the version made by this pass
    std::uint32_t layer = 0;
    Load load = Load::discard;
    std::array<float, 4> clear{};
};

/// An image that a shader samples.
struct ImageRead {
    std::string sampler;
    ImageId image;
    Sampling sampling = Sampling::nearest;
};

/// A buffer behind a storage block of a shader.
struct StorageUse {
    std::string block;
    BufferId buffer;
    bool written = false;
};

/// An image that a compute shader writes texel by texel.
struct ImageStore {
    std::string name;
    ImageId image;
};

/// What a uniform block of a shader holds.
struct ParamBlock {
    std::string block;
    std::vector<std::byte> bytes;
};

/// Everything the executor needs to run a pass: plain data, so that a frame can be inspected without a GPU.
struct PassRecord {
    std::string name;
    std::string group;  ///< which part of the frame asked for it; times are summed by it
    PassKind kind = PassKind::fullscreen;
    ProgramDesc program;
    std::vector<ImageRead> reads;
    std::vector<StorageUse> storage;
    std::vector<ImageStore> stores;
    std::vector<ParamBlock> params;
    std::vector<Target> targets;
    Target depth;                      ///< depth.image is none when unused
    bool depth_test = false;           ///< nearer wins (greater, reversed depth)
    bool blend_add = false;
    bool cull_back = true;
    float depth_bias_slope = 0.0f;
    DrawList draws;
    std::array<std::uint32_t, 3> groups{1, 1, 1};
    bool keep = false;                 ///< runs even when nobody reads what it writes
};

}  // namespace sl
