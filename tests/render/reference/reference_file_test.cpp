// SPDX-License-Identifier: MIT
#include "engine/render/reference/reference_file.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/render/reference/reference.h"
#include "tests/support/scene_builder.h"

namespace sl {
namespace {

constexpr uvec2 size{7, 5};

class ReferenceFileTest : public testing::Test {
  protected:
    std::filesystem::path folder_ = std::filesystem::temp_directory_path() / fmt::format("secondlight_reference_{}", getpid());
    SceneBuilder builder_;

    ReferenceFileTest() {
        std::filesystem::create_directories(folder_);
        builder_.add({Shape::Kind::box, vec3(1)}, mat4(1.0f), vec3(0.3f, 0.6f, 0.9f));
        builder_.scene().sky_radiance = vec3(0.1f, 0.2f, 0.3f);
        builder_.look(vec3(1.2f, 1, 2), vec3(-1.2f, -1, -2), vec3(0, 1, 0), 0.7f);
    }
    ~ReferenceFileTest() override { std::filesystem::remove_all(folder_); }

    ReferenceInfo info(const PathTracer& tracer, const TransportSettings& settings = {}) const {
        return {.scene = "box", .content = tracer.content_hash(), .size = size, .transport = settings};
    }
    std::string error_of(const std::filesystem::path& path) const {
        try {
            (void)read_reference(path);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }
};

TEST_F(ReferenceFileTest, ContinuesAsIfItHadNeverStopped) {
    const PathTracer tracer(builder_.scene(), size, {});
    Film film(size);
    trace_reference(tracer, film, {.block = {.high = size, .last = 12}}, {});
    write_reference(folder_ / "a.exr", info(tracer), film);
    ReferenceFile read = read_reference(folder_ / "a.exr");
    EXPECT_EQ(read.film.blocks(), film.blocks());
    trace_reference(tracer, read.film, {.block = {.high = size, .last = 40}}, {});
    const auto whole = trace_film(builder_.scene(), size, {}, 40).layers(), continued = read.film.layers();
    for (std::size_t i = 0; i < whole.size(); ++i) {
        if (whole[i].name == "irradiance_error") continue;  // a difference of sums, which shows what 48 bits round
        EXPECT_EQ(whole[i].image.data, continued[i].image.data) << whole[i].name;
    }
}

TEST_F(ReferenceFileTest, TellsWhatDiffers) {
    const PathTracer tracer(builder_.scene(), size, {});
    const ReferenceInfo one = info(tracer);
    ReferenceInfo other = one;
    EXPECT_NO_THROW(ReferenceInfo::check_same(one, "a", other, "b"));
    other.transport.bounces = 1;
    EXPECT_THROW(ReferenceInfo::check_same(one, "a", other, "b"), Error);
    builder_.scene().sky_radiance = vec3(1);
    EXPECT_NE(PathTracer(builder_.scene(), size, {}).content_hash(), one.content) << "another sky is another picture";
}

TEST_F(ReferenceFileTest, RefusesOtherFiles) {
    write_exr(folder_ / "plain.exr", {{"", Image(2, 2, 3)}});
    EXPECT_THAT(error_of(folder_ / "plain.exr"), testing::HasSubstr("not written by"));
    write_exr(folder_ / "note.exr", {{"", Image(2, 2, 3)}}, "{}");
    EXPECT_THAT(error_of(folder_ / "note.exr"), testing::HasSubstr("damaged"));
    EXPECT_THAT(error_of(folder_ / "none.exr"), testing::HasSubstr("no such file"));
    const PathTracer tracer(builder_.scene(), size, {});
    write_reference(folder_ / "a.exr", info(tracer), Film(size));
    write_exr(folder_ / "lacks.exr", {{"", Image(7, 5, 3)}}, read_exr_note(folder_ / "a.exr"));
    EXPECT_THAT(error_of(folder_ / "lacks.exr"), testing::HasSubstr("lacks the layer"));
}

TEST_F(ReferenceFileTest, RefusesNumbersThatCannotBe) {
    const PathTracer tracer(builder_.scene(), size, {});
    Film film(size);
    film.add_block({.high = size, .last = 4});
    write_reference(folder_ / "a.exr", info(tracer), film);
    const std::vector<ImageLayer> layers = read_exr(folder_ / "a.exr");
    for (const auto& [key, value] : {std::pair{"seed", "1e30"}, {"size", "[-7, 5]"}, {"bounces", "4294967296"}, {"blocks", "[[0, 0, 7, 6, 0, 4]]"}, {"blocks", "[[0, 0, 7, 5, 4, 4]]"}}) {
        auto note = nlohmann::json::parse(read_exr_note(folder_ / "a.exr"));
        note[key] = nlohmann::json::parse(value);
        write_exr(folder_ / "b.exr", layers, note.dump());
        EXPECT_THAT(error_of(folder_ / "b.exr"), testing::HasSubstr("b.exr: its description is damaged")) << key;
    }
}

}  // namespace
}  // namespace sl
