// SPDX-License-Identifier: MIT
// How even points on a surface are: the measures of docs/quality.md.
#pragma once

#include "vec3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <unordered_map>
#include <vector>

namespace bench {

struct Mark {
    Vec3 position;
    Vec3 normal;
};

// A grid of cells; visits the points of the 27 cells around a place.
class Grid {
public:
    Grid(const std::vector<Mark>& marks, std::size_t count, double side) : side_(side) {
        for (std::size_t i = 0; i < count; ++i) cells_[key(marks[i].position, {0, 0, 0})].push_back(i);
    }
    template <class Visit>
    void around(const Vec3& p, Visit&& visit) const {
        for (int i = -1; i <= 1; ++i)
            for (int j = -1; j <= 1; ++j)
                for (int k = -1; k <= 1; ++k)
                    if (const auto cell = cells_.find(key(p, {i, j, k})); cell != cells_.end())
                        for (const std::size_t mark : cell->second) visit(mark);
    }

private:
    [[nodiscard]] std::uint64_t key(const Vec3& p, const std::array<int, 3>& step) const {
        std::uint64_t key = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const auto number = static_cast<std::int64_t>(std::floor(p[c] / side_)) + step[c] + (1 << 20);
            key = key << 21U | (static_cast<std::uint64_t>(number) & 0x1fffffU);
        }
        return key;
    }

    double side_;
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
};

struct Evenness {
    double relative_radius = 0.0; // smallest distance to a nearest neighbour, in d
    double mean_nearest = 0.0;    // mean distance to nearest neighbours, in d
    double low_frequency = 0.0;   // power below a quarter of the sampling frequency; white noise: 1
};

// The piece of the surface whose marks are measured; marks outside it still count as neighbours.
struct Window {
    bool flat = false; // marks outside [-1, 1]^2 are not measured
    [[nodiscard]] bool holds(const Vec3& p, double margin) const {
        return !flat || (std::abs(p[0]) <= 1.0 - margin && std::abs(p[1]) <= 1.0 - margin);
    }
};

// Straight distances are valid on a small patch only, not over a crease or around a rim.
inline bool same_patch(const Mark& a, const Mark& b) { return dot(a.normal, b.normal) >= 0.5; }

// Measures the distances of the first `count` marks, in d = sqrt(2 / sqrt(3) area / n), the distance of the densest
// packing.
inline void measure_distances(const std::vector<Mark>& marks, std::size_t count, double density, const Window& window,
                              Evenness& result) {
    const double d = std::sqrt(2.0 / std::sqrt(3.0) / density);
    const Grid grid(marks, count, 2.0 * d);
    double smallest = std::numeric_limits<double>::infinity();
    double sum = 0.0;
    std::size_t looked_at = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (!window.holds(marks[i].position, 0.0)) continue;
        double nearest = 4.0 * d * d;
        grid.around(marks[i].position, [&](std::size_t other) {
            const Vec3 between = marks[other].position - marks[i].position;
            if (other != i && same_patch(marks[i], marks[other])) nearest = std::min(nearest, dot(between, between));
        });
        smallest = std::min(smallest, std::sqrt(nearest));
        sum += std::sqrt(nearest);
        ++looked_at;
    }
    result.relative_radius = smallest / d;
    result.mean_nearest = sum / static_cast<double>(looked_at) / d;
}

// Measures the variance of sum_i exp(-|x - p_i|^2 / 2 s^2) over places x of the surface, relative to that of
// independent marks, density pi s^2.  This weighs the power spectrum by exp(-4 pi^2 s^2 f^2), which falls to 1/e at f =
// sqrt(density) / 4 for s = 2 / (pi sqrt(density)).  The places are a regular subset of all marks, moved by half a
// spacing.
inline void measure_low_frequencies(const std::vector<Mark>& marks, std::size_t count, double density,
                                    const std::vector<Mark>& places, const Window& window, Evenness& result) {
    constexpr double pi = 3.14159265358979323846;
    const double sigma = 2.0 / (pi * std::sqrt(density));
    const double reach = 3.5 * sigma;
    const Grid grid(marks, count, reach);
    double sum = 0.0;
    double squares = 0.0;
    double number = 0.0;
    for (const Mark& place : places) {
        if (!window.holds(place.position, reach)) continue;
        double energy = 0.0;
        grid.around(place.position, [&](std::size_t other) {
            const Vec3 between = marks[other].position - place.position;
            if (dot(place.normal, marks[other].normal) >= 0.0)
                energy += std::exp(-dot(between, between) / (2.0 * sigma * sigma));
        });
        sum += energy;
        squares += energy * energy;
        number += 1.0;
    }
    if (number < 2.0) return;
    const double mean = sum / number;
    result.low_frequency = (squares / number - mean * mean) / (density * pi * sigma * sigma);
}

// Returns the periodogram of the marks in [-1, 1]^2 under Hann's window, averaged over frequencies from three periods
// per window to a quarter of the sampling frequency; white noise: 1.
inline double windowed_power(const std::vector<Mark>& marks, std::size_t count, double density) {
    constexpr double pi = 3.14159265358979323846;
    std::vector<std::array<double, 3>> inside; // x, y, weight
    double squares = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3& p = marks[i].position;
        if (std::abs(p[0]) > 1.0 || std::abs(p[1]) > 1.0) continue;
        const double weight = (0.5 + 0.5 * std::cos(pi * p[0])) * (0.5 + 0.5 * std::cos(pi * p[1]));
        inside.push_back({p[0], p[1], weight});
        squares += weight * weight;
    }
    const double highest = 0.25 * std::sqrt(density);
    const int steps = static_cast<int>(highest * 2.0); // the window is 2 wide, so a step is half a cycle per unit
    double sum = 0.0;
    int number = 0;
    const int skip = std::max(1, steps * steps / 1500);
    int counter = 0;
    for (int u = 0; u <= steps; ++u)
        for (int v = -steps; v <= steps; ++v) {
            const double f = 0.5 * std::hypot(u, v);
            if (f < 1.5 || f > highest || (u == 0 && v < 0) || counter++ % skip != 0) continue;
            double real = 0.0;
            double imaginary = 0.0;
            for (const auto& [x, y, weight] : inside) {
                const double phase = pi * (u * x + v * y);
                real += weight * std::cos(phase);
                imaginary += weight * std::sin(phase);
            }
            sum += (real * real + imaginary * imaginary) / squares;
            ++number;
        }
    return number > 0 ? sum / number : 0.0;
}

} // namespace bench
