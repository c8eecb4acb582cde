// SPDX-License-Identifier: MIT
// Pictures that must not change by accident, at 160×90. On a difference, NAME.new.png, NAME.old.png and NAME.difference.png
// are written into build/…/golden; ./check --accept takes the new ones as right.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "engine/ecs/query.h"
#include "engine/render/capture.h"
#include "engine/render/gl/context.h"
#include "game/session.h"

namespace sl {
namespace {

/// Mean absolute difference, and the share of pixels off by more than 8 grey levels: other processors and versions of
/// Mesa round differently along edges, a wrong light changes whole surfaces.
constexpr double mean_tolerance = 1.0 / 255, off_tolerance = 0.01;

struct Shot {
    std::string name, scene, gi, show;
};

std::ostream& operator<<(std::ostream& out, const Shot& shot) { return out << shot.name; }

class Golden : public testing::TestWithParam<Shot> {};

TEST_P(Golden, LooksAsBefore) {
    const Shot& shot = GetParam();
    auto context = gl::create_context(gl::ContextKind::egl);
    Image picture;
    {
        Renderer renderer(shader_folder());
        App app = open_scene({.scene = shot.scene, .gi = shot.gi});
        for (auto [entity, gi] : Query<GiSettings>(app.world)) {
            if (auto* exact = gi.method.get_if<RsmExact>()) exact->rsm_size = 96;
        }
        picture = capture(app, renderer, {.width = 160, .height = 90, .show = shot.show}).picture;
    }
    EXPECT_TRUE(context->errors().empty());

    const std::filesystem::path golden = std::filesystem::path(SL_GOLDEN_FOLDER) / (shot.name + ".png");
    if (std::getenv("SECONDLIGHT_ACCEPT") != nullptr) {
        write_png(golden, picture);
        return;
    }
    ASSERT_TRUE(std::filesystem::exists(golden)) << golden << " is missing; make it with ./check --accept and look at it";
    const Image old = read_png(golden);
    ASSERT_EQ(old.width, picture.width);
    ASSERT_EQ(old.height, picture.height);
    Image difference(old.width, old.height, 3);
    double sum = 0.0, off = 0.0;
    for (std::size_t i = 0; i < std::size_t{old.width} * old.height; ++i) {
        float largest = 0.0f;
        for (std::size_t c = 0; c < 3; ++c) {
            const float d = std::abs(picture.data[i * 3 + c] - old.data[i * old.channels + c]);
            difference.data[i * 3 + c] = std::min(4.0f * d, 1.0f);
            largest = std::max(largest, d);
            sum += d;
        }
        off += largest > 8.0f / 255 ? 1.0 : 0.0;
    }
    const double pixels = double(old.width) * old.height;
    const bool same = sum / (3.0 * pixels) <= mean_tolerance && off / pixels <= off_tolerance;
    if (!same) {
        const std::filesystem::path folder = std::filesystem::current_path() / "golden";
        std::filesystem::create_directories(folder);
        write_png(folder / (shot.name + ".new.png"), picture);
        write_png(folder / (shot.name + ".old.png"), old);
        write_png(folder / (shot.name + ".difference.png"), difference);
        ADD_FAILURE() << shot.name << ": mean difference " << sum / (3.0 * pixels) * 255 << " grey levels, " << 100.0 * off / pixels
                      << " % of the pixels off by more than 8; see " << (folder / (shot.name + ".difference.png"));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Pictures, Golden,
    testing::Values(Shot{"outdoor_off", "outdoor", "off", ""}, Shot{"outdoor_disc", "outdoor", "rsm_disc", ""},
                    Shot{"outdoor_grid", "outdoor", "rsm_grid", ""}, Shot{"indoor_off", "indoor", "off", ""},
                    Shot{"indoor_exact", "indoor", "rsm_exact", ""}, Shot{"indoor_disc", "indoor", "rsm_disc", ""},
                    Shot{"indoor_grid_artefact", "indoor", "rsm_grid:paper-artefact", ""},
                    Shot{"cornell_exact", "cornell", "rsm_exact", ""}, Shot{"cornell_irradiance", "cornell", "rsm_exact", "irradiance"},
                    Shot{"cornell_normal", "cornell", "off", "normal"}, Shot{"plates_irradiance", "plates", "rsm_exact", "irradiance"},
                    Shot{"outdoor_rsm_flux", "outdoor", "rsm_disc", "rsm_flux"}, Shot{"empty", "empty", "rsm_disc", ""}),
    [](const auto& shot) { return shot.param.name; });

}  // namespace
}  // namespace sl
