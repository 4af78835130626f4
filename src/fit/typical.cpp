// SPDX-License-Identifier: MIT
#include "fit/typical.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::fit {
namespace {

constexpr std::size_t most_neighbours = 8; // the number of nearest neighbours that may replace a sample
constexpr std::int64_t spacings_a_task = 512;

// Returns the mean angle of a sample's normal to its neighbours' normals, plus the mean angle of its position above
// their tangent planes.
[[nodiscard]] double deviation_from_neighbours(const Samples& samples, const geometry::Neighbours& neighbours,
                                               std::int64_t i) {
    double height = 0.0;
    double distance = 0.0;
    double turn = 0.0;
    for (const std::int64_t j : neighbours.of(i)) {
        const glm::dvec3 between = samples.position[i] - samples.position[j];
        height += std::abs(glm::dot(between, samples.normal[j]));
        distance += glm::length(between);
        turn += glm::distance(samples.normal[i], samples.normal[j]);
    }
    return height / std::max(distance, 1e-300) + turn / static_cast<double>(neighbours.each());
}

} // namespace

base::Array<std::int64_t> typical_samples(const base::Work& work, const Samples& samples,
                                          const geometry::Neighbours& neighbours) {
    const std::int64_t count = samples.position.size();
    base::Array<double> deviation(work.memory, count);
    base::Array<std::int64_t> typical(work.memory, count);
    const auto for_each = [&](auto&& visit) {
        work.for_chunks(count, spacings_a_task, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i) visit(i);
        });
    };
    for_each([&](std::int64_t i) { deviation[i] = deviation_from_neighbours(samples, neighbours, i); });
    for_each([&](std::int64_t i) {
        typical[i] = i;
        const auto near = neighbours.of(i);
        for (const std::int64_t j : near.first(std::min(most_neighbours, near.size())))
            if (deviation[j] < deviation[typical[i]] || (deviation[j] == deviation[typical[i]] && j < typical[i]))
                typical[i] = j;
    });
    return typical;
}

} // namespace hrbfnpr::fit
