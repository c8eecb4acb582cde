// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_meaning.h"

#include "engine/core/gltf/gltf_animation_check.h"
#include "engine/core/gltf/gltf_buffer_check.h"
#include "engine/core/gltf/gltf_mesh_check.h"
#include "engine/core/gltf/gltf_node_check.h"
#include "engine/core/gltf/gltf_value.h"

namespace sl {

using nlohmann::json;

namespace {

/// Images lie in their views as in a file.
void check_image_views(const json& document, GltfViewUses& uses, GltfFaults& faults) {
    const json& images = gltf_list(document, "images");
    const GltfPlace root, list(root, "images");
    for (std::size_t i = 0; i < images.size() && !faults.is_done(); ++i) {
        const GltfPlace place(list, i);
        const auto view = gltf_find_whole(images[i], "bufferView");
        if (view) uses.use_view(*view, GltfViewUse::other, GltfPlace(place, "bufferView"));
    }
}

}  // namespace

void check_gltf_meaning(const json& document, const GltfLayout& layout, GltfFaults& faults) {
    GltfViewUses uses(layout, faults);
    check_gltf_buffers(document, layout, uses, faults);
    check_image_views(document, uses, faults);
    const GltfNodeTree tree(document, faults);
    check_gltf_nodes(document, tree, faults);
    check_gltf_skins(document, layout, tree, uses, faults);
    check_gltf_cameras_and_lights(document, faults);
    check_gltf_meshes(document, layout, uses, faults);
    check_gltf_animations(document, layout, uses, faults);
}

}  // namespace sl
