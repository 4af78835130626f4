// SPDX-License-Identifier: MIT
#include "picture/cut_faces.h"

#include "base/assert.h"
#include "base/status.h"
#include "picture/tuning_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

namespace hrbfnpr::picture {
namespace {

// ---- Outlines

double length_of_outline(const Outline& outline, std::size_t from) noexcept {
    double length = 0.0;
    for (std::size_t i = from + 1; i < outline.size(); ++i) length += glm::length(outline[i] - outline[i - 1]);
    return length;
}

// An outline to which parts are added at its end.
struct GrowingOutline {
    Outline points;
    double length;
    double share; // Ends meet if their distance is at most this share of the length.

    [[nodiscard]] bool meets(const glm::dvec2& a, const glm::dvec2& b) const noexcept {
        const double least = std::max(share * length, cut_faces_tuning.rounding);
        return glm::length(a - b) <= least && points.size() > 1;
    }
    [[nodiscard]] bool is_closed() const noexcept { return meets(points.back(), points.front()); }
    // Appends a part that continues this outline. If `turned` is true, the part's last point meets the end of the
    // outline, so the part is appended in reverse order. A point that coincides with the end of the outline is skipped.
    void append(const Outline& part, bool turned) {
        const std::size_t before = points.size();
        const double gap = glm::length((turned ? part.back() : part.front()) - points.back());
        const int skipped = gap <= std::max(cut_faces_tuning.closed * length, cut_faces_tuning.rounding) ? 1 : 0;
        if (turned)
            points.insert(points.end(), std::next(part.rbegin(), skipped), part.rend());
        else
            points.insert(points.end(), std::next(part.begin(), skipped), part.end());
        length += length_of_outline(points, before - 1);
    }
};

struct NearestEnd {
    std::size_t part = 0;
    bool turned = false; // True if the end found is the last point of the part.
};

// Finds the end, among all ends of the parts, that is nearest to a place.
NearestEnd nearest_end(const Vector<Outline>& parts, const glm::dvec2& place) noexcept {
    NearestEnd nearest;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < parts.size(); ++i) {
        for (const bool turned : {false, true}) {
            const double distance = glm::length((turned ? parts[i].back() : parts[i].front()) - place);
            if (!(distance < least)) continue;
            least = distance;
            nearest = {i, turned};
        }
    }
    return nearest;
}

// ---- Hatching

// A side of an outline, in coordinates along and across the hatch lines. On a hatch line, `across` is constant.
struct HatchSide {
    double across_from, across_to, along_from, along_to;
};

constexpr double root_half = 0.70710678118654746; // 1 / sqrt(2)
constexpr double farthest_place = 1e100;          // The lengths of sides with larger coordinates would overflow.

glm::dvec2 turned_by_45(const glm::dvec2& p) noexcept {
    return {p.x * root_half + p.y * root_half, p.x * root_half - p.y * root_half};
}

bool is_place(const glm::dvec2& p) noexcept { return std::abs(p.x) < farthest_place && std::abs(p.y) < farthest_place; }

Vector<HatchSide> sides_of_outlines(const Vector<Outline>& outlines, Pool& pool) {
    Vector<HatchSide> sides(&pool);
    for (const Outline& outline : outlines) {
        if (!std::all_of(outline.begin(), outline.end(), is_place)) continue;
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const glm::dvec2 from = turned_by_45(outline[i]);
            const glm::dvec2 to = turned_by_45(outline[(i + 1) % outline.size()]);
            sides.push_back({from.x, to.x, from.y, to.y});
        }
    }
    return sides;
}

} // namespace

Vector<Outline> closed_outlines(const Vector<Outline>& parts, Pool& pool) {
    return close_outlines(parts, cut_faces_tuning.closed, pool).closed;
}

ClosedOutlines close_outlines(const Vector<Outline>& parts, double share, Pool& pool) {
    Vector<Outline> rest(&pool);
    for (const Outline& part : parts)
        if (part.size() > 1) rest.push_back(part);
    ClosedOutlines found{Vector<Outline>(&pool), 0};
    while (!rest.empty()) {
        GrowingOutline outline{std::move(rest.back()), 0.0, share};
        rest.pop_back();
        outline.length = length_of_outline(outline.points, 0);
        while (!outline.is_closed() && !rest.empty()) {
            const NearestEnd nearest = nearest_end(rest, outline.points.back());
            const Outline& next = rest[nearest.part];
            if (!outline.meets(nearest.turned ? next.back() : next.front(), outline.points.back())) break;
            outline.append(next, nearest.turned);
            rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(nearest.part));
        }
        if (outline.points.size() > 3 && outline.is_closed())
            found.closed.push_back(std::move(outline.points));
        else
            ++found.open;
    }
    return found;
}

Vector<Segment> hatched(const Vector<Outline>& outlines, double period, Pool& pool) {
    HRBFNPR_ASSERT(period > 0.0);
    Vector<Segment> segments(&pool);
    const Vector<HatchSide> sides = sides_of_outlines(outlines, pool);
    if (sides.empty()) return segments;
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const HatchSide& side : sides) {
        least = std::min({least, side.across_from, side.across_to});
        most = std::max({most, side.across_from, side.across_to});
    }
    const double first = std::floor(least / period);
    const double last = std::ceil(most / period);
    if (!(last - first <= cut_faces_tuning.most_lines))
        fail(Status::invalid_argument, "hatch lines %g apart are too many for a section of size %g", period,
             most - least);
    Vector<double> places(&pool);
    const auto count = static_cast<std::int64_t>(last - first) + 1;
    for (std::int64_t i = 0; i < count; ++i) {
        const double level = (first + static_cast<double>(i) + 0.5) * period;
        places.clear();
        for (const HatchSide& side : sides) {
            if ((side.across_from <= level) == (side.across_to <= level)) continue;
            const double part = (level - side.across_from) / (side.across_to - side.across_from);
            places.push_back(side.along_from + part * (side.along_to - side.along_from));
        }
        std::sort(places.begin(), places.end());
        for (std::size_t k = 0; k + 1 < places.size(); k += 2)
            segments.push_back({turned_by_45({level, places[k]}), turned_by_45({level, places[k + 1]})});
    }
    return segments;
}

} // namespace hrbfnpr::picture
