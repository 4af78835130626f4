// SPDX-License-Identifier: MIT
// The data that all stages of the sampling share: the surface, seeds, the caller's directions, the projection of points
// onto the surface, and the growing marks of a layer in double precision.
#pragma once

#include "base/work.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"
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
    double unit = 1.0; // the unit of all lengths here, in the caller's unit

    [[nodiscard]] base::Memory& memory() const noexcept { return work.memory; }
    // Return the same site with a part of the work's progress, or with another progress.
    [[nodiscard]] Site part(double from, double to) const noexcept { return with(work.progress().part(from, to)); }
    [[nodiscard]] Site without_progress() const noexcept { return with(work.progress().without_progress()); }
    [[nodiscard]] Site with(const base::Progress& progress) const noexcept {
        return {{work.runtime(), progress}, implicit, projection_tolerance, random_seed, unit};
    }
};

// A stage handles this many points at a time. This bounds its scratch memory and the time between two checks for
// cancellation, and is enough work for all threads.
inline constexpr std::int64_t chunk_size = 16384;

// Projects a chunk of points and keeps those that converged near where they started.
class MarkProjector {
public:
    explicit MarkProjector(const Site& site) noexcept
        : start(site.memory()), site_(site), projection_(site.memory()), placed_(site.memory()) {}

    // Counts every start in `report` as attempted, and as placed or dropped. A start is dropped as strayed if it lands
    // farther than `stray_limit` away.
    void project(double stray_limit, LevelReport& report, const base::Progress& progress);

    [[nodiscard]] bool placed(std::int64_t i) const noexcept { return placed_[i] != 0; }
    [[nodiscard]] glm::dvec3 position(std::int64_t i) const noexcept { return projection_.position[i]; }
    [[nodiscard]] glm::dvec3 normal(std::int64_t i) const noexcept;
    // Drops a point that was placed.
    void drop(std::int64_t i, std::int64_t& reason, LevelReport& report) noexcept;

    geometry::VecArray start; // filled by the caller

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

    // Returns the first-order distance to the surface, f / |grad f|. It is infinite or NaN where that is not defined,
    // for example where the square of the gradient overflows or vanishes.
    [[nodiscard]] double distance(std::int64_t i) const noexcept {
        const double slope = glm::length(gradient[i]);
        return surface::is_usable_slope(slope) ? value[i] / slope : std::numeric_limits<double>::quiet_NaN();
    }
};
void evaluate(const Site& site, const geometry::VecArray& points, FieldSamples& fields);

// The seeds from which marks start. [NPAR 4.2, 5.1]
struct Seeds {
    explicit Seeds(base::Memory& memory) noexcept : position(memory), normal(memory) {}

    geometry::VecArray position; // on the surface
    geometry::VecArray normal;   // unit
    SeedSource source = SeedSource::points;
    LevelReport report;
    double step = 0.0; // rho_0: the caller's value, or the estimate for this source
};

// Functions of the caller that return directions or densities at places.
using PointFunction = std::int32_t (*)(void* user, std::int64_t count, const double* positions, const double* normals,
                                       double* results);

// Asks for `components` numbers at each place. Calls the function on the calling thread, for some places at a time. The
// numbers are 0 before the call. Throws Error{callback} with the function's name if it fails.
[[nodiscard]] base::Array<double> call_at_points(const Site& site, PointFunction function, void* user, const char* name,
                                                 const geometry::VecArray& positions, const geometry::VecArray& normals,
                                                 std::int64_t components);

// The caller's field of directions.
struct DirectionFunction {
    PointFunction function = nullptr;
    void* user = nullptr;

    [[nodiscard]] bool operator==(const DirectionFunction& other) const noexcept = default;
};

// Returns the unit vector of d's part in the plane perpendicular to n, or 0 if that part is too short.
[[nodiscard]] glm::dvec3 tangent_part(const glm::dvec3& d, const glm::dvec3& n) noexcept;

// Fills in unit tangents, or zero where the field has none. Throws Error{callback}.
void directions_at(const Site& site, const DirectionFunction& field, const geometry::VecArray& positions,
                   const geometry::VecArray& normals, geometry::VecArray& directions);

// The limits for the size of a model or set on which marks, which are floats, can be placed. Distances and curvatures
// in the caller's unit then stay within a float's normal range.
inline constexpr double smallest_size = 1e-33;
inline constexpr double largest_size = 1e33;

// Throws Error{invalid_argument} for sizes beyond these limits. `what` names the object of that size, and `remedy` what
// to scale.
void require_size(const char* what, double size, const char* remedy);

// ---- Marks

struct Marks {
    explicit Marks(base::Memory& memory) noexcept
        : position(memory), normal(memory), direction(memory), curvature(memory), curvature_along(memory), key(memory),
          stroke(memory), place(memory), level(memory), rank(memory), width(memory) {}

    geometry::VecArray position;
    geometry::VecArray normal;
    geometry::VecArray direction;                // strokes only, until assembled
    base::Array<std::array<float, 3>> curvature; // k1, k2, confidence; may be empty
    base::Array<double> curvature_along;         // curvature strokes only: the normal curvature along the direction
    base::Array<std::uint64_t> key;    // the mark's identity, whatever marks were dropped; keys random numbers
    base::Array<std::uint32_t> stroke; // for a stroke: 2 * seed + its direction, 0 or 1; for a stipple: its seed
    base::Array<std::int32_t> place;   // the place along the stroke, in finest steps from the seed
    base::Array<std::uint8_t> level;
    base::Array<float> rank;  // may be empty: assemble() makes them. If not, marks are in their final order
    base::Array<float> width; // may be empty: all 1

    [[nodiscard]] std::int64_t count() const noexcept { return position.size(); }
};

// Returns a curvature as a float, limited to the largest float.
[[nodiscard]] inline float clamped_curvature(double k) noexcept {
    constexpr double most = std::numeric_limits<float>::max();
    return static_cast<float>(k < -most ? -most : k > most ? most : k);
}

// Larger sets are refused before they are made: identities of marks are 32 bits wide.
inline constexpr std::int64_t most_marks = std::int64_t{1} << 31;
// The limit for BLUE_NOISE, which takes some 300 bytes for each mark while it works.
inline constexpr std::int64_t most_even_marks = 100000000;

// Returns base * factor^levels. This does not overflow for any input that the boundary accepts.
[[nodiscard]] std::int64_t grown_count(std::int64_t base, std::int64_t factor, std::int32_t levels) noexcept;

// Refuses layers[layer] if it would have more than most_marks after `levels` steps. Layer -1 is the stipples that serve
// only as starts of strokes.
void require_room(std::int64_t layer, std::int64_t full_count, std::int32_t levels, std::int64_t budget);

// A random choice of `kept` candidates: it keeps the candidates with the smallest random keys. So the choice does not
// depend on the order of the candidates.
class Thinning {
public:
    Thinning() noexcept = default; // keeps all candidates
    // key_of(i) identifies candidate i in [0, count).
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
    std::uint64_t limit_ = 0; // candidates with tickets below it are kept
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

// Returns the seed of a layer's random numbers, which do not depend on the other layers. `number` is the layer's number
// among those of its kind.
[[nodiscard]] std::uint64_t layer_seed(std::uint64_t random_seed, Kind kind, std::int64_t number) noexcept;

// Streams keep the random numbers of stipples and of strokes with the same seed apart.
inline constexpr std::uint32_t stream_count = 2;
[[nodiscard]] constexpr std::uint32_t stream_of(Kind kind) noexcept { return kind == Kind::hatch ? 1U : 0U; }

} // namespace hrbfnpr::marks
