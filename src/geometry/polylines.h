// SPDX-License-Identifier: MIT
// Polylines: lengths along them, thinning by a tolerance, chains of lines whose ends meet, Bezier curves through them.
#pragma once

#include "base/assert.h"
#include "base/memory.h"
#include "geometry/segment.h"
#include "geometry/vec.h"

#include <cstdint>
#include <span>

namespace hrbfnpr::geometry {

// Returns the length of a polyline, where place(point) is a point's position vector.
template <class Point, class Place>
[[nodiscard]] auto length_along(std::span<Point> points, const Place& place) noexcept {
    decltype(glm::distance(place(points[0]), place(points[0]))) sum = 0;
    for (std::size_t i = 1; i < points.size(); ++i) sum += glm::distance(place(points[i - 1]), place(points[i]));
    return sum;
}

// Thinning takes time quadratic in the number of points where all are kept, so longer lines are thinned in parts of
// this many points.
inline constexpr std::int64_t simplified_together = 1024;

// Sets keeps[i] to 1 for the points to keep, and to 0 for the others. The kept points are chosen so that no part of the
// line is farther than the tolerance from the segment that replaces it. Both ends are kept. [Douglas and Peucker 1973,
// "Algorithms for the reduction of the number of points required to represent a digitized line or its caricature"]
template <class V>
void simplify_polyline(std::span<const V> points, typename V::value_type tolerance, base::Array<std::uint8_t>& keeps) {
    const auto count = static_cast<std::int64_t>(points.size());
    HRBFNPR_ASSERT(tolerance >= 0 && count > 0);
    const V* const at = points.data();
    keeps.clear();
    keeps.resize(count);
    keeps[0] = 1;
    // The shorter part is split by recursion and the longer one in this loop, so that the depth is at most logarithmic.
    const auto split = [&](const auto& self, std::int64_t first, std::int64_t last) -> void {
        for (;;) {
            auto most = tolerance * tolerance;
            std::int64_t farthest = -1;
            for (std::int64_t i = first + 1; i < last; ++i)
                if (const auto square = squared_distance_to_segment(at[i], at[first], at[last]); square > most) {
                    most = square;
                    farthest = i;
                }
            if (farthest < 0) return;
            keeps[farthest] = 1;
            if (farthest - first < last - farthest) {
                self(self, first, farthest);
                first = farthest;
            } else {
                self(self, farthest, last);
                last = farthest;
            }
        }
    };
    for (std::int64_t first = 0; first < count - 1; first += simplified_together) {
        const std::int64_t last = first + simplified_together < count - 1 ? first + simplified_together : count - 1;
        keeps[last] = 1;
        split(split, first, last);
    }
}

// Follows chains of lines from end to end. Line i begins at end 2 i and finishes at end 2 i + 1. partner[end] is the
// end of the line that continues the chain, or -1. For each line of a chain it calls enter(end) with the end at which
// the chain enters the line, and after the chain leave(closed). Open chains come first, in the order of their first
// lines, then closed ones.
template <class Enter, class Leave>
void follow_chains(const base::Array<std::int32_t>& partner, Enter&& enter, Leave&& leave) {
    HRBFNPR_ASSERT(partner.size() % 2 == 0);
    const auto ends = static_cast<std::int32_t>(partner.size());
    base::Array<std::uint8_t> done(partner.memory(), ends / 2);
    for (const bool rings : {false, true})
        for (std::int32_t start = 0; start < ends; ++start) {
            if (done[start / 2] != 0 || (!rings && partner[start] >= 0)) continue;
            std::int32_t end = start;
            while (end >= 0 && done[end / 2] == 0) {
                HRBFNPR_ASSERT(partner[end] < 0 || partner[partner[end]] == end);
                done[end / 2] = 1;
                enter(end);
                end = partner[end ^ 1];
            }
            leave(end >= 0);
        }
}

// A cubic Bezier curve that begins where the one before it ends.
struct Cubic {
    glm::dvec2 control_1, control_2, end;
};

[[nodiscard]] inline glm::dvec2 point_on_cubic(const glm::dvec2& start, const Cubic& c, double t) noexcept {
    const double s = 1.0 - t;
    return s * s * s * start + 3.0 * s * s * t * c.control_1 + 3.0 * s * t * t * c.control_2 + t * t * t * c.end;
}

// The tuning constants of CurveFit. scripts/bench vector measures their effects.
struct CurveFitTuning {
    // A line keeps a corner where it turns by more than the angle with this cosine, 40 degrees. Larger: more corners.
    double corner_cosine = 0.766;
    // The curve parameters of the points are improved if the squared error is below this factor times the squared
    // tolerance. Otherwise the run of points is halved at once. Larger: fewer curves, more time.
    double near_enough_to_improve = 16.0;
    // A curve is improved at most this often before its run is halved. Larger: fewer curves, more time.
    int improvements = 4;
    // The curve lies within this share of the tolerance at the measured points, since it may be farther off between
    // them. Larger: fewer curves, which may exceed the tolerance.
    double measured_share = 0.9;
    // Measured points are at most this many tolerances apart. Larger: fewer points are measured.
    double spacing = 16.0;
    // At most this many additional points are measured between two given points.
    double most_between = 64.0;
    // A run that is nested more deeply than this is halved in the middle, so that the depth is bounded.
    int deepest = 24;
};
inline constexpr CurveFitTuning curve_fit_tuning;

// Fits Bezier curves to points by least squares, and halves runs where the error is too large [Schneider 1990, "An
// algorithm for automatically fitting digitized curves", Graphics Gems]. The object keeps its working memory.
class CurveFit {
public:
    explicit CurveFit(base::Memory& memory) noexcept : points_(memory), parameters_(memory), cubics_(memory) {}

    // Fits curves to a polyline. Every point of the polyline is within the tolerance of the curves, and the curves'
    // ends are points of the polyline. The last point of a closed line equals its first, and the curves are smooth
    // there unless the line has a corner. The result is valid until the next call. It is empty if all points coincide.
    std::span<const Cubic> fit(std::span<const glm::dvec2> points, double tolerance, bool closed);

private:
    void densify(std::span<const glm::dvec2> points);
    void fit_run(std::int64_t first, std::int64_t last, const glm::dvec2& from, const glm::dvec2& to, int depth);
    [[nodiscard]] Cubic least_squares(std::int64_t first, std::int64_t last, const glm::dvec2& from,
                                      const glm::dvec2& to) const noexcept;
    [[nodiscard]] double farthest(std::int64_t first, std::int64_t last, const Cubic& cubic,
                                  std::int64_t& where) const noexcept;
    void set_parameters(std::int64_t first, std::int64_t last) noexcept;
    void improve_parameters(std::int64_t first, std::int64_t last, const Cubic& cubic) noexcept;
    [[nodiscard]] glm::dvec2 direction_from(std::int64_t end, std::int64_t other) const noexcept;
    [[nodiscard]] glm::dvec2 direction_at(std::int64_t i, std::int64_t first, std::int64_t last) const noexcept;
    [[nodiscard]] bool is_corner(std::int64_t before, std::int64_t i, std::int64_t after) const noexcept;

    double squared_tolerance_ = 0.0; // the squared tolerance at the measured points
    base::Array<glm::dvec2> points_;
    base::Array<double> parameters_; // the curve parameter of each point, from 0 to 1
    base::Array<Cubic> cubics_;
};

} // namespace hrbfnpr::geometry
