// SPDX-License-Identifier: MIT
// Parts of lines within a frame.
#pragma once

#include "base/memory.h"
#include "output/vector/page.h"

#include <utility>

namespace hrbfnpr::output {

class Clip {
public:
    explicit Clip(base::Memory& memory) noexcept : ring_(memory), part_(memory) {}

    // Calls take(PagePath) for each part of the path's centre within the frame, in its order.  Where it is cut its end
    // is flat.  A closed path is open if anything is cut off.
    template <class Take>
    void parts(const PagePath& path, const Frame& frame, Take&& take);

private:
    // The part of a segment, from 0 to 1; false: none.  A segment that is no number is beyond any frame.
    [[nodiscard]] static bool within(const PagePoint& a, const PagePoint& b, const Frame& frame, double& from,
                                     double& to) noexcept;
    // The points of a closed path, from one beyond the frame.
    [[nodiscard]] std::span<const PagePoint> turned(const PagePath& path, const Frame& frame);

    base::Array<PagePoint> ring_;
    base::Array<PagePoint> part_;
};

template <class Take>
void Clip::parts(const PagePath& path, const Frame& frame, Take&& take) {
    bool whole = true;
    for (const PagePoint& p : path.points) whole = whole && frame.contains(p.x, p.y);
    if (whole) {
        take(path);
        return;
    }
    const std::span<const PagePoint> points = path.closed ? turned(path, frame) : path.points;
    PagePath part = path;
    part.closed = false;
    const auto emit = [&](drawing::Cap end) {
        part.points = part_.span();
        part.end = end;
        if (part_.size() > 1) take(std::as_const(part));
        part_.clear();
    };
    part_.clear();
    for (std::size_t i = 1; i < points.size(); ++i) {
        const PagePoint& a = points[i - 1];
        const PagePoint& b = points[i];
        double from = 0.0, to = 1.0;
        if (!within(a, b, frame, from, to)) {
            emit(drawing::Cap::flat);
            continue;
        }
        const auto at = [&](double t) {
            return PagePoint{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.radius + t * (b.radius - a.radius)};
        };
        if (part_.empty() || from > 0.0) {
            emit(drawing::Cap::flat);
            part.begin = i == 1 && from <= 0.0 && !path.closed ? path.begin : drawing::Cap::flat;
            part_.push_back(from > 0.0 ? at(from) : a);
        }
        part_.push_back(to < 1.0 ? at(to) : b);
        if (to < 1.0) emit(drawing::Cap::flat);
    }
    emit(path.closed ? drawing::Cap::flat : path.end);
}

} // namespace hrbfnpr::output
