// SPDX-License-Identifier: MIT
// The sums of hermite_sums.h for the triharmonic kernel at any places near the centres, in a time that hardly depends
// on their number: space is divided into cubes; in each, the far centres' sum is a polynomial that is held, and the
// near centres are summed one by one.  The downward half of a fast multipole method, with cubes for places in place of
// cubes of centres; source_tree.h has the upward one.
#pragma once

#include "implicit/cube_loops.h"
#include "implicit/hermite_jets.h"
#include "implicit/source_tree.h"

#include <array>

namespace hrbfnpr::implicit {

// Of each byte, how many bits it has.  std::popcount is a call of a function where not every processor has the
// instruction.
inline constexpr std::array<std::uint8_t, 256> bits_of_byte = [] {
    std::array<std::uint8_t, 256> bits{};
    for (std::size_t byte = 1; byte < bits.size(); ++byte)
        bits[byte] = static_cast<std::uint8_t>(bits[byte / 2] + byte % 2);
    return bits;
}();

struct LocalFieldOptions {
    double spacing = 1.0;    // of the centres, mean
    double tolerance = 1e-9; // of values, relative to the centres' diagonal; of gradients it is a hundred times as much
    int finer = 0;           // steps of two degrees: each divides the error by about 10
    // Of fewer centres all that are far act one by one on cubes: what it takes for cubes to act as a whole is a second
    // of two cores (AVX2) to make, and saves less.
    std::int64_t worth_translations = 32768;
    std::int64_t most_near = 0; // cubes with more near centres are divided; 0 = as is best for millions of places
};

class LocalField {
public:
    // Throws Error{out_of_memory, cancelled}.
    LocalField(const base::Work& work, const geometry::VecArray& centres, const double* alpha,
               const geometry::VecArray& beta, const LocalFieldOptions& options);

    // The cube that a point lies in, in [0, cubes()); -1 outside of all.
    [[nodiscard]] std::int32_t cube_of(const glm::dvec3& point) const noexcept;
    [[nodiscard]] std::int64_t cubes() const noexcept { return cells_.size(); }

    // Add the sums, or them and their Hessians, at places in the cube.  Thread-safe.
    void add(std::int32_t cube, const Targets& targets) const noexcept;
    void add_jets(std::int32_t cube, const JetTargets& targets) const noexcept;

    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    struct Cell {
        std::array<std::int32_t, 3> cell; // of the level's grid
        std::int32_t level;
        std::int32_t first_child; // they are consecutive, in the order of octants
        std::uint32_t octants;    // which children there are, a bit each: where there is none, this cell serves
        std::int64_t near_begin;  // in near_
        std::int64_t near_end;
        std::int64_t terms; // of its polynomial, in terms_; -1: none

        [[nodiscard]] bool serves() const noexcept { return octants != 255; }
        [[nodiscard]] bool has_child(int octant) const noexcept { return (octants >> octant & 1) != 0; }
        [[nodiscard]] std::int32_t child(int octant) const noexcept {
            return first_child + bits_of_byte[octants & ((1U << octant) - 1U)];
        }
    };
    class Builder;

    [[nodiscard]] glm::dvec3 centre(const Cell& cell) const noexcept;
    [[nodiscard]] CubeSamples samples(const Cell& cell, const double* x, const double* y, const double* z,
                                      std::int64_t count) const noexcept;

    base::InstructionSet set_;
    SourceTree sources_;
    base::Array<Cell> cells_;       // level by level
    base::Array<SourceRange> near_; // of centres in the tree's order
    base::Array<double> terms_;
};

} // namespace hrbfnpr::implicit
