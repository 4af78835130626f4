// SPDX-License-Identifier: MIT
// Evaluates many points at once: on all threads, and cell by cell where the implicit has cells.
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"

namespace hrbfnpr::implicit {

// Returns the order in which points are evaluated, cell by cell. If there are no cells, the result is empty, and the
// points keep their order.
[[nodiscard]] base::Array<std::int32_t> order_by_cell(const base::Work& work, const Implicit& implicit,
                                                      const geometry::VecArray& points);

// Each field has one element for each point.
void evaluate_all(const base::Work& work, const Implicit& implicit, const geometry::VecArray& points,
                  const FieldBatch& fields);

} // namespace hrbfnpr::implicit
