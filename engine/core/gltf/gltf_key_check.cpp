// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_key_check.h"

#include <cmath>

#include "engine/core/gltf/gltf_tolerance.h"
#include "engine/core/gltf/gltf_value.h"

namespace sl {

using nlohmann::json;

namespace {

class Keys {
  public:
    Keys(const GltfLayout& layout, GltfElements::Buffers buffers, GltfFaults& faults)
        : layout_(layout), buffers_(buffers), faults_(faults), checked_(layout.accessors.size()) {}

    void check_animation(const json& animation, const std::string& where) {
        const json& samplers = gltf_list(animation, "samplers");
        for (std::size_t i = 0; i < samplers.size() && faults_.takes_notes(); ++i) {
            check_times(*gltf_find_whole(samplers[i], "input"), fmt::format("{}/samplers/{}/input", where, i));
        }
        for (const json& channel : gltf_list(animation, "channels")) {
            if (!faults_.takes_notes()) return;
            if (gltf_text_at(gltf_part(channel, "target"), "path") != "rotation") continue;
            const std::size_t sampler = *gltf_find_whole(channel, "sampler");
            const bool is_cubic = gltf_text_at(samplers[sampler], "interpolation") == "CUBICSPLINE";
            check_rotations(*gltf_find_whole(samplers[sampler], "output"), is_cubic,
                            fmt::format("{}/samplers/{}/output", where, sampler));
        }
    }

    void check_matrices(std::size_t accessor, const std::string& where) {
        const auto elements = read(accessor, matrices);
        if (!elements) return;
        constexpr std::size_t rows = 4;
        for (std::size_t i = 0; i < elements->count(); ++i) {
            for (std::size_t column = 0; column < rows; ++column) {
                const double should_be = column + 1 == rows ? 1.0 : 0.0;
                const double is = elements->stored(i, column * rows + rows - 1);
                if (std::abs(is - should_be) <= gltf_tolerance::matrix_row) continue;
                faults_.note(where, "the last row of matrix {} of accessor {} holds {} instead of {}", i, accessor, is, should_be);
                return;
            }
        }
    }

  private:
    enum Use : std::uint8_t { times = 1, rotations = 2, cubic_rotations = 4, matrices = 8 };

    /// Nothing where the accessor was read for the same use before, however many share it.
    std::optional<GltfElements> read(std::size_t accessor, Use use) {
        if ((checked_[accessor] & use) != 0) return std::nullopt;
        checked_[accessor] |= use;
        return GltfElements::read(layout_, buffers_, accessor);
    }

    void check_times(std::size_t accessor, const std::string& where) {
        const auto elements = read(accessor, times);
        if (!elements) return;
        if (const double first = elements->stored(0, 0); first < 0.0) {
            faults_.note(where, "the first key of accessor {} is at {} seconds, before 0", accessor, first);
        }
        for (std::size_t i = 1; i < elements->count(); ++i) {
            const double last = elements->stored(i - 1, 0), time = elements->stored(i, 0);
            if (time > last) continue;
            faults_.note(where, "key {} of accessor {} is at {} seconds, the one before it at {}", i, accessor, time, last);
            return;
        }
    }

    void check_rotations(std::size_t accessor, bool is_cubic, const std::string& where) {
        const auto elements = read(accessor, is_cubic ? cubic_rotations : rotations);
        if (!elements) return;
        // Each key of a spline has a tangent before its value and one behind it.
        const std::size_t step = is_cubic ? 3 : 1;
        for (std::size_t i = is_cubic ? 1 : 0; i < elements->count(); i += step) {
            double square = 0.0;
            for (std::size_t k = 0; k < elements->components(); ++k) square += elements->value(i, k) * elements->value(i, k);
            if (std::abs(std::sqrt(square) - 1.0) <= gltf_tolerance::unit_quaternion) continue;
            faults_.note(where, "element {} of accessor {} is a quaternion of length {}, not 1", i, accessor, std::sqrt(square));
            return;
        }
    }

    const GltfLayout& layout_;
    GltfElements::Buffers buffers_;
    GltfFaults& faults_;
    std::vector<std::uint8_t> checked_;
};

}  // namespace

void check_gltf_keys(const json& document, const GltfLayout& layout, GltfElements::Buffers buffers, GltfFaults& faults) {
    Keys keys(layout, buffers, faults);
    const json& animations = gltf_list(document, "animations");
    for (std::size_t i = 0; i < animations.size() && faults.takes_notes(); ++i) {
        keys.check_animation(animations[i], fmt::format("/animations/{}", i));
    }
    const json& skins = gltf_list(document, "skins");
    for (std::size_t i = 0; i < skins.size() && faults.takes_notes(); ++i) {
        const auto matrices = gltf_find_whole(skins[i], "inverseBindMatrices");
        if (matrices) keys.check_matrices(*matrices, fmt::format("/skins/{}/inverseBindMatrices", i));
    }
}

}  // namespace sl
