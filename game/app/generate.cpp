// SPDX-License-Identifier: MIT
#include "engine/core/text_file.h"
#include "game/app/commands.h"
#include "game/hall/hall_glb.h"

namespace sl {

namespace {

struct HallFlags {
    std::string output = "hall.glb";
    std::uint64_t triangles = usual_hall_triangles, seed = 1;
};

int run_generate_hall(const HallFlags& flags) {
    check_output(flags.output, ".glb");
    const Hall hall = make_hall_of(flags.triangles, flags.seed);
    write_text_file(flags.output, hall_glb(hall));
    std::size_t copies = 0;
    for (const HallPart& part : hall.parts) copies += part.places.size();
    fmt::print("{}: {} triangles in {} copies of {} meshes, a sun and {} cameras\n", flags.output, hall.triangles(), copies, hall.parts.size(), hall.cameras.size());
    return 0;
}

}  // namespace

void add_generate_command(const Flags& program) {
    const Flags generate = program.command("generate", "Make a model to try things on");
    generate.needs_command();
    auto flags = std::make_shared<HallFlags>();
    const Flags hall = generate.command("hall", "An atrium with colonnades, vaults, a gallery and hanging cloth, lit by a sun through its open roof, as a glTF file");
    hall.add("-o,--output", flags->output, "GLB file to write");
    hall.add("--triangles", flags->triangles, "About how many, as they are drawn: each copy of a mesh counts, and cloth twice, as it faces both ways");
    hall.add("--seed", flags->seed, "Other textures, folds, and places of small things");
    hall.runs([flags] { return run_generate_hall(*flags); });
}

}  // namespace sl
