// SPDX-License-Identifier: MIT
#include "fit/distance.h"

#include "implicit/evaluate_all.h"

#include <algorithm>

namespace hrbfnpr::fit {
namespace {

// Near the surface |grad f| is about 1. Where |grad f| is smaller than this constant, the constant is used in its
// place, because the first-order distance f / |grad f| would mean nothing.
constexpr double least_slope = 0.1;

[[nodiscard]] Distances make_distances(base::Memory& memory, std::int64_t count) {
    Distances result(memory);
    result.value.resize(count);
    result.gradient.resize(count);
    result.distance.resize(count);
    return result;
}

void set_distance(Distances& distances, std::int64_t i) noexcept {
    distances.distance[i] = distances.value[i] / std::max(least_slope, glm::length(distances.gradient[i]));
}

} // namespace

Distances distances_of_misfit(const base::Array<double>& misfit, const implicit::HrbfData& data,
                              const Samples& samples) {
    Distances result = make_distances(misfit.memory(), samples.position.size());
    for (std::int64_t i = 0; i < samples.position.size(); ++i) {
        const double* m = misfit.data() + 4 * i;
        result.value[i] = -data.scale * m[0];
        result.gradient.set(i, samples.normal[i] - glm::dvec3(m[1], m[2], m[3]));
        set_distance(result, i);
    }
    return result;
}

Distances measure_distances(const base::Work& work, const implicit::HrbfData& data, const Samples& samples) {
    const std::int64_t count = samples.position.size();
    Distances result = make_distances(work.memory, count);
    const implicit::PointBatch points{samples.position.x.data(), samples.position.y.data(), samples.position.z.data(),
                                      count};
    const implicit::FieldBatch fields{
        result.value.data(), {result.gradient.x.data(), result.gradient.y.data(), result.gradient.z.data()}, {}};
    work.for_chunks(count, implicit::batch_size, [&](std::int64_t begin, std::int64_t end) {
        implicit::evaluate(work.instruction_set, data, implicit::slice(points, begin, end), fields.from(begin));
        for (std::int64_t i = begin; i < end; ++i) set_distance(result, i);
    });
    return result;
}

Distances measure_distances(const base::Work& work, const implicit::Implicit& implicit, const Samples& samples) {
    Distances result = make_distances(work.memory, samples.position.size());
    implicit::evaluate_all(
        work, implicit, samples.position,
        {result.value.data(), {result.gradient.x.data(), result.gradient.y.data(), result.gradient.z.data()}, {}});
    for (std::int64_t i = 0; i < samples.position.size(); ++i) set_distance(result, i);
    return result;
}

} // namespace hrbfnpr::fit
