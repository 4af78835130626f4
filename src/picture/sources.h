// SPDX-License-Identifier: MIT
// Reads the sources of a picture from the caller's arrays and handles.
#pragma once

#include "picture/handles.h"
#include "picture/shape.h"
#include "picture/source_fields.h"

#include <hrbfnpr.h>

#include <optional>

namespace hrbfnpr::picture {

// A source: a shape, a model (possibly with marks), or a point set.
struct Source {
    explicit Source(Pool& pool) : name(&pool), values(pool) {}

    String name; // The name, for titles. It may be empty.
    std::optional<Shape> shape;
    Model model;
    PointSet marks;
    SourceValues values; // the values of the shape's points
};

// Reads and checks a source. Throws Error{invalid_argument} that names the wrong field.
[[nodiscard]] Source read_source(const hrbfnpr_picture_source* given, Pool& pool);
// Reads and checks a list of sources. Throws Error{invalid_argument} that names the wrong element.
[[nodiscard]] Vector<Source> read_sources(const hrbfnpr_picture_desc& desc, Pool& pool);

} // namespace hrbfnpr::picture
