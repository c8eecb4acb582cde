// SPDX-License-Identifier: MIT
#pragma once

#include "shared/prelude.h"

SHARED_BEGIN

/// In a table, the bit of a name's upper half that says that there are finer facets as well; and how often one is split.
const uint facet_is_split = 0x40000000u;
const uint facet_most_splits = 5u;
/// Facets that are looked for at most: itself, beside it, four sizes; or finer ones.
const uint facet_most_searches = 6u;

/// How a pass looks irradiance up in the table of facets.
struct FacetParams {
    vec4 grid;    ///< x: side of a facet over its distance from the camera; y: lux of a stored 1; z: factor on the result; w: unused
    uvec4 table;  ///< x: slots - 1, which are a power of two; y: slots that one search looks at; z, w: unused
};

/// A square on a surface, in a lattice of squares whose sides are powers of two, in metres. Of all surfaces that face
/// along one axis and lie in one slab of the lattice, an eighth as high as it is wide, there is one facet.
struct FacetCell {
    uvec4 name;   ///< x, y: upper and lower half; z, w: unused
    vec4 within;  ///< xy: where in the square a point lies, 0..1; zw: unused
};

/// Lattice coordinates along the surface (x, y) and off it (z) of a vector, for a surface that faces along an axis (0 to 2).
SHARED_FN vec3 facet_axes(vec3 v, uint axis) {
    if (axis == 0u) { return vec3(v.y, v.z, v.x); }
    if (axis == 1u) { return vec3(v.z, v.x, v.y); }
    return v;
}

/// The axis along which a normal points most. Halfway between two it is the same for all normals that differ by rounding.
SHARED_FN uint facet_axis(vec3 normal) {
    vec3 size = abs(normal);
    if (size.y >= max(size.x, size.z) - 0.02f) { return 1u; }
    return size.x >= size.z - 0.02f ? 0u : 2u;
}

/// Side of the facets at a distance: the least power of two that is not smaller than asked for; as its exponent. From the
/// bits, which is exact and costs no logarithm.
SHARED_FN float facet_level(float distance, float side_over_distance) {
    uint bits = floatBitsToUint(clamp(distance * side_over_distance, 1e-17f, 1e17f));
    return float(int(bits >> 23) - ((bits & 0x7fffffu) == 0u ? 127 : 126));
}

/// 2 to the power of a whole number from -126 to 127.
SHARED_FN float power_of_two(float exponent) { return uintBitsToFloat(uint(int(exponent) + 127) << 23); }

/// Level and side of the cell whose name has this upper half.
SHARED_FN int facet_name_level(uint high) { return int((high >> 19) & 0x7fu) - 64; }
/// Which way its surface faces: see facet_side.
SHARED_FN uint facet_name_side(uint high) { return (high >> 16) & 7u; }

/// The facet of a point whose lattice coordinates are known, on a surface that faces to a side.
SHARED_FN FacetCell facet_cell_along(vec3 along, uint side, float level) {
    vec3 at = along * power_of_two(-level);
    // Off the surface the lattice is finer: steps are other facets than the floor beside them. Surfaces often lie on its
    // planes; seen a little before themselves, they lie between two.
    at.z = at.z * 8.0f + ((side & 1u) != 0u ? -0.2929f : 0.2929f);
    vec3 cell = floor(at);
    FacetCell result;
    // Modulo 2^16: farther off than that, facets are so far away that their level is another one.
    uint low = (uint(int(cell.x)) & 0xffffu) | (uint(int(cell.y)) << 16);
    uint high = 0x80000000u | (uint(int(level) + 64) << 19) | (side << 16) | (uint(int(cell.z)) & 0xffffu);
    result.name = uvec4(high, low, 0u, 0u);
    result.within = vec4(at.x - cell.x, at.y - cell.y, 0.0f, 0.0f);
    return result;
}

/// The side to which a surface faces: twice the axis, and 1 more where it faces down it.
SHARED_FN uint facet_side(vec3 normal) {
    uint axis = facet_axis(normal);
    return 2u * axis + (facet_axes(normal, axis).z < 0.0f ? 1u : 0u);
}

/// The facet of a point of a surface.
SHARED_FN FacetCell facet_cell(vec3 position, vec3 normal, float level) {
    uint side = facet_side(normal);
    return facet_cell_along(facet_axes(position, side >> 1), side, level);
}

/// Where the search for a facet begins, before it is cut to the table's size.
SHARED_FN uint facet_slot(uint high, uint low) {
    uint hash = (low ^ (high * 0x9e3779b1u)) * 0x7feb352du;
    hash = (hash ^ (hash >> 15)) * 0x846ca68bu;
    return hash ^ (hash >> 16);
}

/// Light as a table holds it, below 2^16: nine bits a channel, from the lowest up, and an exponent for all three
/// (EXT_texture_shared_exponent). Off by at most a 512th of the brightest channel, or by 2^-24.
SHARED_FN uint facet_word(vec3 light) {
    uint exponent = floatBitsToUint(max(max(light.x, light.y), max(light.z, 6e-8f))) >> 23;
    exponent = exponent > 111u ? min(exponent - 111u, 31u) : 0u;
    vec3 steps = min(floor(light * uintBitsToFloat((151u - exponent) << 23) + 0.5f), vec3(511.0f));
    return uint(steps.x) | (uint(steps.y) << 9) | (uint(steps.z) << 18) | (exponent << 27);
}

/// The light that a word holds: the inverse of facet_word.
SHARED_FN vec3 facet_light(uint word) {
    float unit = uintBitsToFloat(((word >> 27) + 103u) << 23);
    return vec3(float(word & 511u), float((word >> 9) & 511u), float((word >> 18) & 511u)) * unit;
}

SHARED_END
