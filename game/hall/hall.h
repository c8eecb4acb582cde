// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/core/image.h"
#include "game/hall/hall_mesh.h"

namespace sl {

/// Surfaces of the hall.
struct HallMaterial {
    std::string name;
    vec3 colour;  ///< linear, multiplies the picture
    float roughness;
    int picture = -1;        ///< of Hall::pictures; -1: none
    bool two_sided = false;
};

struct HallPicture {
    std::string name;
    Image image;  ///< sRGB
};

/// A mesh, and where it stands: turned about y first.
struct HallPlace {
    dvec3 position{0.0};
    double turn = 0.0;  ///< rad, counter-clockwise seen from above
};
struct HallPart {
    std::string name;
    int material;  ///< of Hall::materials
    HallMesh mesh;
    std::vector<HallPlace> places;
};

struct HallCamera {
    std::string name;
    dvec3 eye, target;  ///< m
    double fov_y;       ///< rad
};

struct HallSun {
    vec3 colour;         ///< linear
    double illuminance;  ///< lux, on a surface that faces it
    dvec3 towards;       ///< where its light goes
};

/// An atrium of two storeys under an open roof: columns and arches round a court, vaults over the walk below, a gallery above.
/// x to the right, y up, z along the court; the court's floor is at 0, metres.
struct Hall {
    std::vector<HallMaterial> materials;
    std::vector<HallPicture> pictures;
    std::vector<HallPart> parts;
    std::vector<HallCamera> cameras;
    HallSun sun;

    /// As they are drawn: each copy counts, and what faces both ways twice.
    std::uint64_t triangles() const;
};

/// Where the sky is seen: between these corners, at its height. Everything else is closed.
inline constexpr dvec3 hall_opening_low{-3.4, 9.8, -11.4}, hall_opening_high{3.4, 10.3, 11.4};

/// The same for the same numbers. `detail` is 1 for `usual_hall_triangles` or so, and about in proportion to the triangles;
/// `seed` changes textures, folds and where small things stand.
Hall make_hall(double detail, std::uint64_t seed);
inline constexpr std::uint64_t usual_hall_triangles = 260000;

/// A hall of about as many triangles; fewer or more than there can be are an Error that tells the limits.
Hall make_hall_of(std::uint64_t triangles, std::uint64_t seed);

}  // namespace sl
