// SPDX-License-Identifier: MIT
#include "engine/measure/pixel_text.h"

#include <array>

#include "engine/core/check.h"

namespace sl {

namespace {

constexpr std::uint32_t glyph_width = 5;
constexpr std::uint32_t advance = glyph_width + 1;

/// Seven rows from the top, five dots each, '#' for ink.
struct Glyph {
    char character;
    std::string_view dots;
};

// clang-format off
constexpr std::array glyphs{
    Glyph{' ', "....." "....." "....." "....." "....." "....." "....."},
    Glyph{'0', ".###." "#...#" "#..##" "#.#.#" "##..#" "#...#" ".###."},
    Glyph{'1', "..#.." ".##.." "..#.." "..#.." "..#.." "..#.." ".###."},
    Glyph{'2', ".###." "#...#" "....#" "..##." ".#..." "#...." "#####"},
    Glyph{'3', ".###." "#...#" "....#" "..##." "....#" "#...#" ".###."},
    Glyph{'4', "...#." "..##." ".#.#." "#..#." "#####" "...#." "...#."},
    Glyph{'5', "#####" "#...." "####." "....#" "....#" "#...#" ".###."},
    Glyph{'6', "..##." ".#..." "#...." "####." "#...#" "#...#" ".###."},
    Glyph{'7', "#####" "....#" "...#." "..#.." ".#..." ".#..." ".#..."},
    Glyph{'8', ".###." "#...#" "#...#" ".###." "#...#" "#...#" ".###."},
    Glyph{'9', ".###." "#...#" "#...#" ".####" "....#" "...#." ".##.."},
    Glyph{'A', ".###." "#...#" "#...#" "#####" "#...#" "#...#" "#...#"},
    Glyph{'B', "####." "#...#" "#...#" "####." "#...#" "#...#" "####."},
    Glyph{'C', ".###." "#...#" "#...." "#...." "#...." "#...#" ".###."},
    Glyph{'D', "####." "#...#" "#...#" "#...#" "#...#" "#...#" "####."},
    Glyph{'E', "#####" "#...." "#...." "####." "#...." "#...." "#####"},
    Glyph{'F', "#####" "#...." "#...." "####." "#...." "#...." "#...."},
    Glyph{'G', ".###." "#...#" "#...." "#.###" "#...#" "#...#" ".###."},
    Glyph{'H', "#...#" "#...#" "#...#" "#####" "#...#" "#...#" "#...#"},
    Glyph{'I', ".###." "..#.." "..#.." "..#.." "..#.." "..#.." ".###."},
    Glyph{'J', "....#" "....#" "....#" "....#" "#...#" "#...#" ".###."},
    Glyph{'K', "#...#" "#..#." "#.#.." "##..." "#.#.." "#..#." "#...#"},
    Glyph{'L', "#...." "#...." "#...." "#...." "#...." "#...." "#####"},
    Glyph{'M', "#...#" "##.##" "#.#.#" "#.#.#" "#...#" "#...#" "#...#"},
    Glyph{'N', "#...#" "##..#" "#.#.#" "#..##" "#...#" "#...#" "#...#"},
    Glyph{'O', ".###." "#...#" "#...#" "#...#" "#...#" "#...#" ".###."},
    Glyph{'P', "####." "#...#" "#...#" "####." "#...." "#...." "#...."},
    Glyph{'Q', ".###." "#...#" "#...#" "#...#" "#.#.#" "#..#." ".##.#"},
    Glyph{'R', "####." "#...#" "#...#" "####." "#.#.." "#..#." "#...#"},
    Glyph{'S', ".####" "#...." "#...." ".###." "....#" "....#" "####."},
    Glyph{'T', "#####" "..#.." "..#.." "..#.." "..#.." "..#.." "..#.."},
    Glyph{'U', "#...#" "#...#" "#...#" "#...#" "#...#" "#...#" ".###."},
    Glyph{'V', "#...#" "#...#" "#...#" "#...#" "#...#" ".#.#." "..#.."},
    Glyph{'W', "#...#" "#...#" "#...#" "#.#.#" "#.#.#" "##.##" "#...#"},
    Glyph{'X', "#...#" "#...#" ".#.#." "..#.." ".#.#." "#...#" "#...#"},
    Glyph{'Y', "#...#" "#...#" ".#.#." "..#.." "..#.." "..#.." "..#.."},
    Glyph{'Z', "#####" "....#" "...#." "..#.." ".#..." "#...." "#####"},
    Glyph{'.', "....." "....." "....." "....." "....." ".##.." ".##.."},
    Glyph{',', "....." "....." "....." "....." "..##." "..#.." ".#..."},
    Glyph{':', "....." ".##.." ".##.." "....." ".##.." ".##.." "....."},
    Glyph{'%', "##..#" "##..#" "...#." "..#.." ".#..." "#..##" "#..##"},
    Glyph{'+', "....." "..#.." "..#.." "#####" "..#.." "..#.." "....."},
    Glyph{'-', "....." "....." "....." "#####" "....." "....." "....."},
    Glyph{'>', ".#..." "..#.." "...#." "....#" "...#." "..#.." ".#..."},
    Glyph{'<', "...#." "..#.." ".#..." "#...." ".#..." "..#.." "...#."},
    Glyph{'(', "...#." "..#.." ".#..." ".#..." ".#..." "..#.." "...#."},
    Glyph{')', ".#..." "..#.." "...#." "...#." "...#." "..#.." ".#..."},
    Glyph{'/', "....#" "....#" "...#." "..#.." ".#..." "#...." "#...."},
};
// clang-format on
constexpr std::string_view box = "######...##...##...##...##...######";

std::string_view dots_of(char character) {
    const char capital = character >= 'a' && character <= 'z' ? static_cast<char>(character - 'a' + 'A') : character;
    for (const Glyph& glyph : glyphs) {
        if (glyph.character == capital) return glyph.dots;
    }
    return box;
}

}  // namespace

std::uint32_t text_width(std::string_view text) {
    return text.empty() ? 0 : static_cast<std::uint32_t>(text.size()) * advance - 1;
}

void draw_text(Image& picture, std::int64_t x, std::int64_t y, std::uint32_t scale, vec3 colour,
               std::string_view text) {
    CHECK(picture.channels >= 3 && scale >= 1, "{} channels, scale {}", picture.channels, scale);
    for (std::size_t k = 0; k < text.size(); ++k) {
        const std::string_view dots = dots_of(text[k]);
        for (std::uint32_t dy = 0; dy < text_height * scale; ++dy) {
            for (std::uint32_t dx = 0; dx < glyph_width * scale; ++dx) {
                const std::int64_t px = x + static_cast<std::int64_t>(k * advance * scale + dx), py = y + dy;
                if (dots[(dy / scale) * glyph_width + dx / scale] != '#') continue;
                if (px < 0 || py < 0 || px >= picture.width || py >= picture.height) continue;
                float* pixel = picture.pixel(static_cast<std::uint32_t>(px), static_cast<std::uint32_t>(py));
                for (int c = 0; c < 3; ++c) pixel[c] = colour[c];
            }
        }
    }
}

}  // namespace sl
