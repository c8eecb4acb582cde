// SPDX-License-Identifier: MIT
#include "engine/core/model/gltf_reader.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/core/gltf/gltf_elements.h"

namespace sl {

namespace {

constexpr std::size_t most_warnings = 100;

}  // namespace

template <class Number>
std::optional<std::vector<Number>> GltfReader::read(std::size_t number) {
    const GltfAccessor& accessor = file_.layout.accessors[number];
    const std::size_t width = accessor.format.components();
    if (!accessor.view && !accessor.sparse) return std::vector<Number>(accessor.count * width);
    const auto elements = GltfElements::read(file_.layout, file_.resources.buffers(), number);
    if (!elements) return std::nullopt;
    std::vector<Number> numbers;
    numbers.reserve(accessor.count * width);
    const double one = elements->one();
    const bool is_normalized = accessor.format.is_normalized;
    elements->each_stored([&](std::size_t, std::size_t, double stored) {
        numbers.push_back(static_cast<Number>(is_normalized ? std::max(stored / one, -1.0) : stored));
    });
    return numbers;
}

std::optional<AccessorValues> GltfReader::values(std::size_t accessor) {
    auto numbers = read<float>(accessor);
    if (!numbers) return std::nullopt;
    const GltfAccessor& about = file_.layout.accessors[accessor];
    return AccessorValues{.count = about.count, .width = about.format.components(), .numbers = std::move(*numbers)};
}

std::optional<std::vector<std::uint32_t>> GltfReader::indices(std::size_t accessor) {
    return read<std::uint32_t>(accessor);
}

void GltfReader::warn(std::string_view where, std::string_view what) {
    if (warnings_.size() < most_warnings) {
        warnings_.push_back(where.empty() ? std::string(what) : fmt::format("{}: {}", where, what));
    } else {
        ++untold_;
    }
}

std::vector<std::string> GltfReader::take_warnings() {
    if (untold_ > 0) warnings_.push_back(fmt::format("and {} more", untold_));
    return std::move(warnings_);
}

}  // namespace sl
