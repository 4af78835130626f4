// SPDX-License-Identifier: MIT
// Tells whether a picture is mostly blank, and why.
#pragma once

#include "picture/handles.h"
#include "picture/memory.h"

#include "geometry/vec.h"

#include <optional>

namespace hrbfnpr::picture {

struct Blank {
    std::int64_t shown; // The number of marks that are shown.
    std::int64_t marks; // The number of marks of all items.
    double ink;         // The share of the picture that differs from the paper.
    String text;        // The reason and the remedy, in the notation that in_words() takes.
};

// Returns the share of the picture that differs from the paper if almost nothing of a drawing can be seen, or nullopt
// if enough can be seen. `camera` and `style` belong to the drawing.
[[nodiscard]] std::optional<double> find_blank(const Drawing& drawing, const hrbfnpr_camera& camera,
                                               const hrbfnpr_style& style, Pool& pool);

// Tells why a drawing is nearly blank. The drawing should have all marks, not only those that it needs. `ink` is the
// share of the picture that differs from the paper. `bounds` is the box of everything that is drawn. `is_flipped` is
// true if the caller asked to turn all normals.
[[nodiscard]] Blank why_blank(const Drawing& drawing, double ink, const geometry::Bounds& bounds,
                              const hrbfnpr_camera& camera, const hrbfnpr_style& style, bool is_flipped, Pool& pool);

} // namespace hrbfnpr::picture
