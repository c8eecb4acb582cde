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
/// And by how many a facet is that stands in where there is no light yet: the largest that is found, for there are 64 times
/// fewer of them, and a frame or two light them.
constexpr float stand_in_coarser = coarser_that_are_searched;
/// Corners that differ by this share of their mean get finer facets between them.
constexpr float smooth_contrast = 0.25f;
constexpr std::uint32_t smooth_splits = 3;
/// Of the lattice off a surface.
constexpr float slabs_of_a_side = 8.0f;
constexpr float glaring = 3.0f;
/// A group of corners lies in a square of 8 by 8 facets.
constexpr float group_level = 3.0f;

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

/// Steps, in sides, across a quarter of a facet up its slope: one for each slab of the finer lattice that it passes through.
std::vector<vec2> steps_across_a_quarter(const SurfacePoint& point) {
    const vec3 face = facet_axes(point.face, facet_axis(point.normal()));
    const vec2 slope = std::abs(face.z) > 0.1f ? vec2(face) / face.z : vec2(0.0f);
    const float rise = std::abs(slope.x) + std::abs(slope.y);
    const auto slabs = static_cast<std::uint32_t>(std::ceil(slabs_of_a_side * rise - 1e-3f));
    std::vector<vec2> steps{vec2(0.0f)};
    for (std::uint32_t i = 0; i <= slabs && slabs > 0; ++i) {
        // Between the corners that are lowest and highest.
        const float part = static_cast<float>(i) / static_cast<float>(slabs) - 0.5f;
        steps.push_back(0.49f * part * vec2(std::copysign(1.0f, slope.x), std::copysign(1.0f, slope.y)));
    }
    return steps;
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
    // The few rays of a small picture may all miss what is there, and tell nothing of whether more would meet it.
    const vec2 squares = glm::ceil(vec2(frame.ray_right.w, frame.ray_up.w) / std::max(settings.spacing, 1.0f));
    // Nor do those that meet facets of another width.
    if (deadline.none() && (squares.x * squares.y * elsewhere < 1.0f || other_spacing_)) most = all;
    float fresh = 0.0f;
    for (std::uint32_t i = 0; i < most && looks_ < all && !deadline.passed(looking_takes); ++i) {
        // A camera that moves sees what it missed a frame later; at every other square it is asked in turn.
        const Look what{.number = all_looks_++ % all, .margin = deadline.none() ? 0 : beyond_the_edge, .half = looks_ == 0 && !deadline.none(), .longest = deadline.none() ? 0.0 : longest_look};
        ++looks_;
        fresh = look(frame, settings, what);
        if (deadline.none() && fresh > elsewhere) most = all;
    }
    return fresh;
}

std::uint32_t FacetCache::all_looks(const Facets& settings) { return looks_per_side(settings) * looks_per_side(settings); }

void FacetCache::look_at(const FrameParams& frame, const Facets& settings, const std::vector<Bounds>& where, std::uint32_t looks) {
    for (std::uint32_t i = 0; i < std::min(looks, all_looks(settings)); ++i) look(frame, settings, {.number = i}, where);
}

float FacetCache::look(const FrameParams& frame, const Facets& settings, const Look& what, const std::vector<Bounds>& where) {
    const vec2 size(frame.ray_right.w, frame.ray_up.w);
    const float spacing = std::max(settings.spacing, 1.0f);
    const uvec2 count = uvec2(glm::ceil(size / spacing)) + 2 * what.margin;
    const float side = facet_side_over_distance(frame, settings);
    const vec2 within = place_of_look(what.number, looks_per_side(settings));
    struct Seen {
        SurfacePoint point;
        std::array<float, 3> levels;
        float stand_in;
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
        for (const float level : {near, far, coarse}) {
            const auto known = facets_.find(facet_name(facet_cell(point.position, point.normal(), level)));
            // Other rays of this look may meet it as well, and say the same.
            if (known != facets_.end()) {
                std::atomic_ref(known->second.seen).store(all_looks_, std::memory_order_relaxed);
                std::atomic_ref(groups_[corners_[known->second.corners[0]].group].seen).store(all_looks_, std::memory_order_relaxed);
            }
            if (known == facets_.end() || known->second.stand_in) unknown[number] = Seen{point, {near, far, coarse}, near + stand_in_coarser};
        }
    });
    const auto known = static_cast<std::ptrdiff_t>(unfinished_.size());
    std::size_t fresh = 0;
    // Where thousands of meshes lie in one place, a ray takes as long as thousands.
    const Deadline deadline(what.longest);
    for (const auto& seen : unknown) {
        if (!seen) continue;
        if (fresh > 0 && deadline.passed()) {
            looks_ = 0;
            break;
        }
        ++fresh;
        for (const float level : seen->levels) add(seen->point, level);
        add(seen->point, seen->stand_in, 0, 0, true);
    }
    // All over the picture rather than from its top down: where the time of a frame ends, there is some light everywhere.
    std::sort(unfinished_.begin() + known, unfinished_.end(), [](std::uint32_t a, std::uint32_t b) { return a * 0x9e3779b1u < b * 0x9e3779b1u; });
    return static_cast<float>(fresh) / static_cast<float>(squares.count.x * squares.count.y);
}

void FacetCache::add(const SurfacePoint& point, float level, FacetName root, std::uint32_t depth, bool stand_in) {
    const FacetCell cell = facet_cell(point.position, point.normal(), level);
    const FacetName name = facet_name(cell);
    const auto [entry, fresh] = facets_.try_emplace(name);
    Facet& facet = entry->second;
    if (!fresh) {
        if (!stand_in && std::exchange(facet.stand_in, false)) {
            unsplit_.push_back(name);
            table_is_old_ = shown_are_old_ = true;
        }
        return;
    }
    facet.middle = point;
    facet.level = level;
    facet.depth = depth;
    facet.stand_in = stand_in;
    facet.root = root != 0 ? root : name;
    facet.seen = all_looks_;
    for (std::uint32_t corner = 0; corner < 4; ++corner) {
        facet.corners[corner] = corner_of(facet, name, vec2(cell.within), uvec2(corner & 1, corner >> 1));
        ++corners_[facet.corners[corner]].users;
    }
    if (!stand_in) unsplit_.push_back(name);
    table_is_old_ = shown_are_old_ = true;
}

std::uint32_t FacetCache::corner_of(Facet& facet, FacetName name, vec2 within, uvec2 lattice) {
    // Facets that meet at a corner share it, unless it lies in an edge or at the foot of something.
    const std::uint32_t u = (static_cast<std::uint32_t>(name) + lattice.x) & 0xffffu, v = ((static_cast<std::uint32_t>(name) >> 16) + lattice.y) & 0xffffu;
    const FacetName shared_name = (name & ~FacetName{0xffffffffu}) | (v << 16) | u;
    if (const auto known = shared_corners_.find(shared_name); known != shared_corners_.end()) return known->second;
    const FacetCorner corner = facet_corner(world_->scene, facet.middle, facet.level, within, vec2(lattice));
    const std::uint32_t id = add_corner(corner, facet.level - 1.0f, facet.level + group_level + (facet.stand_in ? -stand_in_coarser : static_cast<float>(facet.depth)));
    corners_[id].stands_in = facet.stand_in;
    if (corner.shared) {
        shared_corners_.emplace(shared_name, id);
        corners_[id].shared_as = shared_name;
    }
    facet.cut |= corner.cut;
    return id;
}

std::uint32_t FacetCache::add_corner(const FacetCorner& corner, float level, float level_of_group) {
    auto id = static_cast<std::uint32_t>(corners_.size());
    if (free_corners_.empty()) {
        corners_.emplace_back();
    } else {
        id = free_corners_.back();
        free_corners_.pop_back();
    }
    const FacetName cell = facet_name(facet_cell(corner.point.position, corner.point.normal(), level_of_group));
    const std::uint32_t group = group_at(cell);
    groups_[group].seen = all_looks_;
    corners_[id] = {.at = {.point = corner.point, .level = level, .guide = groups_[group].guide.get()}, .group = group};
    groups_[group].corners.push_back(id);
    unfinished_.push_back(id);
    return id;
}

std::uint32_t FacetCache::group_at(FacetName cell) {
    const auto [known, fresh] = group_of_cell_.try_emplace(cell, static_cast<std::uint32_t>(groups_.size()));
    if (!fresh) return known->second;
    if (free_groups_.empty()) {
        groups_.emplace_back();
    } else {
        known->second = free_groups_.back();
        free_groups_.pop_back();
    }
    groups_[known->second].cell = cell;
    unguided_.push_back(known->second);
    return known->second;
}

void FacetCache::release(std::uint32_t id) {
    Corner& corner = corners_[id];
    if (--corner.users > 0) return;
    if (corner.shared_as != 0) shared_corners_.erase(corner.shared_as);
    Group& group = groups_[corner.group];
    std::erase(group.corners, id);
    if (corner.counted_spread >= 0.0f) {
        group.spread -= corner.counted_spread;
        --group.judged;
    }
    corner = Corner{.gone = true};
    released_.push_back(id);
}

void FacetCache::bury_released() {
    if (released_.empty()) return;
    const auto gone = [&](std::uint32_t corner) { return corners_[corner].gone; };
    std::erase_if(unfinished_, gone);
    std::erase_if(unmended_, gone);
    free_corners_.insert(free_corners_.end(), released_.begin(), released_.end());
    released_.clear();
}

float FacetCache::mean_irradiance() const {
    double sum = 0.0, lit = 0.0;
    for (const auto& [name, facet] : facets_) {
        const Corner& corner = corners_[facet.corners[0]];
        if (facet.depth > 0 || facet.stand_in || !corner.lit) continue;
        sum += luminance(corner.at.irradiance);
        ++lit;
    }
    return lit > 0.0 ? static_cast<float>(sum / lit) : 0.0f;
}

void FacetCache::split_where_needed() {
    // Not before light has settled: until then it would split where light has not arrived yet.
    if (splits_are_old_ && unfinished_.empty() && share_known() == 1.0f) look_again_at_splits();
    std::optional<float> known_mean;
    const auto mean = [&] { return known_mean ? *known_mean : known_mean.emplace(mean_irradiance()); };
    std::vector<FacetName> waiting;
    for (const FacetName name : std::exchange(unsplit_, {})) {
        Facet& facet = facets_.at(name);
        if (facet.split || facet.depth >= facet_most_splits) continue;
        const bool fine = facet.depth >= smooth_splits;
        float low = std::numeric_limits<float>::infinity(), high = 0.0f, sum = 0.0f;
        bool known = true;
        for (const std::uint32_t corner : facet.corners) {
            known &= corners_[corner].done;
            const float value = luminance(corners_[corner].at.irradiance);
            low = std::min(low, value);
            high = std::max(high, value);
            sum += 0.25f * value;
        }
        if (!known) {
            waiting.push_back(name);
            continue;
        }
        // What is finer still must be worth it: many times as bright as what else is seen.
        if (fine ? (facet.cut ? high : high - low) <= glaring * mean() : !facet.cut && high - low <= smooth_contrast * sum) continue;
        facet.split = true;
        table_is_old_ = shown_are_old_ = true;
        const Facet parent = facet;
        const vec2 within(facet_cell(parent.middle.position, parent.middle.normal(), parent.level).within);
        const std::vector<vec2> steps = steps_across_a_quarter(parent.middle);
        for (std::uint32_t quarter = 0; quarter < 4; ++quarter) {
            const vec2 centre = vec2(0.25f) + 0.5f * vec2(quarter & 1, quarter >> 1) - within;
            for (const vec2 step : steps) {
                const vec3 target = along_surface(parent.middle, parent.level, centre + step);
                if (const auto point = surface_near(world_->scene, parent.middle, target, std::exp2(parent.level))) add(*point, parent.level - 1.0f, parent.root, parent.depth + 1);
            }
        }
        add(parent.middle, parent.level - 1.0f, parent.root, parent.depth + 1);
    }
    unsplit_.insert(unsplit_.end(), waiting.begin(), waiting.end());
}

}  // namespace sl
