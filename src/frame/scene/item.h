// SPDX-License-Identifier: MIT
// What a drawing is made of.
#pragma once

#include "base/view.h"
#include "features/line_set.h"
#include "frame/scene/style.h"
#include "implicit/implicit.h"
#include "marks/point_set.h"

#include <span>

namespace hrbfnpr::frame {

// Where the marks of one layer are in this drawing; views of as many elements as it has marks.
struct Pose {
    std::int64_t layer = 0;
    base::InView position;  // absolute
    base::InView normal;    // unit
    base::InView direction; // unit; or empty
};

struct Item {
    const marks::PointSet* set = nullptr;
    const implicit::Implicit* model = nullptr; // if not, visibility is exact
    Style style;
    glm::dmat4 transform{1.0};
    std::span<const Pose> poses; // whoever made it keeps them
    const curves::LineSet* lines = nullptr;
    bool both_sides = false; // marks are drawn on the inside of the surface, too
};

} // namespace hrbfnpr::frame
