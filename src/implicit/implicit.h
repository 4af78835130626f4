// SPDX-License-Identifier: MIT
// An implicit function f that is evaluated in batches. All code after the fit uses only this interface, so it works
// with any implicit function.
#pragma once

#include "base/work.h"
#include "geometry/vec.h"
#include "implicit/domain.h"

#include <array>
#include <cstdint>

namespace hrbfnpr::implicit {

// Query points as a structure of arrays.
struct PointBatch {
    const double* x = nullptr;
    const double* y = nullptr;
    const double* z = nullptr;
    std::int64_t count = 0;
};

// Where results are written. A null pointer means that the field is not wanted. A gradient or a Hessian is wanted with
// all its components or not at all. Hessians have the order xx xy xz yy yz zz.
struct FieldBatch {
    double* value = nullptr;
    std::array<double*, 3> gradient{};
    std::array<double*, 6> hessian{};

    [[nodiscard]] bool wants_gradient() const noexcept { return gradient[0] != nullptr; }
    [[nodiscard]] bool wants_hessian() const noexcept { return hessian[0] != nullptr; }
    // Returns the same fields, beginning with element `begin`.
    [[nodiscard]] FieldBatch from(std::int64_t begin) const noexcept;
};

[[nodiscard]] PointBatch slice(const PointBatch& points, std::int64_t begin, std::int64_t end) noexcept;

class Sheets;

class Implicit {
public:
    Implicit() = default;
    Implicit(const Implicit&) = delete;
    Implicit& operator=(const Implicit&) = delete;
    virtual ~Implicit() = default;

    // Evaluates the points on the calling thread. The result for a point does not depend on the other points of the
    // batch. Outputs must not alias inputs. Throws Error{callback} if a caller's function fails.
    virtual void evaluate(const PointBatch& points, const FieldBatch& fields) const = 0;

    // Returns whether evaluate() may run on several threads at once, and on other threads than the caller's.
    [[nodiscard]] virtual bool concurrent() const noexcept = 0;

    // Returns the number of cells into which space is divided; 0: there are no cells. Points of one cell take less time
    // if they are evaluated together.
    [[nodiscard]] virtual std::int64_t cells() const noexcept { return 0; }
    // Returns the cell of a point, in [0, cells()).
    [[nodiscard]] virtual std::int32_t cell_of(const glm::dvec3&) const noexcept { return 0; }

    // Returns the box that contains the surface or its samples. It is finite and never empty.
    [[nodiscard]] virtual const geometry::Bounds& bounds() const noexcept = 0;

    // Returns the domain, which says where within the bounds the zero set ends; null: the whole zero set is the
    // surface.
    [[nodiscard]] virtual const Domain* domain() const noexcept { return nullptr; }
    [[nodiscard]] bool contains(const glm::dvec3& place, const glm::dvec3& gradient) const {
        const Domain* const its = domain();
        return its == nullptr || its->contains(place, gradient);
    }

    // Returns the smooth functions that f is made of if f has creases; null: f is smooth. On a crease the gradient is
    // that of the active function.
    [[nodiscard]] virtual const Sheets* sheets() const noexcept { return nullptr; }

    // Returns a bound on |grad f| that holds everywhere; 0: no bound is known.
    [[nodiscard]] virtual double lipschitz() const noexcept { return 0.0; }

    // Returns the unit of tolerances: the diagonal of the bounds. It is positive even for a single sample.
    [[nodiscard]] double diagonal() const noexcept;

    // Returns `work` with all threads if evaluate() may run on several threads; else with the calling thread alone.
    [[nodiscard]] base::Work threads(const base::Work& work) const noexcept {
        return concurrent() ? work : work.on_one_thread();
    }
};

// The number of points that a task evaluates at a time. It is small enough for frequent progress and cancelling, and
// large enough for SIMD.
inline constexpr std::int64_t batch_size = 256;

} // namespace hrbfnpr::implicit
