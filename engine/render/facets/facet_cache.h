// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <unordered_map>

#include "engine/core/work_times.h"
#include "engine/ecs/components/gi_settings.h"
#include "engine/render/facets/deadline.h"
#include "engine/render/facets/facet_corner.h"
#include "engine/render/facets/facet_smoothing.h"
#include "engine/render/facets/facet_table.h"
#include "engine/render/facets/patches.h"
#include "engine/render/scene/frame_params.h"
#include "engine/render/scene/surface_changes.h"

namespace sl {

/// Side of a facet over its distance from the camera.
float facet_side_over_distance(const FrameParams& frame, const Facets& settings);

/// A facet as people can look at it.
struct FacetOutline {
    std::array<vec3, 4> corners;  ///< round it
    vec3 irradiance{0.0f};        ///< mean of its corners, lux
    float noise = 0.0f;           ///< largest standard error at a corner, over its irradiance
};

/// Irradiance kept where it is needed, on the surfaces themselves: the visible surfaces are cut into facets some pixels
/// wide, and light is gathered at their corners from patches of all surfaces, with everything that may stand in its way.
/// What sees what stays while the camera and lights move; when lights change, light alone is renewed. No GL.
class FacetCache {
  public:
    /// What one update may spend.
    struct Budget {
        double seconds = 0.0;  ///< 0: until everything that is wanted is there
        double longest_look = 0.5;  ///< s, where `seconds` is not 0: facets that are new may take so long, and the rest waits for the next update
        std::size_t memory = std::size_t{256} << 20;  ///< bytes, from which what was not seen for long is forgotten; what is seen may take more
    };

    /// Looks at what the camera sees and gathers what is not known yet. Returns the share of the wanted that is known.
    float update(const RenderScene& scene, const FrameParams& frame, const Facets& settings, const Budget& budget);

    const FacetTable& table() const { return table_; }
    /// Root mean square of the standard errors at the corners in the table, each over its irradiance.
    float error() const { return error_; }
    /// Bytes that corners and patches take, about.
    std::size_t memory() const { return memory_; }
    /// The facets from which pixels take their light, nearest to a place first. Costs a look at all of them.
    std::vector<FacetOutline> outlines_near(vec3 place, std::size_t most) const;
    /// What the last update did.
    const WorkTimes& times() const { return times_; }
    /// Counts up when the table changes.
    std::uint64_t version() const { return version_; }

  private:
    struct Corner {
        GatherPoint at;
        std::uint32_t group = 0;
        bool lit = false;   ///< it was gathered at least once
        bool done = false;
        bool gone = false;  ///< nobody has it, and its place may be taken
        bool to_stay = false;          ///< a facet that has it shows it for good
        bool fine = false;             ///< until it has light, that of a coarser facet shows
        bool stands_in = false;        ///< first of those without light
        std::uint32_t users = 0;       ///< facets that have it
        FacetName shared_as = 0;       ///< its name in shared_corners_; 0: none
        float spread = 0.0f;           ///< variance of one link's light over the squared mean
        float counted_spread = -1.0f;  ///< that its group knows of; -1: none
    };
    /// Corners close to each other, which see much the same.
    struct Group {
        std::vector<std::uint32_t> corners;
        std::unique_ptr<Guide> guide;
        float spread = 0.0f;      ///< sum of its corners' spreads
        std::uint32_t judged = 0;  ///< corners in that sum
        bool stale = false;        ///< the guide was made in other light
        FacetName cell = 0;       ///< of the lattice, in which they lie
        std::uint32_t tried = 0;  ///< guided links that each corner had when the guide last learned from them
        std::uint32_t seen = 0;   ///< the last look that met it
    };
    struct Facet {
        SurfacePoint middle;  ///< a point of its surface
        float level = 0.0f;
        std::uint32_t depth = 0;  ///< how often its first one was split
        std::array<std::uint32_t, 4> corners{};
        bool cut = false;    ///< not all corners lie where the lattice has them
        bool stand_in = false;  ///< much larger than what is wanted, until that is there
        bool split = false;  ///< finer ones hold more
        FacetName root = 0;  ///< of the one that was split first
        std::uint32_t seen = 0;  ///< the last look that met it; of one that was not split from another
    };

    /// How much of a frame's time changes of the scene are worth.
    enum class Followed {
        nothing,
        in_passing,  ///< surfaces came or went by themselves, as land does: what is left of the time is for light
        at_once      ///< somebody waits to see it
    };
    /// `may_wait`: what hardly shows need not be followed at once.
    Followed follow_changes(const RenderScene& scene, const FrameParams& frame, const Facets& settings, bool may_wait);
    Followed follow_surfaces(const RenderScene& scene, const FrameParams& frame, const Facets& settings, bool may_wait);
    void follow_lights(const RenderScene& scene);
    void follow_settings(const Facets& settings);
    void start_anew(const RenderScene& scene);
    /// All positions change by `offset`, m: the scene's origin is another one. Lights that only rounding tells from these are
    /// these. False, and nothing is changed, where the lattice of facets would be another one.
    bool move(vec3 offset, const std::vector<RenderScene::Light>& lights);
    /// Exponent of the side of the largest cell that has facets, corners, groups or patches.
    int coarsest_cell() const;
    void change_lights(const RenderScene& scene);
    /// Returns where there are no facets now.
    std::vector<Bounds> change_surfaces(const RenderScene& scene, const std::vector<Bounds>& boxes);
    /// Returns where there are none now.
    std::vector<Bounds> forget_facets(const std::vector<Bounds>& boxes);
    void mend_later(const std::vector<Bounds>& boxes);
    void mend(const Deadline& deadline);
    void look_again_at_splits();
    void forget_unseen();
    /// A little of what `Patches::bury` needs, or all.
    void bury_some(bool all);
    /// Of all corners that are there.
    std::vector<const GatherPoint*> gather_points() const;
    void forget_empty_groups();
    void distrust_guide(std::uint32_t group);
    /// Returns what the last look returned, 0 where there was none.
    float look_around(const FrameParams& frame, const Facets& settings, const Deadline& deadline, double longest_look);
    /// The first looks, at what boxes cover.
    void look_at(const FrameParams& frame, const Facets& settings, const std::vector<Bounds>& where, std::uint32_t looks);
    /// After so many, all that a still camera sees has been met.
    static std::uint32_t all_looks(const Facets& settings);
    /// Rays of the camera through one pixel of each square of the picture.
    struct Look {
        std::uint32_t number = 0;  ///< which pixel of each square
        std::uint32_t margin = 0;  ///< squares beyond the picture's edge
        bool half = false;         ///< every other square
        bool finer = true;         ///< what it meets may ask for finer facets
        double longest = 0.0;      ///< s that what it meets may take, 0: however long; what is left is met by later looks
    };
    /// Along rays that pass through one of the boxes, or all where there are none. Returns the share of squares in which a ray
    /// met what was not known.
    float look(const FrameParams& frame, const Facets& settings, const Look& what, const std::vector<Bounds>& where = {});
    /// By how many levels a facet is coarser that stands in where there is no light yet: the largest that a shader finds, for there
    /// are 64 times fewer of them, and a frame or two light them.
    static constexpr float stand_in_coarser = 3.0f;
    /// A facet where a point lies.
    struct Wanted {
        SurfacePoint point;
        float level = 0.0f;
        FacetName root = 0;  ///< 0: it is one itself
        std::uint32_t depth = 0;
        bool stand_in = false;
    };
    /// Where the facet of this level is split: the next finer one that is not there yet at the point.
    std::optional<Wanted> finer_at(const SurfacePoint& point, float level) const;
    void add(std::span<const Wanted> wanted);
    /// A facet that does not stand in: by what is seen of it where it is cut, else when its light is known.
    void ask_for_finer(FacetName name, Facet& facet);
    std::uint32_t add_corner(const FacetCorner& corner, float level, float group_level);
    std::uint32_t group_at(FacetName cell);
    void release(std::uint32_t corner);
    void bury_released();
    void work(const Facets& settings, const Deadline& deadline);
    /// Returns how many are to get their first links before others get more.
    std::size_t put_urgent_first();
    void guide_corners();
    void improve_guides(const Facets& settings);
    std::vector<Patches::Job> jobs_of(const Group& group);
    void look_for_other_lights(const Deadline& deadline);
    void link_anew(std::uint32_t corner, const Guide* guide);
    /// Of the first `count` that want some, up to `most` links each.
    void link_corners(const Facets& settings, std::size_t count, std::uint32_t most, double share, const Deadline& deadline);
    void light_moves();
    void reflect(const Facets& settings, const Deadline& deadline);
    void gather(const Facets& settings, const Deadline& deadline);
    void judge(std::uint32_t corner);
    void decide(std::uint32_t corner, const Facets& settings);
    float mean_irradiance() const;
    void split_where_needed();
    void fill_table();
    float share_known() const;
    bool in_view(const Group& group) const;
    /// Shares of the corners in view.
    struct Dark {
        float unlit = 1.0f;  ///< without light
        float black = 1.0f;  ///< of these, where no coarser facet shows any
    };
    Dark dark() const;
    static constexpr float a_little_dark = 0.03f;  ///< which a camera that moves always meets

    std::unique_ptr<TransportWorld> world_;
    std::unique_ptr<Patches> patches_;
    dvec3 origin_{0.0};            ///< of the scene
    std::uint64_t materials_ = 0;  ///< hash of all materials
    std::uint64_t surfaces_ = 0;   ///< hash of all draws
    SurfaceChanges changes_;       ///< since those that are traced
    std::uint32_t waited_ = 0;  ///< frames, that changes of surfaces were not followed
    std::vector<RenderScene::Light> lights_;
    bool lights_wait_ = false;  ///< they are those of a frame ago
    bool renewing_ = false;  ///< the table still holds light from before a change

    std::unordered_map<FacetName, Facet> facets_;
    std::unordered_map<FacetName, std::uint32_t> shared_corners_;
    std::deque<Corner> corners_;
    std::size_t buried_ = 0;                   ///< corners whose links were looked at for the patches' burying
    std::vector<std::uint32_t> released_;      ///< corners that are gone, though lists may hold them
    std::vector<std::uint32_t> free_corners_;  ///< places where corners were
    std::unordered_map<FacetName, std::uint32_t> group_of_cell_;
    std::vector<Group> groups_;
    std::vector<std::uint32_t> free_groups_;
    std::vector<std::uint32_t> unguided_;  ///< groups without a guide
    std::vector<std::uint32_t> untried_;   ///< groups whose guide knows nothing yet of what stands in between
    std::vector<std::uint32_t> stale_;     ///< groups whose guide was made in other light
    std::vector<std::uint32_t> unmended_;    ///< corners that do not know yet of changed surfaces; those most concerned come last
    std::vector<std::uint32_t> unfinished_;  ///< corners that want more links, the most urgent first
    std::vector<FacetName> unsplit_;         ///< facets that were not asked yet whether to split
    bool reflecting_ = false;         ///< light between patches has not settled
    std::size_t reflected_ = 0;       ///< the patch whose turn it is to reflect
    float largest_change_ = 0.0f;     ///< in this round
    std::size_t gathered_ = 0;        ///< the corner whose turn it is to gather
    std::size_t to_gather_ = 0;       ///< corners whose patches have changed since
    bool splits_are_old_ = false;     ///< light has changed since facets were asked whether to split
    FacetTable table_;
    std::vector<FacetEntry> shown_;    ///< what the table holds
    bool shown_are_old_ = false;        ///< facets have come or gone, or have their first light
    std::vector<vec3> irradiance_;     ///< of all corners, for the table
    std::vector<float> variance_;      ///< of that over its square; negative where there is no light
    FacetSmoothing smoothing_;
    std::size_t memory_ = 0, most_memory_ = 0;  ///< bytes: taken, and at which what was not seen for long is forgotten
    float error_ = 0.0f;
    bool table_is_old_ = false;
    std::uint64_t version_ = 0;
    bool look_again_ = false;      ///< what is seen of some facets asks for finer ones
    std::uint32_t looks_ = 0;      ///< since the camera or the scene changed
    std::uint32_t all_looks_ = 0;  ///< ever
    std::uint32_t view_began_ = 0;  ///< the last of all looks before the camera came to where it is
    Dark dark_;  ///< of the last frame
    bool other_spacing_ = false;  ///< than in the last frame
    FrameParams seen_{};
    WorkTimes times_;
    float spacing_ = 0.0f, noise_ = 0.0f;  ///< settings of the last frame
    std::uint32_t bounces_ = 0;
};

}  // namespace sl
