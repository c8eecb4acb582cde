// SPDX-License-Identifier: MIT
#pragma once

#include <any>
#include <concepts>
#include <string_view>

#include "engine/core/check.h"
#include "engine/core/fields.h"

namespace sl {

/// The settings of a GI method: a plain struct that tells its name ("rsm_disc", as in scene files, --gi and the editor) and
/// which light it claims to know, with visit_fields(FieldVisitor&, T&) beside it.
template <class T>
concept GiMethodSettings = requires {
    { T::name } -> std::convertible_to<std::string_view>;
    { T::claims } -> std::convertible_to<std::string_view>;
};

class GiMethod;

/// What can be done with a GI method that is known only by name.
struct GiMethodType {
    std::string_view name;
    std::string_view claims;
    GiMethod (*make)();  ///< with its default settings
    void (*visit)(FieldVisitor&, GiMethod&);
};

/// A GI method with its settings, whichever it is: a value, like the settings themselves.
class GiMethod {
  public:
    /// Not explicit: settings are a method.
    template <GiMethodSettings T>
    GiMethod(T settings) : type_(&type_of<T>()), settings_(std::move(settings)) {}

    /// One for each T, wherever it is asked for.
    template <GiMethodSettings T>
    static const GiMethodType& type_of() {
        static constexpr GiMethodType type{.name = T::name,
                                           .claims = T::claims,
                                           .make = [] { return GiMethod(T{}); },
                                           .visit = [](FieldVisitor& visit, GiMethod& method) { visit_fields(visit, method.get<T>()); }};
        return type;
    }
    const GiMethodType& type() const { return *type_; }
    std::string_view name() const { return type_->name; }
    std::string_view claims() const { return type_->claims; }

    template <GiMethodSettings T>
    bool is() const {
        return type_ == &type_of<T>();
    }
    /// Null where it is another method.
    template <GiMethodSettings T>
    T* get_if() {
        return std::any_cast<T>(&settings_);
    }
    template <GiMethodSettings T>
    const T* get_if() const {
        return std::any_cast<T>(&settings_);
    }
    /// It must be that one.
    template <GiMethodSettings T>
    T& get() {
        CHECK(is<T>(), "the GI method is {}, not {}", name(), T::name);
        return *get_if<T>();
    }
    template <GiMethodSettings T>
    const T& get() const {
        CHECK(is<T>(), "the GI method is {}, not {}", name(), T::name);
        return *get_if<T>();
    }

  private:
    const GiMethodType* type_;
    std::any settings_;
};

/// Makes a method known by its name, for as long as the program runs. Names are unique. Whoever renders calls add_gi_method in
/// engine/render/gi/gi.h, which does this too.
void add_gi_method_type(const GiMethodType& type);

/// Names of all methods: the engine's, then those that were added. Holds until another one is added.
std::span<const std::string_view> gi_method_names();
/// Where its name stands among them.
std::size_t gi_method_index(const GiMethod& method);
/// The method of that name with its default settings. Throws Error naming the choices.
GiMethod make_gi_method(std::string_view name);

}  // namespace sl
