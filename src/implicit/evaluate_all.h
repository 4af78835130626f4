// SPDX-License-Identifier: MIT
// Many points at once: on all threads, and cell by cell where the implicit has cells.
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"

namespace hrbfnpr::implicit {

// Which of the points comes first, second, ...: cell by cell.  Empty: in their own order, as there are no cells.
[[nodiscard]] base::Array<std::int32_t> order_by_cell(const base::Work& work, const Implicit& implicit,
                                                      const geometry::VecArray& points);

// Fields are as long as there are points.
void evaluate_all(const base::Work& work, const Implicit& implicit, const geometry::VecArray& points,
                  const FieldBatch& fields);

} // namespace hrbfnpr::implicit
