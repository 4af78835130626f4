// SPDX-License-Identifier: MIT
// How strokes are wanted.
#pragma once

#include "marks/direction_function.h"

namespace hrbfnpr::strokes {

// In object units.
struct Settings {
    double separation = 0.0; // 0 = such that all strokes have about the budget's marks
    double step = 0.0;       // 0 = a part of the separation
    double longest = 0.0;    // 0 = no limit
    marks::Symmetry symmetry = marks::Symmetry::cross;
    marks::DirectionFunction direction; // of FIELD
};

} // namespace hrbfnpr::strokes
