// SPDX-License-Identifier: MIT
#include "engine/ecs/components/gi_method.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "engine/core/error.h"
#include "engine/ecs/components/gi_settings.h"

namespace sl {

namespace {

struct Methods {
    std::vector<const GiMethodType*> types;
    std::vector<std::string_view> names;

    void add(const GiMethodType& type) {
        CHECK(std::ranges::find(names, type.name) == names.end(), "two GI methods are called '{}'", type.name);
        types.push_back(&type);
        names.push_back(type.name);
    }
};

template <class... T>
Methods list_of(std::type_identity<std::tuple<T...>>) {
    Methods methods;
    (methods.add(GiMethod::type_of<T>()), ...);
    return methods;
}

Methods& methods() {
    static Methods all = list_of(std::type_identity<EngineGiMethods>());
    return all;
}

}  // namespace

void add_gi_method_type(const GiMethodType& type) { methods().add(type); }

std::span<const std::string_view> gi_method_names() { return methods().names; }

std::size_t gi_method_index(const GiMethod& method) {
    const auto& types = methods().types;
    const auto found = std::ranges::find(types, &method.type());
    CHECK(found != types.end(), "the GI method '{}' is in use and was not added: call add_gi_method first", method.name());
    return static_cast<std::size_t>(found - types.begin());
}

GiMethod make_gi_method(std::string_view name) {
    const auto found = std::ranges::find(methods().types, name, &GiMethodType::name);
    if (found == methods().types.end()) fail("there is no GI method '{}'; choose one of {}", name, fmt::join(methods().names, ", "));
    return (*found)->make();
}

}  // namespace sl
