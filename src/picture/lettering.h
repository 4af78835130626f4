// SPDX-License-Identifier: MIT
// Draws letters as strokes, so that images have the same pixels on all machines, whatever fonts they have.
#pragma once

#include "picture/cut_faces.h"

#include <string_view>

namespace hrbfnpr::picture {

// `capitals` is the height of capital letters. All lengths have the unit of `capitals`. Texts are UTF-8. Glyphs exist
// for digits, letters without accents, the micro sign and some punctuation. Any other character is drawn as a box.

// Returns the width of a text.
[[nodiscard]] double width_of_text(std::string_view text, double capitals) noexcept;
// Returns half the width of the strokes.
[[nodiscard]] double text_stroke_radius(double capitals) noexcept;
// Returns the strokes of a text. A dot is a segment with no length. The baseline starts at `begin`, and y grows
// downward.
[[nodiscard]] Vector<Segment> strokes_of_text(std::string_view text, const glm::dvec2& begin, double capitals,
                                              Pool& pool);

} // namespace hrbfnpr::picture
