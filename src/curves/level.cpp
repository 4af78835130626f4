// SPDX-License-Identifier: MIT
#include "curves/level.h"

#include "base/assert.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

constexpr std::int64_t vertices_a_task = 16384;
// Points whose Hessians are held at a time: a caller's function runs on the same small stack.
constexpr std::int64_t hessian_block = 32;
// The value of s where no sample is near. It is so large that no step leads there.
constexpr double unsupported = 1e6;

// Evaluates f with its Hessian block by block. level(place, grad f, times, slope) returns g at each point and sets
// slope to its gradient; times(v) is H v there.
template <class LevelAt>
void evaluate_blocks(const implicit::Implicit& surface, const implicit::PointBatch& points, const LevelBatch& out,
                     LevelAt&& level) {
    HRBFNPR_ASSERT(points.count >= 0 && points.count <= implicit::batch_size);
    std::array<std::array<double, static_cast<std::size_t>(hessian_block)>, 6> h; // xx xy xz yy yz zz of each point
    for (std::int64_t begin = 0; begin < points.count; begin += hessian_block) {
        const std::int64_t end = std::min(points.count, begin + hessian_block);
        implicit::FieldBatch fields{
            out.value + begin, {out.gradient[0] + begin, out.gradient[1] + begin, out.gradient[2] + begin}, {}};
        for (std::size_t c = 0; c < 6; ++c) fields.hessian[c] = h[c].data();
        surface.evaluate(implicit::slice(points, begin, end), fields);
        for (std::int64_t i = begin; i < end; ++i) {
            const auto k = static_cast<std::size_t>(i - begin);
            const auto times = [&](const glm::dvec3& v) {
                return glm::dvec3(h[0][k] * v.x + h[1][k] * v.y + h[2][k] * v.z,
                                  h[1][k] * v.x + h[3][k] * v.y + h[4][k] * v.z,
                                  h[2][k] * v.x + h[4][k] * v.y + h[5][k] * v.z);
            };
            glm::dvec3 slope(0.0);
            out.level[i] = level({points.x[i], points.y[i], points.z[i]},
                                 {out.gradient[0][i], out.gradient[1][i], out.gradient[2][i]}, times, slope);
            for (int c = 0; c < 3; ++c) out.level_gradient[static_cast<std::size_t>(c)][i] = slope[c];
        }
    }
}

} // namespace

// grad g = H v + grad f where v depends on the point, H v where it does not.
void ContourLevel::evaluate(const implicit::PointBatch& points, const LevelBatch& out) const {
    const double own = view_.eye.w == 0.0 ? 0.0 : 1.0;
    evaluate_blocks(surface_, points, out,
                    [&](const glm::dvec3& p, const glm::dvec3& gradient, const auto& times, glm::dvec3& slope) {
                        const glm::dvec3 v = view_.sight(p);
                        slope = times(v) + own * gradient;
                        return glm::dot(gradient, v);
                    });
}

void ContourLevel::at_vertices(const base::Runtime& runtime, const SurfaceMesh& mesh, base::Array<double>& level,
                               const base::Progress& progress) const {
    HRBFNPR_ASSERT(mesh.gradient.size() == mesh.vertices());
    level.resize_for_overwrite(mesh.vertices());
    runtime.parallel.for_chunks(mesh.vertices(), vertices_a_task, progress, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) level[i] = glm::dot(mesh.gradient[i], view_.sight(mesh.position[i]));
    });
}

// The normal changes along with the place by the Hessian over |grad f|.
void SupportLevel::evaluate(const implicit::PointBatch& points, const LevelBatch& out) const {
    evaluate_blocks(surface_, points, out,
                    [&](const glm::dvec3& p, const glm::dvec3& gradient, const auto& times, glm::dvec3& slope) {
                        const surface::Support::Answer s = support_.evaluate(p, gradient);
                        slope = s.by_place + times(s.by_normal) / glm::length(gradient);
                        return std::isfinite(s.value) ? s.value - limit_ : unsupported;
                    });
}

void SupportLevel::at_vertices(const base::Runtime& runtime, const SurfaceMesh& mesh, base::Array<double>& level,
                               const base::Progress& progress) const {
    support_.evaluate_all(runtime, mesh.position, mesh.gradient, level, progress);
    HRBFNPR_ASSERT(level.size() == mesh.vertices());
    for (double& value : level) value = std::isfinite(value) ? value - limit_ : unsupported;
}

} // namespace hrbfnpr::curves
