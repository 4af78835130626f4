// SPDX-License-Identifier: MIT
// Finds the up direction. It tests clues one after the other, the most reliable first: the file's format, coordinates
// of a map, a wall, a terrain, a flat base, left and right sides that are alike, a hole below, the ground at z = 0, and
// how the object would stand or fall. The result is y if no clue points to z.
#include "picture/up.h"

#include "base/assert.h"
#include "geometry/point_tree.h"
#include "picture/faces.h"
#include "picture/tuning_look.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hrbfnpr::picture {
namespace {

using UpAxis = glm::length_t;
constexpr UpAxis y_axis = 1;
constexpr UpAxis z_axis = 2;
constexpr const char* nothing_speaks = "nothing suggests another direction";

struct OtherAxes { // The two axes other than a given axis, in ascending order.
    UpAxis first;
    UpAxis second;
};

constexpr OtherAxes axes_across(UpAxis axis) noexcept { return {axis == 0 ? 1 : 0, axis == 2 ? 1 : 2}; }

double least_across(const glm::dvec3& v, UpAxis axis) noexcept {
    return std::min(v[axes_across(axis).first], v[axes_across(axis).second]);
}

geometry::Bounds box_of_samples(const Points& points) noexcept {
    geometry::Bounds box;
    for (const glm::dvec3& p : points) box.extend(p);
    return box;
}

bool are_finite_samples(const Points& points) noexcept {
    return std::all_of(points.begin(), points.end(), [](const glm::dvec3& p) {
        return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    });
}

double mean_along_axis(const Points& points, UpAxis axis) noexcept {
    double sum = 0.0;
    for (const glm::dvec3& p : points) sum += p[axis];
    return sum / static_cast<double>(points.size());
}

// Returns the share of the elements for which `is` returns true.
template <class T, class Is>
double share_of_samples(const Vector<T>& elements, Is&& is) {
    return static_cast<double>(std::count_if(elements.begin(), elements.end(), is)) /
           static_cast<double>(elements.size());
}

double sign_of_part(double x) noexcept { return static_cast<double>(x > 0.0) - static_cast<double>(x < 0.0); }

// ---- Maps, terrains and flat ends

// Returns whether the coordinates are map coordinates: eastings and northings are far from 0, but heights are not.
bool is_on_a_map(const geometry::Bounds& box) noexcept {
    const glm::dvec3 extent = box.size();
    const double height = std::max(std::abs(box.min.z), std::abs(box.max.z));
    double nearest = std::numeric_limits<double>::infinity();
    for (UpAxis axis = 0; axis < 2; ++axis) {
        const double middle = std::abs(box.min[axis] + box.max[axis]) / 2.0;
        if (!(middle > std::max(up_tuning.map_least, up_tuning.map_extents * extent[axis]))) return false;
        nearest = std::min(nearest, middle);
    }
    return nearest > 2.0 * height;
}

bool is_terrain(const glm::dvec3& extent, const Points& normals, UpAxis axis) {
    const double wide = least_across(extent, axis);
    if (!(up_tuning.terrain_relief_least * wide < extent[axis] && extent[axis] < up_tuning.terrain_relief_most * wide))
        return false;
    const double mean = mean_along_axis(normals, axis);
    const double side = sign_of_part(mean);
    return share_of_samples(normals, [&](const glm::dvec3& n) { return n[axis] * side > 0.0; }) >
               up_tuning.terrain_one_side &&
           mean * side > up_tuning.terrain_upward;
}

// Returns whether the shape is an upright wall. Its normals are level, or nearly level and on one side. Normals that
// are only nearly level may also be those of gentle ground, if they point along y. A normal of length 0 is unknown.
bool is_wall(const Points& normals) {
    if (normals.empty()) return false;
    const auto level_share = [&](double limit) {
        return share_of_samples(normals,
                                [limit](const glm::dvec3& n) { return std::abs(n.z) < limit * glm::length(n); });
    };
    if (level_share(up_tuning.side_told) > up_tuning.view_share) return true;
    const double along_y = mean_along_axis(normals, y_axis);
    return std::hypot(mean_along_axis(normals, 0), along_y) > up_tuning.terrain_upward &&
           along_y < up_tuning.terrain_upward && level_share(up_tuning.wall_level) > up_tuning.wall_share;
}

// Returns whether nearly all samples face the same side along z. Such a shape was seen from one side only, and has no
// end to stand on.
bool is_seen_from_one_side(const Points& normals) {
    const double told =
        share_of_samples(normals, [](const glm::dvec3& n) { return std::abs(n.z) > up_tuning.side_told; });
    double sides = 0.0;
    for (const glm::dvec3& n : normals) sides += sign_of_part(n.z);
    return told > up_tuning.view_share &&
           std::abs(sides / static_cast<double>(normals.size())) > up_tuning.view_one_sided;
}

// The share of the samples on each flat end: the lower end along x, the upper end along x, the lower end along y, and
// so on.
using FlatEnds = std::array<double, 6>;
constexpr std::size_t below_y = 2;
constexpr std::size_t below_z = 4;

FlatEnds flat_ends(const Points& points, const Points& normals, const geometry::Bounds& box) noexcept {
    const glm::dvec3 extent = box.size();
    std::array<std::int64_t, 6> counts{};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 place = (points[i] - box.min) / extent;
        for (UpAxis axis = 0; axis < 3; ++axis) {
            const auto end = static_cast<std::size_t>(2 * axis);
            if (place[axis] < up_tuning.end_height && -normals[i][axis] > up_tuning.end_outward) ++counts[end];
            if (1.0 - place[axis] < up_tuning.end_height && normals[i][axis] > up_tuning.end_outward) ++counts[end + 1];
        }
    }
    FlatEnds shares{};
    for (std::size_t end = 0; end < shares.size(); ++end)
        shares[end] = static_cast<double>(counts[end]) / static_cast<double>(points.size());
    return shares;
}

bool has_flat_base(const FlatEnds& ends) noexcept {
    double others = 0.0;
    for (std::size_t end = 0; end < ends.size(); ++end)
        if (end != below_z) others = std::max(others, ends[end]);
    return ends[below_z] >= up_tuning.base_share && ends[below_z] >= up_tuning.base_over_others * others;
}

bool stands_at_origin(const geometry::Bounds& box, UpAxis axis) noexcept {
    const glm::dvec3 extent = box.size();
    const auto is_middle = [&](UpAxis other) {
        return std::abs(box.min[other] + box.max[other]) / 2.0 <= up_tuning.middle_miss * extent[other];
    };
    return std::abs(box.min[axis]) <= up_tuning.ground_miss * extent[axis] && is_middle(axes_across(axis).first) &&
           is_middle(axes_across(axis).second);
}

// ---- Left and right

geometry::VecArray every_nth_sample(const Points& points, std::size_t first, std::size_t step, base::Memory& memory) {
    geometry::VecArray chosen(memory);
    for (std::size_t i = first; i < points.size(); i += step) chosen.push_back(points[i]);
    return chosen;
}

// Returns a high percentile of the distances from the places to the nearest point of a tree.
double distance_of_most(const geometry::VecArray& places, const geometry::PointTree& points, Pool& pool) {
    HRBFNPR_ASSERT(!places.empty() && points.size() > 0);
    const auto any = [](std::int64_t) { return true; };
    Vector<double> distances(&pool);
    const std::int64_t count = std::min(places.size(), up_tuning.mirrored_most);
    for (std::int64_t i = 0; i < count; ++i) {
        std::int64_t found = 0;
        points.nearest(places[i], 1, any, any, &found);
        const glm::dvec3 between = points.points()[found] - places[i];
        const double squared = glm::dot(between, between);
        // An overflow gives NaN, which cannot be sorted, so it is replaced by infinity.
        distances.push_back(squared >= 0.0 ? std::sqrt(squared) : std::numeric_limits<double>::infinity());
    }
    return percentile(distances, up_tuning.mirrored_percentile);
}

// Mirrors samples along an axis, once in their mean and once in the middle of their bounding box. Returns the smaller
// of the two distances between the mirrored and the given samples.
double mirrored_distance(const Points& points, const geometry::Bounds& box, UpAxis axis,
                         const geometry::PointTree& tree, Pool& pool) {
    const auto step = std::max<std::size_t>(1, points.size() / static_cast<std::size_t>(up_tuning.mirrored_most));
    double least = std::numeric_limits<double>::infinity();
    for (const double middle : {mean_along_axis(points, axis), (box.min[axis] + box.max[axis]) / 2.0}) {
        geometry::VecArray mirrored = every_nth_sample(points, 0, step, pool.memory());
        for (std::int64_t i = 0; i < mirrored.size(); ++i) {
            glm::dvec3 p = mirrored[i];
            p[axis] = 2.0 * middle - p[axis];
            mirrored.set(i, p);
        }
        least = std::min(least, distance_of_most(mirrored, tree, pool));
    }
    return least;
}

// Returns the axis, y or z, whose two sides are similar, if the two sides along the other axis differ; else 0. Most
// objects have similar left and right sides, but few look the same above and below [Fu et al. 2008].
UpAxis sideways_axis(const Points& points, const geometry::Bounds& box, Pool& pool) {
    if (points.size() < 8) return 0;
    base::Memory& memory = pool.memory();
    const geometry::PointTree odd(every_nth_sample(points, 1, 2, memory), {});
    const double spacing = distance_of_most(every_nth_sample(points, 0, 2, memory), odd, pool);
    const geometry::PointTree all(every_nth_sample(points, 0, 1, memory), {});
    const std::array<double, 2> off{mirrored_distance(points, box, y_axis, all, pool),
                                    mirrored_distance(points, box, z_axis, all, pool)};
    const glm::dvec3 extent = box.size();
    for (std::size_t k = 0; k < 2; ++k) {
        const UpAxis axis = k == 0 ? y_axis : z_axis;
        const bool lies = extent[axis] < up_tuning.leaf_thickness * least_across(extent, axis);
        const bool alike = off[k] < up_tuning.mirrored_alike * spacing;
        const bool unlike =
            off[1 - k] > std::max(up_tuning.mirrored_unlike * spacing, up_tuning.mirrored_clearly * off[k]);
        if (alike && unlike && !lies) return axis;
    }
    return 0;
}

// ---- A hole to stand on

struct BorderSide { // A side of a triangle: the indices of its two points, and its index in the list of all sides.
    std::int64_t low;
    std::int64_t high;
    std::int64_t number;

    [[nodiscard]] bool joins_same(const BorderSide& other) const noexcept {
        return low == other.low && high == other.high;
    }
    [[nodiscard]] bool operator<(const BorderSide& other) const noexcept {
        if (low != other.low) return low < other.low;
        return high != other.high ? high < other.high : number < other.number;
    }
};

// Returns the sides that only one triangle has, sorted by their points. Each side has the direction in which its
// triangle uses it.
Vector<Edge> border_of(const Vector<Triangle>& triangles, Pool& pool) {
    Vector<BorderSide> sides(&pool);
    sides.reserve(3 * triangles.size());
    const auto ends_of = [&](std::int64_t number) {
        const Triangle& triangle = triangles[static_cast<std::size_t>(number / 3)];
        const auto k = static_cast<std::size_t>(number % 3);
        return Edge{triangle[k], triangle[(k + 1) % 3]};
    };
    for (std::int64_t number = 0; number < 3 * static_cast<std::int64_t>(triangles.size()); ++number) {
        const Edge ends = ends_of(number);
        sides.push_back({std::min(ends[0], ends[1]), std::max(ends[0], ends[1]), number});
    }
    std::sort(sides.begin(), sides.end());
    Vector<Edge> border(&pool);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        if (i > 0 && sides[i].joins_same(sides[i - 1])) continue;
        if (i + 1 < sides.size() && sides[i].joins_same(sides[i + 1])) continue;
        border.push_back(ends_of(sides[i].number));
    }
    return border;
}

// Returns whether a mesh has a hole on which the object stands, as busts and objects scanned on a table have.
bool opens_below(const Shape* shape, UpAxis axis, Pool& pool) {
    if (shape == nullptr || !shape->is_mesh()) return false;
    const Points& points = shape->points;
    const auto point = [&](std::int64_t number) -> const glm::dvec3& {
        HRBFNPR_ASSERT(number >= 0 && static_cast<std::size_t>(number) < points.size());
        return points[static_cast<std::size_t>(number)];
    };
    const Vector<Edge> border = border_of(shape->triangles, pool);
    if (border.empty()) return false;
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    for (const Triangle& triangle : shape->triangles) {
        for (const std::int64_t corner : triangle) {
            lowest = std::min(lowest, point(corner)[axis]);
            highest = std::max(highest, point(corner)[axis]);
        }
    }
    double all = 0.0;
    double below = 0.0;
    double above = 0.0;
    glm::dvec3 hole(0.0);
    const glm::dvec3 anchor = point(border[0][0]);
    for (const Edge& edge : border) {
        const glm::dvec3& start = point(edge[0]);
        const glm::dvec3& end = point(edge[1]);
        const double length = glm::length(end - start);
        const double share = ((start[axis] + end[axis]) / 2.0 - lowest) / (highest - lowest);
        all += length;
        if (share < up_tuning.hole_height) below += length;
        if (share > 1.0 - up_tuning.hole_height) above += length;
        hole += glm::cross(start - anchor, end - anchor);
    }
    if (!(all > 0.0)) return false;
    hole = glm::abs(hole);
    return below >= up_tuning.hole_border * all && above <= up_tuning.hole_above * all &&
           hole[axis] >
               up_tuning.hole_over_others * std::max(hole[axes_across(axis).first], hole[axes_across(axis).second]);
}

// ---- Standing and falling

using FlatPoints = Vector<glm::dvec2>;

// Returns a positive number if the path from a over b to c turns left.
double turn_at(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) noexcept {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Returns the corners of the convex hull, anticlockwise [Andrew 1979]. For a single point it returns no corner.
FlatPoints convex_hull(FlatPoints points) {
    std::sort(points.begin(), points.end(),
              [](const glm::dvec2& a, const glm::dvec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    FlatPoints hull(points.get_allocator());
    const auto add_half = [&](auto first, auto last) {
        const std::size_t begin = hull.size();
        for (; first != last; ++first) {
            while (hull.size() - begin > 1 && turn_at(hull[hull.size() - 2], hull.back(), *first) <= 0.0)
                hull.pop_back();
            hull.push_back(*first);
        }
        if (hull.size() > begin) hull.pop_back(); // The other half of the hull begins here.
    };
    add_half(points.begin(), points.end());
    add_half(points.rbegin(), points.rend());
    return hull;
}

double area_of_polygon(const FlatPoints& polygon) noexcept {
    double twice = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2& a = polygon[i];
        const glm::dvec2& b = polygon[(i + 1) % polygon.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return twice / 2.0;
}

// Returns the height below which points belong to the feet at one end of an axis. `side` (1 or -1) chooses the end;
// with -1, heights are measured downward.
double height_of_end(const geometry::Bounds& box, UpAxis axis, double side) noexcept {
    const double lowest = side > 0.0 ? box.min[axis] : -box.max[axis];
    return lowest + up_tuning.foot_height * (box.max[axis] - box.min[axis]);
}

std::int64_t count_at_end(const Points& points, const geometry::Bounds& box, UpAxis axis, double side) noexcept {
    const double limit = height_of_end(box, axis, side);
    return std::count_if(points.begin(), points.end(), [&](const glm::dvec3& p) { return side * p[axis] < limit; });
}

// Returns whether the object can stand on one of its ends along an axis. The end must be wide, and the middle of the
// object must be above it.
bool rests_on_end(const Points& points, const geometry::Bounds& box, UpAxis axis, double side, Pool& pool) {
    const OtherAxes flat = axes_across(axis);
    const double limit = height_of_end(box, axis, side);
    FlatPoints all(&pool);
    FlatPoints end(&pool);
    glm::dvec2 middle(0.0);
    for (const glm::dvec3& p : points) {
        const glm::dvec2 place(p[flat.first], p[flat.second]);
        all.push_back(place);
        middle += place;
        if (side * p[axis] < limit) end.push_back(place);
    }
    middle /= static_cast<double>(points.size());
    const FlatPoints shadow = convex_hull(std::move(all));
    const FlatPoints base = convex_hull(std::move(end));
    if (base.size() < 3 || area_of_polygon(base) < up_tuning.foot_share * area_of_polygon(shadow)) return false;
    for (std::size_t i = 0; i < base.size(); ++i) {
        const glm::dvec2 along = base[(i + 1) % base.size()] - base[i];
        const glm::dvec2 off = middle - base[i];
        if (!(along.x * off.y - along.y * off.x > 0.0)) return false;
    }
    return true;
}

// Returns the reason why the shape alone says that z is up, or null if it does not.
const char* reason_for_z(const Shape* shape, const Points& points, const Points& normals, Pool& pool) {
    if (points.empty() || !are_finite_samples(points)) return nullptr;
    const geometry::Bounds box = box_of_samples(points);
    const glm::dvec3 extent = box.size();
    if (extent.x <= 0.0 || extent.y <= 0.0 || extent.z <= 0.0) return nullptr;
    if (is_on_a_map(box)) return "x and y are map coordinates";
    if (is_wall(normals)) return "the surface is an upright wall";
    if (is_terrain(extent, normals, z_axis) && !is_terrain(extent, normals, y_axis)) return "the surface is a terrain";
    if (is_seen_from_one_side(normals)) return nullptr;
    const FlatEnds ends = flat_ends(points, normals, box);
    if (has_flat_base(ends)) return "its lower end along z is a flat base";
    const UpAxis sideways = sideways_axis(points, box, pool);
    if (sideways == y_axis) return "left and right are alike along y";
    if (sideways == z_axis || opens_below(shape, y_axis, pool)) return nullptr;
    if (stands_at_origin(box, z_axis) && !stands_at_origin(box, y_axis) && ends[below_z] >= ends[below_y])
        return "it stands on z = 0";
    if (!rests_on_end(points, box, z_axis, 1.0, pool) || rests_on_end(points, box, y_axis, 1.0, pool) ||
        rests_on_end(points, box, y_axis, -1.0, pool))
        return nullptr;
    const auto feet = static_cast<double>(count_at_end(points, box, z_axis, 1.0));
    const auto top = static_cast<double>(count_at_end(points, box, z_axis, -1.0));
    if (top > up_tuning.base_over_others * feet || !rests_on_end(points, box, z_axis, -1.0, pool))
        return "it stands on its feet along z";
    return nullptr;
}

} // namespace

FoundUp find_up(const Shape* shape, const Points& points, const Points& normals, Pool& pool) {
    HRBFNPR_ASSERT(points.size() == normals.size());
    if (shape != nullptr && shape->up) {
        String reason("as in ", &pool);
        if (shape->is_photo)
            reason += "depth images";
        else
            reason += shape->up_by.empty() ? String("files of this kind", &pool) : shape->up_by;
        return {*shape->up, std::move(reason)};
    }
    const char* const reason = reason_for_z(shape, points, normals, pool);
    if (reason == nullptr) return {{0.0, 1.0, 0.0}, String(nothing_speaks, &pool)};
    return {{0.0, 0.0, 1.0}, String(reason, &pool)};
}

glm::dvec3 choose_up(const Call& call, const Shape* shape, const Points& points, const Points& normals) {
    const Options& options = call.options;
    if (options.has_up()) return {options.desc.up[0], options.desc.up[1], options.desc.up[2]};
    const glm::dvec3 y(0.0, 1.0, 0.0);
    if (options.has(HRBFNPR_PICTURE_IS_SOLID)) return y;
    const FoundUp found = find_up(shape, points, normals, call.pool);
    // If the surface is not drawn, later pictures use its up direction, and the user needs no note.
    if (found.direction == y || options.has(HRBFNPR_PICTURE_SURFACE_ONLY)) return found.direction;
    const glm::dvec3& up = found.direction;
    String text("up is ", &call.pool);
    text += name_of_direction(up, call.pool);
    String reasoned(text, &call.pool);
    (reasoned += shape != nullptr && shape->up ? ", " : ": ") += found.reason;
    for (String* const one : {&text, &reasoned}) *one += " ({up=y} changes it)";
    // The caller's text for the kind of file may be too long for a note.
    const bool is_short = call.report.is_short(reasoned);
    call.report.note(HRBFNPR_NOTE_UP, {up.x, up.y, up.z}, is_short ? reasoned : text,
                     {.detail = is_short ? std::string_view() : std::string_view(found.reason)});
    return up;
}

String name_of_direction(const glm::dvec3& direction, Pool& pool) {
    const glm::dvec3 size = glm::abs(direction);
    const double sum = size.x + size.y + size.z;
    for (UpAxis axis = 0; axis < 3; ++axis) {
        if (size[axis] != sum) continue;
        String name(direction[axis] > 0.0 ? "" : "-", &pool);
        name += "xyz"[axis];
        return name;
    }
    return formatted(pool, "%g,%g,%g", direction.x, direction.y, direction.z);
}

char hangs_along(const Points& points, const Points& normals) noexcept {
    if (points.empty() || points.size() != normals.size()) return 0;
    const glm::dvec3 extent = box_of_samples(points).size();
    if (!(extent.x > 0.0 && extent.y > 0.0 && extent.z > 0.0) || is_wall(normals)) return 0;
    for (const UpAxis axis : {z_axis, y_axis})
        if (is_terrain(extent, normals, axis) && mean_along_axis(normals, axis) < 0.0) return "xyz"[axis];
    return 0;
}

} // namespace hrbfnpr::picture
