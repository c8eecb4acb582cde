// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "engine/render/gl/gl.h"

namespace sl::gl {

/// Owns a buffer that grows: upload() reallocates (next power of two) when the bytes do not fit.
class Buffer {
  public:
    Buffer() = default;
    ~Buffer();
    Buffer(Buffer&& other) noexcept { swap(other); }
    Buffer& operator=(Buffer&& other) noexcept {
        swap(other);
        return *this;
    }

    GLuint id() const { return id_; }
    /// Bytes allocated (at least what was last uploaded; never 0 once used).
    std::size_t capacity() const { return capacity_; }

    /// Makes room for `bytes` (contents undefined when it grows).
    void reserve(std::size_t bytes, const char* label = "");
    /// Replaces the contents from the start. An empty span still leaves a buffer that may be bound.
    void upload(std::span<const std::byte> bytes, const char* label = "");
    template <class T>
    void upload(const std::vector<T>& values, const char* label = "") {
        upload(std::as_bytes(std::span(values)), label);
    }
    /// Reads the first `bytes` back. Slow.
    std::vector<std::byte> read(std::size_t bytes) const;

  private:
    void swap(Buffer& other) noexcept {
        std::swap(id_, other.id_);
        std::swap(capacity_, other.capacity_);
    }
    GLuint id_ = 0;
    std::size_t capacity_ = 0;
};

}  // namespace sl::gl
