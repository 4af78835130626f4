// SPDX-License-Identifier: MIT
// What levels that need the Hessian evaluate at a time: a caller's function stands below on the same small stack.
#pragma once

#include "curves/level.h"

#include <algorithm>
#include <array>

namespace hrbfnpr::curves {

struct HessianBlock {
    static constexpr std::int64_t size = 32;

    std::array<std::array<double, static_cast<std::size_t>(size)>, 6> of; // xx xy xz yy yz zz of each point

    [[nodiscard]] glm::dvec3 times(std::int64_t point, const glm::dvec3& v) const noexcept {
        const auto i = static_cast<std::size_t>(point);
        return {of[0][i] * v.x + of[1][i] * v.y + of[2][i] * v.z, of[1][i] * v.x + of[3][i] * v.y + of[4][i] * v.z,
                of[2][i] * v.x + of[4][i] * v.y + of[5][i] * v.z};
    }
    // f, grad f and the Hessian at the points of a block.
    void evaluate(const implicit::Implicit& surface, const implicit::PointBatch& points, const LevelBatch& out) {
        implicit::FieldBatch fields{out.value, out.gradient, {}};
        for (std::size_t c = 0; c < 6; ++c) fields.hessian[c] = of[c].data();
        surface.evaluate(points, fields);
    }
};

[[nodiscard]] inline LevelBatch from(const LevelBatch& out, std::int64_t begin) noexcept {
    LevelBatch part{out.value + begin, {}, out.level + begin, {}};
    for (std::size_t c = 0; c < 3; ++c) {
        part.gradient[c] = out.gradient[c] + begin;
        part.level_gradient[c] = out.level_gradient[c] + begin;
    }
    return part;
}

// evaluate(points, out) block by block.
template <class Evaluate>
void in_blocks(const implicit::PointBatch& points, const LevelBatch& out, Evaluate&& evaluate) {
    for (std::int64_t begin = 0; begin < points.count; begin += HessianBlock::size)
        evaluate(implicit::slice(points, begin, std::min(points.count, begin + HessianBlock::size)), from(out, begin));
}

} // namespace hrbfnpr::curves
