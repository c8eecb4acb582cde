// SPDX-License-Identifier: MIT
// The blocks of a region as a scene file holds them. What is read is written, and read again the same.
#include "game/voxel/region_text.h"

#include "engine/core/check.h"
#include "engine/core/error.h"
#include "tests/fuzz/input_folder.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    sl::VoxelVolume volume, again;
    try {
        sl::put_region(volume, sl::text_of(data, size));
    } catch (const sl::Error&) {
        CHECK(volume.block_count() == 0, "a region that was refused has set blocks");
        return 0;
    }
    if (volume.block_count() == 0) return 0;
    const sl::ivec3 low = volume.low(), high = volume.high();
    if (std::int64_t{high.x - low.x} * (high.y - low.y) * (high.z - low.z) > (1 << 18)) return 0;  // that would take long
    const std::string text = sl::region_text(volume, low, high);
    sl::put_region(again, text);
    CHECK(sl::region_text(again, low, high) == text, "a region that was written is read as another one");
    return 0;
}
