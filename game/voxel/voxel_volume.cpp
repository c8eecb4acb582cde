// SPDX-License-Identifier: MIT
#include "game/voxel/voxel_volume.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "engine/core/check.h"

namespace sl {
namespace {

bool before(ivec3 a, ivec3 b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

}  // namespace

VoxelVolume::VoxelVolume(float block_size) : block_size_(block_size) {
    CHECK(block_size > 0.0f, "block size {} m", block_size);
}

Block VoxelVolume::get(ivec3 block) const {
    const Chunk* found = chunk(chunk_key_of(block));
    return found != nullptr ? found->at(local_in_chunk(block)) : Block::air;
}

void VoxelVolume::fill(ivec3 low, ivec3 high_exclusive, Block kind) {
    if (glm::any(glm::greaterThanEqual(low, high_exclusive))) return;
    const ivec3 first = chunk_key_of(low);
    const ivec3 last = chunk_key_of(high_exclusive - 1);
    for (int y = first.y; y <= last.y; ++y) {
        for (int z = first.z; z <= last.z; ++z) {
            for (int x = first.x; x <= last.x; ++x) {
                const ivec3 origin = chunk_low({x, y, z});
                fill_in_chunk({x, y, z}, glm::max(low - origin, 0),
                              glm::min(high_exclusive - origin, chunk_size), kind);
            }
        }
    }
}

void VoxelVolume::fill_in_chunk(ivec3 key, ivec3 low, ivec3 high, Block kind) {
    auto found = chunks_.find(key);
    if (found == chunks_.end()) {
        if (kind == Block::air) return;
        found = chunks_.try_emplace(key).first;
    }
    Chunk& target = found->second;
    ivec3 changed_low(chunk_size);
    ivec3 changed_high(-1);
    for (int y = low.y; y < high.y; ++y) {
        for (int z = low.z; z < high.z; ++z) {
            for (int x = low.x; x < high.x; ++x) {
                Block& cell = target.blocks[Chunk::index(x, y, z)];
                if (cell == kind) continue;
                if (cell == Block::air) ++target.count;
                if (kind == Block::air) --target.count;
                cell = kind;
                changed_low = glm::min(changed_low, ivec3(x, y, z));
                changed_high = glm::max(changed_high, ivec3(x, y, z));
            }
        }
    }
    if (changed_high.x < 0) return;
    const Box box{chunk_low(key) + changed_low, chunk_low(key) + changed_high + 1};
    changed_[key].add(box);
    for (int axis = 0; axis < 3; ++axis) {
        ivec3 side(0);
        side[axis] = 1;
        if (changed_low[axis] == 0 && chunk(key - side) != nullptr) changed_[key - side].add(box);
        if (changed_high[axis] == chunk_size - 1 && chunk(key + side) != nullptr) changed_[key + side].add(box);
    }
    if (target.count == 0) chunks_.erase(found);
}

const Chunk* VoxelVolume::chunk(ivec3 key) const {
    const auto found = chunks_.find(key);
    return found != chunks_.end() ? &found->second : nullptr;
}

std::vector<ivec3> VoxelVolume::chunk_keys() const {
    std::vector<ivec3> keys;
    keys.reserve(chunks_.size());
    for (const auto& entry : chunks_) keys.push_back(entry.first);
    std::sort(keys.begin(), keys.end(), before);
    return keys;
}

void VoxelVolume::insert_chunk(ivec3 key, const Chunk& chunk) {
    if (chunk.count == 0) return;
    const bool fresh = chunks_.try_emplace(key, chunk).second;
    CHECK(fresh, "chunk {} {} {} is there already", key.x, key.y, key.z);
}

void VoxelVolume::erase_chunk(ivec3 key) {
    chunks_.erase(key);
    changed_.erase(key);
}

std::vector<ivec3> VoxelVolume::take_changed_chunks() {
    taken_ = std::exchange(changed_, {});
    std::vector<ivec3> keys;
    for (const auto& entry : taken_) keys.push_back(entry.first);
    std::sort(keys.begin(), keys.end(), before);
    return keys;
}

VoxelVolume::Box VoxelVolume::changed_box(ivec3 key) const {
    const auto found = taken_.find(key);
    return found != taken_.end() ? found->second : Box{};
}

void VoxelVolume::Box::add(const Box& other) {
    const bool first = low == high;
    low = first ? other.low : glm::min(low, other.low);
    high = first ? other.high : glm::max(high, other.high);
}

ivec3 VoxelVolume::low() const {
    if (chunks_.empty()) return ivec3(0);
    ivec3 result(std::numeric_limits<int>::max());
    for (const auto& entry : chunks_) result = glm::min(result, chunk_low(entry.first));
    return result;
}

ivec3 VoxelVolume::high() const {
    if (chunks_.empty()) return ivec3(0);
    ivec3 result(std::numeric_limits<int>::lowest());
    for (const auto& entry : chunks_) result = glm::max(result, chunk_low(entry.first + 1));
    return result;
}

std::size_t VoxelVolume::block_count() const {
    std::size_t count = 0;
    for (const auto& entry : chunks_) count += entry.second.count;
    return count;
}

}  // namespace sl
