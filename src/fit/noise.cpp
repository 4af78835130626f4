// SPDX-License-Identifier: MIT
#include "fit/noise.h"

#include "geometry/neighbours.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::fit {
namespace {

// A group of the neighbours of each sample: the neighbours [begin, end), counted from the nearest. A group has several
// neighbours, because the noise decides which neighbour is the nearest, and favours one with similar noise.
struct RankRange {
    std::size_t begin;
    std::size_t end;
};
constexpr std::array<RankRange, 5> groups{{{0, 4}, {4, 8}, {8, 16}, {16, 24}, {24, 32}}};
constexpr std::int64_t looked_at = 32768; // the largest number of samples measured, spread evenly over all
constexpr std::size_t terms = 3;          // the number of coefficients: a, b and c

// The median absolute value of a Gaussian variable, in standard deviations.
constexpr double gaussian_median = 0.6744897501960817;
// The median distance between two noisy copies of a unit vector, in standard deviations: 2 sqrt(ln 2).
constexpr double turn_median = 1.6651092223153954;
// Pairs of samples whose normals have a smaller cosine are ignored: the two samples are on two sheets, or there is an
// edge between them.
constexpr double same_side = 0.5;
// If the noise explains less than this share of the nearest neighbours' variance, it may be only an error of the model
// of noise.h. The result is then "no noise".
constexpr double least_share = 0.5;
// Smaller estimates of the noise, in diagonals, count as rounding of coordinates to floats.
constexpr double rounding = 1e-7;

// The typical distance, variance and change of normal over the pairs of one group.
struct PairStatistics {
    double distance = 0.0;
    double variance = 0.0;
    double turn = 0.0; // |n_i - n_j|
};

[[nodiscard]] double median(base::Array<double>& values) {
    double* middle = values.data() + values.size() / 2;
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

[[nodiscard]] PairStatistics measure(const Samples& samples, const geometry::Neighbours& neighbours,
                                     const RankRange& group) {
    base::Array<double> distance(samples.position.memory());
    base::Array<double> error(samples.position.memory());
    base::Array<double> turn(samples.position.memory());
    const std::int64_t step = (samples.position.size() + looked_at - 1) / looked_at;
    for (std::int64_t i = 0; i < samples.position.size(); i += step) {
        for (const std::int64_t j : neighbours.of(i).subspan(group.begin, group.end - group.begin)) {
            if (glm::dot(samples.normal[i], samples.normal[j]) < same_side) continue;
            const glm::dvec3 between = samples.position[j] - samples.position[i];
            distance.push_back(glm::length(between));
            error.push_back(std::abs(0.5 * glm::dot(between, samples.normal[i] + samples.normal[j])));
            turn.push_back(glm::distance(samples.normal[i], samples.normal[j]));
        }
    }
    if (error.empty()) return {};
    const double deviation = median(error) / gaussian_median;
    return {median(distance), deviation * deviation, median(turn)};
}

using Coefficients = std::array<double, terms>;
// The coefficients are fitted so that the dot product of each row with them is about 1.
using Rows = std::array<Coefficients, groups.size()>;

// Solves least squares with 0 <= x <= most by coordinate descent. This is fast enough for three coefficients.
[[nodiscard]] Coefficients bounded_least_squares(const Rows& rows, const Coefficients& most) {
    constexpr int sweeps = 2000;
    Coefficients x{};
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (std::size_t c = 0; c < terms; ++c) {
            double above = 0.0;
            double below = 0.0;
            for (const Coefficients& row : rows) {
                double rest = 1.0;
                for (std::size_t k = 0; k < terms; ++k)
                    if (k != c) rest -= row[k] * x[k];
                above += row[c] * rest;
                below += row[c] * row[c];
            }
            x[c] = below > 0.0 ? std::clamp(above / below, 0.0, most[c]) : 0.0;
        }
    return x;
}

} // namespace

Noise measure_noise(const base::Work& work, const Samples& samples) {
    if (samples.position.size() <= geometry::Neighbours::most) return {};
    const geometry::Neighbours neighbours(work.runtime().parallel, samples.position, geometry::Neighbours::most, work);
    std::array<PairStatistics, groups.size()> pairs;
    for (std::size_t k = 0; k < groups.size(); ++k) {
        work.check();
        pairs[k] = measure(samples, neighbours, groups[k]);
        // There is no estimate if all samples lie exactly in planes, or if no pair of normals is similar.
        if (!(pairs[k].variance > 0.0 && pairs[k].distance > 0.0)) return {};
    }
    Rows rows;
    const double unit = pairs[0].distance;
    for (std::size_t k = 0; k < groups.size(); ++k) {
        const double d2 = (pairs[k].distance / unit) * (pairs[k].distance / unit);
        const double share = pairs[0].variance / pairs[k].variance; // The weight makes errors relative.
        rows[k] = {share, share * d2, share * d2 * d2 * d2};
    }
    // If the noise is not small compared with the spacing, the nearest pairs have similar noise. Their variance then
    // grows with distance, as if the normals were noisy. The measured change of the normals therefore bounds b.
    const double turned = pairs[0].turn * unit;
    const Coefficients most{HUGE_VAL, turned * turned / pairs[0].variance, HUGE_VAL};
    const Coefficients x = bounded_least_squares(rows, most);
    const double position = std::sqrt(0.5 * x[0] * pairs[0].variance);
    if (x[0] < least_share || position < rounding * samples.bounds.diagonal()) return {};
    // Both b and the change of normals include fine detail as well as noise, so the smaller estimate is taken.
    const double normal = std::sqrt(2.0 * x[1] * pairs[0].variance) / unit;
    return {position, std::min(normal, pairs[0].turn / turn_median)};
}

} // namespace hrbfnpr::fit
