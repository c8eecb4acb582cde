// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "game/hall/cloth.h"
#include "game/hall/furniture.h"
#include "game/hall/hall_plan.h"

namespace sl {

using namespace hall_plan;

namespace {

constexpr double quarter = 0.5 * glm::pi<double>();

/// Numbers of 0 to 1, one after the other.
class Numbers {
  public:
    explicit Numbers(std::uint64_t seed) : hash_(seed) {}
    double next() {
        hash_ = hash_mix(hash_, 1);
        return static_cast<double>(hash_ >> 11) / static_cast<double>(std::uint64_t{1} << 53);
    }
    double between(double low, double high) { return glm::mix(low, high, next()); }

  private:
    std::uint64_t hash_;
};

constexpr std::array cloths{HallSurface::red, HallSurface::green, HallSurface::blue};

/// In every other arch of the long sides, on a rod from capital to capital.
void add_curtains(Hall& hall, const HallDetail& detail, Numbers& numbers) {
    constexpr double height = spring - 0.25;
    HallMesh rod;
    const TubeWay across{.at = [](double t) { return dvec3(3.5 * (t - 0.5), 0, 0); }, .side = [](double) { return dvec3(0, 1, 0); }, .radius = 0.02, .length = 3.5};
    add_tube(rod, across, detail.steps(10, 4), 1);
    std::vector<HallPlace> rods;
    for (int i = 0; i < bays_z; ++i) {
        const double side = i % 2 == 0 ? -1.0 : 1.0;
        const HallPlace place{{side * court_x, height, (i + 0.5 - 0.5 * bays_z) * bay}, -side * quarter};
        const ClothShape shape{.width = numbers.between(2.4, 2.9),
                               .length = numbers.between(2.0, 2.5),
                               .folds = std::floor(numbers.between(7.0, 11.0)),
                               .phase = numbers.between(0.0, 6.0)};
        const HallSurface surface = cloths[static_cast<std::size_t>(i) % cloths.size()];
        hall.parts.push_back({fmt::format("curtain {}", i + 1), static_cast<int>(surface), curtain(shape, detail), {place}});
        rods.push_back(place);
    }
    hall.parts.push_back({"rod", static_cast<int>(HallSurface::wood), std::move(rod), std::move(rods)});
}

/// Over the court, in front of what carries the roof.
void add_awnings(Hall& hall, const HallDetail& detail, Numbers& numbers) {
    constexpr std::array places{-6.0, 6.0};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const ClothShape shape{.width = 2.0 * (court_x - 0.5 * upper_wall), .length = numbers.between(2.2, 2.8), .folds = 2.5, .phase = numbers.between(0.0, 6.0)};
        const HallSurface surface = cloths[(i + 1) % cloths.size()];
        hall.parts.push_back({fmt::format("awning {}", i + 1), static_cast<int>(surface), awning(shape, numbers.between(1.0, 1.4), detail), {{{0.0, ceiling - 0.3, places[i]}}}});
    }
}

}  // namespace

void add_hall_furniture(Hall& hall, const HallDetail& detail, std::uint64_t seed) {
    Numbers numbers(seed);
    add_curtains(hall, detail, numbers);
    add_awnings(hall, detail, numbers);
    std::vector<HallPlace> vases, pedestals, knots;
    for (const double z : {-10.0, -2.0, 6.0, 14.6}) {
        for (const double side : {-1.0, 1.0}) {
            const double from_wall = numbers.between(0.6, 0.9), along = numbers.between(-0.5, 0.5);
            vases.push_back({{side * (wall_x - from_wall), 0.0, side * z + along}, numbers.between(0.0, 4.0 * quarter)});
        }
    }
    for (const double side : {-1.0, 1.0}) {
        for (const double z : {-4.0, 4.0}) {
            pedestals.push_back({{side * 2.6, 0.0, z}});
            knots.push_back({{side * 2.6, pedestal_height, z}, numbers.between(0.0, 4.0 * quarter)});
        }
    }
    hall.parts.push_back({"vase", static_cast<int>(HallSurface::clay), vase(detail), std::move(vases)});
    hall.parts.push_back({"pedestal", static_cast<int>(HallSurface::stone), pedestal(detail), std::move(pedestals)});
    hall.parts.push_back({"knot", static_cast<int>(HallSurface::marble), knot(detail), std::move(knots)});
}

}  // namespace sl
