// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string_view>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace sl {

/// CRC-32 as PNG wants it (ISO 3309).
inline std::uint32_t png_checksum(const std::uint8_t* data, std::size_t size) {
    std::uint32_t sum = 0xffffffffu;
    for (std::size_t i = 0; i < size; ++i) {
        sum ^= data[i];
        for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (sum & 1u) * 0xedb88320u;
    }
    return ~sum;
}

/// Makes the checksums of a PNG's chunks right: else nearly every change of a byte would be refused for that alone.
inline void repair_png(std::uint8_t* data, std::size_t size) {
    constexpr std::size_t signature = 8, around = 12;  // length, name and checksum of a chunk
    if (size < signature || std::string_view(reinterpret_cast<const char*>(data) + 1, 3) != "PNG") return;
    const auto big_endian = [](const std::uint8_t* at) { return std::size_t{at[0]} << 24 | std::size_t{at[1]} << 16 | std::size_t{at[2]} << 8 | at[3]; };
    for (std::size_t at = signature; at + around <= size;) {
        const std::size_t length = std::min(big_endian(data + at), size - at - around);
        const std::uint32_t sum = png_checksum(data + at + 4, 4 + length);
        for (std::size_t i = 0; i < 4; ++i) data[at + 8 + length + i] = static_cast<std::uint8_t>(sum >> (24 - 8 * i));
        at += around + length;
    }
}

}  // namespace sl

/// What libFuzzer calls to make an input from another one.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned) {
    size = LLVMFuzzerMutate(data, size, most);
    sl::repair_png(data, size);
    return size;
}
