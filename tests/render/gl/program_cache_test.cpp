// SPDX-License-Identifier: MIT
#include "engine/render/gl/program.h"
#include "tests/render/gl/gl_fixture.h"

namespace sl::gl {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Key;
using testing::Not;
using testing::StartsWith;

class ProgramCacheTest : public GlTest {
  protected:
    TempFolder folder;
    ProgramCache cache{folder.path()};

    static ProgramDesc pass() { return {"", "", "passes/a.comp", {}}; }
    /// A program whose only storage block is called as given, so that a test sees which version is in use.
    void write_pass(const std::string& block) {
        folder.write("passes/a.comp",
                     "#include \"lib/x.glsl\"\nlayout(local_size_x = 1) in;\nlayout(std430) buffer " + block +
                         " { float value; };\nvoid main() { value = x(); }\n");
    }
    void write_library(const std::string& expression) {
        folder.write("lib/x.glsl", "// lib\nfloat x() {\n    return " + expression + ";\n}\n");
    }
    void SetUp() override {
        GlTest::SetUp();
        write_pass("First");
        write_library("1.0");
    }
    void TearDown() override {
        cache = ProgramCache(folder.path());
        GlTest::TearDown();
    }
};
SL_ON_BOTH_CONTEXTS(ProgramCacheTest);

TEST_P(ProgramCacheTest, ErrorsNameFileAndLine) {
    folder.write("passes/a.comp", "layout(local_size_x = 1) in;\n\nvoid main() {\n    oh = 1;\n}\n");
    EXPECT_THAT(error_of([&] { cache.get(pass()); }), StartsWith("passes/a.comp:4: error: "));
}

TEST_P(ProgramCacheTest, ErrorsNameIncludedFileAndLine) {
    write_library("nothing");
    EXPECT_THAT(error_of([&] { cache.get(pass()); }), StartsWith("lib/x.glsl:3: error: "));
    folder.write("passes/a.comp",
                 "#include \"lib/x.glsl\"\nlayout(local_size_x = 1) in;\nvoid main() { oh; }\n");
    write_library("1.0");
    EXPECT_THAT(error_of([&] { cache.get(pass()); }), StartsWith("passes/a.comp:3: error: "));
}

TEST_P(ProgramCacheTest, FirstErrorsAreListedWarningsLast) {
    std::string text = "layout(local_size_x = 1) in;\nvoid main() {\n    int unset; int y = unset;\n";
    for (int i = 0; i < 9; ++i) text += fmt::format("    oh{} = 1;\n", i);
    folder.write("passes/a.comp", text + "}\n");
    const std::string error = error_of([&] { cache.get(pass()); });
    EXPECT_THAT(error, AllOf(StartsWith("passes/a.comp:4: error: "), HasSubstr("passes/a.comp:5: error: ")));
    EXPECT_THAT(error, Not(HasSubstr("passes/a.comp:9")));
    EXPECT_THAT(error, Not(HasSubstr("warning")));
}

TEST_P(ProgramCacheTest, LinkErrorsNameTheProgram) {
    folder.write("a.vert", "out vec2 uv;\nvoid main() { uv = vec2(0); gl_Position = vec4(0); }\n");
    folder.write("a.frag", "in vec4 uv;\nout vec4 colour;\nvoid main() { colour = uv; }\n");
    EXPECT_THAT(error_of([&] {
                    cache.get({"a.vert", "a.frag", "", {}});
                }),
                StartsWith("a.frag: does not link: "));
}

TEST_P(ProgramCacheTest, BuildsOnceAndKeepsTheReference) {
    const Program& first = cache.get(pass());
    for (int i = 0; i < 20; ++i) cache.get({"", "", "passes/a.comp", {{"N", std::to_string(i)}}});
    EXPECT_EQ(&cache.get(pass()), &first);
    EXPECT_FALSE(cache.reload_changed());
    EXPECT_EQ(&cache.get(pass()), &first);
}

TEST_P(ProgramCacheTest, ReloadsAChangedFile) {
    EXPECT_THAT(cache.get(pass()).storage_blocks(), ElementsAre(Key("First")));
    write_pass("Second");
    EXPECT_TRUE(cache.reload_changed());
    EXPECT_THAT(cache.get(pass()).storage_blocks(), ElementsAre(Key("Second")));
    EXPECT_FALSE(cache.reload_changed());
}

TEST_P(ProgramCacheTest, TouchingAFileBuildsNothing) {
    const Program& program = cache.get(pass());
    std::filesystem::last_write_time(folder.path() / "lib/x.glsl",
                                     std::filesystem::file_time_type::clock::now());
    EXPECT_FALSE(cache.reload_changed());
    EXPECT_EQ(&cache.get(pass()), &program);
}

TEST_P(ProgramCacheTest, BrokenIncludeKeepsTheLastGoodProgram) {
    const Program& good = cache.get(pass());
    write_library("broken");
    EXPECT_TRUE(cache.reload_changed());
    EXPECT_EQ(&cache.get(pass()), &good);
    EXPECT_THAT(cache.errors(), ElementsAre(StartsWith("lib/x.glsl:3: error: ")));
    EXPECT_FALSE(cache.reload_changed());
    EXPECT_THAT(cache.errors(), ElementsAre(StartsWith("lib/x.glsl:3: error: ")));

    write_library("2.0");
    EXPECT_TRUE(cache.reload_changed());
    EXPECT_THAT(cache.errors(), IsEmpty());
    EXPECT_FALSE(cache.reload_changed());
}

TEST_P(ProgramCacheTest, OneBrokenFileOfManyProgramsIsOneError) {
    cache.get(pass());
    cache.get({"", "", "passes/a.comp", {{"N", "1"}}});
    write_library("broken");
    EXPECT_TRUE(cache.reload_changed());
    EXPECT_EQ(cache.errors().size(), 1u);
}

TEST_P(ProgramCacheTest, VanishedFileComesBack) {
    const auto long_ago = std::filesystem::file_time_type::clock::now() - std::chrono::hours(1);
    std::filesystem::last_write_time(folder.path() / "passes/a.comp", long_ago);
    const Program& good = cache.get(pass());
    std::filesystem::remove(folder.path() / "lib/x.glsl");
    EXPECT_TRUE(cache.reload_changed());
    EXPECT_EQ(&cache.get(pass()), &good);
    EXPECT_THAT(cache.errors(), ElementsAre(StartsWith("passes/a.comp:1: there is no \"lib/x.glsl\"")));
    EXPECT_FALSE(cache.reload_changed());
    write_library("1.0");
    EXPECT_TRUE(cache.reload_changed());
    EXPECT_THAT(cache.errors(), IsEmpty());
}

TEST_P(ProgramCacheTest, NewIncludeMayBeWrittenLater) {
    cache.get(pass());
    folder.write("passes/a.comp",
                 "#include \"lib/new.glsl\"\nlayout(local_size_x = 1) in;\n"
                 "layout(std430) buffer New { float value; };\nvoid main() { value = y; }\n");
    EXPECT_TRUE(cache.reload_changed());
    EXPECT_FALSE(cache.errors().empty());
    folder.write("lib/new.glsl", "const float y = 3.0;\n");
    EXPECT_TRUE(cache.reload_changed());
    EXPECT_THAT(cache.errors(), IsEmpty());
    EXPECT_THAT(cache.get(pass()).storage_blocks(), ElementsAre(Key("New")));
}

TEST_P(ProgramCacheTest, MixedUpDescriptionStops) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_DEATH(cache.get({"a.vert", "", "a.comp", {}}), "a program is compute alone");
    EXPECT_DEATH(cache.get({}), "a program is compute alone");
}

}  // namespace
}  // namespace sl::gl
