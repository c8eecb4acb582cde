// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstring>

#include "engine/core/fields.h"

namespace sl {

/// One field of every type, for tests of visitors.
struct EveryField {
    enum class Mood { calm, windy, stormy };
    bool flag = false;
    std::int32_t steps = -3;
    std::uint32_t size = 64;
    float strength = 0.3f;
    float angle = 0.5f;
    float brightness = 100.0f;
    float open = 1.0f;
    double precise = 0.1;
    vec2 pair{0.1f, 0.2f};
    vec3 colour{1.0f, 0.5f, 0.25f};
    dvec3 place{1.0, 2.0, 3.0};
    quat rotation{1, 0, 0, 0};
    std::string text = "plain";
    Mood mood = Mood::calm;
};

inline constexpr std::array<std::string_view, 3> mood_names{"calm", "windy", "stormy"};

inline void visit_fields(FieldVisitor& visit, EveryField& every) {
    visit.field("flag", every.flag, {.help = "A flag."});
    visit.field("steps", every.steps, {.min = -10, .max = 10, .help = "Steps."});
    visit.field("size", every.size, {.min = 4, .max = 1024, .unit = "texels", .help = "Size | side."});
    visit.field("strength", every.strength, {.min = 0, .max = 0.7, .help = "Strength."});
    visit.field("angle", every.angle, {.min = 0.001, .max = 1.5533, .unit = "rad", .look = FieldLook::angle});
    visit.field("brightness", every.brightness,
                {.min = 0, .max = 1e9, .unit = "cd", .look = FieldLook::logarithmic});
    visit.field("open", every.open, {});
    visit.field("precise", every.precise, {.min = 0, .unit = "m"});
    visit.field("pair", every.pair, {.max = 5});
    visit.field("colour", every.colour, {.min = 0, .max = 1, .look = FieldLook::colour});
    visit.field("place", every.place, {.min = -1e7, .max = 1e7, .unit = "m"});
    visit.field("rotation", every.rotation, {});
    visit.field("text", every.text, {});
    visit.enumeration("mood", every.mood, mood_names, {.help = "Weather."});
}

/// Whether all numbers agree to the bit.
inline bool same_bits(const EveryField& a, const EveryField& b) {
    const auto same = [](const auto& x, const auto& y) { return std::memcmp(&x, &y, sizeof x) == 0; };
    return a.flag == b.flag && a.steps == b.steps && a.size == b.size && same(a.strength, b.strength) &&
           same(a.angle, b.angle) && same(a.brightness, b.brightness) && same(a.open, b.open) &&
           same(a.precise, b.precise) && same(a.pair, b.pair) && same(a.colour, b.colour) &&
           same(a.place, b.place) && same(a.rotation, b.rotation) && a.text == b.text && a.mood == b.mood;
}

/// The message of the Error that `action` throws; empty where it throws none.
template <class Action>
std::string error_of(Action&& action) {
    try {
        action();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

}  // namespace sl
