// SPDX-License-Identifier: MIT
// Evaluates many points on all threads, cell by cell if the implicit function has cells.
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"

namespace hrbfnpr::implicit {

// Returns the order in which points are evaluated, cell by cell. The result is empty if the implicit function has no
// cells; then points are evaluated in the given order.
[[nodiscard]] base::Array<std::int32_t> order_by_cell(const base::Work& work, const Implicit& implicit,
                                                      const geometry::VecArray& points);

// Evaluates the implicit function at all points. Each array in `fields` has one element for each point.
void evaluate_all(const base::Work& work, const Implicit& implicit, const geometry::VecArray& points,
                  const FieldBatch& fields);

} // namespace hrbfnpr::implicit
