// SPDX-License-Identifier: MIT
#include "engine/ecs/type_name.h"

#include <cxxabi.h>

#include <cctype>
#include <cstdlib>
#include <memory>
#include <string_view>

namespace sl {

namespace {

bool in_identifier(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

}  // namespace

std::string type_name(std::type_index type) {
    int status = 0;
    const std::unique_ptr<char, void (*)(void*)> demangled(
        abi::__cxa_demangle(type.name(), nullptr, nullptr, &status), std::free);
    const std::string_view full = status == 0 ? demangled.get() : type.name();
    constexpr std::string_view unnamed = "(anonymous namespace)";

    std::string name;
    std::size_t word = 0;  // where in `name` the identifier begins that a "::" would turn into a namespace
    for (std::size_t i = 0; i < full.size();) {
        if (full.substr(i, unnamed.size()) == unnamed) {
            i += unnamed.size();
        } else if (full.substr(i, 2) == "::") {
            name.resize(word);
            i += 2;
        } else {
            name += full[i];
            if (!in_identifier(full[i])) word = name.size();
            ++i;
        }
    }
    return name;
}

}  // namespace sl
