// SPDX-License-Identifier: MIT
#include "implicit/scaled.h"

#include <algorithm>

namespace hrbfnpr::implicit {
namespace {

using Column = std::array<double, static_cast<std::size_t>(batch_size)>;

void multiply(double* numbers, std::int64_t count, double by) noexcept {
    for (std::int64_t i = 0; numbers != nullptr && i < count; ++i) numbers[i] *= by;
}

// Calls visit(points, first) for one batch after another, with the points in the function's own unit, and the index of
// the batch's first point.
template <class Visit>
void in_own_unit(const PointBatch& points, double unit, Visit&& visit) {
    std::array<Column, 3> at;
    for (std::int64_t begin = 0; begin < points.count; begin += batch_size) {
        const std::int64_t count = std::min(points.count - begin, batch_size);
        const std::array<const double*, 3> from = {points.x + begin, points.y + begin, points.z + begin};
        for (std::size_t axis = 0; axis < 3; ++axis)
            std::transform(from[axis], from[axis] + count, at[axis].begin(), [&](double x) { return unit * x; });
        visit(PointBatch{at[0].data(), at[1].data(), at[2].data(), count}, begin);
    }
}

void to_unit(const FieldBatch& fields, std::int64_t count, double unit) noexcept {
    multiply(fields.value, count, 1.0 / unit);
    for (double* component : fields.hessian) multiply(component, count, unit);
}

} // namespace

void Scaled::evaluate(const PointBatch& points, const FieldBatch& fields) const {
    in_own_unit(points, unit_, [&](const PointBatch& some, std::int64_t begin) {
        const FieldBatch here = fields.from(begin);
        unscaled_.evaluate(some, here);
        to_unit(here, some.count, unit_);
    });
}

void Scaled::ScaledSheets::active(const PointBatch& points, std::int32_t* sheet) const {
    in_own_unit(points, unit,
                [&](const PointBatch& some, std::int64_t begin) { unscaled.sheets()->active(some, sheet + begin); });
}

void Scaled::ScaledSheets::evaluate(std::int32_t sheet, const PointBatch& points, const FieldBatch& fields) const {
    in_own_unit(points, unit, [&](const PointBatch& some, std::int64_t begin) {
        const FieldBatch here = fields.from(begin);
        unscaled.sheets()->evaluate(sheet, some, here);
        to_unit(here, some.count, unit);
    });
}

} // namespace hrbfnpr::implicit
