// SPDX-License-Identifier: MIT
// What every stage of the sampling works on: the surface, seeds, the caller's directions, how a point comes to rest on
// the surface, and the marks of a layer while they grow, in double precision.
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
    // The same site with a part of the work's progress, or with the progress of another stage.
    [[nodiscard]] Site part(double from, double to) const noexcept { return with(work.progress().part(from, to)); }
    [[nodiscard]] Site standing() const noexcept { return with(work.progress().standing()); }
    [[nodiscard]] Site with(const base::Progress& progress) const noexcept {
        return {{work.runtime(), progress}, implicit, projection_tolerance, random_seed, unit};
    }
};

// A stage handles this many points at a time, which bounds its scratch memory and the time between two looks for a
// cancel, and is enough work for all threads.
inline constexpr std::int64_t chunk_size = 16384;

// Projects a chunk of points and keeps those that converged near where they started.
class Settler {
public:
    explicit Settler(const Site& site) noexcept
        : start(site.memory()), site_(site), projection_(site.memory()), placed_(site.memory()) {}

    // Every start is counted in `report` as attempted and as placed or as dropped; one is dropped
    // as strayed if it lands farther than `stray_limit` from its start.
    void settle(double stray_limit, LevelReport& report, const base::Progress& progress);

    [[nodiscard]] bool placed(std::int64_t i) const noexcept { return placed_[i] != 0; }
    [[nodiscard]] glm::dvec3 position(std::int64_t i) const noexcept { return projection_.position[i]; }
    [[nodiscard]] glm::dvec3 normal(std::int64_t i) const noexcept;
    // Takes back a placed point.
    void drop(std::int64_t i, std::int64_t& reason, LevelReport& report) noexcept;

    geometry::VecArray start; // filled by the caller

private:
    static constexpr std::uint8_t beyond = 2;

    void drop_beyond_end(LevelReport& report);

    const Site& site_;
    surface::Projection projection_;
    base::Array<std::uint8_t> placed_;
};

// Value and gradient at all points, on all threads.
struct FieldSamples {
    explicit FieldSamples(base::Memory& memory) noexcept : value(memory), gradient(memory) {}

    base::Array<double> value;
    geometry::VecArray gradient;

    // The distance to the surface to first order, f / |grad f|; infinite or NaN where that makes no sense, as where
    // the square of the gradient overflows or vanishes.
    [[nodiscard]] double distance(std::int64_t i) const noexcept {
        const double slope = glm::length(gradient[i]);
        return surface::is_slope(slope) ? value[i] / slope : std::numeric_limits<double>::quiet_NaN();
    }
};
void evaluate(const Site& site, const geometry::VecArray& points, FieldSamples& fields);

// Where marks start from.                                             [NPAR 4.2, 5.1]
struct Seeds {
    explicit Seeds(base::Memory& memory) noexcept : position(memory), normal(memory) {}

    geometry::VecArray position; // on the surface
    geometry::VecArray normal;   // unit
    SeedSource source = SeedSource::points;
    LevelReport report;
    double step = 0.0; // rho_0: as set, or the estimate for this source
};

// Functions of the caller that give directions or densities at places.
using PlaceFn = std::int32_t (*)(void* user, std::int64_t count, const double* positions, const double* normals,
                                 double* results);

// Asks for `components` numbers at each place, some places at a time, on the thread that it is called on; they are 0 at
// first. Throws Error{callback} with the function's name if it fails.
[[nodiscard]] base::Array<double> ask_at(const Site& site, PlaceFn function, void* user, const char* name,
                                         const geometry::VecArray& positions, const geometry::VecArray& normals,
                                         std::int64_t components);

// The caller's field of directions.
struct DirectionFunction {
    PlaceFn function = nullptr;
    void* user = nullptr;

    [[nodiscard]] bool operator==(const DirectionFunction& other) const noexcept = default;
};

// The unit part of d in the plane across n; 0: d has hardly a part there.
[[nodiscard]] glm::dvec3 tangent_part(const glm::dvec3& d, const glm::dvec3& n) noexcept;

// Fills in unit tangents, or zero where the field has none. Throws Error{callback}.
void directions_at(const Site& site, const DirectionFunction& field, const geometry::VecArray& positions,
                   const geometry::VecArray& normals, geometry::VecArray& directions);

// Diagonals of what marks, which are floats, can be placed on: their distances and curvatures, in the caller's unit,
// stay within a float's normal range.
inline constexpr double smallest_size = 1e-33;
inline constexpr double largest_size = 1e33;

// Throws Error{invalid_argument} for sizes beyond; `what` has that size, and `remedy` is scaled.
void require_size(const char* what, double size, const char* remedy);

// ---- Marks

struct Marks {
    explicit Marks(base::Memory& memory) noexcept
        : position(memory), normal(memory), direction(memory), curvature(memory), bend(memory), key(memory),
          stroke(memory), place(memory), level(memory), rank(memory), width(memory) {}

    geometry::VecArray position;
    geometry::VecArray normal;
    geometry::VecArray direction;                // strokes only, until assembled
    base::Array<std::array<float, 3>> curvature; // k1, k2, confidence; may be empty
    base::Array<double> bend;                    // curvature strokes only: normal curvature along the direction
    base::Array<std::uint64_t> key;              // the mark's identity, whatever was dropped: keys random numbers
    base::Array<std::uint32_t> stroke;           // 2 * seed + set; for a stipple its seed
    base::Array<std::int32_t> place;             // along the stroke, the seed at 0, in finest steps
    base::Array<std::uint8_t> level;
    base::Array<float> rank;  // may be empty: by number, or at random. If not, marks are in their final order
    base::Array<float> width; // may be empty: all 1

    [[nodiscard]] std::int64_t count() const noexcept { return position.size(); }
};

// A curvature in the float that it fits into, or the largest.
[[nodiscard]] inline float held_curvature(double k) noexcept {
    constexpr double most = std::numeric_limits<float>::max();
    return static_cast<float>(k < -most ? -most : k > most ? most : k);
}

// More marks than this are refused before they are made: identities of marks are 32 bits wide.
inline constexpr std::int64_t most_marks = std::int64_t{1} << 31;
// The same of BLUE_NOISE, which takes some 300 bytes a mark while it works.
inline constexpr std::int64_t most_even_marks = 100000000;

// base * factor^levels, which overflows for nothing that the boundary lets through.
[[nodiscard]] std::int64_t grown_count(std::int64_t base, std::int64_t factor, std::int32_t levels) noexcept;

// Refuses layers[layer] if it would have more than most_marks after `levels` steps; layer -1: stipples that only
// strokes start from.
void require_room(std::int64_t layer, std::int64_t full_count, std::int32_t levels, std::int64_t budget);

// A random choice of `kept` among candidates: those of the smallest random keys, so that the choice does not depend on
// the order in which they are looked at.
class Thinning {
public:
    Thinning() noexcept = default; // keeps all
    // key_of(i) for i in [0, count) identifies the candidates.
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
    std::uint64_t limit_ = 0; // tickets below it are kept
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

// A layer's random numbers do not depend on which other layers are made: this is their seed.  number: of the layer
// among those of its kind.
[[nodiscard]] std::uint64_t layer_seed(std::uint64_t random_seed, Kind kind, std::int64_t number) noexcept;

// Tells the random numbers of stipples from those of strokes that have the same seed.
inline constexpr std::uint32_t stream_count = 2;
[[nodiscard]] constexpr std::uint32_t stream_of(Kind kind) noexcept { return kind == Kind::hatch ? 1U : 0U; }

} // namespace hrbfnpr::marks
