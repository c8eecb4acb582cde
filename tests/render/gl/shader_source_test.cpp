// SPDX-License-Identifier: MIT
#include "engine/render/gl/program.h"
#include "tests/render/gl/gl_fixture.h"

namespace sl::gl {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class ShaderSourceTest : public testing::Test {
  protected:
    TempFolder folder;
    ShaderSource load(const std::string& file) { return load_shader_source({folder.path()}, file, {}); }
    std::string error(const std::string& file) {
        return error_of([&] { load(file); });
    }
};

TEST_F(ShaderSourceTest, StartsWithVersionAndDefines) {
    folder.write("a.comp", "void main() {}\n");
    EXPECT_EQ(load_shader_source({folder.path()}, "a.comp", {{"FAST", "1"}, {"EMPTY", ""}}).text,
              "#version 450 core\n#define FAST 1\n#define EMPTY \n#line 1 0\nvoid main() {}\n");
}

TEST_F(ShaderSourceTest, IncludesOnceAndCountsLines) {
    folder.write("passes/a.frag", "first\n#include \"shared/x.h\"\n  # include \"lib/./x.glsl\"\nlast");
    folder.write("shared/x.h", "#pragma once\nx\n");
    folder.write("lib/x.glsl", "#include \"shared/x.h\"\r\nlib\r\n");
    const ShaderSource source = load("passes/a.frag");
    EXPECT_THAT(source.files, ElementsAre("passes/a.frag", "shared/x.h", "lib/x.glsl"));
    EXPECT_EQ(source.text,
              "#version 450 core\n#line 1 0\nfirst\n"
              "#line 100001 1\n\nx\n#line 3 0\n"
              "#line 200001 2\n#line 200002 2\nlib\r\n#line 4 0\n"
              "last\n");
}

TEST_F(ShaderSourceTest, CyclesAreHarmless) {
    folder.write("a.glsl", "#include \"b.glsl\"\na\n");
    folder.write("b.glsl", "#include \"a.glsl\"\n#include \"b.glsl\"\nb\n");
    EXPECT_THAT(load("a.glsl").files, ElementsAre("a.glsl", "b.glsl"));
}

TEST_F(ShaderSourceTest, SkipsWhatIsForCppAlone) {
    folder.write("a.h",
                 "#ifdef __cplusplus\n#include \"engine/core/math.h\"\n#include <vector>\n#if 1\n"
                 "#include \"engine/core/check.h\"\n#endif\n#else\n#include \"glsl.h\"\n#endif\n"
                 "#ifndef __cplusplus\n#include \"only.h\"\n#else\n#include \"no.h\"\n#endif\n"
                 "#if defined(__cplusplus)\n#include \"no.h\"\n#endif\n"
                 "#if !defined(__cplusplus)\n#include \"third.h\"\n#endif\n");
    folder.write("glsl.h", "");
    folder.write("only.h", "");
    folder.write("third.h", "");
    EXPECT_THAT(load("a.h").files, ElementsAre("a.h", "glsl.h", "only.h", "third.h"));
    EXPECT_THAT(load("a.h").text, Not(HasSubstr("#include")));
}

TEST_F(ShaderSourceTest, SkipsComments) {
    folder.write("a.frag", "// #include \"no\"\n/* x\n#include \"no\"\n*/ y // /*\n#include \"b\"\n");
    folder.write("b", "");
    EXPECT_THAT(load("a.frag").files, ElementsAre("a.frag", "b"));
}

TEST_F(ShaderSourceTest, MissingFilesAreNamedWithTheLineThatAsks) {
    folder.write("passes/a.frag", "\n\n#include \"shared/none.h\"\n");
    EXPECT_THAT(error("passes/a.frag"), StartsWith("passes/a.frag:3: there is no \"shared/none.h\""));
    EXPECT_THAT(error("none.frag"), StartsWith("there is no \"none.frag\""));
    EXPECT_THAT(error_of([] { load_shader_source({"/nowhere/at/all"}, "a", {}); }),
                HasSubstr("/nowhere/at/all"));
    folder.write("b.frag", "#include \"passes\"\n");
    EXPECT_THAT(error("b.frag"), StartsWith("b.frag:1: there is no \"passes\""));
    folder.write("c.frag", "#include \"\"\n");
    EXPECT_THAT(error("c.frag"), StartsWith("c.frag:1: there is no \"\""));
}

TEST_F(ShaderSourceTest, NothingLeavesTheFolder) {
    const fs::path outside = folder.path().parent_path() / (folder.path().filename().string() + "_outside.h");
    std::ofstream(outside) << "secret\n";
    fs::create_symlink(outside, folder.path() / "link.h");
    fs::create_directory_symlink(folder.path().parent_path(), folder.path() / "up");
    const std::string name = outside.filename().string();
    for (const std::string& path : {"../" + name, outside.string(), std::string("link.h"), "up/" + name,
                                    "lib/../../" + name, std::string("../none"), std::string("/none")}) {
        folder.write("a.frag", "x\n#include \"" + path + "\"\n");
        EXPECT_EQ(error("a.frag"), "a.frag:2: \"" + path + "\" leaves the shader folder");
        EXPECT_EQ(error(path), "\"" + path + "\" leaves the shader folder");
    }
    fs::remove(outside);
}

TEST_F(ShaderSourceTest, LaterFoldersAddToTheFirst) {
    folder.write("engine/lib/x.glsl", "engine\n");
    folder.write("own/lib/x.glsl", "hidden\n");
    folder.write("own/own.frag", "#include \"lib/x.glsl\"\n#include \"own.glsl\"\n");
    folder.write("own/own.glsl", "own\n");
    const ShaderFolders both{folder.path() / "engine", folder.path() / "own"};
    const ShaderSource source = load_shader_source(both, "own.frag", {});
    EXPECT_THAT(source.files, ElementsAre("own.frag", "lib/x.glsl", "own.glsl"));
    EXPECT_THAT(source.text, AllOf(HasSubstr("engine\n"), HasSubstr("own\n"), Not(HasSubstr("hidden"))));
    EXPECT_EQ(error_of([&] { load_shader_source(both, "none.frag", {}); }),
              fmt::format("there is no \"none.frag\" in the shader folder {} or {}", both[0].string(), both[1].string()));
}

TEST_F(ShaderSourceTest, LinksInsideTheFolderAreTheSameFile) {
    folder.write("a.frag", "#include \"lib/x.glsl\"\n#include \"alias.glsl\"\n");
    folder.write("lib/x.glsl", "x\n");
    fs::create_symlink("lib/x.glsl", folder.path() / "alias.glsl");
    EXPECT_THAT(load("a.frag").files, ElementsAre("a.frag", "lib/x.glsl"));
}

TEST_F(ShaderSourceTest, BadDirectivesAreErrorsWithALine) {
    folder.write("a.frag", "#version 450\n");
    EXPECT_THAT(error("a.frag"), StartsWith("a.frag:1: remove #version"));
    folder.write("b.frag", "\n#include <x>\n");
    EXPECT_EQ(error("b.frag"), "b.frag:2: write #include \"path\"");
    folder.write("c.frag", "#include \"x\n");
    EXPECT_EQ(error("c.frag"), "c.frag:1: write #include \"path\"");
    folder.write("d.frag", "#include");
    EXPECT_EQ(error("d.frag"), "d.frag:1: write #include \"path\"");
}

TEST_F(ShaderSourceTest, NestingHasABound) {
    for (int i = 0; i < 40; ++i) {
        folder.write(fmt::format("{}.h", i), fmt::format("#include \"{}.h\"\n", i + 1));
    }
    folder.write("40.h", "");
    EXPECT_THAT(error("0.h"), StartsWith("32.h:1: includes nest deeper than 32"));
    EXPECT_EQ(load("8.h").files.size(), 33u);
}

TEST_F(ShaderSourceTest, LogsNameFiles) {
    const ShaderSource source{"", {"passes/rsm.frag", "shared/x.h"}};
    EXPECT_EQ(name_files_in_log("0:14(3): error: oh\n1:2(1): warning: hm\n", source),
              "passes/rsm.frag:14: error: oh\nshared/x.h:2: warning: hm\n");
    EXPECT_EQ(name_files_in_log("1(14) : error C1008: undefined variable \"x\"", source),
              "shared/x.h:14: error C1008: undefined variable \"x\"\n");
    // The line carries the file where the driver lost it.
    EXPECT_EQ(name_files_in_log("0:100007(1): error: oh\n1(100008) : warning: hm\n", source),
              "shared/x.h:7: error: oh\nshared/x.h:8: warning: hm\n");
    EXPECT_EQ(name_files_in_log("7:14(3): error: oh\n99999999999:1(1): x\nlink 0:1(1): y", source),
              "7:14(3): error: oh\n99999999999:1(1): x\nlink 0:1(1): y\n");
}

}  // namespace
}  // namespace sl::gl
