// SPDX-License-Identifier: MIT
// A value of --set. What it sets can be written to a scene file and read again.
#include "engine/ecs/set_field.h"

#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/core/fields_json.h"
#include "engine/ecs/components/name.h"
#include "tests/fuzz/input_folder.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const sl::ComponentRegistry registry = [] {
        sl::ComponentRegistry made;
        sl::register_engine_components(made);
        return made;
    }();
    sl::World world;
    const sl::Entity entity = world.create(sl::Name{"a"});
    for (const sl::ComponentType& type : registry.types()) type.add_default(world, entity);
    try {
        sl::set_field(world, registry, sl::text_of(data, size));
    } catch (const sl::Error&) {
        return 0;
    }
    for (const sl::ComponentType& type : registry.types()) {
        nlohmann::ordered_json object;
        sl::JsonWriter writer(object);
        type.visit(world, entity, writer);
        const nlohmann::json copy = object;
        sl::JsonReader reader(copy, "copy");
        type.visit(world, entity, reader);
        reader.check_all_used();
    }
    return 0;
}
