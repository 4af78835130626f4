// What a frame is asked to draw.
#pragma once

#include "frame/scene/style.h"
#include "implicit/implicit.h"
#include "marks/point_set.h"

namespace hrbfnpr::frame {

struct Item {
    const marks::PointSet* set = nullptr;
    const implicit::Implicit* model = nullptr; // if not, visibility is exact
    Style style;
    glm::dmat4 transform{1.0};
};

} // namespace hrbfnpr::frame
