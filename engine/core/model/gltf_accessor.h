// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tinygltf {
class Model;
}

namespace sl {

/// Elements of an accessor, one after the other, as float: normalized integers are 0 to 1, or -1 to 1.
struct AccessorValues {
    std::size_t count = 0;
    std::size_t width = 0;  ///< numbers in an element
    std::vector<float> numbers;
};

/// Reads an accessor whatever its component type and stride, sparse ones too. Throws Error that names it where it reaches beyond
/// its data, or is larger than any that is read; `where` begins the message.
AccessorValues accessor_values(const tinygltf::Model& model, int accessor, const std::string& where);

/// The same of whole numbers.
std::vector<std::uint32_t> accessor_indices(const tinygltf::Model& model, int accessor, const std::string& where);

}  // namespace sl
