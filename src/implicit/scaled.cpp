// SPDX-License-Identifier: MIT
#include "implicit/scaled.h"

#include <algorithm>

namespace hrbfnpr::implicit {
namespace {

using Column = std::array<double, static_cast<std::size_t>(batch_size)>;

void multiply(double* numbers, std::int64_t count, double by) noexcept {
    for (std::int64_t i = 0; numbers != nullptr && i < count; ++i) numbers[i] *= by;
}

} // namespace

void Scaled::evaluate(const PointBatch& points, const FieldBatch& fields) const {
    std::array<Column, 3> at;
    for (std::int64_t begin = 0; begin < points.count; begin += batch_size) {
        const std::int64_t count = std::min(points.count - begin, batch_size);
        const FieldBatch here = fields.from(begin);
        const std::array<const double*, 3> from = {points.x + begin, points.y + begin, points.z + begin};
        for (std::size_t axis = 0; axis < 3; ++axis)
            std::transform(from[axis], from[axis] + count, at[axis].begin(), [&](double x) { return unit_ * x; });
        own_.evaluate({at[0].data(), at[1].data(), at[2].data(), count}, here);
        multiply(here.value, count, 1.0 / unit_);
        for (double* component : here.hessian) multiply(component, count, unit_);
    }
}

} // namespace hrbfnpr::implicit
