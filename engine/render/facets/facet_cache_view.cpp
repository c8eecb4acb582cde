// SPDX-License-Identifier: MIT
#include "engine/render/facets/facet_cache.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

namespace sl {

namespace {

/// Pixels, per side of a square of the picture, through which the camera's rays go in as many looks.
constexpr std::uint32_t most_looks_per_side = 8;
/// Looks in a frame of a camera that stands still.
constexpr std::uint32_t looks_at_once = 5;
constexpr double looking_takes = 0.2;  ///< of a frame's time
/// Squares of the picture, beyond its edge, where light is gathered before a camera that moves sees them.
constexpr std::uint32_t beyond_the_edge = 2;
/// Share of a look that meets facets which are not known yet, where the camera has not moved but jumped.
constexpr float elsewhere = 0.02f;
/// The cosine of the angle under which facets are seen whole, and how many levels coarser a shader searches.
constexpr float steep = 0.25f, coarser_that_are_searched = 3.0f;
std::uint32_t looks_per_side(const Facets& settings) {
    return std::clamp(static_cast<std::uint32_t>(std::ceil(settings.spacing)), 1u, most_looks_per_side);
}

/// Where in its square a look goes, in [0, 1)²: each part of a grid once, neighbours far apart in time.
vec2 place_of_look(std::uint32_t look, std::uint32_t per_side) {
    std::uint32_t stride = std::max(5 * per_side / 8, 1u);
    while (std::gcd(stride, per_side) != 1) ++stride;
    const std::uint32_t row = look / per_side, column = (look + row) * stride % per_side;
    return (vec2(column, row * stride % per_side) + 0.5f) / static_cast<float>(per_side);
}

/// Numbers of the squares of a look, `count` in rows; `side` pixels wide, and `margin` of them beyond the picture's edge.
struct Squares {
    uvec2 count;
    float side;
    float margin;

    std::vector<std::uint32_t> all() const {
        std::vector<std::uint32_t> numbers(std::size_t{count.x} * count.y);
        std::iota(numbers.begin(), numbers.end(), 0u);
        return numbers;
    }
    /// Those in which one of the boxes may be seen.
    std::vector<std::uint32_t> of(const std::vector<Bounds>& boxes, const FrameParams& frame) const {
        std::vector<char> covered(std::size_t{count.x} * count.y);
        for (const Bounds& box : boxes) {
            const auto [low, high] = around(box, frame);
            for (int y = low.y; y <= high.y; ++y) {
                for (int x = low.x; x <= high.x; ++x) covered[static_cast<std::size_t>(y) * count.x + static_cast<std::size_t>(x)] = 1;
            }
        }
        std::vector<std::uint32_t> numbers = all();
        std::erase_if(numbers, [&](std::uint32_t square) { return covered[square] == 0; });
        return numbers;
    }

  private:
    /// First and last row and column that a box may cover; all where it reaches behind the camera.
    std::pair<ivec2, ivec2> around(const Bounds& box, const FrameParams& frame) const {
        const vec2 last = vec2(count) - 1.0f;
        vec2 low(std::numeric_limits<float>::infinity()), high(-low);
        for (int corner = 0; corner < 8; ++corner) {
            const vec3 place = glm::mix(box.low, box.high, vec3(corner & 1, corner >> 1 & 1, corner >> 2));
            const vec4 clip = frame.clip_from_world * vec4(place, 1.0f);
            if (clip.w <= frame.camera_position.w) return {ivec2(0), ivec2(last)};
            const vec2 pixel = (vec2(clip.x, -clip.y) / clip.w * 0.5f + 0.5f) * vec2(frame.ray_right.w, frame.ray_up.w);
            low = glm::min(low, pixel / side + margin - 1.0f);
            high = glm::max(high, pixel / side + margin + 1.0f);
        }
        return {ivec2(glm::ceil(glm::clamp(low - 1.0f, vec2(0.0f), last + 1.0f))), ivec2(glm::floor(glm::clamp(high, vec2(-1.0f), last)))};
    }
};

}  // namespace

float facet_side_over_distance(const FrameParams& frame, const Facets& settings) {
    return settings.spacing * 2.0f * glm::length(vec3(frame.ray_up)) / frame.ray_up.w;
}

float FacetCache::look_around(const FrameParams& frame, const Facets& settings, const Deadline& deadline, double longest_look) {
    // A camera that moves meets little that is new, and looks again in the next frame; unless it is somewhere else altogether.
    const std::uint32_t all = all_looks(settings);
    std::uint32_t most = looks_ == 0 ? 1 : looks_at_once;
    if (std::exchange(look_again_, false)) {
        looks_ = deadline.none() ? 0 : std::min(looks_, 1u);
        if (deadline.none()) most = all;
    }
    // The few rays of a small picture may all miss what is there, and tell nothing of whether more would meet it.
    const vec2 squares = glm::ceil(vec2(frame.ray_right.w, frame.ray_up.w) / std::max(settings.spacing, 1.0f));
    // Nor do those that meet facets of another width.
    if (deadline.none() && (squares.x * squares.y * elsewhere < 1.0f || other_spacing_)) most = all;
    float fresh = 0.0f;
    // In a window the first one is half of one, and nobody waits for what is finer while places have no light at all.
    const std::uint32_t last = deadline.none() ? all : all + 1;
    for (std::uint32_t i = 0; i < most && looks_ < last && !deadline.passed(looking_takes); ++i) {
        // A camera that moves sees what it missed a frame later; at every other square it is asked in turn.
        const bool moves = looks_ == 0 && !deadline.none();
        const Look what{.number = all_looks_++ % all,
                        .margin = deadline.none() ? 0 : beyond_the_edge,
                        .half = moves,
                        .finer = !moves || dark_.unlit <= a_little_dark,
                        .longest = deadline.none() ? 0.0 : longest_look};
        ++looks_;
        fresh = look(frame, settings, what);
        if (deadline.none() && fresh > elsewhere) most = all;
    }
    return fresh;
}

std::uint32_t FacetCache::all_looks(const Facets& settings) { return looks_per_side(settings) * looks_per_side(settings); }

void FacetCache::look_at(const FrameParams& frame, const Facets& settings, const std::vector<Bounds>& where, std::uint32_t looks) {
    for (std::uint32_t i = 0; i < std::min(looks, all_looks(settings)); ++i) look(frame, settings, {.number = i, .finer = looks >= all_looks(settings)}, where);
}

float FacetCache::look(const FrameParams& frame, const Facets& settings, const Look& what, const std::vector<Bounds>& where) {
    const vec2 size(frame.ray_right.w, frame.ray_up.w);
    const float spacing = std::max(settings.spacing, 1.0f);
    const uvec2 count = uvec2(glm::ceil(size / spacing)) + 2 * what.margin;
    const float side = facet_side_over_distance(frame, settings);
    const vec2 within = place_of_look(what.number, looks_per_side(settings));
    struct Seen {
        SurfacePoint point;
        float level, near, far, coarse;
        bool root;  ///< one of its first facets is not known
    };
    const Squares squares{.count = count, .side = spacing, .margin = static_cast<float>(what.margin)};
    const std::vector<std::uint32_t> looked_at = where.empty() ? squares.all() : squares.of(where, frame);
    std::vector<std::optional<Seen>> unknown(looked_at.size());
    tbb::parallel_for(std::size_t{0}, looked_at.size(), [&](std::size_t number) {
        const std::size_t i = looked_at[number];
        if (what.half && ((i % count.x + i / count.x + what.number) & 1) != 0) return;
        const vec2 cell = vec2(i % count.x, i / count.x) - static_cast<float>(what.margin), last = size - 1.0f + spacing * static_cast<float>(what.margin);
        const vec2 at = (glm::min(glm::floor((cell + within) * spacing), last) + 0.5f) / size;
        const Ray ray{.origin = vec3(frame.camera_position), .direction = view_ray(frame, vec2(2.0f * at.x - 1.0f, 1.0f - 2.0f * at.y)), .nearest = frame.camera_position.w};
        const auto meets = [&](const Bounds& box) { return box.meets(ray.origin, ray.direction, std::numeric_limits<float>::infinity()); };
        if (!where.empty() && std::ranges::none_of(where, meets)) return;
        const auto hit = world_->scene.intersect_front(ray);
        if (!hit) return;
        const SurfacePoint point = world_->scene.surface_at(*hit);
        const vec3 offset = point.position - vec3(frame.camera_position);
        const float distance = glm::length(offset);
        // Pixels beside this one are a little nearer or farther off: where the level changes they want the other one.
        const float near = facet_level(distance * 0.93f, side), far = facet_level(distance * 1.07f, side);
        // Seen from the side, facets are narrower than pixels, and few of them are met: larger ones stand in for the others.
        const float slant = std::abs(glm::dot(offset, point.face)) / distance;
        const float coarse = far + std::clamp(std::ceil(std::log2(steep / std::max(slant, 1e-3f))), 0.0f, coarser_that_are_searched);
        bool known = true;
        for (const float level : {near, far, coarse}) {
            const auto facet = facets_.find(facet_name(facet_cell(point.position, point.normal(), level)));
            // Other rays of this look may meet it as well, and say the same.
            if (facet != facets_.end()) {
                std::atomic_ref(facet->second.seen).store(all_looks_, std::memory_order_relaxed);
                std::atomic_ref(groups_[corners_[facet->second.corners[0]].group].seen).store(all_looks_, std::memory_order_relaxed);
            }
            known &= facet != facets_.end() && !facet->second.stand_in;
        }
        const float level = facet_level(distance, side);
        if (!known || (what.finer && finer_at(point, level))) unknown[number] = Seen{point, level, near, far, coarse, !known};
    });
    const auto known = static_cast<std::ptrdiff_t>(unfinished_.size());
    std::size_t fresh = 0;
    std::vector<Wanted> wanted;
    // Where thousands of meshes lie in one place, a ray takes as long as thousands.
    const Deadline deadline(what.longest);
    std::erase(unknown, std::nullopt);
    for (std::size_t first = 0, most = 1; first < unknown.size(); first += most, most *= 2) {
        if (first > 0 && deadline.passed()) {
            looks_ = 0;
            break;
        }
        // Ever more between two looks at the clock.
        std::vector<Seen> batch;
        for (std::size_t i = first; i < std::min(first + most, unknown.size()); ++i) batch.push_back(*unknown[i]);
        wanted.clear();
        for (const Seen& seen : batch) {
            if (!seen.root) continue;
            ++fresh;
            for (const float level : {seen.near, seen.far, seen.coarse}) wanted.push_back({.point = seen.point, .level = level});
            wanted.push_back({.point = seen.point, .level = seen.near + stand_in_coarser, .stand_in = true});
        }
        add(wanted);
        // Down to the finest, each of which is asked for by the one before it.
        while (what.finer && !batch.empty()) {
            wanted.clear();
            std::erase_if(batch, [&](const Seen& seen) {
                const auto finer = finer_at(seen.point, seen.level);
                if (finer) wanted.push_back(*finer);
                return !finer;
            });
            add(wanted);
        }
    }
    // All over the picture rather than from its top down: where the time of a frame ends, there is some light everywhere.
    std::sort(unfinished_.begin() + known, unfinished_.end(), [](std::uint32_t a, std::uint32_t b) { return a * 0x9e3779b1u < b * 0x9e3779b1u; });
    return static_cast<float>(fresh) / static_cast<float>(squares.count.x * squares.count.y);
}

}  // namespace sl
