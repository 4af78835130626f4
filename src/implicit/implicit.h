// SPDX-License-Identifier: MIT
// An implicit function f, evaluated in batches. Everything downstream of the fit uses this interface only, so that it
// works on any implicit.
#pragma once

#include "base/work.h"
#include "geometry/vec.h"
#include "implicit/domain.h"

#include <array>
#include <cstdint>

namespace hrbfnpr::implicit {

// Query points, structure of arrays.
struct PointBatch {
    const double* x = nullptr;
    const double* y = nullptr;
    const double* z = nullptr;
    std::int64_t count = 0;
};

// Where results are written; a null pointer means "not wanted". A gradient or a Hessian is wanted whole or not at all.
// Hessian order: xx xy xz yy yz zz.
struct FieldBatch {
    double* value = nullptr;
    std::array<double*, 3> gradient{};
    std::array<double*, 6> hessian{};

    [[nodiscard]] bool wants_gradient() const noexcept { return gradient[0] != nullptr; }
    [[nodiscard]] bool wants_hessian() const noexcept { return hessian[0] != nullptr; }
    // Returns the same fields, from element `begin` on.
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

    // Runs on the calling thread. The result for a point does not depend on its batch. Outputs must not alias inputs.
    // Throws Error{callback} where a caller's function fails.
    virtual void evaluate(const PointBatch& points, const FieldBatch& fields) const = 0;

    // Whether evaluate() may run on several threads at once, and on threads other than the caller's.
    [[nodiscard]] virtual bool concurrent() const noexcept = 0;

    // The number of cells of space; points of one cell cost less if they are evaluated side by side. 0: there are no
    // cells.
    [[nodiscard]] virtual std::int64_t cells() const noexcept { return 0; }
    // Returns the cell of a point, in [0, cells()).
    [[nodiscard]] virtual std::int32_t cell_of(const glm::dvec3&) const noexcept { return 0; }

    // The box that the surface (or its samples) lies in; never empty, finite.
    [[nodiscard]] virtual const geometry::Bounds& bounds() const noexcept = 0;

    // The part of the zero level within the bounds that is the surface; null: all of it.
    [[nodiscard]] virtual const Domain* domain() const noexcept { return nullptr; }
    [[nodiscard]] bool contains(const glm::dvec3& place, const glm::dvec3& gradient) const {
        const Domain* const its = domain();
        return its == nullptr || its->contains(place, gradient);
    }

    // The smooth functions that this is made of, if it has creases; null: it is smooth. On a crease the gradient is
    // that of the active function.
    [[nodiscard]] virtual const Sheets* sheets() const noexcept { return nullptr; }

    // A bound on |grad f| that holds everywhere; 0: no bound is known.
    [[nodiscard]] virtual double lipschitz() const noexcept { return 0.0; }

    // Length scale of tolerances: the diagonal of the bounds, positive even for one sample.
    [[nodiscard]] double diagonal() const noexcept;

    // Returns work on all threads if evaluate() may run on several, else on the calling thread.
    [[nodiscard]] base::Work threads(const base::Work& work) const noexcept {
        return concurrent() ? work : work.on_one_thread();
    }
};

// Number of points that a task evaluates at a time: small enough for progress and cancelling, large enough to
// vectorise.
inline constexpr std::int64_t batch_size = 256;

} // namespace hrbfnpr::implicit
