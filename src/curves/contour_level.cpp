// SPDX-License-Identifier: MIT
#include "curves/contour_level.h"

#include "curves/level_block.h"

namespace hrbfnpr::curves {
namespace {

constexpr std::int64_t vertices_a_task = 16384;

} // namespace

void ContourLevel::evaluate(const implicit::PointBatch& points, const LevelBatch& out) const {
    in_blocks(points, out, [&](const implicit::PointBatch& some, const LevelBatch& to) { evaluate_block(some, to); });
}

// grad g = H v + grad f where v depends on the point, H v where it does not.
void ContourLevel::evaluate_block(const implicit::PointBatch& points, const LevelBatch& out) const {
    HessianBlock h;
    h.evaluate(surface_, points, out);
    const double own = view_.eye.w == 0.0 ? 0.0 : 1.0;
    for (std::int64_t i = 0; i < points.count; ++i) {
        const glm::dvec3 v = view_.sight({points.x[i], points.y[i], points.z[i]});
        const glm::dvec3 gradient(out.gradient[0][i], out.gradient[1][i], out.gradient[2][i]);
        const glm::dvec3 level = h.times(i, v) + own * gradient;
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

Curves ContourLevel::moved(base::Memory& memory, const Curves& contours, double farthest) const {
    Curves result(memory);
    result.first.push_back(0);
    result.point.reserve(contours.point.size());
    for (std::int64_t c = 0; c < contours.count(); ++c) {
        for (std::int64_t i = contours.first[c]; i < contours.first[c + 1]; ++i) {
            CurvePoint p = contours.point[i];
            p.value = 0.0;
            p.level = glm::dot(p.gradient, view_.sight(p.position));
            const glm::dvec3 way = p.newton_step();
            if (!(glm::length(way) <= farthest)) continue;
            p.position += way;
            result.point.push_back(p);
        }
        result.first.push_back(result.point.size());
        result.closed.push_back(contours.closed[c]);
    }
    return result;
}

} // namespace hrbfnpr::curves
