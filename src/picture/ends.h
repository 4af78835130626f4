// SPDX-License-Identifier: MIT
// Trims a fitted surface to where its samples end.
#pragma once

#include "picture/call.h"
#include "picture/nearness.h"

namespace hrbfnpr::picture {

// Returns the model without the surface beyond the places. `desc` has everything but its points. `of` names the source
// of the places: "points" or "mesh". If no end is found, this warns and returns the model itself.
[[nodiscard]] Model ended_by(const Call& call, const Model& model, const Points& places, const char* of,
                             const hrbfnpr_trim_desc& desc);

// Returns the model without the surface beyond the shape's points. `hole` is the known size of gaps between points with
// normals, in the points' unit, or nullopt.
[[nodiscard]] Model end_of_points(const Call& call, const Model& model, const Shape& shape, std::optional<double> hole);

[[nodiscard]] hrbfnpr_trim_info trim_info_of(const Model& model);
// Describes in words how much of the surface was left out.
[[nodiscard]] String trim_in_words(const Call& call, const Model& model, const char* of);

} // namespace hrbfnpr::picture
