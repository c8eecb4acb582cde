// SPDX-License-Identifier: MIT
#include "game/app/inspect.h"

#include "engine/core/model/read_model.h"
#include "game/app/commands.h"

namespace sl {

void print_bounds(const Bounds& bounds) {
    if (bounds.empty()) return;
    fmt::print("bounds: {:.3g} {:.3g} {:.3g} to {:.3g} {:.3g} {:.3g} m\n", bounds.low.x, bounds.low.y, bounds.low.z, bounds.high.x, bounds.high.y, bounds.high.z);
}

void add_inspect_command(const Flags& program) {
    auto file = std::make_shared<std::string>();
    const Flags command = program.command("inspect", "What is in a model or a scene: meshes, materials, lights, bounds, and what of it is ignored and why");
    command.add("PATH", *file, "A .gltf, .glb or .vox file, a scene file, or the name of a scene (see `secondlight list scenes`)").required();
    command.runs([file] {
        const std::filesystem::path path = scene_path(*file);
        is_model(path) ? inspect_model(path) : inspect_scene(path);
        return 0;
    });
}

}  // namespace sl
