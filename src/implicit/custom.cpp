// SPDX-License-Identifier: MIT
#include "implicit/custom.h"

#include "base/status.h"

#include <algorithm>

namespace hrbfnpr::implicit {
namespace {

// The default step of differences, in diagonals. For a smooth function it keeps errors below 1e-7: the truncation error
// h^2, and the rounding error, which is epsilon / h for first and epsilon / h^2 for second derivatives.
constexpr double gradient_step = 1e-4;
constexpr double hessian_step = 1e-3;

constexpr auto batch = static_cast<std::size_t>(batch_size);

// The index of element [i][j] in a stored Hessian, whose order is xx xy xz yy yz zz.
constexpr std::size_t hessian_index[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};

// Evaluates one batch of points through the caller's function.
class Batch {
public:
    Batch(const CustomFunction& custom, const PointBatch& points, double diagonal) noexcept
        : custom_(custom), points_(points), count_(static_cast<std::size_t>(points.count)),
          first_step_(custom.difference_step > 0.0 ? custom.difference_step : gradient_step * diagonal),
          second_step_(custom.difference_step > 0.0 ? custom.difference_step : hessian_step * diagonal) {}

    void evaluate(const FieldBatch& fields) {
        copy_given_fields(fields);
        if (fields.wants_gradient() && !custom_.has_gradient) difference_gradient(fields);
        if (!fields.wants_hessian() || custom_.has_hessian) return;
        if (custom_.has_gradient)
            difference_gradient_for_hessian(fields);
        else
            difference_value_for_hessian(fields);
    }

private:
    // Calls the caller's function at the points, moved by `shift`.
    void call(const glm::dvec3& shift, bool gradient, bool hessian) {
        for (std::size_t i = 0; i < count_; ++i) {
            packed_[3 * i] = points_.x[i] + shift.x;
            packed_[3 * i + 1] = points_.y[i] + shift.y;
            packed_[3 * i + 2] = points_.z[i] + shift.z;
        }
        const std::int32_t result =
            custom_.function(custom_.user, points_.count, packed_.data(), value_.data(),
                             gradient ? gradient_.data() : nullptr, hessian ? hessian_.data() : nullptr);
        if (result != 0)
            fail(Status::callback,
                 "function: the custom model's function returned %d; it must return 0 unless it failed",
                 static_cast<int>(result));
    }

    // Copies the fields that the caller's function computes.
    void copy_given_fields(const FieldBatch& fields) {
        const bool gradient = fields.wants_gradient() && custom_.has_gradient;
        const bool hessian = fields.wants_hessian() && custom_.has_hessian;
        if (fields.value == nullptr && !gradient && !hessian) return;
        call(glm::dvec3(0.0), gradient, hessian);
        if (fields.value != nullptr) std::copy_n(value_.data(), count_, fields.value);
        for (std::size_t i = 0; gradient && i < count_; ++i)
            for (std::size_t c = 0; c < 3; ++c) fields.gradient[c][i] = gradient_[3 * i + c];
        for (std::size_t i = 0; hessian && i < count_; ++i)
            for (std::size_t c = 0; c < 6; ++c) fields.hessian[c][i] = hessian_[6 * i + c];
    }

    static glm::dvec3 unit(std::size_t axis, double length) noexcept {
        return {axis == 0 ? length : 0.0, axis == 1 ? length : 0.0, axis == 2 ? length : 0.0};
    }

    // Adds weight * f(points + shift) to `sum`.
    void add_value(const glm::dvec3& shift, double weight, double* sum) {
        call(shift, false, false);
        for (std::size_t i = 0; i < count_; ++i) sum[i] += weight * value_[i];
    }

    void difference_gradient(const FieldBatch& fields) {
        const double weight = 0.5 / first_step_;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::fill_n(fields.gradient[axis], count_, 0.0);
            add_value(unit(axis, first_step_), weight, fields.gradient[axis]);
            add_value(unit(axis, -first_step_), -weight, fields.gradient[axis]);
        }
    }

    // Column `axis` of the Hessian is the derivative of the gradient along `axis`. An element off the diagonal is
    // computed in two columns; the result is their mean.
    void difference_gradient_for_hessian(const FieldBatch& fields) {
        for (double* component : fields.hessian) std::fill_n(component, count_, 0.0);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (const double sign : {1.0, -1.0}) {
                call(unit(axis, sign * second_step_), true, false);
                for (std::size_t c = 0; c < 3; ++c) {
                    const double weight = sign * (c == axis ? 0.5 : 0.25) / second_step_;
                    double* component = fields.hessian[hessian_index[axis][c]];
                    for (std::size_t i = 0; i < count_; ++i) component[i] += weight * gradient_[3 * i + c];
                }
            }
        }
    }

    void difference_value_for_hessian(const FieldBatch& fields) {
        const double h = second_step_;
        const double weight = 1.0 / (h * h);
        call(glm::dvec3(0.0), false, false);
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t i = 0; i < count_; ++i) fields.hessian[hessian_index[a][a]][i] = -2.0 * weight * value_[i];
        for (std::size_t a = 0; a < 3; ++a) {
            add_value(unit(a, h), weight, fields.hessian[hessian_index[a][a]]);
            add_value(unit(a, -h), weight, fields.hessian[hessian_index[a][a]]);
            for (std::size_t b = a + 1; b < 3; ++b) {
                double* mixed = fields.hessian[hessian_index[a][b]];
                std::fill_n(mixed, count_, 0.0);
                for (const double sa : {1.0, -1.0})
                    for (const double sb : {1.0, -1.0})
                        add_value(unit(a, sa * h) + unit(b, sb * h), 0.25 * sa * sb * weight, mixed);
            }
        }
    }

    const CustomFunction& custom_;
    const PointBatch& points_;
    std::size_t count_;
    double first_step_;
    double second_step_;
    std::array<double, 3 * batch> packed_;
    std::array<double, batch> value_;
    std::array<double, 3 * batch> gradient_;
    std::array<double, 6 * batch> hessian_;
};

} // namespace

Custom::~Custom() {
    if (custom_.release != nullptr) custom_.release(custom_.user);
}

void Custom::evaluate(const PointBatch& points, const FieldBatch& fields) const {
    for (std::int64_t begin = 0; begin < points.count; begin += batch_size) {
        const PointBatch part = slice(points, begin, std::min(points.count, begin + batch_size));
        std::unique_lock lock(call_mutex_, std::defer_lock);
        if (!custom_.thread_safe) lock.lock();
        Batch(custom_, part, diagonal()).evaluate(fields.from(begin));
    }
}

} // namespace hrbfnpr::implicit
