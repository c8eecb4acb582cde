// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "engine/core/json_text.h"
#include "engine/core/text_file.h"
#include "engine/ecs/scene_schema.h"
#include "game/app/commands.h"

namespace sl {

void add_schema_command(const Flags& program) {
    const Flags command = program.command("schema", "Print the JSON Schema of scene files: what they may hold, with units and ranges");
    command.footer("docs/scene.schema.json holds it. A scene that names it as its \"$schema\" is completed and checked while it is written,\n"
                   "by editors that know JSON Schema.");
    auto output = std::make_shared<std::string>();
    command.add("--output,-o", *output, "File to write it to; else it is printed");
    command.runs([output] {
        check_output(*output, ".json");
        App app = empty_game();
        const std::string text = json_text(scene_schema(app.registry()));
        output->empty() ? fmt::print("{}", text) : write_text_file(*output, text);
        return 0;
    });
}

}  // namespace sl
