// SPDX-License-Identifier: MIT
// The Hermite RBF implicit of [NPAR 4.1], equation 1.
#pragma once

#include "base/instruction_set.h"
#include "base/memory.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"
#include "kernel/kernel.h"

namespace hrbfnpr::implicit {

// f(x) = scale * g((x - centre) / scale), where
// g(y) = sum_j alpha_j psi(y - y_j) - beta_j . grad psi(y - y_j) + p(y).
// Plain data, which a fit makes and a file holds.
struct HrbfData {
    explicit HrbfData(base::Memory& memory) noexcept
        : sample_position(memory), sample_normal(memory), centre_position(memory), beta(memory), alpha(memory),
          polynomial(memory) {}

    kernel::Kind kernel = kernel::Kind::triharmonic;
    double kernel_radius = 0.0; // in normalised coordinates
    std::int32_t polynomial_degree = 1;
    glm::dvec3 centre{0.0}; // centre of the normalisation
    double scale = 1.0;
    geometry::Bounds bounds;             // bounds of the samples, in the caller's coordinates
    double spacing = 0.0;                // mean distance to the nearest other sample, caller's unit; 0 for one sample
    base::Array<double> sample_position; // 3N numbers, packed x y z, in the caller's coordinates
    base::Array<double> sample_normal;   // 3N numbers, unit vectors
    geometry::VecArray centre_position;  // N normalised positions: (sample - centre) / scale
    geometry::VecArray beta;             // N gradient weights
    base::Array<double> alpha;           // N value weights
    base::Array<double> polynomial;      // coefficients of the basis of kernel/polynomial.h, for normalised points

    [[nodiscard]] std::int64_t count() const noexcept { return alpha.size(); }
    [[nodiscard]] std::int64_t bytes() const noexcept;
};

// Normalises a coordinate of a query or of a sample. The same formula serves both, so that a query at a sample
// coincides exactly with its centre.
[[nodiscard]] inline double normalised(double coordinate, double centre, double scale) noexcept {
    return (coordinate - centre) / scale;
}

// Does the same as Hrbf::evaluate for data that does not belong to an Hrbf yet.
void evaluate(base::InstructionSet set, const HrbfData& data, const PointBatch& points,
              const FieldBatch& fields) noexcept;
// Does the same as Hrbf::evaluate with plain code. Tests compare the vectorised code with it.
void evaluate(const HrbfData& data, const PointBatch& points, const FieldBatch& fields) noexcept;

class Hrbf final : public Implicit {
public:
    Hrbf(base::InstructionSet set, HrbfData data) noexcept : set_(set), data_(std::move(data)) {}

    void evaluate(const PointBatch& points, const FieldBatch& fields) const override;
    [[nodiscard]] bool concurrent() const noexcept override { return true; }
    [[nodiscard]] const geometry::Bounds& bounds() const noexcept override { return data_.bounds; }
    // Sets the box in which the surface is searched for from now on.
    void set_bounds(const geometry::Bounds& bounds) noexcept { data_.bounds = bounds; }
    [[nodiscard]] const HrbfData& data() const noexcept { return data_; }

private:
    base::InstructionSet set_;
    HrbfData data_;
};

} // namespace hrbfnpr::implicit
