// SPDX-License-Identifier: MIT
// Sums over far centres at nodes that are mirrored in three planes (mirrored_basis.h), for each instruction set.
#pragma once

#include "base/instruction_set.h"
#include "implicit/hermite_sums.h"

#include <cstdint>

namespace hrbfnpr::implicit {

// Centres in the coordinates of a cube, and numbers computed from them. With x for a node and y for a centre,
//   |x - y|^2 = |x|^2 + square + x . across
//   r^2 alpha - 3 beta . (x - y) = |x|^2 alpha + constant + x . along
struct MirroredSources {
    static constexpr std::int64_t most = 256; // so that they stay in the fastest cache

    std::int64_t count = 0;
    double square[most];
    double alpha[most];
    double constant[most];
    double across[3][most];
    double along[3][most];

    // Adds the source number `at`. `middle` is the middle of the cube, and `half` half its width.
    void add(const Sources& sources, std::int64_t at, const double* middle, double half) noexcept {
        const double scale = 1.0 / half;
        const double y[3] = {(sources.x[at] - middle[0]) * scale, (sources.y[at] - middle[1]) * scale,
                             (sources.z[at] - middle[2]) * scale};
        const double beta[3] = {3.0 * scale * sources.beta_x[at], 3.0 * scale * sources.beta_y[at],
                                3.0 * scale * sources.beta_z[at]};
        const std::int64_t to = count++;
        square[to] = y[0] * y[0] + y[1] * y[1] + y[2] * y[2];
        alpha[to] = sources.alpha[at];
        constant[to] = alpha[to] * square[to] + (beta[0] * y[0] + beta[1] * y[1] + beta[2] * y[2]);
        for (int c = 0; c < 3; ++c) {
            across[c][to] = -2.0 * y[c];
            along[c][to] = alpha[to] * across[c][to] - beta[c];
        }
    }
};

// The nodes with positive coordinates. `groups` is a multiple of 8.
struct MirroredNodes {
    const double* x;
    const double* y;
    const double* z;
    std::int64_t groups;
};

// Adds the sum of r^3 alpha - 3 r beta . (x - y) over the sources to values[sign * groups + g], at node g with the
// coordinate c negated if bit c of `sign` is set. Lengths are those of the cube [-1, 1]^3: the sums of hermite_sums.h
// are (half width)^3 times as large. No source is near a node.
using AddMirroredSums = void (*)(const MirroredNodes& nodes, const MirroredSources& sources, double* values);

[[nodiscard]] AddMirroredSums mirrored_sums(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::implicit
