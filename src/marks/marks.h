// SPDX-License-Identifier: MIT
// The marks of a layer while they grow, in double precision.
#pragma once

#include "geometry/vec_array.h"
#include "marks/point_set.h"
#include "marks/site.h"

#include <array>
#include <limits>

namespace hrbfnpr::marks {

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
    Thinning(const Site& site, std::int64_t count, std::int64_t kept, std::uint32_t stream, KeyOf key_of,
             const base::Progress& progress);

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
Thinning::Thinning(const Site& site, std::int64_t count, std::int64_t kept, std::uint32_t stream, KeyOf key_of,
                   const base::Progress& progress)
    : active_(kept < count), seed_(site.random_seed), stream_(stream) {
    if (!active_) return;
    base::Array<std::uint64_t> tickets(site.memory());
    tickets.resize_for_overwrite(count);
    site.runtime.parallel.for_chunks(count, chunk_size, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t i = begin; i < end; ++i) tickets[i] = ticket(key_of(i));
    });
    choose(tickets, kept, progress);
}

// A layer's random numbers do not depend on which other layers are made: this is their seed.  number: of the layer
// among those of its kind.
[[nodiscard]] std::uint64_t layer_seed(std::uint64_t random_seed, Kind kind, std::int64_t number) noexcept;

// Tells the random numbers of stipples from those of strokes that have the same seed.
inline constexpr std::uint32_t stream_count = 2;
[[nodiscard]] constexpr std::uint32_t stream_of(Kind kind) noexcept { return kind == Kind::hatch ? 1U : 0U; }

} // namespace hrbfnpr::marks
