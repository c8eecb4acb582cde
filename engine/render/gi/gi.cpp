// SPDX-License-Identifier: MIT
#include "engine/render/gi/gi.h"

#include <map>

namespace sl {

namespace {

using Bodies = std::map<const GiMethodType*, GiBody>;

template <class... T>
Bodies bodies_of(std::type_identity<std::tuple<T...>>) {
    return {{&GiMethod::type_of<T>(), &call_indirect_light<T>}...};
}

Bodies& bodies() {
    static Bodies all = bodies_of(std::type_identity<EngineGiMethods>());
    return all;
}

}  // namespace

void add_gi_body(const GiMethodType& type, GiBody body) { bodies().emplace(&type, body); }

GiResult run_gi_method(const FrameInput& frame, const GBuffer& gbuffer, const GiMethod& method) {
    const auto found = bodies().find(&method.type());
    CHECK(found != bodies().end(), "the GI method '{}' is in use and was not added: call add_gi_method first", method.name());
    return found->second(frame, gbuffer, method);
}

}  // namespace sl
