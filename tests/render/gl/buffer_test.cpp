// SPDX-License-Identifier: MIT
#include "engine/render/gl/buffer.h"

#include <cstring>
#include <numeric>

#include "tests/render/gl/gl_fixture.h"

namespace sl::gl {
namespace {

class BufferTest : public GlTest {};
SL_ON_BOTH_CONTEXTS(BufferTest);

TEST_P(BufferTest, KeepsWhatWasUploaded) {
    Buffer buffer;
    EXPECT_EQ(buffer.id(), 0u);
    std::vector<int> values(1000);
    std::iota(values.begin(), values.end(), -500);
    buffer.upload(values, "numbers");
    const auto read = buffer.read(values.size() * sizeof(int));
    EXPECT_EQ(std::memcmp(read.data(), values.data(), read.size()), 0);
}

TEST_P(BufferTest, GrowsToPowersOfTwoAndStaysTheSameObject) {
    Buffer buffer;
    buffer.upload(std::vector<std::byte>(100));
    const GLuint id = buffer.id();
    EXPECT_EQ(buffer.capacity(), 128u);
    buffer.upload(std::vector<std::byte>(4097));
    EXPECT_EQ(buffer.capacity(), 8192u);
    buffer.upload(std::vector<std::byte>(5));
    EXPECT_EQ(buffer.capacity(), 8192u);
    EXPECT_EQ(buffer.id(), id);
    GLint size = 0;
    glGetNamedBufferParameteriv(id, GL_BUFFER_SIZE, &size);
    EXPECT_EQ(size, 8192);
}

TEST_P(BufferTest, EmptyUploadMayStillBeBound) {
    Buffer buffer;
    buffer.upload(std::vector<float>());
    EXPECT_GT(buffer.capacity(), 0u);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer.id());
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, 0, buffer.id(), 0, 16);
}

TEST_P(BufferTest, MoveLeavesOneOwner) {
    Buffer first;
    first.upload(std::vector<int>{1, 2, 3});
    const GLuint id = first.id();
    Buffer second = std::move(first);
    EXPECT_EQ(second.id(), id);
    EXPECT_EQ(first.id(), 0u);
    first = std::move(second);
    EXPECT_EQ(first.id(), id);
}

TEST_P(BufferTest, ReadingTooMuchStops) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_DEATH(Buffer().read(1), "reading 1 bytes of a buffer of 0");
}

}  // namespace
}  // namespace sl::gl
