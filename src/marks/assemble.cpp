#include "marks/assemble.h"

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

// Strokes one after the other, each from end to end, where the order of the marks is that of
// their ranks; else the order in which they were placed, coarse levels first.
base::Array<std::int64_t> order_of(const Marks& marks, const AssembleSettings& settings) {
    base::Array<std::int64_t> order(marks.position.memory(), marks.count());
    for (std::int64_t i = 0; i < order.size(); ++i) order[i] = i;
    if (settings.progressive && settings.group != Group::stipple && marks.rank.empty())
        std::sort(order.begin(), order.end(), [&](std::int64_t a, std::int64_t b) {
            return marks.stroke[a] != marks.stroke[b] ? marks.stroke[a] < marks.stroke[b]
                                                      : marks.place[a] < marks.place[b];
        });
    return order;
}

void resize(MarkGroup& group, std::int64_t count, bool with_curvature, bool with_width) {
    group.position.resize(3 * count);
    group.normal.resize(3 * count);
    group.direction.resize(3 * count);
    if (with_curvature) group.curvature.resize(3 * count);
    group.rank.resize(count);
    group.level.resize(count);
    group.stroke.resize(2 * count);
    if (with_width) group.width.resize(count);
}

void compute_curvature(const Site& site, const Marks& marks, const base::Array<std::int64_t>& order,
                       base::Array<float>& result, const base::Progress& progress) {
    geometry::VecArray points(site.memory());
    base::Array<surface::Curvature> curvature(site.memory());
    const auto all = static_cast<double>(order.size());
    for (std::int64_t begin = 0; begin < order.size(); begin += chunk_size) {
        const std::int64_t end = std::min(order.size(), begin + chunk_size);
        points.clear();
        for (std::int64_t i = begin; i < end; ++i) points.push_back(marks.position[order[i]]);
        surface::principal_curvatures(site.runtime, site.implicit, points, curvature,
                                      progress.part(static_cast<double>(begin) / all, static_cast<double>(end) / all));
        for (std::int64_t i = begin; i < end; ++i) {
            const surface::Curvature& c = curvature[i - begin];
            store(result, i, {held_curvature(c.k1), held_curvature(c.k2), c.confidence});
        }
    }
}

} // namespace

float random_rank(std::uint64_t random_seed, std::uint64_t key, Group group) noexcept {
    return rank_of(base::uniform4(random_seed, key, base::Purpose::rank, lane_of(group))[0]);
}

void assemble(const Site& site, const Marks& marks, const AssembleSettings& settings, const glm::dvec3& origin,
              MarkGroup& result, const base::Progress& progress) {
    const std::int64_t count = marks.count();
    const base::Array<std::int64_t> order = order_of(marks, settings);
    const bool is_stipple = settings.group == Group::stipple;
    resize(result, count, settings.with_curvature, !marks.width.empty());
    // Rank 1 first: a mark is shown where its rank is at least tau.
    const auto last = static_cast<double>(is_stipple ? count : settings.strokes);
    for (std::int64_t i = 0; i < count; ++i) {
        if (i % 65536 == 0) progress.check();
        const std::int64_t from = order[i];
        const glm::dvec3 n = marks.normal[from];
        store(result.position, i, marks.position[from] - origin);
        store(result.normal, i, n);
        store(result.direction, i, is_stipple ? geometry::stipple_frame(n).u : marks.direction[from]);
        const double number = is_stipple ? static_cast<double>(i) : static_cast<double>(marks.stroke[from]);
        result.rank[i] = settings.progressive ? rank_of(1.0 - (number + 0.5) / last)
                                              : random_rank(site.random_seed, marks.key[from], settings.group);
        if (!marks.rank.empty()) result.rank[i] = marks.rank[from];
        result.rank[i] = settings.part[is_stipple ? 0U : marks.stroke[from] & 1U].rank(result.rank[i]);
        if (!marks.width.empty()) result.width[i] = marks.width[from];
        result.level[i] = marks.level[from];
        result.stroke[2 * i] = marks.stroke[from];
        result.stroke[2 * i + 1] = static_cast<std::uint32_t>(marks.place[from]);
        if (!marks.curvature.empty())
            for (std::size_t k = 0; k < 3; ++k)
                result.curvature[3 * i + static_cast<std::int64_t>(k)] = marks.curvature[from][k];
    }
    if (settings.with_curvature && marks.curvature.empty())
        compute_curvature(site, marks, order, result.curvature, progress);
    progress.update(1.0);
}

void measure(const base::Runtime& runtime, std::span<const geometry::VecArray* const> positions, double area,
             PointSet& set, const base::Progress& progress) {
    const geometry::VecArray* largest = positions.front();
    for (const geometry::VecArray* group : positions) {
        if (group->size() > largest->size()) largest = group;
        for (std::int64_t i = 0; i < group->size(); ++i) set.bounds.extend((*group)[i]);
    }
    if (set.bounds.empty()) return; // no mark: an origin or a spacing would be 0 / 0
    set.origin = set.bounds.centre();
    set.spacing = area > 0.0 ? std::sqrt(area / static_cast<double>(largest->size()))
                             : covered_spacing(runtime, *largest, progress);
}

} // namespace hrbfnpr::marks
