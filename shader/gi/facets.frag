// SPDX-License-Identifier: MIT
// Irradiance from the table of facets: the four corners of the facet under a pixel, mixed by where it lies in between.
#include "lib/gbuffer.glsl"
#include "shared/facets.h"

layout(std140) uniform Facets { FacetParams facets; };
layout(std430) readonly buffer Table { uvec2 words[]; };  // a name per slot, then two pairs of words of light per slot

layout(location = 0) out vec4 irradiance;  // rgb: lux; a: 1 where a facet was found

vec3 mixed(uint slot, vec2 within) {
    uint at = facets.table.x + 1u + 2u * slot;
    uvec2 low = words[at], high = words[at + 1u];
    return mix(mix(facet_light(low.x), facet_light(low.y), within.x), mix(facet_light(high.x), facet_light(high.y), within.x), within.y);
}

void main() {
    Point point = point_at(ivec2(gl_FragCoord.xy));
    irradiance = vec4(0.0);
    if (point.distance < 0.0) return;
    float level = facet_level(length(point.position - frame.camera_position.xyz), facets.grid.x);
    uint side = facet_side(point.normal);
    vec3 along = facet_axes(point.position, side >> 1);
    // One loop for all that may have to be looked for: where a processor runs shaders, pixels side by side wait for each
    // other, and a branch that no pixel takes costs as much as one that all take.
    uint slot = ~0u, probe = 0u, coarser = 0u, finer = 0u;
    vec2 within = vec2(0.0);
    for (uint i = 0u; i < facet_most_searches * facets.table.y; ++i) {
        FacetCell cell = facet_cell_along(along, side, level);
        uint at = (facet_slot(cell.name.x, cell.name.y) + probe) & facets.table.x;
        uvec2 name = words[at];
        if (name.y == cell.name.y && (name.x & ~facet_is_split) == cell.name.x) {
            slot = at;
            within = cell.within.xy;
            if (name.x == cell.name.x || coarser > 0u || finer == facet_most_splits) break;
            ++finer;
            level -= 1.0;
            probe = 0u;
        } else if (name.x != 0u) {
            ++probe;
        } else {
            if (slot != ~0u || coarser == 5u) break;
            if (coarser == 0u) {
                // At an edge a surface may go on by a hair behind the next one, where no ray meets it: what is beside it
                // will do.
                vec2 to_eye = facet_axes(frame.camera_position.xyz, side >> 1).xy - along.xy;
                along.xy += to_eye * (0.05 * power_of_two(level) / max(length(to_eye), 1e-20));
            } else {
                // A coarser one is there for pixels that no ray has met yet.
                level += 1.0;
            }
            ++coarser;
            probe = 0u;
        }
    }
    if (slot == ~0u) return;
    irradiance = vec4(mixed(slot, within) * (facets.grid.y * facets.grid.z), 1.0);
}
