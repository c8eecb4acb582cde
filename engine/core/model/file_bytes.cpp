// SPDX-License-Identifier: MIT
#include "engine/core/model/file_bytes.h"

#include <fstream>

#include "engine/core/error.h"

namespace sl {

std::vector<std::byte> file_bytes(const std::filesystem::path& file, std::uint64_t most) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) fail("{}: {}", file.string(), std::filesystem::exists(file, error) ? "it is no file" : "there is no such file");
    const std::uint64_t size = std::filesystem::file_size(file, error);
    if (error || size > most) fail("{}: it is larger than {} MB", file.string(), most >> 20);
    std::vector<std::byte> bytes(size);
    std::ifstream stream(file, std::ios::binary);
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (!stream || stream.gcount() != static_cast<std::streamsize>(size)) fail("{}: it cannot be read", file.string());
    return bytes;
}

}  // namespace sl
