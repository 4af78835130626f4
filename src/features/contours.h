// SPDX-License-Identifier: MIT
// The contours of a line set for one eye, part by part. The eye may be that of a camera, or a light.
#pragma once

#include "curves/curve_changes.h"
#include "curves/trace.h"
#include "features/line_set.h"
#include "features/tuning.h"

namespace hrbfnpr::curves {

// The surface of a line set, or the smooth part of it with the given index.
struct SmoothPart {
    const LineSet& lines;
    std::int64_t part;

    [[nodiscard]] const implicit::Implicit& surface() const noexcept {
        return lines.parts().empty() ? lines.surface() : lines.parts()[part]->surface;
    }
    [[nodiscard]] const SurfaceMesh& mesh() const noexcept {
        return lines.parts().empty() ? lines.mesh() : lines.parts()[part]->mesh;
    }
};
[[nodiscard]] inline std::int64_t smooth_parts_of(const LineSet& lines) noexcept {
    return std::max<std::int64_t>(1, lines.parts().size());
}

// Returns View::eye for an eye in the coordinates of a line set: a place (w = 1, or another number), or the direction
// of all lines of sight (w = 0). An eye that is very far away becomes a direction.
[[nodiscard]] glm::dvec4 eye_for(const LineSet& lines, const glm::dvec4& eye) noexcept;

// Calls trace(work, part) for the smooth parts of a line set. Large parts are traced one after another, each by all
// threads. Small parts have too little work for that, and each is traced by one thread. prepare(part) is called for all
// parts in order, each before it is traced.
template <class Prepare, class Trace>
void trace_parts(const base::Work& work, const LineSet& lines, Prepare&& prepare, Trace&& trace) {
    base::Array<std::int64_t> small(work.memory);
    for (std::int64_t p = 0; p < smooth_parts_of(lines); ++p) {
        prepare(p);
        if (SmoothPart{lines, p}.mesh().triangles() < feature_tuning.small_part)
            small.push_back(p);
        else
            trace(work.without_progress(), p);
    }
    const base::Runtime one_thread(work, base::Parallel());
    lines.surface().threads(work).for_each(small.size(), [&](std::int64_t i) {
        trace(base::Work{one_thread, work.without_progress()}, small[i]);
    });
}

} // namespace hrbfnpr::curves
