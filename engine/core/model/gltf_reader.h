// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/gltf/gltf_check.h"

namespace sl {

/// Elements of an accessor, one after the other, as float: normalized integers are 0 to 1, or -1 to 1.
struct AccessorValues {
    std::size_t count = 0;
    std::size_t width = 0;  ///< numbers in an element
    std::vector<float> numbers;
};

/// What a model is made from: a file without a fatal fault, whose types, references and ranges need no second look.
class GltfReader {
  public:
    explicit GltfReader(const GltfChecked& file) : file_(file) {}

    const nlohmann::json& document() const { return file_.file.json; }
    const GltfResources& resources() const { return file_.resources; }

    /// Nothing where the bytes lie in a file that is not read.
    std::optional<AccessorValues> values(std::size_t accessor);
    /// The same of whole numbers.
    std::optional<std::vector<std::uint32_t>> indices(std::size_t accessor);

    /// For what is left out or not understood; `where` is its place in the file, "" the whole. Only the first hundred are kept.
    void warn(std::string_view where, std::string_view what);
    /// All of them, with the number of those that were not kept.
    std::vector<std::string> take_warnings();

  private:
    template <class Number>
    std::optional<std::vector<Number>> read(std::size_t accessor);

    const GltfChecked& file_;
    std::vector<std::string> warnings_;
    std::size_t untold_ = 0;
};

}  // namespace sl
