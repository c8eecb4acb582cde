// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sl {

/// What the URIs of data usually begin with; small letters are not asked for.
inline constexpr std::string_view gltf_data_scheme = "data:";

/// A URI of a file, taken apart.
struct GltfUri {
    enum class Kind : std::uint8_t {
        invalid,
        data,      ///< holds its bytes itself
        relative,  ///< a file beside
        absolute,  ///< has a scheme such as "http"
    };
    Kind kind = Kind::invalid;
    std::string media_type;       ///< in small letters; of data
    std::vector<std::byte> data;  ///< of data
    std::string path;             ///< of relative ones, "%20" replaced by a space
};

/// Decodes percent signs, and the bytes of data.
GltfUri read_gltf_uri(std::string_view text);

}  // namespace sl
