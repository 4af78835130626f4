// SPDX-License-Identifier: MIT
#include "marks/assemble.h"

#include "base/long_array.h"
#include "base/random.h"
#include "geometry/tangent_frame.h"
#include "marks/spacing.h"
#include "surface/curvature.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::marks {
namespace {

void store(base::Array<float>& array, std::int64_t i, const glm::dvec3& v) noexcept {
    array[3 * i] = static_cast<float>(v.x);
    array[3 * i + 1] = static_cast<float>(v.y);
    array[3 * i + 2] = static_cast<float>(v.z);
}

void resize(Layer& layer, std::int64_t count, bool with_curvature, bool with_width, const base::Progress& progress) {
    base::resize_long(layer.position, 3 * count, progress);
    base::resize_long(layer.normal, 3 * count, progress);
    base::resize_long(layer.direction, 3 * count, progress);
    if (with_curvature) base::resize_long(layer.curvature, 3 * count, progress);
    base::resize_long(layer.rank, count, progress);
    base::resize_long(layer.level, count, progress);
    base::resize_long(layer.stroke, 2 * count, progress);
    if (with_width) base::resize_long(layer.width, count, progress);
}

void compute_curvature(const Site& site, const Marks& marks, base::Array<float>& result,
                       const base::Progress& progress) {
    geometry::VecArray points(site.memory());
    base::Array<surface::Curvature> curvature(site.memory());
    const auto all = static_cast<double>(marks.count());
    for (std::int64_t begin = 0; begin < marks.count(); begin += chunk_size) {
        const std::int64_t end = std::min(marks.count(), begin + chunk_size);
        points.clear();
        for (std::int64_t i = begin; i < end; ++i) points.push_back(marks.position[i]);
        surface::principal_curvatures(site.runtime, site.implicit, points, curvature,
                                      progress.part(static_cast<double>(begin) / all, static_cast<double>(end) / all));
        for (std::int64_t i = begin; i < end; ++i) {
            const surface::Curvature& c = curvature[i - begin];
            store(result, i, {held_curvature(c.k1), held_curvature(c.k2), c.confidence});
        }
    }
}

} // namespace

float random_rank(std::uint64_t random_seed, std::uint64_t key, Kind kind) noexcept {
    return rank_of(base::uniform4(random_seed, key, base::Purpose::rank, stream_of(kind))[0]);
}

void assemble(const Site& site, const Marks& marks, const AssembleSettings& settings, const glm::dvec3& origin,
              Layer& result, const base::Progress& progress) {
    const std::int64_t count = marks.count();
    resize(result, count, settings.with_curvature, !marks.width.empty(), progress);
    for (std::int64_t i = 0; i < count; ++i) {
        if (i % 16384 == 0) progress.check();
        const glm::dvec3 n = marks.normal[i];
        store(result.position, i, marks.position[i] - origin);
        store(result.normal, i, n);
        store(result.direction, i, settings.strokes ? marks.direction[i] : geometry::stipple_frame(n).u);
        // Rank 1 first: a mark is shown where its rank is at least tau.
        const float own = !marks.rank.empty() ? marks.rank[i]
                          : result.progressive
                              ? rank_of(1.0 - (static_cast<double>(i) + 0.5) / static_cast<double>(count))
                              : random_rank(site.random_seed, marks.key[i], result.kind);
        result.rank[i] = settings.part[settings.strokes ? marks.stroke[i] & 1U : 0U].rank(own);
        if (!marks.width.empty()) result.width[i] = marks.width[i];
        result.level[i] = marks.level[i];
        result.stroke[2 * i] = settings.strokes ? marks.stroke[i] : 2 * marks.stroke[i];
        result.stroke[2 * i + 1] = static_cast<std::uint32_t>(marks.place[i]);
        if (!marks.curvature.empty())
            for (std::size_t k = 0; k < 3; ++k)
                result.curvature[3 * i + static_cast<std::int64_t>(k)] = marks.curvature[i][k];
    }
    if (settings.with_curvature && marks.curvature.empty()) compute_curvature(site, marks, result.curvature, progress);
    if (settings.strokes) index_strokes(result, progress);
    progress.update(1.0);
}

void measure(const base::Runtime& runtime, std::span<const geometry::VecArray* const> positions, double area,
             PointSet& set, const base::Progress& progress) {
    const geometry::VecArray* largest = positions.front();
    for (const geometry::VecArray* layer : positions) {
        if (layer->size() > largest->size()) largest = layer;
        for (std::int64_t i = 0; i < layer->size(); ++i) set.bounds.extend((*layer)[i]);
    }
    if (set.bounds.empty()) return; // no mark: an origin or a spacing would be 0 / 0
    set.origin = set.bounds.centre();
    set.spacing = area > 0.0 ? std::sqrt(area / static_cast<double>(largest->size()))
                             : covered_spacing(runtime, *largest, progress);
}

} // namespace hrbfnpr::marks
