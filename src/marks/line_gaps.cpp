// SPDX-License-Identifier: MIT
// How far apart nested lines really lie, since tone goes by the paper that each of them has.
#include "base/assert.h"
#include "geometry/point_grid.h"
#include "marks/clusters.h"
#include "marks/tuning.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::marks {
namespace {

constexpr std::size_t most_lines = 64; // beside a mark
constexpr std::int64_t strokes_a_task = 16;

// Published strokes lie as they grew: their report's step is not the distance between them.
bool has_nested_lines(const Layer& layer) noexcept {
    const bool nested = layer.kind == Kind::own || (layer.kind == Kind::hatch && layer.progressive);
    return nested && layer.strokes() > 1 && layer.report.step > 0.0;
}

// The gap around a mark. Marks beside it, its own line's among them, have offsets across the line; the gaps between
// these count the more the nearer they are. It is 1 where no mark is beside it.
float gap_around(const Layer& layer, const geometry::VecArray& place, const geometry::PointGrid& grid,
                 std::int64_t mark) noexcept {
    const glm::dvec3 n = vector_at(layer.normal, mark);
    const glm::dvec3 along = vector_at(layer.direction, mark);
    const glm::dvec3 across = glm::cross(n, along);
    std::array<double, most_lines> offset;
    std::size_t count = 0;
    grid.around(place[mark], [&](std::int64_t at) {
        const std::int64_t other = grid.index(at);
        const glm::dvec3 way = (place[other] - place[mark]) / layer.report.step;
        const double u = glm::dot(way, across);
        // The comparisons are false for NaN, so that it is beside nothing.
        if (count < most_lines && std::abs(u) < marks_tuning.gap_reach &&
            std::abs(glm::dot(way, along)) < marks_tuning.strip &&
            std::abs(glm::dot(way, n)) < marks_tuning.gap_steepest * std::abs(u) + 0.1 &&
            glm::dot(n, glm::dvec3(vector_at(layer.normal, other))) > marks_tuning.gap_cosine)
            offset[count++] = u;
    });
    std::sort(offset.begin(), offset.begin() + static_cast<std::ptrdiff_t>(count));
    double sum = 0.0;
    double weights = 0.0;
    double last = count > 0 ? offset[0] : 0.0;
    for (std::size_t i = 1; i < count; ++i) {
        const double here = offset[i];
        if (here - last < marks_tuning.same_line) continue;
        const double at = 0.5 * (last + here) / marks_tuning.gap_reach;
        const double weight = (1.0 - at * at) * (1.0 - at * at);
        sum += weight * std::min(here - last, marks_tuning.widest_gap);
        weights += weight;
        last = here;
    }
    return weights > 0.0 ? static_cast<float>(sum / weights) : 1.0F;
}

} // namespace

void measure_gaps(const base::Runtime& runtime, const Layer& layer, base::Array<float>& gap,
                  const base::Progress& progress) {
    gap.clear();
    if (!has_nested_lines(layer)) return;
    HRBFNPR_ASSERT(layer.direction.size() == 3 * layer.count());
    const std::int64_t marks = layer.count();
    geometry::VecArray place(runtime.memory, marks);
    for (std::int64_t i = 0; i < marks; ++i) place.set(i, glm::dvec3(vector_at(layer.position, i)));
    const geometry::PointGrid grid(place, marks_tuning.gap_reach * layer.report.step, progress);
    // A file may have any separation: only few marks around each one can all be looked at.
    const std::int64_t sample = std::max<std::int64_t>(marks / 32, 1);
    std::int64_t visits = 0;
    for (std::int64_t i = 0; i < marks; i += sample) grid.around(place[i], [&](std::int64_t) { ++visits; });
    if (visits > marks_tuning.most_visits * (marks / sample)) return;
    gap.resize(marks);
    runtime.parallel.for_chunks(layer.strokes(), strokes_a_task, [&](std::int64_t begin, std::int64_t end) {
        base::Array<float> measured(runtime.memory);
        const auto averaged = [&](std::int64_t k) {
            const std::int64_t reach = std::min({marks_tuning.most_averaged, k, measured.size() - 1 - k});
            float sum = 0.0F;
            for (std::int64_t i = k - reach; i <= k + reach; ++i) sum += measured[i];
            return sum / static_cast<float>(2 * reach + 1);
        };
        for (std::int64_t s = begin; s < end; ++s) {
            progress.check();
            const std::int64_t first = layer.stroke_first[s];
            const std::int64_t count = std::int64_t{layer.stroke_first[s + 1]} - first;
            measured.clear();
            for (std::int64_t i = 0; i < count; i += marks_tuning.measured_each)
                measured.push_back(gap_around(layer, place, grid, layer.mark_of(first + i)));
            for (std::int64_t i = 0; i < count; ++i) {
                const std::int64_t k = i / marks_tuning.measured_each;
                const float t =
                    static_cast<float>(i % marks_tuning.measured_each) / static_cast<float>(marks_tuning.measured_each);
                gap[layer.mark_of(first + i)] =
                    std::lerp(averaged(k), averaged(std::min(k + 1, measured.size() - 1)), t);
            }
        }
    });
}

} // namespace hrbfnpr::marks
