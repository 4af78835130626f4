// SPDX-License-Identifier: MIT
// The sources of a picture, read from the caller's arrays and handles.
#pragma once

#include "picture/handles.h"
#include "picture/shape.h"

#include <hrbfnpr.h>

#include <optional>

namespace hrbfnpr::picture {

// One of: a shape, a model (perhaps with its marks), or a point set.
struct Source {
    explicit Source(Pool& pool) : name(&pool) {}

    String name; // for titles; may be empty
    std::optional<Shape> shape;
    Model model;
    PointSet marks;
};

// Reads and checks one.  Throws Error{invalid_argument} that names its field.
[[nodiscard]] Source read_source(const hrbfnpr_picture_source* given, Pool& pool);
// Reads and checks a list.  Throws Error{invalid_argument} that names the element.
[[nodiscard]] Vector<Source> read_sources(const hrbfnpr_picture_desc& desc, Pool& pool);

} // namespace hrbfnpr::picture
