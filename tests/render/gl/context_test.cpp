// SPDX-License-Identifier: MIT
#include "engine/render/gl/context.h"

#include <cstdlib>

#include "tests/render/gl/gl_fixture.h"

namespace sl::gl {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class ContextTest : public GlTest {};
SL_ON_BOTH_CONTEXTS(ContextTest);

TEST_P(ContextTest, Gives45Core) {
    GLint major = 0, minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    EXPECT_GE(10 * major + minor, 45);
    EXPECT_EQ(context().kind(), GetParam());
    EXPECT_FALSE(context().renderer().empty());
    EXPECT_FALSE(context().vendor().empty());
    EXPECT_FALSE(context().version().empty());
    RecordProperty("renderer", context().renderer());
    RecordProperty("version", context().version());
}

TEST_P(ContextTest, StartsInTheStateThatPassesRelyOn) {
    GLint origin = 0, depth = 0, pack = 0, unpack = 0;
    glGetIntegerv(GL_CLIP_ORIGIN, &origin);
    glGetIntegerv(GL_CLIP_DEPTH_MODE, &depth);
    glGetIntegerv(GL_PACK_ALIGNMENT, &pack);
    glGetIntegerv(GL_UNPACK_ALIGNMENT, &unpack);
    EXPECT_EQ(origin, GL_LOWER_LEFT);
    EXPECT_EQ(depth, GL_ZERO_TO_ONE);
    EXPECT_EQ(pack, 1);
    EXPECT_EQ(unpack, 1);
    EXPECT_TRUE(glIsEnabled(GL_FRAMEBUFFER_SRGB));
    EXPECT_TRUE(glIsEnabled(GL_TEXTURE_CUBE_MAP_SEAMLESS));
}

TEST_P(ContextTest, KeepsDriverErrorsAtOnce) {
    glEnable(0xdead);
    EXPECT_THAT(context().errors(), SizeIs(1));
    context().clear_errors();
    EXPECT_THAT(context().errors(), IsEmpty());
}

TEST_P(ContextTest, KeepsABoundedNumberOfErrors) {
    for (int i = 0; i < 1100; ++i)
        glDebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_ERROR, 1, GL_DEBUG_SEVERITY_MEDIUM,
                             -1, "again");
    EXPECT_THAT(context().errors(), SizeIs(1000));
    context().clear_errors();
}

TEST_P(ContextTest, LeavesNotesAndShaderMessagesOut) {
    glDebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_PERFORMANCE, 1, GL_DEBUG_SEVERITY_MEDIUM,
                         -1, "slow");
    glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, "pass");
    glPopDebugGroup();
    const GLuint shader = glCreateShader(GL_VERTEX_SHADER);
    const char* nonsense = "nonsense";
    glShaderSource(shader, 1, &nonsense, nullptr);
    glCompileShader(shader);
    glDeleteShader(shader);
    EXPECT_THAT(context().errors(), IsEmpty());
}

TEST(ContextKindTest, NamesRoundTrip) {
    for (ContextKind kind :
         {ContextKind::automatic, ContextKind::window, ContextKind::egl, ContextKind::osmesa}) {
        EXPECT_EQ(parse_context_kind(context_kind_name(kind)), kind);
    }
}

TEST(ContextKindTest, UnknownNameListsTheChoices) {
    EXPECT_THAT(error_of([] { parse_context_kind("vulkan"); }), HasSubstr("auto, window, egl or osmesa"));
}

TEST(ContextCreation, AutomaticPrefersEgl) {
    EXPECT_EQ(create_context(ContextKind::automatic)->kind(), ContextKind::egl);
}

TEST(ContextCreation, ContextsMayFollowEachOther) {
    for (int i = 0; i < 3; ++i) {
        for (ContextKind kind : {ContextKind::egl, ContextKind::osmesa}) {
            const auto context = create_context(kind);
            GLuint texture = 0;
            glCreateTextures(GL_TEXTURE_2D, 1, &texture);
            EXPECT_NE(texture, 0u);
            glDeleteTextures(1, &texture);
            EXPECT_THAT(context->errors(), IsEmpty());
        }
    }
}

TEST(ContextCreationDeathTest, OnlyOneAtATime) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_DEATH(
        {
            const auto first = create_context(ContextKind::osmesa);
            const auto second = create_context(ContextKind::osmesa);
        },
        "one OpenGL context at a time");
}

/// Runs in a child process, because Mesa reads the variable once.
void expect_refusal(ContextKind kind) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(
        {
            setenv("MESA_GL_VERSION_OVERRIDE", "4.1", 1);
            const std::string message = error_of([&] { create_context(kind); });
            std::fprintf(stderr, "[%s]\n", message.c_str());
            std::exit(message.empty() ? 0 : 1);
        },
        testing::ExitedWithCode(1),
        "\\[OpenGL 4.5 core is needed, but this driver \\(.*\\) gives 4.1: .*\\]");
}

TEST(ContextCreationDeathTest, OldDriverIsNamedOnEgl) {
    expect_refusal(ContextKind::egl);
}
TEST(ContextCreationDeathTest, OldDriverIsNamedOnOsmesa) {
    expect_refusal(ContextKind::osmesa);
}

}  // namespace
}  // namespace sl::gl
