// SPDX-License-Identifier: MIT
// Curves f = g = 0 on a surface, as polylines with a cubic between consecutive points: their points, Newton's method
// that brings places onto a curve, the cubics, and queries whether a curve passes near a place. Also lines on a surface
// that do not depend on the camera, as curves with a strength at each point, and their parts that face a camera.
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

// The camera in the surface's own coordinates.
struct View {
    // The image of a place.
    struct Seen {
        glm::dvec2 place; // pixels
        double w;         // > 0 in front of the eye
    };

    glm::dvec4 eye{0.0, 0.0, 0.0, 1.0}; // w = 1: the position of the eye; w = 0: the viewing direction
    glm::dmat4 to_window{1.0};          // to (x w, y w, depth w, w), pixels

    // The vector from the eye to a point, not normalised.
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
    // Evaluates at most implicit::batch_size points on the calling thread. g and its gradient need not be correct far
    // from f = 0.
    virtual void evaluate(const implicit::PointBatch& points, const LevelBatch& out) const = 0;
    // Computes g at the vertices of a mesh of the surface from the gradients that the mesh stores. `level` is resized.
    virtual void at_vertices(const base::Work& work, const SurfaceMesh& mesh, base::Array<double>& level) const = 0;
};

// The occluding contour: g = grad f . v, where v is the vector from the eye to the point.
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

// The border of the support: g = s - limit, with s from surface/support.h. The surface lies to the left of the border.
class SupportLevel final : public Level {
public:
    SupportLevel(const implicit::Implicit& surface, const surface::Support& support, double limit) noexcept
        : surface_(surface), support_(support), limit_(limit) {}

    [[nodiscard]] const implicit::Implicit& surface() const noexcept override { return surface_; }
    void evaluate(const implicit::PointBatch& points, const LevelBatch& out) const override;
    void at_vertices(const base::Work& work, const SurfaceMesh& mesh, base::Array<double>& level) const override;

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
    std::int64_t is_cusp = 0;       // 1: the line of sight is tangent to the curve here; set by with_cusps()

    // The direction of the curve, with negative g to its left; not normalised.
    [[nodiscard]] glm::dvec3 direction() const noexcept { return glm::cross(gradient, level_gradient); }
    // Returns the shortest step to f = g = 0 if both functions are linear: -J^T (J J^T)^-1 (f, g). The step is not
    // finite if the gradients are parallel.
    [[nodiscard]] glm::dvec3 newton_step() const noexcept;
};

// Evaluates f and g at the positions of all points, in parallel.
void evaluate(const base::Work& work, const Level& level, base::Array<CurvePoint>& points);

// Brings each point onto its curve by one Newton step, and by a second one if the first was longer than enough[i]. Adds
// to `evaluations`.
void bring_closer(const base::Work& work, const Level& level, const base::Array<double>& enough,
                  base::Array<CurvePoint>& points, std::int64_t& evaluations);

struct NewtonSettings {
    // A step shorter than this is the last one; so is a longer step if the step after it would be negligible.
    double tolerance = 0.0;
    double farthest = 0.0; // a point that moves farther from its start is given up
};

// Brings points onto curves, all in parallel. found[i] is 1 if point i got there. Returns the number of evaluations.
std::int64_t bring_to_curve(const base::Work& work, const Level& level, const NewtonSettings& settings,
                            base::Array<CurvePoint>& points, base::Array<std::uint8_t>& found);

// Two places of the surface near each other, with g < 0 at the first and g >= 0 at the second, so that g has a zero
// between them.
struct Bracket {
    glm::dvec3 negative, positive;
};

// Finds a zero of g between each pair of places by bisection on the surface. Each point is within 2^-halvings of the
// places' distance of a zero. Returns the number of evaluations.
std::int64_t bisect(const base::Work& work, const Level& level, const base::Array<Bracket>& places, int halvings,
                    base::Array<CurvePoint>& points);

// Makes a Newton step towards f = 0 along grad f.
inline void step_to_surface(CurvePoint& p) noexcept {
    p.position -= p.value / glm::dot(p.gradient, p.gradient) * p.gradient;
}

// ---- Curves

// The points are in the order of CurvePoint::direction().
using Curves = Chains<CurvePoint>;

// The cubic between two points of a curve.
class CubicPiece {
public:
    CubicPiece(const CurvePoint& a, const CurvePoint& b) noexcept
        : a_(a.position), b_(b.position), length_(glm::distance(a_, b_)), begin_(tangent(a)), end_(tangent(b)) {
        // With this speed at both ends, in chords, the middle of the cubic lies on a circular arc: an arc of angle t
        // needs the speed 4 tan(t / 4) radii, and its chord is 2 sin(t / 2) radii.
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
    // Returns the chord if the curve has no direction, which happens where one of its functions is constant.
    [[nodiscard]] glm::dvec3 tangent(const CurvePoint& point) const noexcept {
        const glm::dvec3 unit = glm::normalize(point.direction());
        if (std::isfinite(unit.x + unit.y + unit.z)) return unit;
        return length_ > 0.0 ? (b_ - a_) / length_ : glm::dvec3(0.0);
    }

    glm::dvec3 a_, b_;
    double length_;
    glm::dvec3 begin_, end_;
};

// The search for a zero between two places where a function has different signs: the Illinois method. [Dowell & Jarratt
// 1971]
struct Illinois {
    double low = 0.0, high = 1.0;
    double at_low, at_high; // the values at both ends; the value of an end that stays is halved
    double trial;           // the place of the next evaluation
    int trusted;            // after this many steps the search bisects
    int steps = 0;
    int kept = 0; // how often in a row the same end stayed: > 0: the higher end, < 0: the lower end

    Illinois(double from, double to, int trusted_steps = curve_tuning.most_steps) noexcept
        : at_low(from), at_high(to), trial(from / (from - to)), trusted(trusted_steps) {
        HRBFNPR_ASSERT(!(from * to > 0.0));
    }
    // Takes the function's value at the trial.
    void take(double value) noexcept {
        const bool same = (value < 0.0) == (at_low < 0.0);
        (same ? low : high) = trial;
        (same ? at_low : at_high) = value;
        kept = same ? std::max(1, kept + 1) : std::min(-1, kept - 1);
        if (kept > 1) at_high *= 0.5;
        if (kept < -1) at_low *= 0.5;
        trial = low + (high - low) * at_low / (at_low - at_high);
        const bool found = at_low == 0.0 || at_high == 0.0;
        // The value may jump, for example at a sample: then bisection continues.
        if (++steps > trusted || (!found && !(trial > low && trial < high))) trial = 0.5 * (low + high);
    }
    [[nodiscard]] bool done(double width) const noexcept {
        return !(high - low > width) || at_low == 0.0 || at_high == 0.0;
    }
};

// ---- Nearness

[[nodiscard]] geometry::VecArray positions_of(const base::Array<CurvePoint>& points);
// The number of the curve of each point.
[[nodiscard]] base::Array<std::int32_t> curve_of_points(const Curves& curves);

class NearCurves {
public:
    // Supports queries up to the distance `farthest`, for curves whose pieces are no longer than `longest`. The curves
    // must outlive it.
    NearCurves(const Curves& curves, double longest, double farthest)
        : curves_(curves), longest_(longest), curve_(curve_of_points(curves)),
          grid_(positions_of(curves.point), longest + farthest) {
        HRBFNPR_ASSERT(longest > 0.0 && farthest >= 0.0);
    }

    // The nearest place on a cubic.
    struct Foot {
        glm::dvec3 place{0.0};
        double distance = HUGE_VAL;
        std::int64_t curve = -1; // -1: no curve is near
    };
    // Returns the nearest place on the curves that run in the direction `along`, if it is nearer than `most`. The curve
    // `but` is ignored.
    [[nodiscard]] Foot nearest(const glm::dvec3& place, const glm::dvec3& along, std::int64_t but = -1,
                               double most = HUGE_VAL) const;
    // Returns the nearest curve in the direction `along` if it is within `distance`, else -1.
    [[nodiscard]] std::int64_t passing(const glm::dvec3& place, const glm::dvec3& along, double distance,
                                       std::int64_t but = -1) const {
        return nearest(place, along, but, std::nextafter(distance, HUGE_VAL)).curve;
    }
    // Whether a curve in the direction `along` is within `distance`. Looks near the point `guess` first, and sets it to
    // the point near which a curve was found.
    [[nodiscard]] bool passes(const glm::dvec3& place, const glm::dvec3& along, double distance,
                              std::int64_t& guess) const;

private:
    // Examines the pieces on both sides of a point, and sets `best` to their nearest place if that is nearer.
    void examine_adjacent_pieces(std::int64_t point, const glm::dvec3& place, const glm::dvec3& along,
                                 Foot& best) const noexcept;

    const Curves& curves_;
    double longest_;
    base::Array<std::int32_t> curve_; // the curve of each point
    geometry::PointGrid grid_;
};

// ---- Lines on a surface that do not depend on the camera

// CurvePoint::direction() runs along the line, and `gradient` is the surface's normal; f and g are unused.
struct SurfaceLines {
    explicit SurfaceLines(base::Memory& memory) : curves(memory), strength(memory) {}

    Curves curves;
    base::Array<float> strength; // the strength at each point

    [[nodiscard]] std::int64_t bytes() const noexcept { return curves.bytes() + strength.bytes(); }
};

// The tangent of the circle through three consecutive points at the middle one. `in` and `out` are the vectors to that
// point and from it; the nearer point has more weight. The tangent is not normalised.
[[nodiscard]] inline glm::dvec3 tangent_between(const glm::dvec3& in, const glm::dvec3& out) noexcept {
    const double a = glm::dot(in, in);
    const double b = glm::dot(out, out);
    return a > 0.0 && b > 0.0 ? in / a + out / b : in + out;
}

// Adds lines point by point.
class LineBuilder {
public:
    // as_given: tangents are kept and normals made perpendicular to them, since the lines need not lie on the surface;
    // otherwise normals are kept and tangents changed.
    explicit LineBuilder(SurfaceLines& lines, bool as_given = false) noexcept : lines_(lines), as_given_(as_given) {}

    // Adds a point unless it coincides with the last one. tangent: of any length; 0: it is computed from the points.
    void add(const glm::dvec3& position, const glm::dvec3& normal, double strength,
             const glm::dvec3& tangent = glm::dvec3(0.0));
    // Adds a point of other lines.
    void add(const SurfaceLines& from, std::int64_t point);
    // Ends the line. It is dropped if it has too few points: two for an open line, three for a closed one.
    void end(bool closed);

private:
    SurfaceLines& lines_;
    bool as_given_;
};

// The parts of lines where `value` is below 0 if `below` is set, else those where it is not. `value` has one entry for
// each point; parts end at its zeros by interpolation. as_given: see LineBuilder.
[[nodiscard]] SurfaceLines parts_where(const SurfaceLines& lines, const base::Array<double>& value, bool below,
                                       bool as_given);
// The parts where the surface shows its outside to the eye if `outside` is set, else its inside. They end where the
// line of sight is tangent to the surface, according to the lines' normals.
[[nodiscard]] SurfaceLines facing_parts(base::Memory& memory, const SurfaceLines& lines, const View& view,
                                        bool outside);

// Adds a point to each piece on which the surface turns from facing the eye to facing away, where grad f is
// perpendicular to the line of sight. Parts that end there then meet the contours that end there.
[[nodiscard]] SurfaceLines with_turns(const base::Runtime& runtime, const SurfaceLines& lines,
                                      const implicit::Implicit& surface, const View& view);

} // namespace hrbfnpr::curves
