// SPDX-License-Identifier: MIT
#include "geometry/bvh.h"

#include "base/assert.h"
#include "geometry/bvh_build.h"

#include <algorithm>

namespace hrbfnpr::geometry {
namespace {

// The method of Ericson, Real-Time Collision Detection (2005), 5.1.5.
[[nodiscard]] glm::dvec3 nearest_on_triangle(const std::array<glm::dvec3, 3>& v, const glm::dvec3& p) noexcept {
    const glm::dvec3 ab = v[1] - v[0], ac = v[2] - v[0];
    const glm::dvec3 ap = p - v[0], bp = p - v[1], cp = p - v[2];
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
    if (d1 <= 0.0 && d2 <= 0.0) return v[0];
    const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
    if (d3 >= 0.0 && d4 <= d3) return v[1];
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return v[0] + (d1 / (d1 - d3)) * ab;
    const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    if (d6 >= 0.0 && d5 <= d6) return v[2];
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return v[0] + (d2 / (d2 - d6)) * ac;
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 >= d3 && d5 >= d6) return v[1] + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (v[2] - v[1]);
    const double sum = va + vb + vc;
    return v[0] + ab * (vb / sum) + ac * (vc / sum);
}

// The axes of a ray's frame. The direction is longest along z.
using RayAxes = glm::vec<3, glm::length_t>;

[[nodiscard]] RayAxes axes_of(const glm::dvec3& direction) noexcept {
    const glm::dvec3 length = glm::abs(direction);
    if (length.x >= length.y && length.x >= length.z) return RayAxes(1, 2, 0);
    return length.y >= length.z ? RayAxes(2, 0, 1) : RayAxes(0, 1, 2);
}

[[nodiscard]] double max_component(const glm::dvec3& v) noexcept { return std::max({v.x, v.y, v.z}); }

} // namespace

struct Bvh::ExactRay {
    ExactRay(const glm::dvec3& from, const glm::dvec3& along) noexcept
        : origin(from), direction(along), axes(axes_of(along)), slope_x(along[axes.x] / along[axes.z]),
          slope_y(along[axes.y] / along[axes.z]) {}

    // Returns the t at which the ray meets a face, or NaN if it does not. Whether it does is found by the method of
    // Woop, Benthin, Wald, "Watertight ray/triangle intersection" (2013): in a frame that is sheared so that the ray is
    // the z axis, two faces with a common edge compute the same cross product of its ends, with opposite signs. Where
    // it does is found by the method of Moeller, Trumbore, "Fast, minimum storage ray/triangle intersection" (1997).
    [[nodiscard]] double meet(const Corners& p) const noexcept {
        const double none = std::numeric_limits<double>::quiet_NaN();
        const glm::dvec3 a = sheared(p[0]), b = sheared(p[1]), c = sheared(p[2]);
        const double u = c.x * b.y - c.y * b.x;
        const double v = a.x * c.y - a.y * c.x;
        const double w = b.x * a.y - b.y * a.x;
        const bool inside = (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
        const double sum = u + v + w;
        if (!inside || sum == 0.0) return none;
        const glm::dvec3 ab = p[1] - p[0];
        const glm::dvec3 ac = p[2] - p[0];
        const double determinant = glm::dot(ab, glm::cross(direction, ac));
        if (determinant == 0.0) return (u * a.z + v * b.z + w * c.z) / sum;
        return glm::dot(ac, glm::cross(origin - p[0], ab)) / determinant;
    }

    // Returns the corner of a face in the frame of the ray. z is the parameter t.
    [[nodiscard]] glm::dvec3 sheared(const glm::dvec3& corner) const noexcept {
        const glm::dvec3 off = corner - origin;
        return {off[axes.x] - slope_x * off[axes.z], off[axes.y] - slope_y * off[axes.z],
                off[axes.z] / direction[axes.z]};
    }

    glm::dvec3 origin, direction;
    RayAxes axes;
    double slope_x, slope_y;
};

Bvh::Bvh(const base::Work& work, const base::Array<glm::dvec3>& vertex, const base::Array<Triangle>& triangle)
    : loops_(bvh_loops(work.instruction_set)), node_(work.memory), leaf_(work.memory), face_(work.memory),
      corners_(work.memory) {
    const std::int64_t count = triangle.size();
    for (const std::int64_t face : work.over(count))
        for (const std::int32_t corner : triangle[face]) bounds_.extend(vertex[corner]);
    if (count > 0) centre_ = bounds_.centre();
    if (const double half = 0.5 * bounds_.longest_side(); half > 1e-280) scale_ = 1.0 / half;
    constexpr std::int64_t at_once = 4096;
    base::Array<BvhItem> item(work.memory);
    item.resize_for_overwrite(count);
    work.for_chunks(count, at_once, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t face = begin; face < end; ++face) {
            const Triangle& t = triangle[face];
            const glm::dvec3 a = vertex[t[0]], b = vertex[t[1]], c = vertex[t[2]];
            const glm::vec3 low = scale_ * (glm::min(glm::min(a, b), c) - centre_);
            const glm::vec3 high = scale_ * (glm::max(glm::max(a, b), c) - centre_);
            item[face] = {{low.x, low.y, low.z, 0.0F}, {high.x, high.y, high.z, 0.0F}, static_cast<std::int32_t>(face)};
        }
    });
    BvhBoxes boxes = build_bvh(work, item);
    node_ = std::move(boxes.node);
    leaf_ = std::move(boxes.leaf);
    root_ = boxes.root;
    face_.resize_for_overwrite(count);
    corners_.resize_for_overwrite(count);
    work.for_chunks(leaf_.size(), at_once, [&](std::int64_t begin, std::int64_t end) {
        for (BvhLeaf& leaf : std::span(leaf_.begin() + begin, leaf_.begin() + end)) {
            std::fill_n(&leaf.corner[0][0], 9 * bvh_width, 0.0F);
            for (std::int32_t i = 0; i < leaf.count; ++i) {
                const std::int32_t face = face_[leaf.first + i] = item[leaf.first + i].face;
                for (std::size_t k = 0; k < 3; ++k) {
                    const glm::dvec3 corner = corners_[leaf.first + i][k] = vertex[triangle[face][k]];
                    const glm::vec3 scaled = scale_ * (corner - centre_);
                    for (glm::length_t axis = 0; axis < 3; ++axis)
                        leaf.corner[3 * k + static_cast<std::size_t>(axis)][i] = scaled[axis];
                }
            }
        }
    });
}

Bvh::Nearest Bvh::nearest(const glm::dvec3& p, double limit) const noexcept {
    struct Search {
        const Bvh& bvh;
        glm::dvec3 p;
        Nearest best;

        // Returns the squared distance beyond which the walk may leave out faces. It is rounded up.
        [[nodiscard]] float most() const noexcept {
            const double squared = best.squared * bvh.scale_ * bvh.scale_ * (1.0 + 0x1p-18) + 1e-36;
            return static_cast<float>(std::min(squared, 1e29));
        }
        static float visit(void* user, std::int64_t number) {
            Search& search = *static_cast<Search*>(user);
            const glm::dvec3 place = nearest_on_triangle(search.bvh.corners_[number], search.p);
            const double near = glm::dot(place - search.p, place - search.p);
            const std::int64_t face = search.bvh.face_[number];
            Nearest& best = search.best;
            if (near < best.squared || (near == best.squared && (best.face < 0 || face < best.face)))
                best = {near, face, place};
            return search.most();
        }
    };
    Search search{*this, p, {limit, -1, {}}};
    // Far places are moved nearer, which moves them nearer to each box.
    const glm::dvec3 scaled = glm::clamp(scale_ * (p - centre_), glm::dvec3(-1e14), glm::dvec3(1e14));
    const double error = 0x1p-22 * std::max(1.0, max_component(glm::abs(scaled)));
    BvhPlace place{{}, static_cast<float>(error), search.most()};
    for (glm::length_t k = 0; k < 3; ++k) place.place[k] = static_cast<float>(scaled[k]);
    if (!face_.empty()) loops_.around(view(), place, Search::visit, &search);
    return search.best;
}

// A ray in the coordinates of the walk. It begins where the ray enters the box of all faces, so that it is exact for an
// origin far away.
struct Bvh::WalkRay {
    // Returns the ray's parameter in the walk, rounded up.
    [[nodiscard]] float limit(double t) const noexcept {
        return static_cast<float>(std::clamp(t * unit - enter, 0.0, 8.0)) + 8.0F * bvh_margin;
    }

    double unit;  // the length of the ray's direction
    double enter; // the distance from the ray's origin to the box
    BvhRay ray;
};

// Returns whether the ray meets the box of all faces. If so, it sets `walk`.
bool Bvh::start(const ExactRay& exact, double t_min, double t_max, WalkRay& walk) const noexcept {
    walk.unit = scale_ * std::abs(exact.direction[exact.axes.z]);
    if (face_.empty() || !(walk.unit > 0.0) || !(walk.unit < std::numeric_limits<double>::infinity())) return false;
    const glm::dvec3 along = (scale_ / walk.unit) * exact.direction;
    const glm::dvec3 from = scale_ * (exact.origin - centre_);
    double enter = t_min * walk.unit;
    double leave = t_max * walk.unit;
    for (glm::length_t k = 0; k < 3; ++k) {
        const double margin = double{bvh_margin} + 1e-12 * std::abs(from[k]);
        const double low = scale_ * (bounds_.min[k] - centre_[k]) - margin - from[k];
        const double high = scale_ * (bounds_.max[k] - centre_[k]) + margin - from[k];
        if (std::abs(along[k]) < 1e-200) {
            if (low > 0.0 || high < 0.0) return false;
            continue;
        }
        const double inverse = 1.0 / along[k];
        enter = std::max(enter, std::min(low * inverse, high * inverse));
        leave = std::min(leave, std::max(low * inverse, high * inverse));
    }
    if (!(enter <= leave)) return false;
    walk.enter = enter;
    const glm::dvec3 place = from + enter * along;
    for (glm::length_t k = 0; k < 3; ++k) {
        walk.ray.origin[k] = static_cast<float>(place[k]);
        // A slope below 1e-9 changes the ray's place by less than the margin of the boxes.
        walk.ray.inverse[k] = static_cast<float>(1.0 / std::copysign(std::max(std::abs(along[k]), 1e-9), along[k]));
        walk.ray.axis[k] = exact.axes[k];
    }
    walk.ray.slope[0] = static_cast<float>(exact.slope_x);
    walk.ray.slope[1] = static_cast<float>(exact.slope_y);
    walk.ray.limit = walk.limit(t_max);
    return true;
}

template <class Meet>
void Bvh::cast(const glm::dvec3& origin, const glm::dvec3& direction, double t_min, double t_max, Meet&& meet) const {
    HRBFNPR_ASSERT(t_min >= 0.0);
    struct Search {
        static float visit(void* user, std::int64_t number) {
            Search& search = *static_cast<Search*>(user);
            const double t = search.exact.meet(search.bvh.corners_[number]);
            if (t > search.t_min && t <= search.t_max) search.t_max = search.meet(number, t);
            return search.t_max < 0.0 ? -1.0F : search.walk.limit(search.t_max);
        }

        const Bvh& bvh;
        ExactRay exact;
        double t_min, t_max;
        Meet& meet;
        WalkRay walk;
    };
    Search search{*this, ExactRay(origin, direction), t_min, t_max, meet, {}};
    if (start(search.exact, t_min, t_max, search.walk)) loops_.along(view(), search.walk.ray, Search::visit, &search);
}

Bvh::Hit Bvh::first_hit(const glm::dvec3& origin, const glm::dvec3& direction, double t_min,
                        double t_max) const noexcept {
    Hit first;
    const auto meet = [&](std::int64_t number, double t) {
        const std::int64_t face = face_[number];
        if (t < first.t ? t < t_max : face < first.face) first = {t, face};
        return std::min(first.t, t_max);
    };
    cast(origin, direction, t_min, t_max, meet);
    return first;
}

bool Bvh::any_hit(const glm::dvec3& origin, const glm::dvec3& direction, double t_min, double t_max) const noexcept {
    bool found = false;
    const auto meet = [&](std::int64_t, double t) {
        found = found || t < t_max;
        return found ? -1.0 : t_max;
    };
    cast(origin, direction, t_min, t_max, meet);
    return found;
}

void Bvh::visit_crossings(const glm::dvec3& origin, const glm::dvec3& direction, double t_max, VisitCrossing visit,
                          void* user) const {
    const auto meet = [&](std::int64_t number, double t) {
        const Corners& p = corners_[number];
        const double along = glm::dot(glm::cross(p[1] - p[0], p[2] - p[0]), direction);
        if (t < t_max) visit(user, face_[number], t, along > 0.0 ? 1 : -1);
        return t_max;
    };
    cast(origin, direction, 0.0, t_max, meet);
}

int Bvh::winding_beyond(const glm::dvec3& place, const glm::dvec3& other) const noexcept {
    int winding = 0;
    visit_crossings(
        place, other - place, 1.0, [](void* user, std::int32_t, double, int sign) { *static_cast<int*>(user) += sign; },
        &winding);
    return winding;
}

} // namespace hrbfnpr::geometry
