// SPDX-License-Identifier: MIT
// Where a fitted surface ends: where what it was fitted to does.
#pragma once

#include "picture/call.h"
#include "picture/nearness.h"

namespace hrbfnpr::picture {

// The model with what lies beyond the places left out. desc: all but its points. of: what the places belong to,
// "points" or "mesh". It is the model itself, with a warning, where no end is found.
[[nodiscard]] Model ended_by(const Call& call, const Model& model, const Points& places, const char* of,
                             const hrbfnpr_trim_desc& desc);

// The model with what lies beyond the points of the shape left out. hole: how large gaps between points with normals
// are known to be, in their unit, if that is known.
[[nodiscard]] Model end_of_points(const Call& call, const Model& model, const Shape& shape, std::optional<double> hole);

[[nodiscard]] hrbfnpr_trim_info trim_info_of(const Model& model);
// What was left out, in words.
[[nodiscard]] String trim_in_words(const Call& call, const Model& model, const char* of);

} // namespace hrbfnpr::picture
