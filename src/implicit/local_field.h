// SPDX-License-Identifier: MIT
// Computes the sums of hermite_sums.h for the triharmonic kernel at any places near the centres, in a time that hardly
// depends on the number of centres. Space is divided into cubes. In each cube, the sum over far centres is a stored
// polynomial, and near centres are summed one by one. This is the downward half of a fast multipole method whose
// targets are all places in the cubes. The upward half, as in source_tree.h, would not save time: with up to 65 536
// centres, making the polynomials by it took 1.5 times as long.
#pragma once

#include "base/work.h"
#include "geometry/octree.h"
#include "implicit/cube_loops.h"
#include "implicit/hermite_jets.h"
#include "implicit/hermite_sums.h"

#include <array>

namespace hrbfnpr::implicit {

// The number of bits set in each byte. It replaces std::popcount, which is a slow function call if the compiler may not
// assume the processor's instruction.
inline constexpr std::array<std::uint8_t, 256> bits_of_byte = [] {
    std::array<std::uint8_t, 256> bits{};
    for (std::size_t byte = 1; byte < bits.size(); ++byte)
        bits[byte] = static_cast<std::uint8_t>(bits[byte / 2] + byte % 2);
    return bits;
}();

struct LocalFieldOptions {
    double spacing = 1.0; // mean spacing of the centres
    // The allowed error of values, relative to the diagonal of the centres. The error of gradients may be 100 times as
    // large.
    double tolerance = 1e-9;
    int finer = 0; // the number of times that the degree is raised by 2; each time divides the error by about 10
    std::int64_t most_near = 0; // cubes with more near centres are divided; 0: the best number for millions of places
};

class LocalField {
public:
    // Throws Error{out_of_memory, cancelled}.
    LocalField(const base::Work& work, const geometry::VecArray& centres, const double* alpha,
               const geometry::VecArray& beta, const LocalFieldOptions& options);

    // Returns the index of the cube that contains a point, in [0, cubes()), or -1 if the point is outside all cubes.
    [[nodiscard]] std::int32_t cube_of(const glm::dvec3& point) const noexcept;
    [[nodiscard]] std::int64_t cubes() const noexcept { return cells_.size(); }

    // Returns the number of centres that are summed one by one at places in the cube.
    [[nodiscard]] std::int64_t near_centres(std::int32_t cube) const noexcept;

    // The first function adds the sums at places in the cube; the second also adds Hessians. Thread-safe.
    void add(std::int32_t cube, const Targets& targets) const noexcept;
    void add_jets(std::int32_t cube, const JetTargets& targets) const noexcept;

    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    struct Cell {
        std::array<std::int32_t, 3> cell; // the cell's position in the grid of its level
        std::int32_t level;
        std::int32_t first_child; // children are consecutive, in the order of octants
        std::uint32_t octants;    // a bit for each child that exists; the cell itself serves the other octants
        std::int64_t near_begin;  // the index in near_ at which the cell's ranges begin
        std::int64_t near_end;
        std::int64_t terms; // the index in terms_ at which the cell's polynomial begins; -1: it has no polynomial

        [[nodiscard]] bool serves() const noexcept { return octants != 255; }
        [[nodiscard]] bool has_child(int octant) const noexcept { return (octants >> octant & 1) != 0; }
        [[nodiscard]] std::int32_t child(int octant) const noexcept {
            return first_child + bits_of_byte[octants & ((1U << octant) - 1U)];
        }
    };
    class Builder;

    // The levels above this one are skipped in a search for a cell: start_ has the cell for each cube of this level.
    static constexpr std::int32_t start_level = 4;

    [[nodiscard]] glm::dvec3 centre(const Cell& cell) const noexcept;
    // Returns the smallest cell down to the level `deepest` that contains a cube of the octree's deepest level. The
    // cell `from` contains it, too.
    [[nodiscard]] std::int32_t descend(std::int32_t from, const std::array<std::uint32_t, 3>& cube,
                                       std::int32_t deepest) const noexcept;
    void find_starts();
    [[nodiscard]] CubeSamples samples(const Cell& cell, const double* x, const double* y, const double* z,
                                      std::int64_t count) const noexcept;

    // Returns the centres [begin, end) in the order of the tree, with their weights.
    [[nodiscard]] Sources sources(std::int64_t begin, std::int64_t end) const noexcept;
    void load(const double* alpha, const geometry::VecArray& beta, const base::Progress& progress);

    base::InstructionSet set_;
    geometry::Octree tree_;
    base::Array<double> alpha_; // weights in the order of the tree
    geometry::VecArray beta_;
    base::Array<std::int32_t> degree_; // the degree of the polynomials of each level
    base::Array<Cell> cells_;          // sorted by level
    base::Array<SourceRange> near_;    // ranges of near centres, in the order of the tree
    base::Array<double> terms_;
    base::Array<std::int32_t> start_;
};

} // namespace hrbfnpr::implicit
