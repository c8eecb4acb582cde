// SPDX-License-Identifier: MIT
#include "game/app/compare.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "tests/core/image_fixture.h"

namespace sl {
namespace {

using testing::HasSubstr;

Image filled(std::uint32_t width, std::uint32_t height, std::uint32_t channels, float value) {
    Image image(width, height, channels);
    std::ranges::fill(image.data, value);
    return image;
}

class Compare : public ImageTest {
  protected:
    CompareFlags flags;

    void SetUp() override {
        ImageTest::SetUp();
        flags.image = folder / "image.exr";
        flags.reference = folder / "reference.exr";
    }
    void write(const std::vector<ImageLayer>& image, const std::vector<ImageLayer>& reference) const {
        write_exr(flags.image, image);
        write_exr(flags.reference, reference);
    }
    std::string refusal() const {
        return error_of([this] { load_pair(flags); });
    }
    /// What the command prints on standard error, and whether it succeeded.
    std::pair<int, std::string> run() const {
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        const int code = run_compare(flags);
        testing::internal::GetCapturedStdout();
        return {code, testing::internal::GetCapturedStderr()};
    }
};

TEST_F(Compare, TakesIrradianceWhereBothHaveItAndColourOtherwise) {
    write({{"", filled(4, 3, 4, 1)}, {"irradiance", filled(4, 3, 3, 3)}},
          {{"", filled(4, 3, 4, 1)}, {"irradiance", filled(4, 3, 3, 2)}});
    EXPECT_EQ(load_pair(flags).layer, "irradiance");
    EXPECT_DOUBLE_EQ(compare(load_pair(flags), flags).errors.nrmse, 0.5);
    write({{"", filled(4, 3, 4, 1)}, {"irradiance", filled(4, 3, 3, 3)}}, {{"", filled(4, 3, 4, 1)}});
    EXPECT_EQ(load_pair(flags).layer, "");
    flags.layer = "";
    EXPECT_EQ(compare(load_pair(flags), flags).errors.nrmse, 0.0);
}

TEST_F(Compare, LayersOfTwoNamesAndGreyAgainstColour) {
    write({{"mine", filled(4, 3, 3, 1.5f)}}, {{"theirs", filled(4, 3, 1, 1)}});
    flags.layer = "mine";
    EXPECT_THAT(
        refusal(),
        HasSubstr("reference.exr: there is no layer mine; choose with --layer or --reference-layer from: theirs"));
    flags.reference_layer = "theirs";
    EXPECT_DOUBLE_EQ(compare(load_pair(flags), flags).errors.bias, 0.5);
}

TEST_F(Compare, BackgroundIsLeftOutWhereTheReferencesDepthIsZero) {
    Image depth = filled(4, 1, 1, 0.1f), other = depth, image = filled(4, 1, 3, 1);
    depth.data[3] = 0.0f;
    std::fill_n(image.pixel(3, 0), 3, 100.0f);
    write({{"", image}, {"depth", other}}, {{"", filled(4, 1, 3, 1)}, {"depth", depth}});
    EXPECT_EQ(compare(load_pair(flags), flags).errors.pixels, 3u);
    EXPECT_EQ(compare(load_pair(flags), flags).errors.nrmse, 0.0);
    EXPECT_EQ(compare(load_pair(flags), flags).flip.mean, 0.0);
    EXPECT_EQ(load_pair(flags).background_differs, 1u);
    write({{"", image}, {"depth", depth}}, {{"", filled(4, 1, 3, 1)}});
    EXPECT_EQ(compare(load_pair(flags), flags).errors.pixels, 3u);
    flags.no_mask = true;
    EXPECT_EQ(compare(load_pair(flags), flags).errors.pixels, 4u);
    EXPECT_GT(compare(load_pair(flags), flags).errors.nrmse, 1.0);
}

TEST_F(Compare, TellsTheReferencesOwnNoise) {
    // Halves of 0.9 and 1.1 around a mean of 1: the mean is known to a tenth.
    write({{"irradiance", filled(4, 3, 3, 1)}}, {{"irradiance", filled(4, 3, 3, 1)}, {"irradiance_half", filled(4, 3, 3, 1.1f)}});
    EXPECT_NEAR(load_pair(flags).reference_noise.value(), 0.1, 1e-6);
    write({{"irradiance", filled(4, 3, 3, 1)}}, {{"irradiance", filled(4, 3, 3, 1)}});
    EXPECT_FALSE(load_pair(flags).reference_noise.has_value());
}

TEST_F(Compare, ExposesSoThatTheReferencesMeanIsMidGrey) {
    write({{"", filled(4, 4, 3, 0)}}, {{"", filled(4, 4, 3, 500)}});
    // 500 / (1.2 · 2^EV) = 0.18.
    EXPECT_NEAR(compare(load_pair(flags), flags).ev100, std::log2(500 / 1.2 / 0.18), 1e-4);
    // Black against 18 % grey, L = 116 · 0.18^⅓ − 16 = 49.496: 0.95 · 49.496^0.7 / 16.5104.
    EXPECT_NEAR(compare(load_pair(flags), flags).flip.mean, 0.95 * std::pow(49.496, 0.7) / 16.5104, 1e-4);
    flags.ev100 = 1.0;
    EXPECT_EQ(compare(load_pair(flags), flags).ev100, 1.0);
    EXPECT_NEAR(compare(load_pair(flags), flags).flip.mean, 0.96738, 1e-4);  // cut at white
}

TEST_F(Compare, ABlackReferenceIsComparedToo) {
    write({{"", filled(2, 2, 3, 1)}}, {{"", filled(2, 2, 3, 0)}});
    const Comparison result = compare(load_pair(flags), flags);
    EXPECT_TRUE(std::isinf(result.errors.nrmse));
    EXPECT_TRUE(std::isfinite(result.flip.mean));
    EXPECT_EQ(result.ev100, 0.0);
}

TEST_F(Compare, PicturesAreDecoded) {
    flags.image = folder / "image.png";
    flags.reference = folder / "reference.png";
    write_png(flags.image, filled(4, 3, 4, 0.0f));
    write_png(flags.reference, filled(4, 3, 3, 1.0f));
    const Comparison result = compare(load_pair(flags), flags);
    EXPECT_NEAR(result.flip.mean, 0.96738, 1e-4);
    EXPECT_DOUBLE_EQ(result.errors.bias, -1.0);
    // 8 bits of 0.5 are 128, linear 0.21586.
    write_png(flags.image, filled(4, 3, 1, 0.5f));
    EXPECT_NEAR(compare(load_pair(flags), flags).errors.bias, 0.21586 - 1.0, 1e-5);
    flags.layer = "irradiance";
    EXPECT_THAT(refusal(), HasSubstr("for EXR files"));
    flags.layer.reset();
    flags.reference = folder / "reference.exr";
    EXPECT_THAT(refusal(), HasSubstr("two EXR files or two PNG files"));
}

TEST_F(Compare, RefusesWhatCannotBeCompared) {
    EXPECT_THAT(refusal(), HasSubstr("image.exr: cannot be read: there is no such file"));
    write({{"", filled(4, 3, 3, 1)}}, {{"", filled(3, 4, 3, 1)}});
    EXPECT_THAT(refusal(), HasSubstr("image.exr, layer '' (the unnamed one) has 4 x 3 pixels"));
    Image bad = filled(4, 3, 3, 1);
    bad.pixel(2, 1)[2] = std::numeric_limits<float>::quiet_NaN();
    write({{"", filled(4, 3, 3, 1)}}, {{"", bad}});
    EXPECT_THAT(refusal(), HasSubstr("reference.exr, layer '' (the unnamed one): 1 of 12 pixels hold infinity or no "
                                     "number, the first at column 2, row 1"));
    write({{"", filled(4, 3, 2, 1)}}, {{"", bad}});
    EXPECT_THAT(refusal(), HasSubstr("two channels are no colour"));
    flags.pixels_per_degree = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(run_compare(flags), Error);
}

TEST_F(Compare, LimitsDecideTheExitCodeAndAreNamed) {
    write({{"", filled(4, 3, 3, 0.9f)}}, {{"", filled(4, 3, 3, 1)}});
    EXPECT_EQ(run(), std::pair(0, std::string()));
    flags.max_nrmse = 0.11;
    flags.max_bias = 0.11;
    EXPECT_EQ(run(), std::pair(0, std::string()));
    flags.max_bias = 0.05;
    const auto [code, text] = run();
    EXPECT_EQ(code, 1);
    EXPECT_THAT(text, HasSubstr("bias 0.1 exceeds --max-bias 0.05 by 0.05"));
    EXPECT_THAT(text, testing::Not(HasSubstr("nrmse")));
}

TEST_F(Compare, WritesFiguresAndHeatMaps) {
    write({{"", filled(40, 30, 3, 1.1f)}}, {{"", filled(40, 30, 3, 1)}});
    flags.json = folder / "figures.json";
    flags.heat_map = folder / "heat.png";
    for (const char* heat : {"relative", "flip"}) {
        flags.heat = heat;
        EXPECT_EQ(run().first, 0);
        EXPECT_GT(read_png(flags.heat_map).height, 30u);
    }
    const auto json = nlohmann::json::parse(bytes_of(flags.json));
    EXPECT_NEAR(json.at("nrmse").get<double>(), 0.1, 1e-6);
    EXPECT_EQ(json.at("pixels"), 1200);
    for (const char* key : {"relmse", "p95", "bias", "flip", "ev100"}) EXPECT_TRUE(json.at(key).is_number()) << key;
}

}  // namespace
}  // namespace sl
