// SPDX-License-Identifier: MIT
// Ends a fitted surface where its samples end.
#pragma once

#include "picture/call.h"
#include "picture/nearness.h"

namespace hrbfnpr::picture {

// Returns the model without the surface that is beyond the places. `desc` is complete except for its points. `of` names
// the source of the places: "points" or "mesh". If no end is found, it warns and returns the unchanged model.
[[nodiscard]] Model ended_by(const Call& call, const Model& model, const Points& places, const char* of,
                             const hrbfnpr_trim_desc& desc);

// Returns the model without the surface that is beyond the points of the shape. `hole` is the size of gaps between
// points with normals, in the points' unit, or nullopt if it is unknown.
[[nodiscard]] Model end_of_points(const Call& call, const Model& model, const Shape& shape, std::optional<double> hole);

[[nodiscard]] hrbfnpr_trim_info trim_info_of(const Model& model);
// Describes in words how much surface was left out.
[[nodiscard]] String trim_in_words(const Call& call, const Model& model, const char* of);

} // namespace hrbfnpr::picture
