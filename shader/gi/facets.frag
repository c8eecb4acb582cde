// SPDX-License-Identifier: MIT
// Irradiance from the table of facets: the four corners of the facet under a pixel, mixed by where it lies in between.
#include "lib/gbuffer.glsl"
#include "shared/facets.h"

layout(std140) uniform Facets { FacetParams facets; };
layout(std430) readonly buffer Table { uvec2 words[]; };  // a name per slot, then three pairs of words of light per slot

layout(location = 0) out vec4 irradiance;  // rgb: lux; a: 1 where a facet was found

struct Found {
    uint slot;  // ~0: none
    bool split;
};

Found find(FacetCell cell) {
    uint at = facet_slot(cell.name.x, cell.name.y) & facets.table.x;
    for (uint i = 0u; i < facets.table.y; ++i) {
        uvec2 name = words[at];
        if (name.y == cell.name.y && (name.x & ~facet_is_split) == cell.name.x) return Found(at, name.x != cell.name.x);
        if (name.x == 0u) break;
        at = (at + 1u) & facets.table.x;
    }
    return Found(~0u, false);
}

vec3 mixed(uint slot, vec2 within) {
    uint at = facets.table.x + 1u + 3u * slot;
    uvec2 first = words[at], second = words[at + 1u], third = words[at + 2u];
    vec2 a = unpackHalf2x16(first.x), b = unpackHalf2x16(first.y), c = unpackHalf2x16(second.x);
    vec2 d = unpackHalf2x16(second.y), e = unpackHalf2x16(third.x), f = unpackHalf2x16(third.y);
    vec3 low = mix(vec3(a, b.x), vec3(b.y, c), within.x);
    vec3 high = mix(vec3(d, e.x), vec3(e.y, f), within.x);
    return mix(low, high, within.y);
}

void main() {
    Point point = point_at(ivec2(gl_FragCoord.xy));
    irradiance = vec4(0.0);
    if (point.distance < 0.0) return;
    float level = facet_level(length(point.position - frame.camera_position.xyz), facets.grid.x);
    uint side = facet_side(point.normal);
    vec3 along = facet_axes(point.position, side >> 1);
    FacetCell cell = facet_cell_along(along, side, level);
    Found found = find(cell);
    if (found.slot == ~0u) {
        // At an edge a surface may go on by a hair behind the next one, where no ray meets it: what is beside it will do.
        vec2 to_eye = facet_axes(frame.camera_position.xyz, side >> 1).xy - along.xy;
        along.xy += to_eye * (0.05 * power_of_two(level) / max(length(to_eye), 1e-20));
    }
    // A coarser one is there for pixels that no ray has met yet.
    for (float coarser = 0.0; coarser <= 3.0 && found.slot == ~0u; ++coarser) {
        cell = facet_cell_along(along, side, level + coarser);
        found = find(cell);
        found.split = false;
    }
    if (found.slot == ~0u) return;
    for (uint finer = 1u; finer <= facet_most_splits && found.split; ++finer) {
        FacetCell inner_cell = facet_cell_along(along, side, level - float(finer));
        Found inner = find(inner_cell);
        if (inner.slot == ~0u) break;
        found = inner;
        cell = inner_cell;
    }
    irradiance = vec4(mixed(found.slot, cell.within.xy) * (facets.grid.y * facets.grid.z), 1.0);
}
