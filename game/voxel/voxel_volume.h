// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "engine/core/math.h"
#include "game/voxel/blocks.h"

namespace sl {

inline constexpr int chunk_bits = 5;
inline constexpr int chunk_size = 1 << chunk_bits;  ///< blocks along one edge

/// 32 x 32 x 32 blocks. x runs fastest, then z, then y.
struct Chunk {
    std::array<Block, chunk_size * chunk_size * chunk_size> blocks{};
    std::uint32_t count = 0;  ///< blocks that are not air

    static constexpr std::size_t index(int x, int y, int z) {
        return static_cast<std::size_t>((y * chunk_size + z) * chunk_size + x);
    }
    Block at(ivec3 local) const { return blocks[index(local.x, local.y, local.z)]; }
};

/// The chunk that holds a block. Shifts round down, so negative coordinates need no care.
inline ivec3 chunk_key_of(ivec3 block) {
    return {block.x >> chunk_bits, block.y >> chunk_bits, block.z >> chunk_bits};
}
inline ivec3 chunk_low(ivec3 key) {
    return key * chunk_size;
}
inline ivec3 local_in_chunk(ivec3 block) {
    return {block.x & (chunk_size - 1), block.y & (chunk_size - 1), block.z & (chunk_size - 1)};
}

struct IvecHash {
    std::size_t operator()(ivec3 v) const {
        const auto x = static_cast<std::uint32_t>(v.x);
        const auto y = static_cast<std::uint32_t>(v.y);
        const auto z = static_cast<std::uint32_t>(v.z);
        return hash_mix((std::uint64_t{x} << 32) | z, y);
    }
};

/// An unbounded grid of blocks, stored where it is not air. Block (x, y, z) fills [x, x + 1) * block_size on
/// each axis, in local metres; y is up. Reading from several threads is safe while nobody writes.
class VoxelVolume {
  public:
    /// Edge of a block in metres, > 0.
    explicit VoxelVolume(float block_size = 0.5f);

    float block_size() const { return block_size_; }
    /// Air where nothing was set.
    Block get(ivec3 block) const;
    void set(ivec3 block, Block kind) { fill(block, block + 1, kind); }
    /// Sets every block with low <= block < high on all axes; nothing where the box is empty.
    void fill(ivec3 low, ivec3 high_exclusive, Block kind);

    /// Null where all is air.
    const Chunk* chunk(ivec3 key) const;
    /// Keys of all chunks with a block in them, sorted.
    std::vector<ivec3> chunk_keys() const;
    /// Takes in a whole chunk, where there is none, which does not count as a change: who brings it brings its mesh.
    void insert_chunk(ivec3 key, const Chunk& chunk);
    /// Makes all of it air, which does not count as a change either.
    void erase_chunk(ivec3 key);
    /// Keys of the chunks whose mesh may have changed since the last call, sorted: those written with another
    /// kind and the existing ones that touch a written block. A key without a chunk says that the chunk
    /// became air.
    std::vector<ivec3> take_changed_chunks();
    /// A box of blocks, high exclusive; low == high when there are none.
    struct Box {
        ivec3 low{0}, high{0};

        void add(const Box& other);
    };
    /// Box around the blocks for which a chunk was in the last answer of take_changed_chunks, its own or right beside it.
    Box changed_box(ivec3 key) const;

    /// Box of blocks around all chunks that are not air, high exclusive; low == high when there is none.
    ivec3 low() const;
    ivec3 high() const;
    /// Blocks that are not air.
    std::size_t block_count() const;

  private:
    void fill_in_chunk(ivec3 key, ivec3 low, ivec3 high, Block kind);

    float block_size_;
    std::unordered_map<ivec3, Chunk, IvecHash> chunks_;
    std::unordered_map<ivec3, Box, IvecHash> changed_, taken_;
};

}  // namespace sl
