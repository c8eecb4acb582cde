// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_structure.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <unordered_map>
#include <unordered_set>

#include "engine/core/closest_name.h"
#include "engine/core/gltf/gltf_declarations.h"
#include "engine/core/gltf/gltf_extensions.h"
#include "engine/core/gltf/gltf_value.h"

namespace sl {

using nlohmann::json;

namespace {

std::string_view article_and_kind(GltfKind kind) {
    switch (kind) {
        case GltfKind::boolean: return "true or false";
        case GltfKind::whole: return "a whole number from 0 to 2^53 - 1";
        case GltfKind::number: return "a number";
        case GltfKind::text: return "a text";
        case GltfKind::object: return "an object";
    }
    return "";
}

bool is_of_kind(const json& value, GltfKind kind) {
    switch (kind) {
        case GltfKind::boolean: return value.is_boolean();
        case GltfKind::whole: return gltf_whole_number(value).has_value();
        case GltfKind::number: return value.is_number();
        case GltfKind::text: return value.is_string();
        case GltfKind::object: return value.is_object();
    }
    return false;
}

/// A value as in messages; what holds others is only named.
std::string shown(const json& value) {
    if (value.is_structured()) return fmt::format("an {}", value.type_name());
    if (value.is_string()) return fmt::format("'{}'", for_message(value.get_ref<const std::string&>()));
    return value.dump();
}

std::string range_text(const GltfProperty& property) {
    const std::string zero = property.may_be_zero ? "0 or " : "";
    if (std::isfinite(property.most)) {
        return fmt::format("{}{} {} and {}", zero, property.is_above_least ? "above" : "between", property.least,
                           property.is_above_least ? fmt::format("at most {}", property.most)
                                                   : fmt::format("{}", property.most));
    }
    return fmt::format("{}{} {}", zero, property.is_above_least ? "above" : "at least", property.least);
}

class Structure {
  public:
    Structure(const json& document, GltfFaults& faults) : document_(document), faults_(faults) {
        for (const std::string_view list : {"extensionsUsed", "extensionsRequired"}) {
            const auto found = document.find(list);
            if (found == document.end() || !found->is_array()) continue;
            for (const json& name : *found) {
                if (name.is_string()) declared_.insert(name.get_ref<const std::string&>());
            }
        }
    }

    /// As deep as the tables are, not as the document is.
    void check_object(const json& value, const GltfObject& object, const json* owner, const GltfPlace& place) {
        for (const GltfProperty& property : object.properties) {
            if (faults_.is_done()) return;
            const auto found = value.find(property.name);
            if (found == value.end()) {
                check_absence(value, property, object, place);
                continue;
            }
            const GltfPlace at(place, property.name);
            if (!property.companion.empty() && !value.contains(property.companion)) {
                faults_.note(at.text(), "needs \"{}\" beside it", property.companion);
            }
            check_property(*found, property, value, owner, at);
        }
        if (!object.one_of.empty()) check_one_of(value, object, place);
        check_extensions(value, object, owner, place);
    }

  private:
    void check_absence(const json& value, const GltfProperty& property, const GltfObject& object,
                       const GltfPlace& place) {
        bool is_needed = property.is_needed;
        if (!property.needed_for_type.empty()) {
            const auto type = value.find("type");
            is_needed = is_needed || (type != value.end() && *type == property.needed_for_type);
        }
        if (is_needed) faults_.fatal(place.text(), "the {} has no \"{}\"", object.name, property.name);
    }

    void check_one_of(const json& value, const GltfObject& object, const GltfPlace& place) {
        const auto there = std::count_if(object.one_of.begin(), object.one_of.end(),
                                         [&](std::string_view name) { return value.contains(name); });
        if (there == 1) return;
        // What a type asks for has been missed already, and an unknown type may bring its own.
        if (there == 0 && value.contains("type")) return;
        faults_.note(place.text(), "the {} has {} of {}; it must have exactly one", object.name,
                     there == 0 ? "none" : "more than one", fmt::join(object.one_of, ", "));
    }

    void check_property(const json& value, const GltfProperty& property, const json& object, const json* owner,
                        const GltfPlace& place) {
        if (!property.is_array) {
            check_item(value, property, object, owner, place);
            return;
        }
        if (!value.is_array()) {
            faults_.fatal(place.text(), "must be an array, not {}", shown(value));
            return;
        }
        check_length(value, property, place);
        for (std::size_t i = 0; i < value.size() && !faults_.is_done(); ++i) {
            check_item(value[i], property, object, owner, GltfPlace(place, i));
        }
        if (property.is_distinct) check_distinct(value, place);
    }

    void check_length(const json& value, const GltfProperty& property, const GltfPlace& place) {
        const std::size_t size = value.size();
        if (size == 0 && property.least_length <= 1) {
            faults_.note(place.text(), "is an empty array; it must be left out or hold something");
        } else if (size < property.least_length || size > property.most_length) {
            faults_.fatal(place.text(), "has {} elements; {} {}", size,
                          size < property.least_length ? "it must have" : "it may have at most",
                          size < property.least_length ? property.least_length : property.most_length);
        }
    }

    void check_distinct(const json& value, const GltfPlace& place) {
        std::unordered_set<std::string> seen;
        for (std::size_t i = 0; i < value.size(); ++i) {
            if (value[i].is_structured() || seen.insert(value[i].dump()).second) continue;
            faults_.note(GltfPlace(place, i).text(), "{} stands in the array twice", shown(value[i]));
        }
    }

    void check_item(const json& value, const GltfProperty& property, const json& object, const json* owner,
                    const GltfPlace& place) {
        if (!property.is_map) {
            check_value(value, property, object, owner, place);
            return;
        }
        if (!value.is_object()) {
            faults_.fatal(place.text(), "must be an object, not {}", shown(value));
            return;
        }
        if (value.empty()) faults_.note(place.text(), "is an empty object");
        for (const auto& [key, item] : value.items()) {
            if (faults_.is_done()) return;
            check_value(item, property, object, owner, GltfPlace(place, key));
        }
    }

    void check_value(const json& value, const GltfProperty& property, const json& object, const json* owner,
                     const GltfPlace& place) {
        if (!is_of_kind(value, property.kind)) {
            faults_.fatal(place.text(), "must be {}, not {}", article_and_kind(property.kind), shown(value));
        } else if (property.kind == GltfKind::object) {
            check_object(value, *property.object, &object, place);
        } else if (property.kind == GltfKind::text) {
            check_text(value.get_ref<const std::string&>(), property, place);
        } else if (value.is_number()) {
            check_number(value, property, owner, place);
        }
    }

    void check_text(const std::string& text, const GltfProperty& property, const GltfPlace& place) {
        const auto& words = property.words;
        if (!words.empty() && std::find(words.begin(), words.end(), text) == words.end()) {
            faults_.note(place.text(), "is '{}'; known are {}", for_message(text), fmt::join(words, ", "));
        }
        if (property.is_well_formed && !property.is_well_formed(text)) {
            faults_.fatal(place.text(), "is '{}'; must be {}", for_message(text), property.form);
        }
    }

    void check_number(const json& value, const GltfProperty& property, const json* owner, const GltfPlace& place) {
        const double number = value.get<double>();
        const bool is_below = property.is_above_least ? number <= property.least : number < property.least;
        if ((is_below || number > property.most) && !(property.may_be_zero && number == 0.0)) {
            // A count that is out of range would break whoever reckons with it; a factor can be clamped.
            if (property.kind == GltfKind::whole) {
                faults_.fatal(place.text(), "is {}; must be {}", shown(value), range_text(property));
                return;
            }
            faults_.note(place.text(), "is {}; must be {}", shown(value), range_text(property));
        }
        if (property.kind != GltfKind::whole) return;
        const std::uint64_t whole = *gltf_whole_number(value);
        if (property.multiple_of > 1 && whole % property.multiple_of != 0) {
            faults_.note(place.text(), "is {}; must be a multiple of {}", whole, property.multiple_of);
        }
        const auto& numbers = property.numbers;
        const auto is_it = [&](int known) { return static_cast<double>(known) == number; };
        if (!numbers.empty() && std::none_of(numbers.begin(), numbers.end(), is_it)) {
            faults_.note(place.text(), "is {}; known are {}", whole, fmt::join(numbers, ", "));
        }
        if (!property.target.empty()) check_reference(whole, property, owner, place);
    }

    void check_reference(std::uint64_t index, const GltfProperty& property, const json* owner,
                         const GltfPlace& place) {
        std::size_t size = 0;
        if (property.is_target_local) {
            const auto found = owner ? owner->find(property.target) : document_.end();
            if (owner && found != owner->end() && found->is_array()) size = found->size();
        } else {
            size = size_of(property.target);
        }
        if (index < size) return;
        faults_.fatal(place.text(), "refers to number {} of /{}, which has {}", index, property.target, size);
    }

    /// Length of an array, by keys from the root.
    std::size_t size_of(std::string_view target) {
        const auto [known, is_new] = sizes_.try_emplace(target, 0);
        if (!is_new) return known->second;
        const json* value = &document_;
        while (!target.empty()) {
            const std::string_view key = target.substr(0, target.find('/'));
            target.remove_prefix(std::min(key.size() + 1, target.size()));
            if (!value->is_object() || !value->contains(key)) return 0;
            value = &*value->find(key);
        }
        return known->second = value->is_array() ? value->size() : 0;
    }

    void check_extensions(const json& value, const GltfObject& object, const json* owner, const GltfPlace& place) {
        const auto found = value.find("extensions");
        if (found == value.end()) return;
        const GltfPlace all(place, "extensions");
        if (!found->is_object()) {
            faults_.fatal(all.text(), "must be an object, not {}", shown(*found));
            return;
        }
        for (const auto& [name, content] : found->items()) {
            if (faults_.is_done()) return;
            const GltfPlace at(all, name);
            if (!declared_.contains(name)) faults_.note(at.text(), "is used, but does not stand in /extensionsUsed");
            if (!content.is_object()) {
                faults_.fatal(at.text(), "must be an object, not {}", shown(content));
                continue;
            }
            const auto known = gltf_extensions();
            const auto is_it = [&](const GltfExtension& entry) {
                return entry.name == name && entry.owner == object.name;
            };
            const auto entry = std::find_if(known.begin(), known.end(), is_it);
            if (entry != known.end() && entry->object) {
                check_object(content, *entry->object, owner, at);
            } else if (is_known_gltf_extension(name)) {
                faults_.note(at.text(), "has no place in the extensions of the {}", object.name);
            }
        }
    }

    const json& document_;
    GltfFaults& faults_;
    std::unordered_set<std::string_view> declared_;
    std::unordered_map<std::string_view, std::size_t> sizes_;
};

}  // namespace

void check_gltf_structure(const json& document, GltfFaults& faults, std::span<const std::string_view> supported) {
    const GltfPlace root;
    if (!document.is_object()) {
        faults.fatal("", "the document must be an object, not {}", shown(document));
        return;
    }
    // First, for it explains the rest.
    check_gltf_declarations(document, faults, supported);
    Structure(document, faults).check_object(document, gltf_document(), nullptr, root);
}

}  // namespace sl
