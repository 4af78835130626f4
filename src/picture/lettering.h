// SPDX-License-Identifier: MIT
// Letters as strokes: figures of images have the same pixels whatever fonts a machine has.
#pragma once

#include "picture/cut_faces.h"

#include <string_view>

namespace hrbfnpr::picture {

// Widths and lengths are in units of `capitals`, the height of capital letters.  Text is UTF-8.  It has digits, letters
// without accents, the micro sign and some punctuation; any other character is a box.

// How far a text goes.
[[nodiscard]] double width_of_text(std::string_view text, double capitals) noexcept;
// Half the width of its strokes.
[[nodiscard]] double text_stroke_radius(double capitals) noexcept;
// Its strokes; a dot is a segment without length.  begin: where the baseline begins.  y grows downward.
[[nodiscard]] Vector<Segment> strokes_of_text(std::string_view text, const glm::dvec2& begin, double capitals,
                                              Pool& pool);

} // namespace hrbfnpr::picture
