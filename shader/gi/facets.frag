// SPDX-License-Identifier: MIT
// Irradiance from the table of facets: the four corners of the facet under a pixel, mixed by where it lies in between.
#include "lib/gbuffer.glsl"
#include "shared/facets.h"

struct FacetSlot {
    uvec4 first;   // xy: name; zw: half floats
    uvec4 second;  // half floats
};

layout(std140) uniform Facets { FacetParams facets; };
layout(std430) readonly buffer Table { FacetSlot slots[]; };

layout(location = 0) out vec4 irradiance;  // rgb: lux; a: 1 where a facet was found

bool find(FacetCell cell, out FacetSlot slot) {
    uint at = facet_slot(cell.name.x, cell.name.y);
    for (uint i = 0u; i < facets.table.y; ++i, ++at) {
        slot = slots[at & facets.table.x];
        if (slot.first.xy == cell.name.xy) return true;
        if (slot.first.x == 0u) return false;
    }
    return false;
}

bool is_split(FacetSlot slot) { return (slot.first.z & 0x8000u) != 0u; }

vec3 mixed(FacetSlot slot, vec2 within) {
    vec2 a = unpackHalf2x16(slot.first.z & 0xffff7fffu), b = unpackHalf2x16(slot.first.w), c = unpackHalf2x16(slot.second.x);
    vec2 d = unpackHalf2x16(slot.second.y), e = unpackHalf2x16(slot.second.z), f = unpackHalf2x16(slot.second.w);
    vec3 low = mix(vec3(a, b.x), vec3(b.y, c), within.x);
    vec3 high = mix(vec3(d, e.x), vec3(e.y, f), within.x);
    return mix(low, high, within.y);
}

void main() {
    Point point = point_at(ivec2(gl_FragCoord.xy));
    irradiance = vec4(0.0);
    if (point.distance < 0.0) return;
    float level = facet_level(length(point.position - frame.camera_position.xyz), facets.grid.x);
    FacetSlot slot;
    FacetCell cell = facet_cell(point.position, point.normal, level);
    bool found = find(cell, slot);
    if (!found) {
        // A coarser one that is there for pixels that no ray has met yet.
        for (float coarser = 1.0; coarser <= 3.0 && !found; ++coarser) {
            cell = facet_cell(point.position, point.normal, level + coarser);
            found = find(cell, slot);
        }
        if (!found) return;
    } else {
        for (float finer = 1.0; finer <= 3.0 && is_split(slot); ++finer) {
            FacetSlot inner;
            FacetCell inner_cell = facet_cell(point.position, point.normal, level - finer);
            if (!find(inner_cell, inner)) break;
            slot = inner;
            cell = inner_cell;
        }
    }
    irradiance = vec4(mixed(slot, cell.within.xy) * (facets.grid.y * facets.grid.z), 1.0);
}
