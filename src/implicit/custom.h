// SPDX-License-Identifier: MIT
// An implicit function that the caller provides. Missing derivatives are computed by differences.
#pragma once

#include "implicit/implicit.h"

#include <mutex>

namespace hrbfnpr::implicit {

// See hrbfnpr_implicit_fn.
using CustomFn = std::int32_t (*)(void* user, std::int64_t count, const double* points, double* value, double* gradient,
                                  double* hessian);

struct CustomFunction {
    CustomFn function = nullptr;
    void* user = nullptr;
    void (*release)(void* user) = nullptr;
    bool has_gradient = false;
    bool has_hessian = false;
    bool thread_safe = false;
    geometry::Bounds bounds;
    double difference_step = 0.0; // in diagonals; 0: automatic
};

class Custom final : public Implicit {
public:
    explicit Custom(const CustomFunction& custom) noexcept : custom_(custom) {}
    ~Custom() override;

    void evaluate(const PointBatch& points, const FieldBatch& fields) const override;
    [[nodiscard]] bool concurrent() const noexcept override { return custom_.thread_safe; }
    [[nodiscard]] const geometry::Bounds& bounds() const noexcept override { return custom_.bounds; }

private:
    CustomFunction custom_;
    // Several threads may use a model. The mutex is recursive because the function may evaluate another model whose
    // function evaluates this one.
    mutable std::recursive_mutex call_mutex_;
};

} // namespace hrbfnpr::implicit
