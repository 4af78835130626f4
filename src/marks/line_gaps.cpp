// SPDX-License-Identifier: MIT
#include "marks/line_gaps.h"

#include "geometry/point_grid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::marks {
namespace {

// In separations: lines are looked for so far to either side ...
constexpr double reach = 2.5;
// ... where they cross a strip of twice this width, which one mark of each does, or two ...
constexpr double beside = 0.35;
// ... and no farther off the tangent plane than this part of their distance, and facing the same way.
constexpr double steepest = 0.6;
constexpr double least_cosine = 0.5;
// Marks that are nearer to each other across are of one line, and no gap counts as wider.
constexpr double same_line = 0.3;
constexpr double widest = 2.0;
// Every so many marks of a line are asked, and as many to either side averaged as make some three separations.
constexpr std::int64_t every = 4;
constexpr std::int64_t most_averaged = 2;
constexpr std::int64_t most_lines = 64;
constexpr std::int64_t most_visits = 4000; // of marks around a mark
constexpr std::int64_t chunk = 16;         // lines

// Published strokes lie as they grew: their report's step is not the distance between them.
[[nodiscard]] bool has_nested_lines(const Layer& layer) noexcept {
    const bool nested = layer.kind == Kind::own || (layer.kind == Kind::hatch && layer.progressive);
    return nested && layer.strokes() > 1 && layer.report.step > 0.0;
}

class Gaps {
public:
    Gaps(const base::Runtime& runtime, const Layer& layer, const base::Progress& progress)
        : layer_(layer), separation_(layer.report.step), place_(places(runtime.memory, layer)),
          grid_(place_, reach * separation_, progress) {}

    // Whether so few marks lie around each one that they can all be looked at: a file may have any separation.
    [[nodiscard]] bool are_few() const noexcept {
        constexpr std::int64_t samples = 32;
        const std::int64_t step = std::max<std::int64_t>(place_.size() / samples, 1);
        std::int64_t visits = 0;
        for (std::int64_t i = 0; i < place_.size(); i += step) grid_.around(place_[i], [&](std::int64_t) { ++visits; });
        return visits <= most_visits * (place_.size() / step);
    }

    // Of one line; `asked` is room.
    void measure(std::int64_t stroke, base::Array<float>& asked, base::Array<float>& gap) const {
        const std::int64_t first = layer_.stroke_first[stroke];
        const std::int64_t count = std::int64_t{layer_.stroke_first[stroke + 1]} - first;
        const std::int64_t parts = (count + every - 1) / every;
        asked.resize(parts);
        for (std::int64_t k = 0; k < parts; ++k) {
            asked[k] = around(layer_.mark_of(first + k * every));
        }
        for (std::int64_t i = 0; i < count; ++i) {
            const std::int64_t k = i / every;
            const float t = static_cast<float>(i % every) / static_cast<float>(every);
            gap[layer_.mark_of(first + i)] =
                std::lerp(averaged(asked, k), averaged(asked, std::min(k + 1, parts - 1)), t);
        }
    }

private:
    [[nodiscard]] static geometry::VecArray places(base::Memory& memory, const Layer& layer) {
        geometry::VecArray places(memory, layer.count());
        for (std::int64_t i = 0; i < layer.count(); ++i) {
            places.set(i, glm::dvec3(vector_at(layer.position, i)));
        }
        return places;
    }

    [[nodiscard]] static float averaged(const base::Array<float>& asked, std::int64_t k) noexcept {
        const std::int64_t beside_it = std::min({most_averaged, k, asked.size() - 1 - k});
        float sum = 0.0F;
        for (std::int64_t i = k - beside_it; i <= k + beside_it; ++i) sum += asked[i];
        return sum / static_cast<float>(2 * beside_it + 1);
    }

    // Gaps count the more the nearer they are; without any it is 1.
    [[nodiscard]] float around(std::int64_t mark) const noexcept {
        std::array<double, most_lines> offset;
        const std::int64_t count = offsets(mark, offset);
        std::sort(offset.begin(), offset.begin() + count);
        double sum = 0.0;
        double weights = 0.0;
        double last = count > 0 ? offset[0] : 0.0;
        for (std::int64_t i = 1; i < count; ++i) {
            if (offset[static_cast<std::size_t>(i)] - last < same_line) continue;
            const double here = offset[static_cast<std::size_t>(i)];
            const double at = 0.5 * (last + here) / reach;
            const double weight = (1.0 - at * at) * (1.0 - at * at);
            sum += weight * std::min(here - last, widest);
            weights += weight;
            last = here;
        }
        return weights > 0.0 ? static_cast<float>(sum / weights) : 1.0F;
    }

    // Across the line, in separations, of the marks beside this one, its own among them.
    [[nodiscard]] std::int64_t offsets(std::int64_t mark, std::array<double, most_lines>& offset) const noexcept {
        const glm::dvec3 p = place_[mark];
        const glm::dvec3 n = vector_at(layer_.normal, mark);
        const glm::dvec3 along = vector_at(layer_.direction, mark);
        const glm::dvec3 across = glm::cross(n, along);
        std::int64_t count = 0;
        grid_.around(p, [&](std::int64_t at) {
            const std::int64_t other = grid_.index(at);
            const glm::dvec3 way = (place_[other] - p) / separation_;
            const double u = glm::dot(way, across);
            // What is no number is beside nothing.
            if (count < most_lines && std::abs(u) < reach && std::abs(glm::dot(way, along)) < beside &&
                std::abs(glm::dot(way, n)) < steepest * std::abs(u) + 0.1 &&
                glm::dot(n, glm::dvec3(vector_at(layer_.normal, other))) > least_cosine)
                offset[static_cast<std::size_t>(count++)] = u;
        });
        return count;
    }

    const Layer& layer_;
    double separation_;
    geometry::VecArray place_;
    geometry::PointGrid grid_;
};

} // namespace

void measure_gaps(const base::Runtime& runtime, const Layer& layer, base::Array<float>& gap,
                  const base::Progress& progress) {
    gap.clear();
    if (!has_nested_lines(layer)) return;
    const Gaps gaps(runtime, layer, progress);
    if (!gaps.are_few()) return;
    gap.resize(layer.count());
    runtime.parallel.for_chunks(layer.strokes(), chunk, [&](std::int64_t begin, std::int64_t end) {
        base::Array<float> asked(runtime.memory);
        for (std::int64_t s = begin; s < end; ++s) {
            progress.check();
            gaps.measure(s, asked, gap);
        }
    });
}

} // namespace hrbfnpr::marks
