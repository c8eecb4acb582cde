// SPDX-License-Identifier: MIT
#pragma once

#include <OpenImageIO/filesystem.h>

#include <algorithm>

namespace sl {

/// Bytes in memory as a file for OpenImageIO, whose own IOMemReader (2.4) does not look whether a place that a damaged file names
/// lies before its first byte or behind its last. The bytes must outlive it.
class MemoryReader final : public OIIO::Filesystem::IOMemReader {
  public:
    MemoryReader(const void* bytes, std::size_t size) : IOMemReader(bytes, size) {}

    std::size_t pread(void* buffer, std::size_t count, std::int64_t offset) override {
        const bool inside = offset >= 0 && static_cast<std::size_t>(offset) < size();
        return inside ? IOMemReader::pread(buffer, std::min(count, size() - static_cast<std::size_t>(offset)), offset) : 0;
    }
};

}  // namespace sl
