// SPDX-License-Identifier: MIT
// An implicit whose surface ends where an extent says.
#pragma once

#include "implicit/implicit.h"

namespace hrbfnpr::implicit {

class Trimmed final : public Implicit {
public:
    // Both live as long as this.
    Trimmed(const Implicit& whole, const Extent& extent) noexcept : whole_(whole), extent_(extent) {}

    void evaluate(const PointBatch& points, const FieldBatch& fields) const override {
        whole_.evaluate(points, fields);
    }
    [[nodiscard]] bool concurrent() const noexcept override { return whole_.concurrent(); }
    [[nodiscard]] std::int64_t cells() const noexcept override { return whole_.cells(); }
    [[nodiscard]] std::int32_t cell_of(const glm::dvec3& p) const noexcept override { return whole_.cell_of(p); }
    [[nodiscard]] const geometry::Bounds& bounds() const noexcept override { return whole_.bounds(); }
    [[nodiscard]] const Extent* extent() const noexcept override { return &extent_; }
    [[nodiscard]] double lipschitz() const noexcept override { return whole_.lipschitz(); }
    [[nodiscard]] const Sheets* sheets() const noexcept override { return whole_.sheets(); }

private:
    const Implicit& whole_;
    const Extent& extent_;
};

} // namespace hrbfnpr::implicit
