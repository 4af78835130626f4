// SPDX-License-Identifier: MIT
// The data that all stages of mark generation share: the surface, the seeds, the caller's directions, the projection of
// points onto the surface, and the growing marks of a layer in double precision.
#pragma once

#include "base/work.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"
#include "marks/need.h"
#include "marks/point_set.h"
#include "surface/project.h"

#include <array>
#include <limits>

namespace hrbfnpr::marks {

struct Site {
    base::Work work;
    const implicit::Implicit& implicit;
    double projection_tolerance; // in diagonals
    std::uint64_t random_seed;
    double unit = 1.0;          // the unit of all lengths in this struct, in the caller's units
    const Need* need = nullptr; // tells which marks a still picture needs; null: all marks are needed

    [[nodiscard]] base::Memory& memory() const noexcept { return work.memory; }
    // Return the same site with a part of the work's progress, with no progress, or with the given progress.
    [[nodiscard]] Site part(double from, double to) const noexcept { return with(work.progress().part(from, to)); }
    [[nodiscard]] Site without_progress() const noexcept { return with(work.progress().without_progress()); }
    [[nodiscard]] Site with(const base::Progress& progress) const noexcept {
        return {{work.runtime(), progress}, implicit, projection_tolerance, random_seed, unit, need};
    }
};

// The number of points that a stage handles at a time. It bounds scratch memory and the time between two checks for
// cancellation, and is enough work for all threads.
inline constexpr std::int64_t chunk_size = 16384;

// Projects a chunk of points and keeps those that converged near where they started.
class MarkProjector {
public:
    explicit MarkProjector(const Site& site) noexcept
        : start(site.memory()), site_(site), projection_(site.memory()), placed_(site.memory()) {}

    // Projects the points in `start`. Counts each of them in `report` as attempted, and as placed or dropped. A point
    // that lands farther than `stray_limit` from its start is dropped as strayed.
    void project(double stray_limit, LevelReport& report, const base::Progress& progress);

    [[nodiscard]] bool placed(std::int64_t i) const noexcept { return placed_[i] != 0; }
    [[nodiscard]] glm::dvec3 position(std::int64_t i) const noexcept { return projection_.position[i]; }
    [[nodiscard]] glm::dvec3 normal(std::int64_t i) const noexcept;
    // Drops a point that was placed before. `reason` is the counter to increase.
    void drop(std::int64_t i, std::int64_t& reason, LevelReport& report) noexcept;

    geometry::VecArray start; // the starting points; the caller fills it

private:
    static constexpr std::uint8_t beyond = 2;

    void drop_beyond_end(LevelReport& report);

    const Site& site_;
    surface::Projection projection_;
    base::Array<std::uint8_t> placed_;
};

// The value and the gradient of f at all points.
struct FieldSamples {
    explicit FieldSamples(base::Memory& memory) noexcept : value(memory), gradient(memory) {}

    base::Array<double> value;
    geometry::VecArray gradient;

    // Returns the first-order estimate f / |grad f| of the distance to the surface. It is infinite or NaN where it is
    // undefined, for example where the square of the gradient overflows or becomes 0.
    [[nodiscard]] double distance(std::int64_t i) const noexcept {
        const double slope = glm::length(gradient[i]);
        return surface::is_usable_slope(slope) ? value[i] / slope : std::numeric_limits<double>::quiet_NaN();
    }
};
void evaluate(const Site& site, const geometry::VecArray& points, FieldSamples& fields);

// The seeds from which marks start. [NPAR 4.2, 5.1]
struct Seeds {
    explicit Seeds(base::Memory& memory) noexcept : position(memory), normal(memory) {}

    geometry::VecArray position; // places on the surface
    geometry::VecArray normal;   // unit normals
    SeedSource source = SeedSource::points;
    LevelReport report;
    double step = 0.0; // rho_0 of the article: the caller's value, or an estimate from the seeds
};

// A function of the caller that returns directions or densities at places.
using PointFunction = std::int32_t (*)(void* user, std::int64_t count, const double* positions, const double* normals,
                                       double* results);

// Calls a function of the caller, which gives `components` numbers for each place. Calls it on the calling thread, for
// one block of places after the other. The numbers are 0 before each call. If the function fails, throws
// Error{callback} with the function's name.
[[nodiscard]] base::Array<double> call_at_points(const Site& site, PointFunction function, void* user, const char* name,
                                                 const geometry::VecArray& positions, const geometry::VecArray& normals,
                                                 std::int64_t components);

// The caller's field of directions.
struct DirectionFunction {
    PointFunction function = nullptr;
    void* user = nullptr;

    [[nodiscard]] bool operator==(const DirectionFunction& other) const noexcept = default;
};

// Returns the unit vector of d's component perpendicular to n; 0 if this component is too short.
[[nodiscard]] glm::dvec3 tangent_part(const glm::dvec3& d, const glm::dvec3& n) noexcept;

// Returns unit tangents, or 0 where the function gives no direction. Throws Error{callback}.
void directions_at(const Site& site, const DirectionFunction& field, const geometry::VecArray& positions,
                   const geometry::VecArray& normals, geometry::VecArray& directions);

// The smallest and largest size of a model or set on which marks can be placed. Within these limits, distances and
// curvatures in the caller's unit are in the normal range of a float.
inline constexpr double smallest_size = 1e-33;
inline constexpr double largest_size = 1e33;

// Throws Error{invalid_argument} if a size is outside these limits. The message uses `what` for the object of that
// size, and `remedy` for what to scale.
void require_size(const char* what, double size, const char* remedy);

// ---- Marks

struct Marks {
    explicit Marks(base::Memory& memory) noexcept
        : position(memory), normal(memory), direction(memory), curvature(memory), curvature_along(memory), key(memory),
          stroke(memory), place(memory), level(memory), rank(memory), width(memory) {}

    geometry::VecArray position;
    geometry::VecArray normal;
    geometry::VecArray direction;                // only for strokes, until the layer is assembled
    base::Array<std::array<float, 3>> curvature; // k1, k2, confidence; may be empty
    // Only for strokes along curvature: the normal curvature along the direction.
    base::Array<double> curvature_along;
    // A number that identifies the mark, and does not change if other marks are dropped. It is the key of random
    // numbers.
    base::Array<std::uint64_t> key;
    // For a stroke: 2 * seed + direction (0 or 1); for a stipple: the index of its seed.
    base::Array<std::uint32_t> stroke;
    base::Array<std::int32_t> place; // the position along the stroke, in steps of the finest level from the seed
    base::Array<std::uint8_t> level;
    base::Array<float> rank;  // if empty, assemble() makes the ranks; if not, the marks are in their final order
    base::Array<float> width; // empty if all are 1
    // The number of marks that the whole surface would have, if only those of a `Need` were placed. 0: all were placed.
    std::int64_t whole = 0;

    [[nodiscard]] std::int64_t count() const noexcept { return position.size(); }
    [[nodiscard]] std::int64_t whole_count() const noexcept { return whole > 0 ? whole : count(); }
};

// Returns a curvature as a float, limited to the largest float.
[[nodiscard]] inline float clamped_curvature(double k) noexcept {
    constexpr double most = std::numeric_limits<float>::max();
    return static_cast<float>(k < -most ? -most : k > most ? most : k);
}

// The largest number of marks in a layer. Larger layers are refused before they are made, because mark ids have 32
// bits.
inline constexpr std::int64_t most_marks = std::int64_t{1} << 31;
// The largest number of marks for BLUE_NOISE, which needs about 300 bytes of working memory for each mark.
inline constexpr std::int64_t most_even_marks = 100000000;

// Returns base * factor^levels. This does not overflow for any input that the boundary accepts.
[[nodiscard]] std::int64_t grown_count(std::int64_t base, std::int64_t factor, std::int32_t levels) noexcept;

// Refuses layers[layer] if it would have more than most_marks after `levels` steps. Layer -1 is the stipples that are
// made only as starts of strokes.
void require_room(std::int64_t layer, std::int64_t full_count, std::int32_t levels, std::int64_t budget);

// Chooses `kept` candidates at random: those with the smallest random keys. So the choice does not depend on the order
// of the candidates.
class Thinning {
public:
    Thinning() noexcept = default; // keeps all candidates
    // key_of(i) returns a number that identifies candidate i in [0, count).
    template <class KeyOf>
    Thinning(const Site& site, std::int64_t count, std::int64_t kept, std::uint32_t stream, KeyOf key_of);

    [[nodiscard]] bool active() const noexcept { return active_; }
    [[nodiscard]] bool keeps(std::uint64_t key) const noexcept { return !active_ || ticket(key) < limit_; }

private:
    [[nodiscard]] std::uint64_t ticket(std::uint64_t key) const noexcept;
    void choose(base::Array<std::uint64_t>& tickets, std::int64_t kept, const base::Progress& progress);

    bool active_ = false;
    std::uint64_t seed_ = 0;
    std::uint32_t stream_ = 0;
    std::uint64_t limit_ = 0; // candidates with tickets below this are kept
};

template <class KeyOf>
Thinning::Thinning(const Site& site, std::int64_t count, std::int64_t kept, std::uint32_t stream, KeyOf key_of)
    : active_(kept < count), seed_(site.random_seed), stream_(stream) {
    if (!active_) return;
    base::Array<std::uint64_t> tickets(site.memory());
    tickets.resize_for_overwrite(count);
    site.work.for_chunks(count, chunk_size, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) tickets[i] = ticket(key_of(i));
    });
    choose(tickets, kept, site.work);
}

// Returns the seed of the random numbers of a layer, which do not depend on the other layers. `number` is the layer's
// index among layers of its kind.
[[nodiscard]] std::uint64_t layer_seed(std::uint64_t random_seed, Kind kind, std::int64_t number) noexcept;

// The number of streams of random numbers. Stipples and strokes use separate streams, so that their numbers differ even
// with the same seed.
inline constexpr std::uint32_t stream_count = 2;
[[nodiscard]] constexpr std::uint32_t stream_of(Kind kind) noexcept { return kind == Kind::hatch ? 1U : 0U; }

} // namespace hrbfnpr::marks
