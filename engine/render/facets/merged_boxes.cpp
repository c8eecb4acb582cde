// SPDX-License-Identifier: MIT
#include "engine/render/facets/merged_boxes.h"

#include <limits>

namespace sl {

namespace {

/// Of more than that each pair is not looked at.
constexpr std::size_t most_compared = 256;
/// What touches is merged where a box round both is not larger by more than this share of what the two are.
constexpr float worth_merging = 0.1f;

Bounds round_both(const Bounds& a, const Bounds& b) {
    Bounds both = a;
    both.add(b);
    return both;
}

}  // namespace

float half_surface(const Bounds& box) {
    const vec3 size = box.high - box.low;
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

std::vector<Bounds> merged_boxes(std::vector<Bounds> boxes, std::size_t most) {
    while (boxes.size() > most_compared) {
        boxes[boxes.size() - most_compared - 1].add(boxes.back());
        boxes.pop_back();
    }
    while (boxes.size() > 1) {
        std::size_t first = 0, second = 0;
        float least = std::numeric_limits<float>::infinity();
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            for (std::size_t j = i + 1; j < boxes.size(); ++j) {
                const float apart = half_surface(boxes[i]) + half_surface(boxes[j]), growth = half_surface(round_both(boxes[i], boxes[j])) - apart;
                const bool one = boxes[i].touches(boxes[j]) && growth <= worth_merging * apart;
                if (!(growth < least) || (!one && boxes.size() <= most)) continue;
                least = growth;
                first = i;
                second = j;
            }
        }
        if (second == 0) break;
        boxes[first].add(boxes[second]);
        boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(second));
    }
    return boxes;
}

}  // namespace sl
