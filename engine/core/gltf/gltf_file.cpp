// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_file.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "engine/core/gltf/gltf_json.h"

namespace sl {

namespace {

constexpr std::uint32_t magic = 0x46546C67;         // "glTF"
constexpr std::uint32_t json_chunk = 0x4E4F534A;    // "JSON"
constexpr std::uint32_t binary_chunk = 0x004E4942;  // "BIN"
constexpr std::uint32_t container_version = 2;
constexpr std::size_t header_bytes = 12, chunk_header_bytes = 8, chunk_alignment = 4;

std::uint32_t word(std::span<const std::byte> bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < sizeof value; ++i) value |= std::to_integer<std::uint32_t>(bytes[at + i]) << (8 * i);
    return value;
}

std::string_view text_of(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string place(std::size_t byte) {
    return fmt::format("byte {}", byte);
}

/// Reads chunk after chunk.
class Container {
  public:
    Container(std::span<const std::byte> bytes, GltfFaults& faults) : bytes_(bytes), faults_(faults) {}

    GltfFile read() {
        file_.is_container = true;
        if (!read_header()) return std::move(file_);
        std::size_t at = header_bytes;
        for (std::size_t chunk = 0; at < end_ && !faults_.is_done(); ++chunk) {
            const std::size_t next = read_chunk(at, chunk);
            if (next == 0) break;
            at = next;
        }
        if (!has_json_ && !faults_.has_fatal()) faults_.fatal(place(header_bytes), "the container holds no JSON chunk");
        return std::move(file_);
    }

  private:
    /// Finds the end that the header tells; what lies behind it is ignored.
    bool read_header() {
        if (bytes_.size() < header_bytes) {
            faults_.fatal(place(bytes_.size()), "the file ends within the container's header of {} bytes", header_bytes);
            return false;
        }
        if (const std::uint32_t version = word(bytes_, 4); version != container_version) {
            faults_.fatal(place(4), "the container has version {}; this program reads version {}", version,
                          container_version);
            return false;
        }
        const std::uint32_t length = word(bytes_, 8);
        if (length <= header_bytes) {
            faults_.fatal(place(8), "the container says that it is {} bytes long, too short for a chunk", length);
            return false;
        }
        if (length > bytes_.size()) {
            faults_.note(place(8), "the container says that it is {} bytes long, the file has {}", length, bytes_.size());
        }
        end_ = std::min<std::size_t>(length, bytes_.size());
        return true;
    }

    /// Returns where the next chunk begins, or 0 where the file is broken.
    std::size_t read_chunk(std::size_t at, std::size_t chunk) {
        if (bytes_.size() - at < chunk_header_bytes) {
            faults_.fatal(place(at), "the file ends within the header of chunk {}", chunk);
            return 0;
        }
        const std::size_t length = word(bytes_, at);
        const std::uint32_t kind = word(bytes_, at + 4);
        const std::size_t data = at + chunk_header_bytes;
        if (chunk == 0 && kind != json_chunk) {
            faults_.fatal(place(at + 4), "the first chunk must be JSON, not of the kind {:#010x}", kind);
            return 0;
        }
        if (length % chunk_alignment != 0) {
            faults_.note(place(at), "the length of chunk {} is {}, no multiple of {}", chunk, length, chunk_alignment);
        }
        const std::size_t left = end_ > data ? end_ - data : 0;
        if (length > left) {
            faults_.fatal(place(at), "chunk {} says that it has {} bytes; {} are left", chunk, length, left);
            return 0;
        }
        read_content(kind, chunk, data, bytes_.subspan(data, length));
        return data + length;
    }

    void read_content(std::uint32_t kind, std::size_t chunk, std::size_t at, std::span<const std::byte> content) {
        if (kind == json_chunk) {
            if (has_json_) {
                faults_.note(place(at), "chunk {} is a second JSON chunk; it is ignored", chunk);
            } else if (content.empty()) {
                faults_.fatal(place(at), "the JSON chunk is empty");
            } else {
                file_.json = read_gltf_json(text_of(content), at, faults_);
            }
            has_json_ = true;
        } else if (kind == binary_chunk) {
            if (file_.binary) {
                faults_.note(place(at), "chunk {} is a second BIN chunk; it is ignored", chunk);
                return;
            }
            if (chunk != 1) faults_.note(place(at), "the BIN chunk must be the second, not number {}", chunk + 1);
            file_.binary = content;
        }
    }

    std::span<const std::byte> bytes_;
    GltfFaults& faults_;
    GltfFile file_;
    std::size_t end_ = 0;
    bool has_json_ = false;
};

}  // namespace

GltfFile read_gltf_file(std::span<const std::byte> bytes, GltfFaults& faults) {
    if (bytes.size() >= sizeof magic && word(bytes, 0) == magic) return Container(bytes, faults).read();
    GltfFile file;
    if (bytes.empty()) {
        faults.fatal(place(0), "the file is empty");
    } else if (bytes.front() == std::byte{0}) {
        faults.fatal(place(0), "is neither a container, which begins with 'glTF', nor JSON");
    } else {
        file.json = read_gltf_json(text_of(bytes), 0, faults);
    }
    return file;
}

}  // namespace sl
