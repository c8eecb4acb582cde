// SPDX-License-Identifier: MIT
#include "game/hall/hall.h"

#include "engine/core/error.h"
#include "game/hall/hall_pictures.h"
#include "game/hall/hall_plan.h"

namespace sl {

namespace {

constexpr double least_detail = 0.001, most_detail = 64.0;

enum Picture { stone_picture_number, tile_picture_number, cloth_picture_number };

/// In the order of HallSurface.
std::vector<HallMaterial> materials() {
    return {{.name = "stone", .colour = vec3(1.0f), .roughness = 0.9f, .picture = stone_picture_number},
            {.name = "plaster", .colour = {0.72f, 0.67f, 0.58f}, .roughness = 0.95f},
            {.name = "tiles", .colour = vec3(1.0f), .roughness = 0.5f, .picture = tile_picture_number},
            {.name = "wood", .colour = {0.23f, 0.13f, 0.07f}, .roughness = 0.7f},
            {.name = "red cloth", .colour = {0.85f, 0.06f, 0.05f}, .roughness = 1.0f, .picture = cloth_picture_number, .two_sided = true},
            {.name = "green cloth", .colour = {0.08f, 0.60f, 0.12f}, .roughness = 1.0f, .picture = cloth_picture_number, .two_sided = true},
            {.name = "blue cloth", .colour = {0.07f, 0.16f, 0.80f}, .roughness = 1.0f, .picture = cloth_picture_number, .two_sided = true},
            {.name = "clay", .colour = {0.56f, 0.25f, 0.13f}, .roughness = 0.6f},
            {.name = "marble", .colour = {0.76f, 0.73f, 0.68f}, .roughness = 0.6f}};
}

}  // namespace

std::uint64_t Hall::triangles() const {
    std::uint64_t count = 0;
    for (const HallPart& part : parts) {
        const std::uint64_t sides = materials[static_cast<std::size_t>(part.material)].two_sided ? 2 : 1;
        count += sides * part.places.size() * part.mesh.triangles();
    }
    return count;
}

Hall make_hall(double detail, std::uint64_t seed) {
    Hall hall{.materials = materials(),
              .pictures = {{"stone", stone_picture(seed)}, {"tiles", tile_picture(seed)}, {"cloth", cloth_picture(seed)}},
              .parts = {},
              .cameras = {{.name = "nave", .eye = {-1.0, 2.0, 11.2}, .target = {0.4, 3.2, -12.0}, .fov_y = 1.05},
                          {.name = "gallery", .eye = {6.0, 7.0, 11.2}, .target = {0.0, 5.6, -6.0}, .fov_y = 1.05},
                          {.name = "court", .eye = {2.6, 1.6, 8.4}, .target = {-2.0, 7.4, -3.0}, .fov_y = 1.15}},
              .sun = {.colour = {1.0f, 0.95f, 0.87f}, .illuminance = 90000.0, .towards = {-0.42, -1.0, 0.28}}};
    const HallDetail fineness(detail);
    add_hall_shell(hall, fineness);
    add_hall_arcades(hall, fineness);
    add_hall_furniture(hall, fineness, seed);
    return hall;
}

Hall make_hall_of(std::uint64_t triangles, std::uint64_t seed) {
    double low = least_detail, high = 1.0;
    Hall coarse = make_hall(low, seed), fine = make_hall(high, seed);
    while (fine.triangles() < triangles && high < most_detail) fine = make_hall(high *= 2.0, seed);
    if (triangles < coarse.triangles()) fail("--triangles {}: the coarsest hall has {}", triangles, coarse.triangles());
    if (triangles > fine.triangles()) fail("--triangles {}: the finest hall has {}", triangles, fine.triangles());
    // By then no number of steps changes any more.
    constexpr int halvings = 20;
    for (int halving = 0; halving < halvings; ++halving) {
        const double middle = std::sqrt(low * high);
        Hall between = make_hall(middle, seed);
        const bool too_fine = between.triangles() > triangles;
        (too_fine ? high : low) = middle;
        (too_fine ? fine : coarse) = std::move(between);
    }
    return triangles - coarse.triangles() <= fine.triangles() - triangles ? coarse : fine;
}

}  // namespace sl
