// SPDX-License-Identifier: MIT
#include "engine/render/gl/buffer.h"

#include <algorithm>
#include <bit>

#include "engine/core/check.h"
#include "engine/render/gl/label.h"

namespace sl::gl {
namespace {

constexpr std::size_t smallest = 64;

}  // namespace

Buffer::~Buffer() {
    if (id_ != 0) glDeleteBuffers(1, &id_);
}

void Buffer::reserve(std::size_t bytes, const char* label) {
    if (id_ == 0) {
        glCreateBuffers(1, &id_);
        set_label(GL_BUFFER, id_, label);
    }
    if (bytes <= capacity_ && capacity_ != 0) return;
    capacity_ = std::bit_ceil(std::max(bytes, smallest));
    glNamedBufferData(id_, static_cast<GLsizeiptr>(capacity_), nullptr, GL_DYNAMIC_DRAW);
}

void Buffer::upload(std::span<const std::byte> bytes, const char* label) {
    reserve(bytes.size(), label);
    if (!bytes.empty()) glNamedBufferSubData(id_, 0, static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

std::vector<std::byte> Buffer::read(std::size_t bytes) const {
    CHECK(bytes <= capacity_, "reading {} bytes of a buffer of {}", bytes, capacity_);
    std::vector<std::byte> result(bytes);
    if (bytes != 0) glGetNamedBufferSubData(id_, 0, static_cast<GLsizeiptr>(bytes), result.data());
    return result;
}

}  // namespace sl::gl
