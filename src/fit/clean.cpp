// SPDX-License-Identifier: MIT
#include "fit/clean.h"

#include "fit/suspects.h"

#include <algorithm>
#include <optional>

namespace hrbfnpr::fit {
namespace {

constexpr std::int64_t neighbours_each = 16;

// Two samples are near duplicates if their distance is below this share of the local spacing and their normals differ
// by less than 15 degrees. The local spacing is the distance to the 16th neighbour divided by `spacings_of_farthest`.
constexpr double duplicate = 1e-3;
// The distance to the 16th neighbour on an even sheet, in spacings: sqrt(16 / pi).
constexpr double spacings_of_farthest = 2.26;
constexpr double agreement = 0.965925826289;

[[nodiscard]] double duplicate_distance(const Samples& samples, const geometry::Neighbours& neighbours,
                                        std::int64_t i) {
    const glm::dvec3 farthest = samples.position[neighbours.of(i).back()];
    return duplicate / spacings_of_farthest * glm::distance(samples.position[i], farthest);
}

// Returns the sum of the cosines between a sample's normal and its neighbours' normals.
[[nodiscard]] double sum_of_cosines(const Samples& samples, const geometry::Neighbours& neighbours, std::int64_t i) {
    double sum = 0.0;
    for (const std::int64_t j : neighbours.of(i)) sum += glm::dot(samples.normal[i], samples.normal[j]);
    return sum;
}

struct Duplicates {
    explicit Duplicates(base::Memory& memory) noexcept : representative(memory), contradicts(memory) {}

    base::Array<std::int64_t> representative; // for each sample: the sample that it is merged into, or itself
    base::Array<std::uint8_t> contradicts;    // 1 for the worse of two near samples with different normals
    std::int64_t merged = 0;
};

[[nodiscard]] Duplicates find_duplicates(const Samples& samples, const geometry::Neighbours& neighbours) {
    const std::int64_t count = samples.position.size();
    Duplicates result(samples.position.memory());
    result.representative.resize(count);
    result.contradicts.resize(count);
    for (std::int64_t i = 0; i < count; ++i) result.representative[i] = i;
    for (std::int64_t i = 0; i < count; ++i) {
        if (result.representative[i] != i) continue;
        const double limit = duplicate_distance(samples, neighbours, i);
        for (const std::int64_t j : neighbours.of(i)) {
            // The neighbours are sorted, nearest first.
            if (glm::distance(samples.position[i], samples.position[j]) > limit) break;
            if (j < i || result.representative[j] != j) continue;
            if (glm::dot(samples.normal[i], samples.normal[j]) >= agreement) {
                result.representative[j] = i;
                ++result.merged;
            } else {
                const bool first = sum_of_cosines(samples, neighbours, i) < sum_of_cosines(samples, neighbours, j);
                result.contradicts[first ? i : j] = 1;
            }
        }
    }
    return result;
}

void drop(Samples& samples, const base::Array<std::uint8_t>& marked) {
    std::int64_t kept = 0;
    for (std::int64_t i = 0; i < samples.position.size(); ++i) {
        if (marked[i] != 0) continue;
        samples.position.set(kept, samples.position[i]);
        samples.normal.set(kept++, samples.normal[i]);
    }
    samples.position.resize(kept);
    samples.normal.resize(kept);
}

[[nodiscard]] std::int64_t count_of(const base::Array<std::uint8_t>& marked) {
    return std::count(marked.begin(), marked.end(), std::uint8_t{1});
}

// Returns an array that is 1 for each sample that remains after merging.
[[nodiscard]] base::Array<std::uint8_t> without_merged(const Duplicates& duplicates) {
    base::Array<std::uint8_t> contradicts(duplicates.contradicts.memory());
    for (std::int64_t i = 0; i < duplicates.contradicts.size(); ++i)
        if (duplicates.representative[i] == i) contradicts.push_back(duplicates.contradicts[i]);
    return contradicts;
}

// Drops or turns the suspects. Returns true if samples were dropped.
bool repair(Samples& samples, const Suspects& suspects, Repair outliers, Repair flipped_normals, Cleaning& report) {
    base::Array<std::uint8_t> dropped(samples.position.memory(), samples.position.size());
    for (std::int64_t i = 0; i < dropped.size(); ++i) {
        if (outliers == Repair::drop && suspects.outlier[i] != 0) dropped[i] = 1;
        if (suspects.flipped[i] == 0) continue;
        if (flipped_normals == Repair::drop) dropped[i] = 1;
        if (flipped_normals == Repair::reorient) samples.normal.set(i, -samples.normal[i]);
    }
    if (outliers == Repair::drop) report.outliers_dropped = report.outliers_found;
    if (flipped_normals != Repair::keep) report.flipped_repaired = report.flipped_found;
    const bool any = count_of(dropped) > 0;
    if (any) drop(samples, dropped);
    return any;
}

} // namespace

Cleaning clean(const base::Work& work, Samples& samples, Repair outliers, Repair flipped_normals) {
    Cleaning report;
    work.update(0.0);
    if (samples.position.size() < fewest_to_clean) return report;
    std::optional<geometry::Neighbours> neighbours;
    neighbours.emplace(work.runtime().parallel, samples.position, neighbours_each, work);
    work.update(0.3);
    const Duplicates duplicates = find_duplicates(samples, *neighbours);
    report.near_duplicates = duplicates.merged;
    if (duplicates.merged > 0) {
        merge(samples, duplicates.representative);
        neighbours.emplace(work.runtime().parallel, samples.position, neighbours_each, work);
    }
    work.update(0.5);
    Suspects suspects = find_suspects(work, samples, *neighbours);
    const base::Array<std::uint8_t> contradicts = without_merged(duplicates);
    for (std::int64_t i = 0; i < contradicts.size(); ++i) {
        suspects.outlier[i] |= contradicts[i];
        if (suspects.outlier[i] != 0) suspects.flipped[i] = 0;
    }
    report.outliers_found = count_of(suspects.outlier);
    report.flipped_found = count_of(suspects.flipped);
    work.update(0.8);
    if (repair(samples, suspects, outliers, flipped_normals, report) || duplicates.merged > 0)
        measure_extent(work, samples);
    work.update(1.0);
    return report;
}

} // namespace hrbfnpr::fit
