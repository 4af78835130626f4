// SPDX-License-Identifier: MIT
// Curves whose visibility is asked for, and surfaces that hide them.
#pragma once

#include "curves/curves.h"
#include "curves/level.h"
#include "curves/sheet_count.h"
#include "curves/view.h"

#include <cstdint>

namespace hrbfnpr::visibility {

// Subject::clear of creases, which are known as well as sheets are: beside their ends the sheet that hides them is
// near.
inline constexpr double clear_of_creases = 1e-3;

// A surface.
struct Occluder {
    const curves::SheetCounter* sheets = nullptr;
    const implicit::Implicit* surface = nullptr;
    glm::dmat4 to_world{1.0}; // affine
    glm::dvec4 eye{0.0};      // curves::View::eye, in its own coordinates
};

// Curves on one surface.
struct Subject {
    const curves::Curves* curves = nullptr;
    const curves::Level* level = nullptr; // whose zero lines they are; null: polylines as they are
    curves::View view;
    double side = 0.0;        // of its mesh's cells: its unit of length
    double clear = 0.02;      // in sides: surface so near before a place of a curve does not hide it
    glm::dmat4 to_world{1.0}; // affine
    std::int32_t item = 0;    // of its surface among the occluders
    std::int32_t sheets = 2;  // that begin or end at these curves: 2 of a contour or of a crease
                              // that is one, 1 of a border, 0 of other lines
    bool mirrored = false;    // the image shows its surface mirrored
    bool joined = false;      // open curves end at others, as at the corners of a crease
};

} // namespace hrbfnpr::visibility
