// SPDX-License-Identifier: MIT
// An implicit in another unit of length.
#pragma once

#include "implicit/sheets.h"

namespace hrbfnpr::implicit {

// g(y) = f(unit y) / unit: the same surface in another unit of length, with the same gradients. A unit that is a power
// of two causes no rounding.
class Scaled final : public Implicit {
public:
    // `own` must outlive this.
    Scaled(const Implicit& own, double unit) noexcept
        : own_(own), unit_(unit), bounds_{own.bounds().min / unit, own.bounds().max / unit}, domain_(own, unit),
          sheets_(own, unit) {}

    void evaluate(const PointBatch& points, const FieldBatch& fields) const override;
    [[nodiscard]] bool concurrent() const noexcept override { return own_.concurrent(); }
    [[nodiscard]] std::int64_t cells() const noexcept override { return own_.cells(); }
    [[nodiscard]] std::int32_t cell_of(const glm::dvec3& p) const noexcept override { return own_.cell_of(unit_ * p); }
    [[nodiscard]] const geometry::Bounds& bounds() const noexcept override { return bounds_; }
    [[nodiscard]] double lipschitz() const noexcept override { return own_.lipschitz(); }
    [[nodiscard]] const Domain* domain() const noexcept override {
        return own_.domain() != nullptr ? &domain_ : nullptr;
    }
    [[nodiscard]] const Sheets* sheets() const noexcept override {
        return own_.sheets() != nullptr ? &sheets_ : nullptr;
    }

private:
    struct ScaledDomain final : Domain {
        ScaledDomain(const Implicit& of, double by) noexcept : own(of), unit(by) {}
        [[nodiscard]] double beyond(const glm::dvec3& place, const glm::dvec3& gradient) const override {
            return own.domain()->beyond(unit * place, gradient);
        }
        [[nodiscard]] bool near_end(const glm::dvec3& place) const noexcept override {
            return own.domain()->near_end(unit * place);
        }
        [[nodiscard]] bool may_end_near(const glm::dvec3& centre, double half) const noexcept override {
            return own.domain()->may_end_near(unit * centre, unit * half);
        }
        [[nodiscard]] bool is_nowhere_near(const glm::dvec3& centre, double half) const noexcept override {
            return own.domain()->is_nowhere_near(unit * centre, unit * half);
        }
        const Implicit& own;
        double unit;
    };
    struct ScaledSheets final : Sheets {
        ScaledSheets(const Implicit& of, double by) noexcept : own(of), unit(by) {}
        [[nodiscard]] std::int32_t count() const noexcept override { return own.sheets()->count(); }
        void active(const PointBatch& points, std::int32_t* sheet) const override;
        void evaluate(std::int32_t sheet, const PointBatch& points, const FieldBatch& fields) const override;
        const Implicit& own;
        double unit;
    };

    const Implicit& own_;
    double unit_;
    geometry::Bounds bounds_;
    ScaledDomain domain_;
    ScaledSheets sheets_;
};

} // namespace hrbfnpr::implicit
