// SPDX-License-Identifier: MIT
// An implicit function whose surface has another domain.
#pragma once

#include "implicit/implicit.h"

namespace hrbfnpr::implicit {

class Trimmed final : public Implicit {
public:
    // The object keeps references to `whole` and `domain`.
    Trimmed(const Implicit& whole, const Domain& domain) noexcept : whole_(whole), domain_(domain) {}

    void evaluate(const PointBatch& points, const FieldBatch& fields) const override {
        whole_.evaluate(points, fields);
    }
    [[nodiscard]] bool concurrent() const noexcept override { return whole_.concurrent(); }
    [[nodiscard]] std::int64_t cells() const noexcept override { return whole_.cells(); }
    [[nodiscard]] std::int32_t cell_of(const glm::dvec3& p) const noexcept override { return whole_.cell_of(p); }
    [[nodiscard]] const geometry::Bounds& bounds() const noexcept override { return whole_.bounds(); }
    [[nodiscard]] const Domain* domain() const noexcept override { return &domain_; }
    [[nodiscard]] double lipschitz() const noexcept override { return whole_.lipschitz(); }
    [[nodiscard]] const Sheets* sheets() const noexcept override { return whole_.sheets(); }

private:
    const Implicit& whole_;
    const Domain& domain_;
};

} // namespace hrbfnpr::implicit
