// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

namespace sl {

struct GltfObject;

/// JSON type of a property; whole: a number without a fraction.
enum class GltfKind : std::uint8_t { boolean, whole, number, text, object };

/// What one property of an object may be. Made by the functions below, which read as a table.
struct GltfProperty {
    std::string_view name;
    GltfKind kind;
    const GltfObject* object = nullptr;  ///< what a value of kind object holds

    bool is_needed = false;
    std::string_view needed_for_type;  ///< needed where the object's "type" is this
    std::string_view companion;        ///< the property without which this one means nothing

    bool is_array = false;  ///< an array of what `kind` says
    bool is_map = false;    ///< an object with free keys to what `kind` says; within an array where that is one
    bool is_distinct = false;
    std::size_t least_length = 1;
    std::size_t most_length = std::numeric_limits<std::size_t>::max();

    /// Ranges hold for the number, or for each number of an array.
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    bool is_above_least = false;
    bool may_be_zero = false;  ///< whatever `least` says
    unsigned multiple_of = 1;

    std::string_view target;        ///< array that this is an index into: keys from the document's root, by '/'
    bool is_target_local = false;   ///< `target` is a key of the object that owns this one

    std::span<const std::string_view> words = {};
    std::span<const int> numbers = {};
    bool (*is_well_formed)(std::string_view) = nullptr;
    std::string_view form;  ///< what `is_well_formed` asks for, for messages

    constexpr GltfProperty needed() const { return with(&GltfProperty::is_needed, true); }
    constexpr GltfProperty needed_for(std::string_view type) const { return with(&GltfProperty::needed_for_type, type); }
    constexpr GltfProperty beside(std::string_view other) const { return with(&GltfProperty::companion, other); }
    constexpr GltfProperty distinct() const { return with(&GltfProperty::is_distinct, true); }
    constexpr GltfProperty at_least(double value) const { return with(&GltfProperty::least, value); }
    constexpr GltfProperty above(double value) const { return at_least(value).with(&GltfProperty::is_above_least, true); }
    constexpr GltfProperty within(double low, double high) const { return at_least(low).with(&GltfProperty::most, high); }
    constexpr GltfProperty or_zero() const { return with(&GltfProperty::may_be_zero, true); }
    constexpr GltfProperty in_steps_of(unsigned step) const { return with(&GltfProperty::multiple_of, step); }
    constexpr GltfProperty among(std::span<const std::string_view> list) const { return with(&GltfProperty::words, list); }
    constexpr GltfProperty among(std::span<const int> list) const { return with(&GltfProperty::numbers, list); }
    constexpr GltfProperty array(std::size_t least_size = 1) const {
        return with(&GltfProperty::is_array, true).with(&GltfProperty::least_length, least_size);
    }
    constexpr GltfProperty array_of(std::size_t size) const { return array(size).with(&GltfProperty::most_length, size); }

    template <class Member, class Value>
    constexpr GltfProperty with(Member GltfProperty::*member, Value value) const {
        GltfProperty changed = *this;
        changed.*member = value;
        return changed;
    }
};

/// True or false.
constexpr GltfProperty gltf_flag(std::string_view name) {
    return {name, GltfKind::boolean};
}
/// Any number.
constexpr GltfProperty gltf_number(std::string_view name) {
    return {name, GltfKind::number};
}
/// Any text.
constexpr GltfProperty gltf_text(std::string_view name) {
    return {name, GltfKind::text};
}
/// Counts, offsets and codes: none is negative.
constexpr GltfProperty gltf_whole(std::string_view name) {
    return GltfProperty{name, GltfKind::whole}.at_least(0);
}
/// A number of the array of the document that `target` names: "meshes".
constexpr GltfProperty gltf_index(std::string_view name, std::string_view target) {
    return gltf_whole(name).with(&GltfProperty::target, target);
}
/// An object with properties of its own.
constexpr GltfProperty gltf_object(std::string_view name, const GltfObject& object) {
    return {name, GltfKind::object, &object};
}

/// What an object of a file may hold.
struct GltfObject {
    std::string_view name;
    std::vector<GltfProperty> properties;
    std::vector<std::string_view> one_of;  ///< exactly one of these is there; empty: no such rule
};

/// The whole file, and through its properties all that it may hold.
const GltfObject& gltf_document();
/// How a material's extensions refer to a texture.
const GltfObject& gltf_texture_info();
/// The same for normal textures, which have a scale.
const GltfObject& gltf_normal_texture_info();

}  // namespace sl
