// SPDX-License-Identifier: MIT
#include "surface/creased.h"

#include "implicit/sheets.h"

namespace hrbfnpr::surface {

base::Array<std::int32_t> sheets_at(const base::Work& work, const implicit::Implicit& implicit,
                                    const geometry::VecArray& points) {
    const implicit::Sheets* const sheets = implicit.sheets();
    base::Array<std::int32_t> sheet(work.memory, sheets != nullptr ? points.size() : 0);
    if (sheets == nullptr) return sheet;
    const auto run = [&](std::int64_t begin, std::int64_t end) {
        work.check();
        sheets->active({points.x.data() + begin, points.y.data() + begin, points.z.data() + begin, end - begin},
                       sheet.data() + begin);
    };
    implicit.threads(work).for_chunks(points.size(), implicit::batch_size, run);
    return sheet;
}

} // namespace hrbfnpr::surface
