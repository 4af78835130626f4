// SPDX-License-Identifier: MIT
#include "picture/strays.h"

#include "base/assert.h"
#include "geometry/vec.h"
#include "picture/statistics.h"
#include "picture/tuning_points.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::picture {
namespace {

bool is_finite_point(const glm::dvec3& p) noexcept {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

std::int64_t count_in(const PointMask& mask) noexcept { return std::count(mask.begin(), mask.end(), std::uint8_t{1}); }

PointMask without_those(const PointMask& mask, Pool& pool) {
    PointMask kept(mask.size(), 0, &pool);
    std::transform(mask.begin(), mask.end(), kept.begin(),
                   [](std::uint8_t out) { return static_cast<std::uint8_t>(1 - out); });
    return kept;
}

template <class T>
void keep_elements(Vector<T>& elements, const PointMask& kept) noexcept {
    std::size_t to = 0;
    for (std::size_t i = 0; i < elements.size(); ++i)
        if (kept[i] != 0) elements[to++] = elements[i];
    elements.erase(elements.begin() + static_cast<std::ptrdiff_t>(to), elements.end());
}

// Returns whether all points of a face or an edge are kept.
template <class Numbers>
bool has_all(const Numbers& numbers, const PointMask& kept) noexcept {
    return std::all_of(numbers.begin(), numbers.end(), [&](std::int64_t i) {
        HRBFNPR_ASSERT(i >= 0 && i < static_cast<std::int64_t>(kept.size()));
        return kept[static_cast<std::size_t>(i)] != 0;
    });
}

// Keeps the faces or edges whose points are all kept. Replaces the indices of their points by the new indices.
template <class Numbers>
void keep_joined(Vector<Numbers>& joined, const PointMask& kept, const Vector<std::int64_t>& number) noexcept {
    joined.erase(
        std::remove_if(joined.begin(), joined.end(), [&](const Numbers& each) { return !has_all(each, kept); }),
        joined.end());
    for (Numbers& each : joined)
        for (std::int64_t& i : each) i = number[static_cast<std::size_t>(i)];
}

PointMask points_at(const Points& points, double value, Pool& pool) {
    PointMask at(points.size(), 0, &pool);
    for (std::size_t i = 0; i < points.size(); ++i)
        at[i] = points[i].x == value || points[i].y == value || points[i].z == value ? 1 : 0;
    return at;
}

// Returns whether a value is below the coordinates of all other points, by more than the extent of these points.
bool is_far_below(double value, const Points& points, const PointMask& at_it) noexcept {
    geometry::Bounds rest;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (at_it[i] == 0 && is_finite_point(points[i])) rest.extend(points[i]);
    if (rest.empty()) return false;
    const double least = std::min(std::min(rest.min.x, rest.min.y), rest.min.z);
    return least - value >= rest.longest_side();
}

} // namespace

bool keep_points(Shape& shape, const PointMask& kept, Pool& pool) {
    HRBFNPR_ASSERT(kept.size() == shape.points.size());
    const bool is_mesh = shape.is_mesh();
    const auto stays = [&](const Triangle& face) { return has_all(face, kept); };
    if (is_mesh && std::none_of(shape.triangles.begin(), shape.triangles.end(), stays)) return false;
    if (is_mesh) {
        Vector<std::int64_t> number(kept.size(), 0, &pool);
        std::int64_t next = 0;
        for (std::size_t i = 0; i < kept.size(); ++i) number[i] = kept[i] != 0 ? next++ : -1;
        keep_joined(shape.triangles, kept, number);
        keep_joined(shape.sharp_edges, kept, number);
    } else {
        shape.columns = shape.rows = 0; // Without some of its points, an image is only a set of points.
    }
    keep_elements(shape.points, kept);
    if (!shape.normals.empty()) keep_elements(shape.normals, kept);
    return true;
}

NoData leave_out_no_data(Shape& shape, Pool& pool) {
    const auto all = static_cast<std::int64_t>(shape.points.size());
    for (const double value : strays_tuning.no_data) {
        const PointMask at_it = points_at(shape.points, value, pool);
        const std::int64_t count = count_in(at_it);
        if (count == 0 || count == all || !is_far_below(value, shape.points, at_it)) continue;
        if (keep_points(shape, without_those(at_it, pool), pool)) return {count, value};
    }
    return {};
}

std::int64_t leave_out_far(Shape& shape, Pool& pool) {
    const PointMask far = far_from_most(shape.points, pool);
    const std::int64_t count = count_in(far);
    if (count == 0 || !keep_points(shape, without_those(far, pool), pool)) return 0;
    return count;
}

PointMask far_from_most(const Points& points, Pool& pool) {
    PointMask far(points.size(), 0, &pool);
    const auto finite = static_cast<std::size_t>(std::count_if(points.begin(), points.end(), is_finite_point));
    if (static_cast<double>(finite) < 2.0 / strays_tuning.few) return far;

    glm::dvec3 middle(0.0);
    Vector<double> numbers(&pool);
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        numbers.clear();
        for (const glm::dvec3& p : points)
            if (is_finite_point(p)) numbers.push_back(p[axis]);
        middle[axis] = median_of(numbers);
    }
    constexpr double nowhere = -1.0; // the value for a point that is not finite
    Vector<double> distance(points.size(), nowhere, &pool);
    for (std::size_t i = 0; i < points.size(); ++i)
        if (is_finite_point(points[i])) distance[i] = glm::length(points[i] - middle);

    // The largest distances, in ascending order: those of the few points that may be far, and one more.
    const auto few = static_cast<std::size_t>(strays_tuning.few * static_cast<double>(finite));
    numbers = distance;
    const auto last = numbers.end() - static_cast<std::ptrdiff_t>(few + 1);
    std::nth_element(numbers.begin(), last, numbers.end());
    std::sort(last, numbers.end());
    for (auto at = last; at + 1 != numbers.end(); ++at) {
        if (!(at[1] > strays_tuning.far * at[0])) continue;
        if (at[0] > 0.0)
            for (std::size_t i = 0; i < points.size(); ++i) far[i] = distance[i] > at[0] ? 1 : 0;
        break;
    }
    return far;
}

// ---- Dust

namespace {

constexpr int cell_bits = 21; // the number of bits for each axis in the index of a cell

std::int64_t cell_along(double place) noexcept {
    constexpr double most = 2097152.0 - 3.0; // The largest cell index. It leaves an empty cell on both sides.
    return place < most ? static_cast<std::int64_t>(place) + 1 : static_cast<std::int64_t>(most) + 1;
}

// Returns the index of a cell. Cells that are neighbours along z have consecutive indices.
constexpr std::int64_t cell_number(std::int64_t x, std::int64_t y, std::int64_t z) noexcept {
    return x * (std::int64_t{1} << (2 * cell_bits)) + y * (std::int64_t{1} << cell_bits) + z;
}

struct OccupiedCell {
    std::int64_t number;
    std::int64_t points;
};

// Returns the cells that hold points, ascending.
Vector<OccupiedCell> occupied_cells(const Vector<std::int64_t>& cell_of, Pool& pool) {
    Vector<std::int64_t> sorted(cell_of, &pool);
    std::sort(sorted.begin(), sorted.end());
    Vector<OccupiedCell> cells(&pool);
    for (const std::int64_t number : sorted) {
        if (cells.empty() || cells.back().number != number) cells.push_back({number, 0});
        ++cells.back().points;
    }
    return cells;
}

// Returns the median, over all points, of the number of points in the cell of a point.
double median_crowd(const Vector<OccupiedCell>& cells, std::size_t points, Pool& pool) {
    Vector<std::int64_t> crowds(&pool);
    for (const OccupiedCell& cell : cells) crowds.push_back(cell.points);
    std::sort(crowds.begin(), crowds.end());
    const auto low = static_cast<std::int64_t>((points - 1) / 2);
    const auto high = static_cast<std::int64_t>(points / 2);
    std::int64_t before = 0;
    double sum = 0.0;
    // A cell with `crowd` points is counted once for each of its points.
    for (const std::int64_t crowd : crowds) {
        if (before <= low && low < before + crowd) sum += static_cast<double>(crowd);
        if (before <= high && high < before + crowd) sum += static_cast<double>(crowd);
        before += crowd;
    }
    return sum / 2.0;
}

std::int64_t points_around(const OccupiedCell& cell, const Vector<OccupiedCell>& cells) noexcept {
    std::int64_t around = 0;
    for (std::int64_t x = -1; x <= 1; ++x)
        for (std::int64_t y = -1; y <= 1; ++y) {
            // The first of three consecutive cells along z.
            const std::int64_t first = cell.number + cell_number(x, y, -1);
            auto at = std::lower_bound(cells.begin(), cells.end(), first,
                                       [](const OccupiedCell& a, std::int64_t b) { return a.number < b; });
            for (; at != cells.end() && at->number <= first + 2; ++at) around += at->points;
        }
    return around;
}

} // namespace

PointMask find_strays(const Points& points, Pool& pool) {
    PointMask none(points.size(), 0, &pool);
    if (points.size() < strays_tuning.fewest) return none;
    geometry::Bounds bounds;
    for (const glm::dvec3& p : points) bounds.extend(p);
    const double root = std::sqrt(static_cast<double>(points.size()));
    double side = bounds.diagonal() / root;
    Vector<std::int64_t> cell_of(points.size(), 0, &pool);
    Vector<OccupiedCell> cells(&pool);
    while (true) {
        if (!(side > 0.0)) return none;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const glm::dvec3 place = (points[i] - bounds.min) / side;
            cell_of[i] = cell_number(cell_along(place.x), cell_along(place.y), cell_along(place.z));
        }
        cells = occupied_cells(cell_of, pool);
        if (median_crowd(cells, points.size(), pool) >= strays_tuning.crowd) break;
        const double next = strays_tuning.coarser * side;
        if (!(next > side)) return none; // The cells are too small: rounding keeps the side from growing.
        side = next;
    }

    Vector<std::int64_t> lonely(&pool); // the cells of possible strays, in ascending order
    for (const OccupiedCell& cell : cells)
        if (cell.points <= strays_tuning.alone && points_around(cell, cells) <= strays_tuning.alone)
            lonely.push_back(cell.number);
    PointMask strays(points.size(), 0, &pool);
    for (std::size_t i = 0; i < points.size(); ++i)
        strays[i] = std::binary_search(lonely.begin(), lonely.end(), cell_of[i]) ? 1 : 0;
    return static_cast<double>(count_in(strays)) <= strays_tuning.most * static_cast<double>(points.size()) ? strays
                                                                                                            : none;
}

} // namespace hrbfnpr::picture
