// SPDX-License-Identifier: MIT
// Whether a picture is mostly blank, and why.
#pragma once

#include "picture/handles.h"
#include "picture/memory.h"

#include "geometry/vec.h"

#include <optional>

namespace hrbfnpr::picture {

struct Blank {
    std::int64_t shown; // marks
    std::int64_t marks; // of all items
    double ink;         // share of the picture that is not as the paper
    String text;        // why, and what to do about it, as in_words() takes it
};

// Tells why hardly anything can be seen of a drawing; nothing where enough can be.  bounds: the box of all that is
// drawn. camera and style: those of the drawing.  is_flipped: whether the caller had all normals turned.
[[nodiscard]] std::optional<Blank> why_blank(const Drawing& drawing, const geometry::Bounds& bounds,
                                             const hrbfnpr_camera& camera, const hrbfnpr_style& style, bool is_flipped,
                                             Pool& pool);

} // namespace hrbfnpr::picture
