// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_view_use.h"

namespace sl {

void GltfViewUses::use(std::size_t accessor, GltfViewUse use, const GltfPlace& where) {
    const auto view = layout_.accessors[accessor].view;
    if (!view) return;
    Record& record = records_[*view];
    use_view(*view, use, where);
    if (use != GltfViewUse::vertices) return;
    const bool is_shared = record.vertex_accessor != no_accessor && record.vertex_accessor != accessor;
    if (is_shared && layout_.views[*view].stride == 0 && !record.has_told_sharing) {
        record.has_told_sharing = true;
        faults_.note(where.text(), "buffer view {} has no byteStride, which it needs: accessors {} and {} share it", *view,
                     record.vertex_accessor, accessor);
    }
    record.vertex_accessor = accessor;
}

void GltfViewUses::use_view(std::size_t view, GltfViewUse use, const GltfPlace& where) {
    Record& record = records_[view];
    const GltfView& about = layout_.views[view];
    // The target of a view is a use that stands in the file.
    if (record.use == GltfViewUse::none && about.target == gltf_vertex_target) record.use = GltfViewUse::vertices;
    if (record.use == GltfViewUse::none && about.target == gltf_index_target) record.use = GltfViewUse::indices;
    const bool is_drawn = use != GltfViewUse::other && record.use != GltfViewUse::other;
    if (is_drawn && record.use != GltfViewUse::none && record.use != use) {
        faults_.note(where.text(), "buffer view {} holds {}, so that it cannot hold {}", view,
                     record.use == GltfViewUse::vertices ? "vertices" : "indices",
                     use == GltfViewUse::vertices ? "vertices" : "indices");
    }
    if (use != GltfViewUse::vertices && about.stride > 0) {
        faults_.note(where.text(), "buffer view {} has a byteStride, which only views of vertices may have", view);
    }
    if (record.use == GltfViewUse::none || record.use == GltfViewUse::other) record.use = use;
}

}  // namespace sl
