// SPDX-License-Identifier: MIT
#include "game/voxel/region_text.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <vector>

#include "engine/core/error.h"

namespace sl {

namespace {

/// Further from the origin, single cells cannot be told apart in metres.
constexpr int farthest_cell = 1 << 24;

std::int64_t cells_of(ivec3 size) { return std::int64_t{size.x} * size.y * size.z; }

bool too_large(ivec3 size) {
    // In two steps, or the product may be none.
    const std::int64_t floor = std::int64_t{size.x} * size.z;
    return floor > most_region_cells || floor * size.y > most_region_cells;
}

/// Calls `visit` with each cell of a box, in the order of the runs.
template <class Visit>
void each_cell(ivec3 low, ivec3 size, Visit&& visit) {
    for (int y = 0; y < size.y; ++y) {
        for (int z = 0; z < size.z; ++z) {
            for (int x = 0; x < size.x; ++x) visit(low + ivec3(x, y, z));
        }
    }
}

/// Takes words off a text and tells where one is wrong.
class Words {
  public:
    explicit Words(std::string_view text) : text_(text) {}

    bool empty() {
        skip_spaces();
        return at_ == text_.size();
    }
    std::string_view next(const char* wanted) {
        if (empty()) fail("the blocks of a region end where {} should follow", wanted);
        word_ = at_;
        while (at_ < text_.size() && text_[at_] != ' ') ++at_;
        return text_.substr(word_, at_ - word_);
    }
    void expect(std::string_view key) {
        if (next(key.data()) != key) wrong(fmt::format("'{}'", key));
    }
    int number(std::string_view text, int least, int most, const char* wanted) const {
        int value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size() || value < least || value > most) wrong(fmt::format("{} from {} to {}", wanted, least, most));
        return value;
    }
    ivec3 numbers(int least, int most, const char* wanted) {
        ivec3 result;
        for (int axis = 0; axis < 3; ++axis) result[axis] = number(next(wanted), least, most, wanted);
        return result;
    }
    [[noreturn]] void wrong(const std::string& wanted) const { fail("the blocks of a region: at character {} there should be {}", word_ + 1, wanted); }

  private:
    void skip_spaces() {
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    }

    std::string_view text_;
    std::size_t at_ = 0, word_ = 0;  ///< of the next word and of the last one
};

std::vector<Block> kinds_of(Words& words) {
    std::vector<Block> kinds;
    std::string_view names = words.next("names of kinds");
    while (true) {
        const std::size_t comma = names.find(',');
        const auto kind = block_by_name(names.substr(0, comma));
        if (!kind) words.wrong(fmt::format("kinds of blocks with commas between them, and '{:.40}' is none", names.substr(0, comma)));
        kinds.push_back(*kind);
        if (comma == std::string_view::npos) return kinds;
        names.remove_prefix(comma + 1);
    }
}

}  // namespace

std::string region_text(const VoxelVolume& volume, ivec3 low, ivec3 high) {
    if (glm::any(glm::lessThan(low, ivec3(-farthest_cell))) || glm::any(glm::greaterThan(high, ivec3(farthest_cell)))) fail("a region reaches at most {} blocks from the origin", farthest_cell);
    const ivec3 size = high - low;
    if (glm::any(glm::lessThan(size, ivec3(1)))) fail("a region from {},{},{} to {},{},{} is empty", low.x, low.y, low.z, high.x, high.y, high.z);
    if (too_large(size)) fail("a region of {} x {} x {} blocks is too large: it may have {}", size.x, size.y, size.z, most_region_cells);
    std::vector<Block> kinds;
    std::string runs;
    std::size_t kind = 0, count = 0;
    const auto end_run = [&] { if (count > 0) fmt::format_to(std::back_inserter(runs), " {}:{}", count, kind); };
    each_cell(low, size, [&](ivec3 cell) {
        const Block block = volume.get(cell);
        if (count > 0 && kinds[kind] == block) return void(++count);
        end_run();
        const auto known = std::ranges::find(kinds, block);
        kind = static_cast<std::size_t>(known - kinds.begin());
        if (known == kinds.end()) kinds.push_back(block);
        count = 1;
    });
    end_run();
    std::vector<std::string_view> names;
    for (const Block block : kinds) names.push_back(block_info(block).name);
    return fmt::format("low {} {} {} size {} {} {} kinds {} runs{}", low.x, low.y, low.z, size.x, size.y, size.z, fmt::join(names, ","), runs);
}

void put_region(VoxelVolume& volume, std::string_view text) {
    Words words(text);
    if (words.empty()) return;
    words.expect("low");
    const ivec3 low = words.numbers(-farthest_cell, farthest_cell, "a whole number");
    words.expect("size");
    const ivec3 size = words.numbers(1, farthest_cell, "a whole number");
    if (glm::any(glm::greaterThan(low + size, ivec3(farthest_cell)))) words.wrong(fmt::format("a box that ends at {} at most", farthest_cell));
    if (too_large(size)) words.wrong(fmt::format("fewer blocks: {} at most", most_region_cells));
    words.expect("kinds");
    const std::vector<Block> kinds = kinds_of(words);
    words.expect("runs");
    std::vector<Block> blocks;
    while (!words.empty()) {
        const std::string_view run = words.next("a run");
        const std::size_t colon = run.find(':');
        if (colon == std::string_view::npos) words.wrong("a run, for example 12:0");
        const int left = static_cast<int>(cells_of(size) - static_cast<std::int64_t>(blocks.size()));
        const int count = words.number(run.substr(0, colon), 1, left, "how many blocks are left");
        const int kind = words.number(run.substr(colon + 1), 0, static_cast<int>(kinds.size()) - 1, "which of the kinds");
        blocks.insert(blocks.end(), static_cast<std::size_t>(count), kinds[static_cast<std::size_t>(kind)]);
    }
    if (static_cast<std::int64_t>(blocks.size()) != cells_of(size)) fail("the blocks of a region end after {} of {}", blocks.size(), cells_of(size));
    auto block = blocks.begin();
    each_cell(low, size, [&](ivec3 cell) { volume.set(cell, *block++); });
}

}  // namespace sl
