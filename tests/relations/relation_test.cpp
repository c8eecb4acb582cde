// SPDX-License-Identifier: MIT
#include "tests/relations/relation_test.h"

#include <cstdlib>

namespace sl {

namespace {

using Kind = RenderScene::Light::Kind;

// Eight scenes per relation and method keep the whole program at about a minute. RapidCheck reads its parameters
// once, when the first property runs; what the caller has set stays.
const bool parameters_given = std::getenv("RC_PARAMS") != nullptr;
const int parameters_set = setenv("RC_PARAMS", "seed=20260101 max_success=8", 0);
/// Facets gather for some tenths of a second for one picture, so they get fewer.
constexpr int scenes_of_facets = 3;

/// Uniform in steps of a hundredth, whatever RapidCheck's size; shrinks towards `low`.
rc::Gen<float> number(float low, float high) {
    const auto steps = rc::gen::inRange(static_cast<int>(low * 100.0f), static_cast<int>(high * 100.0f) + 1);
    return rc::gen::map(rc::gen::resize(rc::kNominalSize, steps), [](int step) { return static_cast<float>(step) * 0.01f; });
}

rc::Gen<vec3> triple(float low, float high) {
    return rc::gen::apply([](float x, float y, float z) { return vec3(x, y, z); }, number(low, high), number(low, high), number(low, high));
}

rc::Gen<ScenePlan::Thing> things(rc::Gen<Shape::Kind> kind) {
    using Thing = ScenePlan::Thing;
    // High enough not to cut the floor: what lies under it would be lit by nobody.
    const auto place = rc::gen::apply([](float x, float y, float z) { return vec3(x, y, z); }, number(-2.5f, 2.5f), number(1.5f, 2.0f), number(-2.5f, 2.5f));
    return rc::gen::build<Thing>(rc::gen::set(&Thing::kind, kind), rc::gen::set(&Thing::size, triple(0.6f, 1.6f)), rc::gen::set(&Thing::place, place),
                                 rc::gen::set(&Thing::turn, triple(0.0f, 3.1f)), rc::gen::set(&Thing::albedo, triple(0.05f, 0.95f)));
}

rc::Gen<ScenePlan::Lamp> lamps(rc::Gen<Kind> kind) {
    using Lamp = ScenePlan::Lamp;
    return rc::gen::build<Lamp>(rc::gen::set(&Lamp::kind, kind), rc::gen::set(&Lamp::azimuth, number(0.0f, 6.28f)), rc::gen::set(&Lamp::elevation, number(0.6f, 1.5f)),
                                rc::gen::set(&Lamp::height, number(3.5f, 5.0f)), rc::gen::set(&Lamp::intensity, triple(100.0f, 1000.0f)),
                                rc::gen::set(&Lamp::outer_cone, number(0.3f, 0.8f)));
}

/// One of `first`, and up to `more` of `rest`.
template <class T>
rc::Gen<std::vector<T>> one_and_more(const rc::Gen<T>& first, const rc::Gen<T>& rest, int more) {
    const auto count = rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, more + 1));
    const auto others = rc::gen::mapcat(count, [rest](int n) { return rc::gen::container<std::vector<T>>(static_cast<std::size_t>(n), rest); });
    return rc::gen::apply([](const T& one, std::vector<T> all) {
        all.insert(all.begin(), one);
        return all;
    }, first, others);
}

}  // namespace

rc::Gen<ScenePlan> scene_plans() {
    const auto any_shape = rc::gen::element(Shape::Kind::box, Shape::Kind::quad, Shape::Kind::sphere);
    const auto any_light = rc::gen::element(Kind::directional, Kind::spot, Kind::point);
    return rc::gen::build<ScenePlan>(
        rc::gen::set(&ScenePlan::things, one_and_more(things(rc::gen::just(Shape::Kind::box)), things(any_shape), 5)),
        rc::gen::set(&ScenePlan::floor_albedo, triple(0.05f, 0.95f)),
        rc::gen::set(&ScenePlan::lamps, one_and_more(lamps(rc::gen::element(Kind::directional, Kind::spot)), lamps(any_light), 2)),
        rc::gen::set(&ScenePlan::eye_azimuth, number(0.0f, 6.28f)), rc::gen::set(&ScenePlan::eye_elevation, number(0.3f, 1.3f)),
        rc::gen::set(&ScenePlan::eye_distance, number(4.0f, 7.0f)));
}

ResultTable& relation_table() {
    static auto* table = static_cast<ResultTable*>(testing::AddGlobalTestEnvironment(new ResultTable(
        "relations", SL_DOCS_FOLDER "/gi.md", "relation", {"rsm_exact", "rsm_grid", "rsm_disc", "facets", "path_tracer"},
        {"twice the light, twice the picture", "light A + light B = sum of the two pictures", "permuted channels, permuted picture",
         "the same frame twice, the same bytes", "an unseen entity added", "an entity added outside of all maps",
         "an unlit, unseen entity that makes the scene larger", "moved by 24 m", "moved by 1 km, as far as relative coordinates go",
         "turned by 90° about the vertical", "turned by any angle", "mirrored", "scaled by 2⁻¹⁰ to 2¹⁰", "scaled by 10⁻³ to 10³"})));
    return *table;
}
// GoogleTest wants its environments before it runs.
static const ResultTable& registered = relation_table();

/// Many relations ask for the same unchanged scenes.
static std::optional<std::string> name_of_unchanged(const ScenePlan& plan, const SceneChange& change) {
    if (change.place != mat4(1.0f) || change.scale != 1.0f || change.light != 1.0f || change.channels != uvec3(0, 1, 2)) return std::nullopt;
    std::ostringstream name;
    showValue(plan, name);
    return name.str();
}

void Relations::for_plans(const std::function<void(const ScenePlan&)>& property) const {
    int scenes = 0;
    rc::detail::checkGTest([&] {
        const ScenePlan plan = *scene_plans().as("scene");
        if (!method().facets() || parameters_given || ++scenes <= scenes_of_facets) property(plan);
    });
}

Picture Relations::draw(const ScenePlan& plan, const SceneChange& change, const LightMethod& with) {
    SceneBuilder builder;
    build(plan, change, builder);
    // Facets use what they have learned of the scene before, and that is another picture of it.
    if (with.facets()) renderer->forget();
    const Picture picture = picture_of(with, builder.scene(), *renderer, size);
    RC_ASSERT(insane_pixel(picture) == "");
    return picture;
}

const Picture& Relations::draw_once(const ScenePlan& plan, bool fine) {
    static std::map<std::tuple<std::string, std::string, bool>, Picture> known;
    const auto [entry, fresh] = known.try_emplace({method().name, *name_of_unchanged(plan, {}), fine});
    if (fresh) entry->second = draw(plan, {}, fine ? finer(64) : method());
    return entry->second;
}

TracedMean Relations::trace(const ScenePlan& plan, const SceneChange& change, std::uint32_t samples) const {
    static std::map<std::pair<std::string, std::uint32_t>, TracedMean> known;
    const auto name = name_of_unchanged(plan, change);
    if (const auto found = name ? known.find({*name, samples}) : known.end(); found != known.end()) return found->second;
    SceneBuilder builder;
    build(plan, change, builder);
    glm::dvec3 sum(0.0), squares(0.0);
    for (std::uint32_t seed = 1; seed <= TracedMean::seeds; ++seed) {
        LightMethod with = method();
        with.transport.seed = seed;
        with.transport.light_paths = true;
        with.samples = samples;
        const glm::dvec3 mean = traced_picture(with, builder.scene(), size).mean();
        sum += mean;
        squares += mean * mean;
    }
    constexpr double n = TracedMean::seeds;
    const glm::dvec3 variance = glm::max(squares / n - sum * sum / (n * n), glm::dvec3(0.0)) * (n / (n - 1.0));
    const TracedMean result{.mean = sum / n, .error = glm::sqrt(variance / n)};
    if (name) known.emplace(std::pair(*name, samples), result);
    return result;
}

LightMethod Relations::quick() const {
    LightMethod result = method();
    if (auto* facets = result.facets() ? result.gi->get_if<Facets>() : nullptr) facets->noise = 0.3f;
    return result;
}

LightMethod Relations::finer(std::uint32_t rsm_size) const {
    LightMethod result = method();
    if (auto* exact = result.traced() ? nullptr : result.gi->get_if<RsmExact>()) exact->rsm_size = rsm_size;
    if (auto* disc = result.traced() ? nullptr : result.gi->get_if<RsmDisc>()) *disc = RsmDisc{.rsm_size = rsm_size, .samples = 4096, .radius = 1.5f, .interpolate = false};
    if (auto* facets = result.facets() ? result.gi->get_if<Facets>() : nullptr) facets->spacing = 4.0f;
    return result;
}

void Relations::expect_within(const std::string& relation, double measured, double bound) const {
    relation_table().worst(relation, method().name, measured);
    if (measured > bound) RC_FAIL(fmt::format("{}: {} deviates by {:.3g}, more than {:.3g}", relation, method().name, measured, bound));
}

void Relations::expect_facets_agree(const std::string& relation, const Picture& a, const Picture& b, double most) {
    const Deviation found = deviation(a, b);
    expect_within(relation, found.inner, most);
    if (std::abs(found.mean) > 0.5 * most) RC_FAIL(fmt::format("{}: facets are {:+.3g} brighter", relation, found.mean));
}

void Relations::expect_within_noise(const std::string& relation, const TracedMean& a, const TracedMean& b) const {
    // With 7 + 7 degrees of freedom chance exceeds 6 standard errors once in 30,000 comparisons.
    // That holds for bell-shaped means. With 96 paths a pixel it did not: where things touch, all seeds missed rare bright
    // paths and agreed on 2 % too little.
    constexpr double most_errors = 6.0;
    for (int c = 0; c < 3; ++c) {
        const double noise = std::hypot(a.error[c], b.error[c]), difference = std::abs(a.mean[c] - b.mean[c]);
        if (b.mean[c] <= 0.0) continue;
        relation_table().worst(relation, method().name, noise / b.mean[c], "noise of ");
        // Noise would excuse anything if there were enough of it. Measured: 1.3 % at most.
        if (noise > 0.03 * b.mean[c]) RC_FAIL(fmt::format("{}: noise of {:.3g} is too much to compare means", relation, noise / b.mean[c]));
        // Equal points give equal means up to rounding, and then there is no noise.
        if (difference > most_errors * noise + 1e-5 * b.mean[c]) {
            RC_FAIL(fmt::format("{}: means {} and {} differ by {:.1f} standard errors", relation, a.mean[c], b.mean[c], difference / noise));
        }
    }
}

void Relations::expect_same_brightness(const std::string& relation, const std::vector<double>& changes) const {
    // All pixels of rsm_disc share one pattern, so that a whole picture is brighter or darker by chance; a wrong weight
    // would make every picture brighter. So the average over all scenes is tested against its own standard error.
    double sum = 0.0, squares = 0.0;
    for (const double change : changes) {
        sum += change;
        squares += change * change;
    }
    const auto n = static_cast<double>(changes.size());
    const double mean = sum / n, error = std::sqrt(std::max(squares / n - mean * mean, 0.0) / (n - 1.0));
    relation_table().say(relation, method().name, fmt::format("{:+.1f} ± {:.1f} %", 100.0 * mean, 100.0 * error));
    EXPECT_LT(std::abs(mean), 4.0 * error + 0.005) << relation;
}

static std::vector<LightMethod> repeatable_methods() {
    std::vector<LightMethod> methods = small_methods();
    for (LightMethod& method : methods) method.transport.light_paths = false;
    return methods;
}

INSTANTIATE_TEST_SUITE_P(All, Relations, testing::ValuesIn(repeatable_methods()), method_name_of);

}  // namespace sl
