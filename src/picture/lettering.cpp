// SPDX-License-Identifier: MIT
#include "picture/lettering.h"

#include "picture/tuning_lines.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace hrbfnpr::picture {
namespace {

// The strokes of a letter on a grid. The side of a grid square is an eighth of a capital's height. Blanks separate the
// strokes. Each point of a stroke is two characters: its column as a digit and its row as a letter. Row c is the
// baseline, i the height of small letters, k the height of capitals, and a the bottom of small letters that reach below
// the baseline.
struct Glyph {
    char32_t character;
    int width;        // in columns of the grid
    char strokes[40]; // The text is in an array, because a table of pointers would need relocation.
};

constexpr double rows_of_capital = 8.0;
constexpr double gap_of_glyphs = 3.0; // The gap between two letters in columns. Half of it is on each side of a letter.
constexpr char baseline_row = 'c';
constexpr char32_t greek_mu = 0x3BC;
constexpr char32_t micro_sign = 0xB5;

constexpr std::array<Glyph, 75> glyphs{
    Glyph{U' ', 1, ""},
    Glyph{U'"', 2, "0k0i 2k2i"},
    Glyph{U'\'', 0, "0k0i"},
    Glyph{U'(', 1, "1k0i0d1b"},
    Glyph{U')', 1, "0k1i1d0b"},
    Glyph{U'+', 4, "0f4f 2h2d"},
    Glyph{U',', 1, "1c0a"},
    Glyph{U'-', 3, "0f3f"},
    Glyph{U'.', 0, "0c0c"},
    Glyph{U'/', 4, "0b4k"},
    Glyph{U'0', 5, "1c4c5e5i4k1k0i0e1c"},
    Glyph{U'1', 5, "1i3k3c 1c5c"},
    Glyph{U'2', 5, "0i1k4k5i5g0c5c"},
    Glyph{U'3', 5, "0j1k4k5j5h4g2g 4g5f5d4c1c0d"},
    Glyph{U'4', 5, "4c4k0e5e"},
    Glyph{U'5', 5, "5k0k0g1h4h5f5d4c1c0d"},
    Glyph{U'6', 5, "5j4k2k0h0d1c4c5d5f4g1g0f"},
    Glyph{U'7', 5, "0k5k2c"},
    Glyph{U'8', 5, "1g0h0j1k4k5j5h4g1g0f0d1c4c5d5f4g"},
    Glyph{U'9', 5, "0d1c3c5f5j4k1k0j0h1g4g5h"},
    Glyph{U':', 0, "0h0h 0d0d"},
    Glyph{U'A', 6, "0c3k6c 1f5f"},
    Glyph{U'B', 5, "0c0k4k5j5h4g0g 4g5f5d4c0c"},
    Glyph{U'C', 5, "5j4k1k0i0e1c4c5d"},
    Glyph{U'D', 5, "0c0k3k5i5e3c0c"},
    Glyph{U'E', 5, "5k0k0c5c 0g4g"},
    Glyph{U'F', 5, "5k0k0c 0g4g"},
    Glyph{U'G', 5, "5j4k1k0i0e1c4c5e5g3g"},
    Glyph{U'H', 5, "0c0k 5c5k 0g5g"},
    Glyph{U'I', 0, "0c0k"},
    Glyph{U'J', 3, "3k3e2c1c0d"},
    Glyph{U'K', 5, "0c0k 5k0f 2h5c"},
    Glyph{U'L', 4, "0k0c4c"},
    Glyph{U'M', 6, "0c0k3e6k6c"},
    Glyph{U'N', 5, "0c0k5c5k"},
    Glyph{U'O', 6, "2c4c6e6i4k2k0i0e2c"},
    Glyph{U'P', 5, "0c0k4k5j5h4g0g"},
    Glyph{U'Q', 6, "2c4c6e6i4k2k0i0e2c 4e6b"},
    Glyph{U'R', 5, "0c0k4k5j5h4g0g 3g5c"},
    Glyph{U'S', 5, "5j4k1k0j0h1g4g5f5d4c1c0d"},
    Glyph{U'T', 6, "0k6k 3k3c"},
    Glyph{U'U', 5, "0k0e1c4c5e5k"},
    Glyph{U'V', 6, "0k3c6k"},
    Glyph{U'W', 8, "0k2c4k6c8k"},
    Glyph{U'X', 5, "0c5k 0k5c"},
    Glyph{U'Y', 6, "0k3g6k 3g3c"},
    Glyph{U'Z', 5, "0k5k0c5c"},
    Glyph{U'_', 5, "0b5b"},
    Glyph{U'a', 4, "0h1i3i4h4c 4f1f0e0d1c3c4d"},
    Glyph{U'b', 4, "0k0c 0h1i3i4h4d3c1c0d"},
    Glyph{U'c', 4, "4h3i1i0h0d1c3c4d"},
    Glyph{U'd', 4, "4k4c 4h3i1i0h0d1c3c4d"},
    Glyph{U'e', 4, "0f4f4h3i1i0h0d1c3c4d"},
    Glyph{U'f', 3, "3k2k1j1c 0i3i"},
    Glyph{U'g', 4, "4i4b3a1a0b 4h3i1i0h0d1c3c4d"},
    Glyph{U'h', 4, "0k0c 0h1i3i4h4c"},
    Glyph{U'i', 0, "0i0c 0k0k"},
    Glyph{U'j', 1, "1i1b0a 1k1k"},
    Glyph{U'k', 4, "0k0c 4i0e 1f4c"},
    Glyph{U'l', 0, "0k0c"},
    Glyph{U'm', 6, "0i0c 0h1i2i3h3c 3h4i5i6h6c"},
    Glyph{U'n', 4, "0i0c 0h1i3i4h4c"},
    Glyph{U'o', 4, "1c3c4d4h3i1i0h0d1c"},
    Glyph{U'p', 4, "0i0a 0h1i3i4h4d3c1c0d"},
    Glyph{U'q', 4, "4i4a 4h3i1i0h0d1c3c4d"},
    Glyph{U'r', 3, "0i0c 0g2i3i"},
    Glyph{U's', 4, "4h3i1i0h0g1f3f4e4d3c1c0d"},
    Glyph{U't', 3, "1k1d2c3c 0i3i"},
    Glyph{U'u', 4, "0i0d1c3c4d 4i4c"},
    Glyph{U'v', 4, "0i2c4i"},
    Glyph{U'w', 6, "0i1c3h5c6i"},
    Glyph{U'x', 4, "0i4c 0c4i"},
    Glyph{U'y', 4, "0i2c 4i2c1a0a"},
    Glyph{U'z', 4, "0i4i0c4c"},
    Glyph{micro_sign, 4, "0i0a 0d1c3c4d 4i4c"},
};
static_assert(std::is_sorted(glyphs.begin(), glyphs.end(),
                             [](const Glyph& a, const Glyph& b) { return a.character < b.character; }));

constexpr Glyph unknown_glyph{0, 5, "0c5c5k0k0c"};

const Glyph& glyph_of(char32_t character) noexcept {
    const char32_t known = character == greek_mu ? micro_sign : character;
    const auto* const found = std::lower_bound(glyphs.begin(), glyphs.end(), known,
                                               [](const Glyph& a, char32_t b) { return a.character < b; });
    return found != glyphs.end() && found->character == known ? *found : unknown_glyph;
}

// Returns the first character of a text, and removes it from the text. Returns 0, which has no glyph, for bytes that
// are not UTF-8.
char32_t take_character(std::string_view& text) noexcept {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    const std::uint8_t lead = byte(0);
    const std::size_t more = lead >= 0xF0 ? 3U : lead >= 0xE0 ? 2U : lead >= 0xC0 ? 1U : 0U;
    char32_t character = more == 0 ? lead : lead & (0x3FU >> more);
    if (more == 0 && lead >= 0x80) character = 0;
    std::size_t size = 1;
    for (; size <= more && size < text.size() && (byte(size) & 0xC0U) == 0x80; ++size)
        character = character << 6U | (byte(size) & 0x3FU);
    if (size != more + 1) character = 0;
    text.remove_prefix(size);
    return character;
}

double width_of_glyph(const Glyph& glyph) noexcept { return static_cast<double>(glyph.width) + gap_of_glyphs; }

// Returns the side length of a grid square. Strokes extend past the grid by half their width, so the grid of a capital
// is smaller than the capital by one stroke width.
double square_of_grid(double capitals) noexcept {
    return (1.0 - lettering_tuning.stroke_width) * capitals / rows_of_capital;
}

} // namespace

double width_of_text(std::string_view text, double capitals) noexcept {
    double columns = 0.0;
    while (!text.empty()) columns += width_of_glyph(glyph_of(take_character(text)));
    return columns * square_of_grid(capitals);
}

double text_stroke_radius(double capitals) noexcept { return 0.5 * lettering_tuning.stroke_width * capitals; }

Vector<Segment> strokes_of_text(std::string_view text, const glm::dvec2& begin, double capitals, Pool& pool) {
    const double square = square_of_grid(capitals);
    const glm::dvec2 origin = begin - glm::dvec2(0.0, text_stroke_radius(capitals));
    Vector<Segment> strokes(&pool);
    double column = 0.5 * gap_of_glyphs;
    while (!text.empty()) {
        const Glyph& glyph = glyph_of(take_character(text));
        const auto place = [&](std::size_t i) {
            return origin + square * glm::dvec2(column + static_cast<double>(glyph.strokes[i] - '0'),
                                                static_cast<double>(baseline_row - glyph.strokes[i + 1]));
        };
        const std::size_t size = std::string_view(glyph.strokes).size();
        for (std::size_t i = 0; i + 3 < size; i += 2) {
            if (glyph.strokes[i + 2] == ' ') { // A blank ends the stroke.
                ++i;
                continue;
            }
            strokes.push_back({place(i), place(i + 2)});
        }
        column += width_of_glyph(glyph);
    }
    return strokes;
}

} // namespace hrbfnpr::picture
