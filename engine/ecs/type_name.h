// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <typeindex>
#include <typeinfo>

namespace sl {

/// What a person calls a type: demangled, without namespaces, also inside template arguments.
std::string type_name(std::type_index type);

/// The same of a type that is known where this is compiled.
template <class T>
std::string type_name() {
    return type_name(std::type_index(typeid(T)));
}

}  // namespace sl
