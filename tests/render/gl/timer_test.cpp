// SPDX-License-Identifier: MIT
#include "engine/render/gl/timer.h"

#include <chrono>

#include "engine/render/gl/texture.h"
#include "tests/render/gl/compute_fixture.h"

namespace sl::gl {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

MATCHER_P(Named, name, "") {
    return arg.name == name;
}

class TimerTest : public GlTest {};
SL_ON_BOTH_CONTEXTS(TimerTest);

/// Fills a framebuffer by running `steps` steps per pixel.
class Work {
  public:
    Work() : image_({.width = 256, .height = 256, .format = Format::rgba32f}) {
        folder_.write("a.vert",
                      "void main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, "
                      "gl_VertexID == 2 ? 3 : -1, 0.5, 1); }\n");
        folder_.write("a.frag",
                      "uniform int steps;\nout vec4 colour;\nvoid main() {\n    float x = gl_FragCoord.x;\n"
                      "    for (int i = 0; i < steps; ++i) x = sin(x) + 1.0;\n    colour = vec4(x);\n}\n");
        program_ = &cache_.get({"a.vert", "a.frag", "", {}});
        glCreateFramebuffers(1, &framebuffer_);
        glNamedFramebufferTexture(framebuffer_, GL_COLOR_ATTACHMENT0, image_.id(), 0);
        glCreateVertexArrays(1, &vertices_);
    }
    ~Work() {
        glDeleteFramebuffers(1, &framebuffer_);
        glDeleteVertexArrays(1, &vertices_);
    }
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;

    void draw(int steps) const {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        glViewport(0, 0, 256, 256);
        glBindVertexArray(vertices_);
        glUseProgram(program_->id());
        glProgramUniform1i(program_->id(), program_->uniforms().at("steps"), steps);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }

  private:
    TempFolder folder_;
    ProgramCache cache_{folder_.path()};
    Texture image_;
    const Program* program_ = nullptr;
    GLuint framebuffer_ = 0, vertices_ = 0;
};

TEST_P(TimerTest, MoreWorkTakesLonger) {
    const Work work;
    work.draw(1);
    glFinish();
    SpanTimers timers;
    const auto start = std::chrono::steady_clock::now();
    timers.begin_frame();
    timers.begin_span("little");
    work.draw(2);
    timers.end_span();
    timers.begin_span("much");
    work.draw(400);
    timers.end_span();
    timers.end_frame();
    timers.finish();
    const double wall =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    ASSERT_THAT(timers.newest(), ElementsAre(Named("little"), Named("much")));
    const double little = timers.newest()[0].milliseconds, much = timers.newest()[1].milliseconds;
    EXPECT_GT(little, 0.0);
    EXPECT_GT(much, 4.0 * little);
    EXPECT_GT(much, 0.3 * wall);  // both draw to one framebuffer, which llvmpipe would put together
    EXPECT_LT(little + much, 1.1 * wall);
}

TEST_P(TimerTest, ComputeIsTimedInItsOwnSpan) {
    TempFolder folder;
    folder.write("a.comp",
                 "layout(local_size_x = 64) in;\nlayout(std430) buffer Result { float result[]; };\n"
                 "void main() {\n    float x = float(gl_GlobalInvocationID.x);\n"
                 "    for (int i = 0; i < 400; ++i) x = sin(x) + 1.0;\n"
                 "    result[gl_GlobalInvocationID.x] = x;\n}\n");
    ProgramCache cache(folder.path());
    const Program& program = cache.get({"", "", "a.comp", {}});
    Buffer buffer;
    buffer.upload(std::vector<float>(64 * 512));
    const auto dispatch = [&] {
        glUseProgram(program.id());
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer.id());
        glDispatchCompute(512, 1, 1);
    };
    const Work work;
    work.draw(1);
    dispatch();
    glFinish();
    SpanTimers timers;
    timers.begin_frame();
    timers.begin_span("draw");
    work.draw(2);
    timers.end_span();
    timers.begin_span("compute");
    dispatch();
    timers.end_span();
    timers.end_frame();
    timers.finish();
    ASSERT_THAT(timers.newest(), ElementsAre(Named("draw"), Named("compute")));
    EXPECT_GT(timers.newest()[1].milliseconds, 2.0 * timers.newest()[0].milliseconds);
}

TEST_P(TimerTest, ResultsArriveWithoutWaitingAndQueriesAreReused) {
    const Work work;
    SpanTimers timers;
    EXPECT_THAT(timers.newest(), IsEmpty());
    bool arrived = false;
    for (int frame = 0; frame < 200; ++frame) {
        timers.begin_frame();
        arrived = arrived || !timers.newest().empty();
        timers.begin_span("work");
        work.draw(5);
        timers.end_span();
        timers.end_frame();
        glFlush();
    }
    EXPECT_TRUE(arrived);
    GLuint next = 0;
    glCreateQueries(GL_TIMESTAMP, 1, &next);
    EXPECT_LT(next, 300u);
    glDeleteQueries(1, &next);
}

TEST_P(TimerTest, FinishGivesTheLastFrame) {
    SpanTimers timers;
    for (const char* name : {"first", "second"}) {
        timers.begin_frame();
        timers.begin_span(name);
        timers.end_span();
        timers.end_frame();
    }
    timers.finish();
    EXPECT_THAT(timers.newest(), ElementsAre(Named("second")));
    timers.begin_frame();
    timers.end_frame();
    timers.finish();
    EXPECT_THAT(timers.newest(), IsEmpty());
}

TEST_P(TimerTest, MayBeDestroyedInTheMiddle) {
    SpanTimers timers;
    timers.begin_frame();
    timers.begin_span("open");
}

TEST_P(TimerTest, MistakesStop) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    SpanTimers timers;
    EXPECT_DEATH(timers.begin_span("x"), "span \"x\" begins outside a frame");
    EXPECT_DEATH(timers.end_span(), "end_span without begin_span");
}

}  // namespace
}  // namespace sl::gl
