// SPDX-License-Identifier: MIT
// Curves f = g = 0 on a surface, stored as polylines with a cubic between consecutive points. This file has their
// points, Newton's method for moving places onto a curve, the cubics, and queries whether a curve passes near a place.
// It also has lines on a surface that do not depend on the camera, as curves with a strength at each point, and finds
// their parts that face a camera.
#pragma once

#include "base/assert.h"
#include "base/memory.h"
#include "base/operation.h"
#include "base/work.h"
#include "curves/chains.h"
#include "curves/surface_mesh.h"
#include "curves/tuning.h"
#include "geometry/point_grid.h"
#include "geometry/vec.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"
#include "surface/support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace hrbfnpr::curves {

// ---- Levels: a function g in space. Its zero lines on the surface f = 0 are the curves to be drawn.

// The camera in the coordinates of the surface.
struct View {
    // The image of a place.
    struct Seen {
        glm::dvec2 place; // the position of the image, in pixels
        double w;         // homogeneous coordinate: above 0 if the place is in front of the eye
    };

    glm::dvec4 eye{0.0, 0.0, 0.0, 1.0}; // w = 1: the position of the eye; w = 0: the viewing direction
    // Maps a place in the coordinates of the surface to (x w, y w, depth w, w). x and y are in pixels.
    glm::dmat4 to_window{1.0};

    // Returns the vector from the eye to a point, not normalised.
    [[nodiscard]] glm::dvec3 sight(const glm::dvec3& p) const noexcept {
        return eye.w == 0.0 ? glm::dvec3(eye) : p - glm::dvec3(eye);
    }
    [[nodiscard]] Seen see(const glm::dvec3& p) const noexcept {
        const glm::dvec4 q = to_window * glm::dvec4(p, 1.0);
        return {{q.x / q.w, q.y / q.w}, q.w};
    }
};

// The arrays for the values of f and g and their gradients. No pointer is null.
struct LevelBatch {
    double* value = nullptr;
    std::array<double*, 3> gradient{};
    double* level = nullptr;
    std::array<double*, 3> level_gradient{};
};

class Level {
public:
    Level() = default;
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;
    virtual ~Level() = default;

    [[nodiscard]] virtual const implicit::Implicit& surface() const noexcept = 0;
    // Evaluates f and g at up to implicit::batch_size points, on the calling thread. Far from f = 0, g and its gradient
    // may be wrong.
    virtual void evaluate(const implicit::PointBatch& points, const LevelBatch& out) const = 0;
    // Computes g at the vertices of a surface mesh from the gradients stored in the mesh. Resizes `level`.
    virtual void at_vertices(const base::Work& work, const SurfaceMesh& mesh, base::Array<double>& level) const = 0;
    // Works like at_vertices(), but where g is certainly negative, the result may be any negative number. This is
    // faster for some levels.
    virtual void signs_at_vertices(const base::Work& work, const SurfaceMesh& mesh, base::Array<double>& level) const {
        at_vertices(work, mesh, level);
    }
};

// The function for the occluding contour: g = grad f . v, where v is the vector from the eye to the point.
class ContourLevel final : public Level {
public:
    ContourLevel(const implicit::Implicit& surface, const View& view) noexcept : surface_(surface), view_(view) {}

    [[nodiscard]] const implicit::Implicit& surface() const noexcept override { return surface_; }
    [[nodiscard]] const View& view() const noexcept { return view_; }
    void evaluate(const implicit::PointBatch& points, const LevelBatch& out) const override;
    void at_vertices(const base::Work& work, const SurfaceMesh& mesh, base::Array<double>& level) const override;

private:
    const implicit::Implicit& surface_;
    View view_;
};

// The function for the border of the support: g = s - limit, where s is the support that surface/support.h computes.
// The surface is to the left of the border.
class SupportLevel final : public Level {
public:
    SupportLevel(const implicit::Implicit& surface, const surface::Support& support, double limit) noexcept
        : surface_(surface), support_(support), limit_(limit) {}

    [[nodiscard]] const implicit::Implicit& surface() const noexcept override { return surface_; }
    void evaluate(const implicit::PointBatch& points, const LevelBatch& out) const override;
    void at_vertices(const base::Work& work, const SurfaceMesh& mesh, base::Array<double>& level) const override;
    void signs_at_vertices(const base::Work& work, const SurfaceMesh& mesh, base::Array<double>& level) const override;

private:
    const implicit::Implicit& surface_;
    const surface::Support& support_;
    double limit_;
};

// ---- Points

// The values of f and g at a place near a curve.
struct CurvePoint {
    glm::dvec3 position{0.0};
    glm::dvec3 gradient{0.0};       // grad f
    glm::dvec3 level_gradient{0.0}; // grad g
    double value = 0.0;             // f
    double level = 0.0;             // g
    std::int64_t is_cusp = 0;       // 1 if the line of sight is tangent to the curve at this point; set by with_cusps()

    // Returns the direction of the curve, not normalised. Negative g is to its left.
    [[nodiscard]] glm::dvec3 direction() const noexcept { return glm::cross(gradient, level_gradient); }
    // Returns the shortest step to a point with f = g = 0, if both functions were linear: -J^T (J J^T)^-1 (f, g). If
    // the gradients are parallel, the step is not finite.
    [[nodiscard]] glm::dvec3 newton_step() const noexcept;
};

// Evaluates f and g at the positions of all points, in parallel.
void evaluate(const base::Work& work, const Level& level, base::Array<CurvePoint>& points);

// Moves each point towards its curve by one Newton step, and by a second step if the first was longer than enough[i].
// Adds to `evaluations`.
void bring_closer(const base::Work& work, const Level& level, const base::Array<double>& enough,
                  base::Array<CurvePoint>& points, std::int64_t& evaluations);

struct NewtonSettings {
    // A Newton step shorter than this is the last one. A longer step is also the last one if the step after it would be
    // negligible.
    double tolerance = 0.0;
    double farthest = 0.0; // A point that moves farther from its start than this is given up.
};

// Moves points onto curves, all in parallel. Sets found[i] to 1 if point i reached a curve. Returns the number of
// evaluations.
std::int64_t bring_to_curve(const base::Work& work, const Level& level, const NewtonSettings& settings,
                            base::Array<CurvePoint>& points, base::Array<std::uint8_t>& found);

// Two places on the surface, near each other, with g < 0 at the first and g >= 0 at the second. So g has a zero between
// them.
struct Bracket {
    glm::dvec3 negative, positive;
};

// Finds a zero of g between each pair of places by bisection on the surface. The distance of the result from a zero is
// at most 2^-halvings times the distance of the places. Returns the number of evaluations.
std::int64_t bisect(const base::Work& work, const Level& level, const base::Array<Bracket>& places, int halvings,
                    base::Array<CurvePoint>& points);

// Moves a point by one Newton step towards f = 0, along grad f.
inline void step_to_surface(CurvePoint& p) noexcept {
    p.position -= p.value / glm::dot(p.gradient, p.gradient) * p.gradient;
}

// ---- Curves

// The curves. Their points are in the order given by CurvePoint::direction().
using Curves = Chains<CurvePoint>;

// The cubic between two consecutive points of a curve.
class CubicPiece {
public:
    CubicPiece(const CurvePoint& a, const CurvePoint& b) noexcept
        : a_(a.position), b_(b.position), length_(glm::distance(a_, b_)), begin_(tangent(a)), end_(tangent(b)) {
        // The factor after length_ is the speed of the cubic at both ends, in lengths of the chord. With this speed,
        // the middle of the cubic is on a circular arc. On an arc of radius 1 and angle t the speed is 4 tan(t / 4),
        // and the chord has the length 2 sin(t / 2).
        const double cosine = std::clamp(glm::dot(begin_, end_), 0.0, 1.0);
        const double speed = length_ * (2.0 / (1.0 + std::sqrt(0.5 * (1.0 + cosine))));
        begin_ *= speed;
        end_ *= speed;
    }

    [[nodiscard]] glm::dvec3 at(double u) const noexcept {
        const double v = 1.0 - u;
        return v * v * (1.0 + 2.0 * u) * a_ + u * u * (3.0 - 2.0 * u) * b_ + u * v * (v * begin_ - u * end_);
    }
    [[nodiscard]] glm::dvec3 derivative(double u) const noexcept {
        const double v = 1.0 - u;
        return 6.0 * u * v * (b_ - a_) + v * (v - 2.0 * u) * begin_ + u * (u - 2.0 * v) * end_;
    }
    [[nodiscard]] double length() const noexcept { return length_; }

private:
    // Returns the unit tangent at a point. If the curve has no direction, because f or g is constant there, returns the
    // direction of the chord.
    [[nodiscard]] glm::dvec3 tangent(const CurvePoint& point) const noexcept {
        const glm::dvec3 unit = glm::normalize(point.direction());
        if (std::isfinite(unit.x + unit.y + unit.z)) return unit;
        return length_ > 0.0 ? (b_ - a_) / length_ : glm::dvec3(0.0);
    }

    glm::dvec3 a_, b_;
    double length_;
    glm::dvec3 begin_, end_;
};

// A search for a zero between two places where a function has different signs, by the Illinois method. [Dowell &
// Jarratt 1971]
struct Illinois {
    double low = 0.0, high = 1.0;
    // The values of the function at both ends. If an end has not moved in two or more steps, its value is halved.
    double at_low, at_high;
    double trial; // the place to evaluate next
    int trusted;  // after this many steps, the search bisects
    int steps = 0;
    int kept = 0; // how often in a row an end has not moved: above 0 for the end `high`, below 0 for the end `low`

    Illinois(double from, double to, int trusted_steps = curve_tuning.most_steps) noexcept
        : at_low(from), at_high(to), trial(from / (from - to)), trusted(trusted_steps) {
        HRBFNPR_ASSERT(!(from * to > 0.0));
    }
    // Continues the search with the value of the function at `trial`.
    void take(double value) noexcept {
        const bool same = (value < 0.0) == (at_low < 0.0);
        (same ? low : high) = trial;
        (same ? at_low : at_high) = value;
        kept = same ? std::max(1, kept + 1) : std::min(-1, kept - 1);
        if (kept > 1) at_high *= 0.5;
        if (kept < -1) at_low *= 0.5;
        trial = low + (high - low) * at_low / (at_low - at_high);
        const bool found = at_low == 0.0 || at_high == 0.0;
        // If the value jumps, as it may at a sample, the search continues by bisection.
        if (++steps > trusted || (!found && !(trial > low && trial < high))) trial = 0.5 * (low + high);
    }
    [[nodiscard]] bool done(double width) const noexcept {
        return !(high - low > width) || at_low == 0.0 || at_high == 0.0;
    }
};

// ---- Nearness

[[nodiscard]] geometry::VecArray positions_of(const base::Array<CurvePoint>& points);
// Returns for each point the index of its curve.
[[nodiscard]] base::Array<std::int32_t> curve_of_points(const Curves& curves);

class NearCurves {
public:
    // Supports queries up to the distance `farthest`, for curves whose pieces are no longer than `longest`. The curves
    // must outlive this object.
    NearCurves(const Curves& curves, double longest, double farthest)
        : curves_(curves), longest_(longest), curve_(curve_of_points(curves)),
          grid_(positions_of(curves.point), longest + farthest) {
        HRBFNPR_ASSERT(longest > 0.0 && farthest >= 0.0);
    }

    // The place on a cubic that is nearest to a given place.
    struct Foot {
        glm::dvec3 place{0.0};
        double distance = HUGE_VAL;
        std::int64_t curve = -1; // -1 if no curve is near
    };
    // Returns the place on the curves that is nearest to `place`, if its distance is below `most`. Only curves whose
    // direction makes at most a right angle with `along` are searched. The curve with the index `but` is ignored.
    [[nodiscard]] Foot nearest(const glm::dvec3& place, const glm::dvec3& along, std::int64_t but = -1,
                               double most = HUGE_VAL) const;
    // Returns the index of the curve that nearest() finds within `distance`, or -1.
    [[nodiscard]] std::int64_t passing(const glm::dvec3& place, const glm::dvec3& along, double distance,
                                       std::int64_t but = -1) const {
        return nearest(place, along, but, std::nextafter(distance, HUGE_VAL)).curve;
    }
    // Returns whether a curve is within `distance` of `place` and makes at most a right angle with `along`. The search
    // begins near the point with the index `guess`. If it finds a curve, it sets `guess` to the index of the point near
    // which the curve was found.
    [[nodiscard]] bool passes(const glm::dvec3& place, const glm::dvec3& along, double distance,
                              std::int64_t& guess) const;

private:
    // Examines the two pieces that meet at a point. If their nearest place is nearer to `place` than `best`, sets
    // `best` to it.
    void examine_adjacent_pieces(std::int64_t point, const glm::dvec3& place, const glm::dvec3& along,
                                 Foot& best) const noexcept;

    const Curves& curves_;
    double longest_;
    base::Array<std::int32_t> curve_; // for each point: its curve
    geometry::PointGrid grid_;
};

// ---- Lines on a surface that do not depend on the camera

// In the points, CurvePoint::direction() is the direction of the line, and `gradient` is the normal of the surface. f
// and g are not used.
struct SurfaceLines {
    explicit SurfaceLines(base::Memory& memory) : curves(memory), strength(memory) {}

    Curves curves;
    base::Array<float> strength; // the strength at each point

    [[nodiscard]] std::int64_t bytes() const noexcept { return curves.bytes() + strength.bytes(); }
};

// Returns the tangent, at the middle of three consecutive points, of the circle through them. `in` and `out` are the
// vectors to the middle point and from it; the nearer of the other points has more weight. The tangent is not
// normalised.
[[nodiscard]] inline glm::dvec3 tangent_between(const glm::dvec3& in, const glm::dvec3& out) noexcept {
    const double a = glm::dot(in, in);
    const double b = glm::dot(out, out);
    return a > 0.0 && b > 0.0 ? in / a + out / b : in + out;
}

// Adds lines point by point.
class LineBuilder {
public:
    // If `as_given` is true, tangents are kept and normals are made perpendicular to them; the lines need not lie on
    // the surface. Otherwise normals are kept and tangents are changed.
    explicit LineBuilder(SurfaceLines& lines, bool as_given = false) noexcept : lines_(lines), as_given_(as_given) {}

    // Adds a point, unless it coincides with the last one. `tangent` may have any length. If it is 0, the tangent is
    // computed from the points.
    void add(const glm::dvec3& position, const glm::dvec3& normal, double strength,
             const glm::dvec3& tangent = glm::dvec3(0.0));
    // Adds a copy of a point of other lines.
    void add(const SurfaceLines& from, std::int64_t point);
    // Ends the line. It is dropped if it has too few points: an open line needs two, a closed line three.
    void end(bool closed);

private:
    SurfaceLines& lines_;
    bool as_given_;
};

// Returns the parts of lines where `value` is below 0, if `below` is set, or not below 0 otherwise. `value` has one
// number for each point. Parts end at the zeros, found by interpolation. For `as_given` see LineBuilder.
[[nodiscard]] SurfaceLines parts_where(const SurfaceLines& lines, const base::Array<double>& value, bool below,
                                       bool as_given);
// Returns the parts where the eye sees the outside of the surface, if `outside` is set, or the inside otherwise. They
// end where the line of sight is tangent to the surface, by the normals of the lines.
[[nodiscard]] SurfaceLines facing_parts(base::Memory& memory, const SurfaceLines& lines, const View& view,
                                        bool outside);

// Adds a point to each piece on which the surface turns from facing the eye to facing away from it. At the added point
// grad f is perpendicular to the line of sight. So a contour passes through the point, and the parts of the line that
// end there meet the contour.
[[nodiscard]] SurfaceLines with_turns(const base::Runtime& runtime, const SurfaceLines& lines,
                                      const implicit::Implicit& surface, const View& view);

} // namespace hrbfnpr::curves
