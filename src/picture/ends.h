// SPDX-License-Identifier: MIT
// Ends a fitted surface where its samples end.
#pragma once

#include "picture/call.h"
#include "picture/nearness.h"

namespace hrbfnpr::picture {

// Returns the model, trimmed by hrbfnpr_model_trim to the surface that the places support. `desc` is complete except
// for its points. `of` names the source of the places: "points" or "mesh". If the end of the surface is not found, the
// function warns and returns the unchanged model.
[[nodiscard]] Model ended_by(const Call& call, const Model& model, const Points& places, const char* of,
                             const hrbfnpr_trim_desc& desc);

// Returns the model, trimmed to the surface that the points of the shape support. `hole` is hrbfnpr_trim_desc::hole in
// the unit of the points, for points with normals. If `hole` is nullopt, the default is used, and no normals are
// passed.
[[nodiscard]] Model end_of_points(const Call& call, const Model& model, const Shape& shape, std::optional<double> hole);

[[nodiscard]] hrbfnpr_trim_info trim_info_of(const Model& model);
// Describes in words how much surface was left out.
[[nodiscard]] String trim_in_words(const Call& call, const Model& model, const char* of);

} // namespace hrbfnpr::picture
