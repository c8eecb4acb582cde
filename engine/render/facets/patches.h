// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <span>
#include <unordered_map>

#include "engine/render/facets/facet_name.h"
#include "engine/render/facets/guide.h"
#include "engine/render/trace/transport_world.h"

namespace sl {

/// What a ray from a gather point has met.
struct Link {
    std::uint32_t patch;  ///< or Patches::sky, Patches::nothing
    float guided = 0.0f;    ///< density of guided rays over that of rays by chance, for equal numbers of both
    float distance = 0.0f;  ///< m; infinite to the sky
    std::uint32_t direction = 0;  ///< pack_normal
};

/// A point on a surface whose irradiance is gathered: rays in well-spread directions find once what it sees, and whatever
/// light changes later is only summed up anew.
struct GatherPoint {
    SurfacePoint point;
    float level = 0.0f;            ///< exponent of the side of the smallest patches that it tells apart
    const Guide* guide = nullptr;  ///< what it sends further rays to
    std::vector<Link> by_chance;   ///< along rays with density cos θ / π
    std::vector<Link> guided;      ///< along rays that the guide has drawn
    vec3 irradiance{0.0f};         ///< as last gathered, lux
    std::uint32_t changes = 0;     ///< of surfaces, which its links have followed
    std::uint32_t renewed = 0;     ///< how many links did not survive those

    /// Bytes.
    std::size_t memory() const { return sizeof(GatherPoint) + (by_chance.capacity() + guided.capacity()) * sizeof(Link); }
};

/// The surfaces that others see, as patches that reflect diffusely, and the light that they exchange along links: a
/// radiosity solution whose form factors are rays (Hanrahan et al. 1991 for links between patches of sizes that suit their
/// distance). A patch is all that is seen of its cell of a world-space lattice from its own first point, so none reaches
/// through a wall. Which patches there are depends on surfaces alone; what they reflect is renewed when lights change.
class Patches {
  public:
    static constexpr std::uint32_t sky = ~0u, nothing = ~0u - 1;

    /// A point and how many rays by chance it is to have had in all; with a guide, it gets half as many guided ones.
    struct Job {
        GatherPoint* point;
        std::uint32_t by_chance;
        std::uint32_t seed;  ///< equal seeds: equal directions round the normal
        std::uint32_t patch = nothing;  ///< whose middle `point` is; its rays start all over the patch
    };
    /// An irradiance and its standard error, of luminance.
    struct Gathered {
        vec3 irradiance{0.0f};
        float error = 0.0f;
    };

    /// The world must outlive the patches.
    explicit Patches(const TransportWorld& world) : world_(world) { measure_world(); }

    /// The world's positions have all changed by `offset`, m, a whole number of the sides of `coarsest_cell`.
    void move(vec3 offset);
    /// Exponent of the side of the largest cell that has patches; of none, 0.
    int coarsest_cell() const;

    /// Surfaces of the world have changed within boxes alone: what lies there is forgotten. Lights are those of before.
    /// What points have seen there, or through it, stays until `mend`.
    void change(std::span<const Bounds> boxes);
    /// What these points' links met in or through boxes that have changed is looked for anew.
    void mend(std::span<const Job> jobs);
    /// The same for at most `most` patches; false when all have followed.
    bool mend(std::size_t most);
    bool mending() const { return mended_ < patches_.size() && !changes_.empty(); }
    /// All points and patches have followed all changes: no link leads to what is gone, and its place can be taken.
    void forget_changes();

    /// Forgets all patches from which no light comes to these points, straight or reflected.
    void forget_all_but_seen_from(std::span<const GatherPoint* const> points);
    /// Whether so many patches are gone, and may still be linked to, that it pays to look.
    bool many_gone() const;
    /// Places of patches that are gone, and that nothing is linked to, can be taken; for changes that come without end are never
    /// all followed, and `forget_changes` does not happen. It takes its time: begin, tell each point that is there now, in
    /// any order and from any thread, and let patches look at their own links, `most` at a time, until it returns false.
    void begin_burying();
    bool burying() const { return !linked_.empty(); }
    void keep_linked(const GatherPoint& point);
    bool bury(std::size_t most);
    /// Bytes, about.
    std::size_t memory() const;

    /// Follows the rays that points still lack; what they meet becomes a patch where it is none yet.
    void link(std::span<const Job> jobs);
    /// Links of patches themselves, of at most `most` of them; those found last come last. False when none lacks any.
    bool grow(std::size_t most);

    /// These lights have gone or come: where one matters, the light of patches is asked for anew, by `renew`.
    void forget_light(std::span<const LightParams> lights);
    void forget_light(std::span<const Emitters::Ball> glowing);
    /// Direct light of at most `most` patches that wait for it, a first estimate before what lights it evenly; false when
    /// none does.
    bool renew(std::size_t most);
    /// Whether some have not even a first estimate.
    bool renewing() const { return dark() || !waiting_.empty(); }
    /// Whether some have no light at all.
    bool dark() const { return !dark_.empty(); }
    /// One more reflection from these patches. Returns the largest change of one's luminance, lux.
    float reflect(std::size_t first, std::size_t last);
    std::size_t size() const { return patches_.size(); }
    /// Starts again with light of one reflection; `any` false: of none, and patches are black.
    void forget_reflections(bool any);

    /// Of a point that is no patch's own: what glows is seen by its links.
    Gathered gather(const GatherPoint& point) const { return gather(point, seen_); }
    /// Where rays of points near each other are best sent, judged by the links by chance that they have.
    Guide guide_for(std::span<const Job> points) const;
    /// Whether the guided links of points tell that their guide should send rays elsewhere, as it does from now on. Their
    /// links are not those of such a guide, and have to be found anew.
    bool improve(Guide& guide, std::span<const Job> points) const;
    /// Mean luminance of what patches reflect, lux.
    float mean_light() const;

  private:
    static constexpr std::uint32_t links_of_a_patch = 32;
    /// From the middle of its cell, over its side, how far a patch reaches.
    static constexpr float reach = 0.9f;
    /// Light that brings less than this share of what is there may change unnoticed.
    static constexpr float too_little = 0.005f;
    /// Strata, per side, in which a patch's direct light is sampled: of one that is lit evenly, and of one with a shadow's
    /// edge in it.
    static constexpr std::uint32_t few_strata = 4, many_strata = 8;

    /// A place in a patch. There are many of them, so that they hold no more than light needs.
    class Sample {
      public:
        explicit Sample(const SurfacePoint& point);
        /// Where it is; of its surface, the normal alone.
        SurfacePoint place() const;
        vec3 albedo() const;

        vec3 position;
        float glow;          ///< luminance of what it gives out of itself, lux
        vec3 lit{0.0f};      ///< irradiance straight from lights and what glows, lux
        std::uint8_t lit_in = 0;  ///< that light, as its patch counts them; 0: none

      private:
        float error_;
        std::uint32_t face_, normal_, albedo_;  ///< packed
    };
    struct Patch {
        GatherPoint middle;
        FacetName cell = 0;
        float level = 0.0f;  ///< of the cell
        float side = 0.0f;   ///< of the cell, m
        std::vector<Sample> samples;
        vec3 albedo{0.0f};
        vec3 lit{0.0f};       ///< radiosity without that of indirect light, lux
        vec3 glow{0.0f};      ///< what it gives out of itself, lux
        vec3 bright_place{0.0f};  ///< middle of what of it is lit
        float bright_radius = 0.0f;
        std::uint32_t strata = 0;  ///< per side, of the samples
        bool sharp = false;        ///< seen by more than other patches
        bool waiting = false;      ///< for its light
        bool rough = false;        ///< few of its samples are lit
        bool gone = false;         ///< its surface is no longer there
        std::uint8_t light = 1;    ///< counts up, but for 0, when all that its samples know becomes old

        bool knows(const Sample& sample) const { return sample.lit_in == light; }
        void forget_light();
    };
    /// What tells which points are a patch's, apart from all else that it knows: a search in a cell reads no more.
    struct Mark {
        vec3 position{0.0f};  ///< the patch's own point, its face and rounding error
        float side = 0.0f;
        vec3 face{0.0f};
        float error = 0.0f;
        float glow = 0.0f;             ///< nit
        std::uint32_t next = nothing;  ///< another one in the same cell

        Mark() = default;
        explicit Mark(const Patch& patch);
    };
    /// What a ray met.
    struct Met {
        std::uint32_t patch = nothing;  ///< or sky
        float guided = 0.0f, distance = std::numeric_limits<float>::infinity();
        std::uint32_t direction = 0;
        bool surface = false;           ///< `point` is on one, whose patch is `patch` when it was known
        float level = 0.0f;
        SurfacePoint point;
    };

    /// What is worth rays of its own.
    struct Bright {
        vec3 place;
        float radius, share;
    };
    /// What sky is seen through.
    struct Opening {
        vec3 place;
        float radius;
    };

    /// One ray of a job.
    struct Probe {
        const Job* job;
        bool guided;
        std::uint32_t number;
        Met met;
    };

    void measure_world();
    void trace(std::vector<Probe>& rays);
    void forget(std::span<const Bounds> boxes);
    /// Of light, of some lights, that comes through a box. Returns whether there was any.
    bool forget_shadows(Patch& patch, vec3 middle, const Bounds& box, std::span<const std::uint32_t> lights) const;
    bool passes(const GatherPoint& point, const Link& link, const Bounds& box) const;
    Met by_chance(const Job& job, std::uint32_t number, const GuideCones& guide) const;
    Met guided(const GatherPoint& from, std::uint32_t number, const GuideCones& guide) const;
    Met follow(const GatherPoint& from, const SurfacePoint& start, vec3 direction, const GuideCones& guide, bool sharp) const;
    Gathered gather(const GatherPoint& point, const std::vector<vec3>& light) const;
    /// Irradiance, at most, from a glowing ball within a distance of a place, lux.
    static float brings(const Emitters::Ball& ball, vec3 place, float within);
    /// Luminance that arrives along a link, lux.
    float brings(const Link& link) const;
    std::optional<Opening> opening_beside(const GatherPoint& point, const Link& link) const;
    /// Its surface is no longer there, or nothing sees it.
    void remove(std::uint32_t patch);
    /// Of those that are gone; one per patch, not 0: it stays.
    void bury_unlinked();
    void remove_from_lists();
    void remove_from_cell(std::uint32_t patch);
    std::uint32_t find(const SurfacePoint& point, float level, bool sharp) const;
    /// Of a cell's patches, from its first on, that whose light is most likely that of a point which none of them sees.
    std::uint32_t most_alike(const SurfacePoint& point, std::uint32_t first) const;
    std::uint32_t add(const SurfacePoint& point, float level, bool sharp);
    std::uint32_t place_for_one_more();
    bool belongs(const SurfacePoint& point, const Mark& mark) const;
    void spread_samples(Patch& patch, std::uint32_t strata) const;
    /// What rays from a light have found on a patch.
    struct Narrow {
        vec3 flux{0.0f};   ///< that it reflects, lumen
        vec3 place{0.0f};  ///< middle of the lit part
    };
    /// Whether a light may shine on so little of a patch that its samples would miss that.
    bool narrow(std::uint32_t light, const Patch& patch) const;
    Narrow light_narrowly(std::uint32_t light, const Patch& patch) const;
    /// Lights each `every`th sample; returns whether they disagree.
    bool light_samples(Patch& patch, std::size_t every) const;
    /// A first estimate, or all that it wants; returns whether it wants no more.
    bool light(std::uint32_t patch, bool all);
    template <class Most, class Irradiance>
    void forget_where(Most&& most, Irradiance&& irradiance);
    void wait(std::uint32_t patch);
    void set_radiosity(std::uint32_t patch);
    /// Irradiance straight from the sky, lux.
    vec3 from_sky(const GatherPoint& point) const;

    const TransportWorld& world_;
    float coarsest_ = 0.0f;  ///< level of the largest patches that others ask for whatever the distance
    std::deque<Patch> patches_;
    std::vector<Mark> marks_;
    std::vector<vec3> reflected_;  ///< per patch, radiosity, lux; what other patches gather: what glows has lit them already
    std::vector<vec3> seen_;       ///< the same with its own glow
    std::vector<vec4> places_;     ///< middle of the cell and side; side -1: gone. All that most of them are asked for after changes
    std::vector<Emitters::Ball> glowing_;
    std::unordered_map<FacetName, std::uint32_t> first_;  ///< of a cell
    std::vector<std::uint32_t> dark_;     ///< wait for their first direct light
    std::vector<std::uint32_t> waiting_;  ///< for direct light that is other than it was
    std::vector<Bounds> changes_;          ///< where surfaces have changed, as long as some links may not know of it
    std::uint32_t all_changes_ = 0;        ///< ever; the last of `changes_` is the last of them
    std::size_t mended_ = 0;               ///< patches before it know all of them
    std::vector<std::uint32_t> rough_;    ///< for more of their samples to be lit
    bool black_ = false;     ///< patches reflect nothing
    std::vector<std::uint32_t> ungrown_;  ///< patches without links of their own, the first found first
    std::vector<std::uint32_t> gone_;     ///< patches that links may still lead to
    std::vector<char> linked_;             ///< while patches are buried: which may be linked to; those that came since are not in it
    std::size_t looked_at_ = 0;             ///< then: patches whose links were
    std::vector<std::uint32_t> free_;     ///< places where patches were
};

}  // namespace sl
