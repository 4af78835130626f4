// SPDX-License-Identifier: MIT
// Normals that tone goes by: of a rough surface, averaged over some of it, so that its grain is no form.
#pragma once

#include "marks/marks.h"

namespace hrbfnpr::marks {

// Averages over marks on the same side of creases whose normals agree, within twice the `length`, in object units;
// nearer ones count for more.  spacing: the root of the area for each mark.  result: 3 for each mark.
void soften_normals(const Site& site, const Marks& marks, double length, double spacing, base::Array<float>& result,
                    const base::Progress& progress);

} // namespace hrbfnpr::marks
