// SPDX-License-Identifier: MIT
// An implicit in another unit of length.
#pragma once

#include "implicit/implicit.h"

namespace hrbfnpr::implicit {

// g(y) = f(unit y) / unit: the same surface in that unit, with the same gradients.  A power of two is exact.
class Scaled final : public Implicit {
public:
    // `own` lives as long as this.
    Scaled(const Implicit& own, double unit) noexcept
        : own_(own), unit_(unit), bounds_{own.bounds().min / unit, own.bounds().max / unit} {}

    void evaluate(const PointBatch& points, const FieldBatch& fields) const override;
    [[nodiscard]] bool concurrent() const noexcept override { return own_.concurrent(); }
    [[nodiscard]] std::int64_t cells() const noexcept override { return own_.cells(); }
    [[nodiscard]] std::int32_t cell_of(const glm::dvec3& p) const noexcept override { return own_.cell_of(unit_ * p); }
    [[nodiscard]] const geometry::Bounds& bounds() const noexcept override { return bounds_; }

private:
    const Implicit& own_;
    double unit_;
    geometry::Bounds bounds_;
};

} // namespace hrbfnpr::implicit
