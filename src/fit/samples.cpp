// SPDX-License-Identifier: MIT
#include "fit/samples.h"

#include "base/sort.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::fit {
namespace {

// Larger coordinates are rejected, so that squares and cubes stay far from the ends of a double's range.
constexpr double coordinate_limit = 1e100;

constexpr double coincidence = 1e-9;           // Samples closer than this coincide, in diagonals.
constexpr double same_normal = 0.999847695156; // Normals with a larger cosine count as equal: the cosine of 1 degree.
constexpr double degrees = 57.29577951308232;
constexpr double rescaled_by = 1e-4;

[[nodiscard]] glm::dvec3 read(const base::InView& view, std::int64_t i) noexcept {
    return {view.get(i, 0), view.get(i, 1), view.get(i, 2)};
}

[[nodiscard]] double largest(const glm::dvec3& v) noexcept {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

[[nodiscard]] bool finite(const glm::dvec3& v) noexcept {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

[[nodiscard]] glm::dvec3 checked_point(const base::InView& points, std::int64_t i) {
    const glm::dvec3 p = read(points, i);
    const auto index = static_cast<long long>(i);
    if (!finite(p)) fail(Status::invalid_argument, "points[%lld] is NaN or infinite; remove that sample", index);
    if (largest(p) > coordinate_limit)
        fail(Status::invalid_argument, "points[%lld] has a coordinate beyond 1e100; use a larger unit", index);
    return p;
}

[[nodiscard]] glm::dvec3 checked_normal(const base::InView& normals, std::int64_t i, std::int64_t& rescaled) {
    const glm::dvec3 n = read(normals, i);
    const auto index = static_cast<long long>(i);
    if (!finite(n)) fail(Status::invalid_argument, "normals[%lld] is NaN or infinite; remove that sample", index);
    const double size = largest(n);
    if (size == 0.0)
        fail(Status::invalid_argument, "normals[%lld] is zero; give it a direction or remove that sample", index);
    const glm::dvec3 scaled = n / size; // Dividing by the size first keeps the square of a tiny normal above zero.
    const double length = glm::length(scaled);
    if (!(std::abs(length * size - 1.0) <= rescaled_by)) ++rescaled;
    return scaled / length;
}

// A sample's position along a fixed direction. Samples that follow each other in this order are mostly close in space.
// The direction is neither an axis nor a diagonal, because shapes often have planes perpendicular to these.
struct SampleOnLine {
    double key;
    std::int64_t index;
};

[[nodiscard]] base::Array<SampleOnLine> sorted_on_line(const geometry::VecArray& position,
                                                       const geometry::Bounds& bounds, const base::Progress& progress) {
    const glm::dvec3 direction = glm::normalize(glm::dvec3(0.5257, 0.7331, 0.4313));
    base::Array<SampleOnLine> order(position.memory(), position.size());
    for (std::int64_t i = 0; i < order.size(); ++i) order[i] = {glm::dot(direction, position[i] - bounds.min), i};
    base::sort_long(
        order.begin(), order.end(),
        [](const SampleOnLine& a, const SampleOnLine& b) {
            return a.key < b.key || (a.key == b.key && a.index < b.index);
        },
        progress);
    return order;
}

void require_agreement(const Samples& samples, std::int64_t a, std::int64_t b) {
    const double cosine = glm::dot(samples.normal[a], samples.normal[b]);
    if (cosine >= same_normal) return;
    fail(Status::invalid_argument,
         "points[%lld] and points[%lld] coincide, but their normals differ by %.3g degrees; remove one of them or move "
         "them apart",
         static_cast<long long>(std::min(a, b)), static_cast<long long>(std::max(a, b)),
         degrees * std::acos(std::clamp(cosine, -1.0, 1.0)));
}

// Returns, for each sample, the index of the sample that represents all samples at the same position.
[[nodiscard]] base::Array<std::int64_t> representatives(const Samples& samples, const base::Progress& progress) {
    base::Memory& memory = samples.position.memory();
    const double tolerance = coincidence * samples.bounds.diagonal();
    const base::Array<SampleOnLine> order = sorted_on_line(samples.position, samples.bounds, progress);
    base::Array<std::int64_t> representative(memory, order.size());
    base::Array<SampleOnLine> kept(memory);
    for (const std::int64_t next : progress.over(order.size())) {
        const SampleOnLine& sample = order[next];
        std::int64_t found = -1;
        for (std::int64_t k = kept.size() - 1; k >= 0 && found < 0; --k) {
            if (sample.key - kept[k].key > 1.001 * tolerance) break;
            if (glm::distance(samples.position[sample.index], samples.position[kept[k].index]) <= tolerance)
                found = kept[k].index;
        }
        if (found < 0) {
            kept.push_back(sample);
            found = sample.index;
        } else {
            require_agreement(samples, sample.index, found);
        }
        representative[sample.index] = found;
    }
    return representative;
}

// Returns the distance from sample order[at] to the nearest other sample.
[[nodiscard]] double nearest(const geometry::VecArray& position, const base::Array<SampleOnLine>& order,
                             std::int64_t at) {
    double best = HUGE_VAL;
    const glm::dvec3 p = position[order[at].index];
    for (std::int64_t k = at + 1; k < order.size() && order[k].key - order[at].key < best; ++k)
        best = std::min(best, glm::distance(p, position[order[k].index]));
    for (std::int64_t k = at - 1; k >= 0 && order[at].key - order[k].key < best; --k)
        best = std::min(best, glm::distance(p, position[order[k].index]));
    return best;
}

[[nodiscard]] double mean_spacing(const base::Work& work, const Samples& samples) {
    const std::int64_t count = samples.position.size();
    if (count < 2) return 0.0;
    const base::Array<SampleOnLine> order = sorted_on_line(samples.position, samples.bounds, work);
    base::Array<double> distance(work.memory, count);
    work.for_chunks(count, 256, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) distance[i] = nearest(samples.position, order, i);
    });
    double sum = 0.0;
    for (const double d : distance) sum += d;
    return sum / static_cast<double>(count);
}

} // namespace

void merge(Samples& samples, const base::Array<std::int64_t>& representative) {
    base::Memory& memory = samples.position.memory();
    const std::int64_t count = samples.position.size();
    base::Array<std::int64_t> slot(memory, count);  // for each representative: 1 + the index of its average
    base::Array<std::int64_t> share(memory, count); // the number of samples merged into each average
    std::int64_t kept = 0;
    for (std::int64_t i = 0; i < count; ++i) {
        std::int64_t& at = slot[representative[i]];
        if (at == 0) {
            at = ++kept;
            samples.position.set(kept - 1, samples.position[i]);
            samples.normal.set(kept - 1, samples.normal[i]);
        } else {
            samples.position.set(at - 1, samples.position[at - 1] + samples.position[i]);
            samples.normal.set(at - 1, samples.normal[at - 1] + samples.normal[i]);
        }
        ++share[at - 1];
    }
    for (std::int64_t k = 0; k < kept; ++k) {
        if (share[k] == 1) continue;
        // Clamping keeps the rounded mean inside the bounds.
        const glm::dvec3 mean = samples.position[k] / static_cast<double>(share[k]);
        samples.position.set(k, glm::clamp(mean, samples.bounds.min, samples.bounds.max));
        samples.normal.set(k, glm::normalize(samples.normal[k]));
    }
    samples.position.resize(kept);
    samples.normal.resize(kept);
}

void measure_extent(const base::Work& work, Samples& samples) {
    samples.bounds = {};
    for (std::int64_t i = 0; i < samples.position.size(); ++i) samples.bounds.extend(samples.position[i]);
    samples.spacing = mean_spacing(work, samples);
}

Samples read_samples(const base::Work& work, const base::InView& points, const base::InView& normals) {
    work.update(0.0);
    Samples samples(work.memory);
    samples.position.resize(points.count);
    samples.normal.resize(points.count);
    for (const std::int64_t i : work.over(points.count)) {
        samples.position.set(i, checked_point(points, i));
        samples.normal.set(i, checked_normal(normals, i, samples.rescaled_normals));
        samples.bounds.extend(samples.position[i]);
    }
    const double diagonal = samples.bounds.diagonal();
    if (diagonal > 0.0 && diagonal < 1.0 / coordinate_limit)
        fail(Status::invalid_argument, "points span only %.3g, less than 1e-100; use a smaller unit", diagonal);
    work.update(0.25);
    merge(samples, representatives(samples, work));
    work.check();
    samples.merged = points.count - samples.position.size();
    work.update(0.5);
    samples.spacing = mean_spacing(work, samples);
    work.update(1.0);
    return samples;
}

} // namespace hrbfnpr::fit
