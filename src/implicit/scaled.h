// SPDX-License-Identifier: MIT
// An implicit function in another unit of length.
#pragma once

#include "implicit/sheets.h"

namespace hrbfnpr::implicit {

// g(y) = f(unit y) / unit. This is the same surface in another unit of length; the gradients are the same. There is no
// rounding if `unit` is a power of two.
class Scaled final : public Implicit {
public:
    // The object keeps a reference to `unscaled`.
    Scaled(const Implicit& unscaled, double unit) noexcept
        : unscaled_(unscaled), unit_(unit), bounds_{unscaled.bounds().min / unit, unscaled.bounds().max / unit},
          domain_(unscaled, unit), sheets_(unscaled, unit) {}

    void evaluate(const PointBatch& points, const FieldBatch& fields) const override;
    [[nodiscard]] bool concurrent() const noexcept override { return unscaled_.concurrent(); }
    [[nodiscard]] std::int64_t cells() const noexcept override { return unscaled_.cells(); }
    [[nodiscard]] std::int32_t cell_of(const glm::dvec3& p) const noexcept override {
        return unscaled_.cell_of(unit_ * p);
    }
    [[nodiscard]] const geometry::Bounds& bounds() const noexcept override { return bounds_; }
    [[nodiscard]] double lipschitz() const noexcept override { return unscaled_.lipschitz(); }
    [[nodiscard]] const Domain* domain() const noexcept override {
        return unscaled_.domain() != nullptr ? &domain_ : nullptr;
    }
    [[nodiscard]] const Sheets* sheets() const noexcept override {
        return unscaled_.sheets() != nullptr ? &sheets_ : nullptr;
    }

private:
    struct ScaledDomain final : Domain {
        ScaledDomain(const Implicit& of, double by) noexcept : unscaled(of), unit(by) {}
        [[nodiscard]] double beyond(const glm::dvec3& place, const glm::dvec3& gradient) const override {
            return unscaled.domain()->beyond(unit * place, gradient);
        }
        [[nodiscard]] bool near_end(const glm::dvec3& place) const noexcept override {
            return unscaled.domain()->near_end(unit * place);
        }
        [[nodiscard]] bool may_end_near(const glm::dvec3& centre, double half) const noexcept override {
            return unscaled.domain()->may_end_near(unit * centre, unit * half);
        }
        [[nodiscard]] bool has_no_surface_in(const glm::dvec3& centre, double half) const noexcept override {
            return unscaled.domain()->has_no_surface_in(unit * centre, unit * half);
        }
        const Implicit& unscaled;
        double unit;
    };
    struct ScaledSheets final : Sheets {
        ScaledSheets(const Implicit& of, double by) noexcept : unscaled(of), unit(by) {}
        [[nodiscard]] std::int32_t count() const noexcept override { return unscaled.sheets()->count(); }
        void active(const PointBatch& points, std::int32_t* sheet) const override;
        void evaluate(std::int32_t sheet, const PointBatch& points, const FieldBatch& fields) const override;
        const Implicit& unscaled;
        double unit;
    };

    const Implicit& unscaled_;
    double unit_;
    geometry::Bounds bounds_;
    ScaledDomain domain_;
    ScaledSheets sheets_;
};

} // namespace hrbfnpr::implicit
