// One stroke: a curve through a field of directions that keeps its distance from the others.
// [Jobard & Lefer 1997, 3]
#pragma once

#include "base/operation.h"
#include "geometry/vec.h"
#include "sampling/stroke_grid.h"
#include "surface/direction_field.h"

namespace hrbfnpr::sampling {

// Distances in object units.
struct TraceSettings {
    double step = 0.0;         // from point to point
    double test = 0.0;         // a stroke ends where it comes nearer than this to a parallel one
    double longest = 0.0;      // 0 = no limit
    double least_cosine = 0.9; // of the turn from point to point; sharper ones end the stroke
    std::int32_t thin = 1;     // every thin-th point stands in the grid
    bool turned = false;       // the second set of a line field
    geometry::Bounds region;   // strokes stay inside
    base::Progress progress;   // only looked at for a cancel
};

// Whether two points see each other as neighbours: on the same side, with strokes that run alike.
[[nodiscard]] inline bool run_alike(const StrokePoint& a, const StrokePoint& b) noexcept {
    constexpr double cosine = 0.7071067811865476; // 45 degrees: each stroke of a cross has its own
    return glm::dot(a.normal, b.normal) > 0.0 && std::abs(glm::dot(a.direction, b.direction)) > cosine;
}

// Squared distance by which strokes are kept apart: how near another one is ahead counts more than it is, so that
// strokes end nearer to the tip of one that they go on from than to one beside them, and leave no bald spots.
[[nodiscard]] inline double squared_clearance(const StrokePoint& from, const glm::dvec3& offset) noexcept {
    constexpr double stretch = 1.7;
    const double along = glm::dot(offset, from.direction);
    return glm::dot(offset, offset) + (stretch * stretch - 1.0) * along * along;
}

class Tracer {
public:
    Tracer(base::Memory& memory, const surface::DirectionField& field, StrokeGrid& grid) noexcept
        : field_(field), grid_(grid), ahead_(memory), behind_(memory) {}

    // The point of the field nearest to p, on the side of `normal`, with the direction nearest to `along`.
    // False where there is none.
    bool settle(const glm::dvec3& p, const glm::dvec3& normal, const glm::dvec3& along, bool turned,
                StrokePoint& point) const noexcept;
    // Both ways from `seed`.  The points stand in the grid as those of `stroke` afterwards.
    void trace(const StrokePoint& seed, std::int32_t stroke, const TraceSettings& settings);

    // Of the last stroke, from end to end.
    [[nodiscard]] std::int64_t count() const noexcept { return ahead_.size() + behind_.size(); }
    [[nodiscard]] const StrokePoint& point(std::int64_t i) const noexcept {
        return i < behind_.size() ? behind_[behind_.size() - 1 - i] : ahead_[i - behind_.size()];
    }
    // Its ends meet.
    [[nodiscard]] bool closed() const noexcept { return closed_; }

private:
    enum class Verdict { free, blocked, closes };

    bool advance(const StrokePoint& from, const TraceSettings& settings, StrokePoint& to) const noexcept;
    [[nodiscard]] Verdict look(const StrokePoint& point, std::int32_t stroke, std::int32_t place,
                               const TraceSettings& settings) const noexcept;
    void run(const StrokePoint& from, int side, std::int32_t stroke, std::int64_t most, const TraceSettings& settings);
    void close_up(const StrokePoint& end, std::int32_t stroke, std::int32_t place, const TraceSettings& settings);

    const surface::DirectionField& field_;
    StrokeGrid& grid_;
    base::Array<StrokePoint> ahead_;  // from the seed on
    base::Array<StrokePoint> behind_; // the other way, without the seed
    bool closed_ = false;
};

} // namespace hrbfnpr::sampling
