// SPDX-License-Identifier: MIT
#include "curves/contour_level.h"

#include <algorithm>

namespace hrbfnpr::curves {
namespace {

constexpr std::int64_t vertices_a_task = 16384;

// Points at a time: a caller's function stands below on the same small stack.
constexpr std::int64_t block = 32;

// Upper triangles of the points' Hessians: xx xy xz yy yz zz.
struct Hessians {
    std::array<std::array<double, static_cast<std::size_t>(block)>, 6> of;

    [[nodiscard]] glm::dvec3 times(std::size_t i, const glm::dvec3& v) const noexcept {
        return {of[0][i] * v.x + of[1][i] * v.y + of[2][i] * v.z, of[1][i] * v.x + of[3][i] * v.y + of[4][i] * v.z,
                of[2][i] * v.x + of[4][i] * v.y + of[5][i] * v.z};
    }
};

LevelBatch from(const LevelBatch& out, std::int64_t begin) noexcept {
    LevelBatch part{out.value + begin, {}, out.level + begin, {}};
    for (std::size_t c = 0; c < 3; ++c) {
        part.gradient[c] = out.gradient[c] + begin;
        part.level_gradient[c] = out.level_gradient[c] + begin;
    }
    return part;
}

} // namespace

void ContourLevel::evaluate(const implicit::PointBatch& points, const LevelBatch& out) const {
    for (std::int64_t begin = 0; begin < points.count; begin += block)
        evaluate_block(implicit::slice(points, begin, std::min(points.count, begin + block)), from(out, begin));
}

// grad g = H v + grad f where v depends on the point, H v where it does not.
void ContourLevel::evaluate_block(const implicit::PointBatch& points, const LevelBatch& out) const {
    Hessians h;
    implicit::FieldBatch fields{out.value, out.gradient, {}};
    for (std::size_t c = 0; c < 6; ++c) fields.hessian[c] = h.of[c].data();
    surface_.evaluate(points, fields);
    const double own = view_.eye.w == 0.0 ? 0.0 : 1.0;
    for (std::int64_t i = 0; i < points.count; ++i) {
        const glm::dvec3 v = view_.sight({points.x[i], points.y[i], points.z[i]});
        const glm::dvec3 gradient(out.gradient[0][i], out.gradient[1][i], out.gradient[2][i]);
        const glm::dvec3 level = h.times(static_cast<std::size_t>(i), v) + own * gradient;
        out.level[i] = glm::dot(gradient, v);
        for (int c = 0; c < 3; ++c) out.level_gradient[static_cast<std::size_t>(c)][i] = level[c];
    }
}

void ContourLevel::at_vertices(const base::Runtime& runtime, const SurfaceMesh& mesh, base::Array<double>& level,
                               const base::Progress& progress) const {
    level.resize_for_overwrite(mesh.vertices());
    runtime.parallel.for_chunks(mesh.vertices(), vertices_a_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t i = begin; i < end; ++i) level[i] = glm::dot(mesh.gradient[i], view_.sight(mesh.position[i]));
    });
}

} // namespace hrbfnpr::curves
