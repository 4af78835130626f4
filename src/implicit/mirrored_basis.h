// SPDX-License-Identifier: MIT
// Triharmonic polynomials of an odd degree on the cube [-1, 1]^3 that approximate a function from its values at nodes.
// The nodes are mirrored in the planes x = 0, y = 0 and z = 0, so there are eight of them for each node with positive
// coordinates. A function is the sum of eight parts, each even or odd in x, in y and in z. The fit of a part needs only
// the nodes with positive coordinates, so all matrices are small, and the sums at the nodes share work.
//
// There are more nodes than polynomials, and the fit is that of least squares. It is as accurate as interpolation by
// CubeBasis with the next higher degree, and it has fewer terms.
#pragma once

#include "base/memory.h"
#include "base/work.h"
#include "geometry/vec_array.h"
#include "implicit/cube_loops.h"

#include <array>

namespace hrbfnpr::implicit {

class MirroredBasis {
public:
    static constexpr int degree_min = 3;
    static constexpr int degree_max = 19;

    // The degree is odd.
    MirroredBasis(const base::Work& work, int degree);

    [[nodiscard]] int degree() const noexcept { return degree_; }
    // Returns the number of nodes with positive coordinates, which is a multiple of 8.
    [[nodiscard]] std::int64_t groups() const noexcept { return nodes_.size(); }
    // Returns the number of all nodes. Node `sign * groups() + g` is node g of nodes() with the coordinate c negated if
    // bit c of `sign` is set.
    [[nodiscard]] std::int64_t size() const noexcept { return 8 * nodes_.size(); }
    // Returns the nodes with positive coordinates.
    [[nodiscard]] const geometry::VecArray& nodes() const noexcept { return nodes_; }

    // Fits the polynomials of several functions at a time.
    class Batch {
    public:
        // The terms are those of polynomials of degree `order`, which is at least the degree of the basis.
        Batch(base::Memory& memory, const MirroredBasis& basis, int order);

        // Adds a function with these values at the nodes, times `factor`. flush() adds its terms to `terms`. Changes
        // the values.
        void add(double* values, double factor, double* terms) noexcept;
        [[nodiscard]] bool full() const noexcept { return count_ == cube_batch; }
        void flush(const CubeLoops& loops) noexcept;

    private:
        const MirroredBasis& basis_;
        std::array<base::Array<std::int32_t>, 8> term_; // for each part, the indices of its terms
        int count_ = 0;
        std::array<double*, cube_batch> terms_{};
        base::Array<double> in_;  // interleaved, for each part the values at the nodes with positive coordinates
        base::Array<double> out_; // for each function, the terms of one part
    };

private:
    void fit_part(const base::Work& work, const base::Array<double>& polynomials, std::size_t parity);

    int degree_;
    geometry::VecArray nodes_;
    // For each part, the matrix that maps values to terms. It is column-major with a padded number of rows. Bit c of
    // the index is set for functions that are odd along the axis c.
    std::array<base::Array<double>, 8> matrix_;
};

} // namespace hrbfnpr::implicit
