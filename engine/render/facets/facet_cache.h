// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <unordered_map>

#include "engine/ecs/components/gi_settings.h"
#include "engine/render/scene/frame_params.h"
#include "engine/render/trace/path_walk.h"
#include "shared/facets.h"

namespace sl {

/// The facets as shaders search them: open addressing, linear probing, 8 words a slot.
struct FacetTable {
    std::vector<std::uint32_t> words;
    std::uint32_t slots = 0;         ///< a power of two
    std::uint32_t longest_search = 0;
    float unit = 1.0f;               ///< lux of a stored 1
};

/// Irradiance kept where it is needed, on the surfaces themselves: the visible surfaces are cut into facets some pixels
/// wide, and the light that arrives at each corner is path traced, with everything that may stand in its way. Corners stay
/// while the camera moves, and until something changes that light depends on. No GL.
class FacetCache {
  public:
    struct Budget {
        double seconds = 0.0;  ///< 0: until everything that is wanted is there
    };

    /// Looks at what the camera sees and traces what is not known yet. Returns the share of the wanted that is known.
    float update(const RenderScene& scene, const FrameParams& frame, const Facets& settings, const Budget& budget);

    const FacetTable& table() const { return table_; }
    /// Counts up when the table changes.
    std::uint64_t version() const { return version_; }
    std::size_t facets() const { return facets_.size(); }
    std::size_t corners() const { return corners_.size(); }
    std::uint64_t paths() const { return paths_; }

  private:
    /// A place on a surface where light is gathered.
    struct Corner {
        SurfacePoint point;
        glm::dvec3 sum{0.0};
        double squares = 0.0;  ///< of luminance
        std::uint32_t samples = 0;
        bool done = false;

        vec3 irradiance() const { return samples > 0 ? vec3(sum / double(samples)) : vec3(0.0f); }
    };
    struct Facet {
        SurfacePoint middle;  ///< a point of its surface
        float level = 0.0f;
        std::uint32_t depth = 0;  ///< how often its first one was split
        std::array<std::uint32_t, 4> corners{};
        bool cut = false;    ///< not all corners lie where the lattice has them: something stands between, or an edge
        bool split = false;  ///< finer ones hold more
    };
    using Name = std::uint64_t;
    static Name name_of(const FacetCell& cell) { return (Name{cell.name.x} << 32) | cell.name.y; }

    void start_anew(const RenderScene& scene, const Facets& settings, std::uint64_t content);
    void look(const FrameParams& frame, const Facets& settings);
    void add(const SurfacePoint& point, float level, std::uint32_t depth);
    std::uint32_t corner_of(const Facet& facet, vec2 lattice, Name name, vec2 within);
    bool clear_around(const SurfacePoint& point, float side) const;
    std::optional<SurfacePoint> surface_near(const SurfacePoint& from, vec3 target, float side) const;
    void trace(const Facets& settings, const Budget& budget);
    void split_where_needed(const Facets& settings);
    void fill_table();
    float share_known() const;

    std::unique_ptr<TransportWorld> world_;
    std::uint64_t content_ = 0;
    bool renewing_ = false;  ///< the table still holds light from before a change
    std::unordered_map<Name, Facet> facets_;
    std::unordered_map<Name, std::uint32_t> shared_corners_;
    std::vector<Corner> corners_;
    std::vector<std::uint32_t> unfinished_;
    std::vector<Name> unsplit_;  ///< facets that were not asked yet whether to split
    FacetTable table_;
    std::uint64_t version_ = 0, paths_ = 0;
    std::uint32_t looks_ = 0;  ///< since the camera or the scene changed
    FrameParams seen_{};
    double seconds_per_path_ = 1e-5;
};

}  // namespace sl
