// Samples of a closed surface with bumps, as many as wanted.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace bench {

struct Samples {
    std::vector<double> points; // packed x y z
    std::vector<double> normals;

    [[nodiscard]] std::int64_t count() const { return static_cast<std::int64_t>(points.size() / 3); }
    // The normal may be of any length.
    void add(const std::array<double, 3>& p, const std::array<double, 3>& n) {
        const double length = std::hypot(n[0], n[1], n[2]);
        for (std::size_t c = 0; c < 3; ++c) {
            points.push_back(p[c]);
            normals.push_back(n[c] / length);
        }
    }
};

// Fibonacci's spiral on the sphere, with radius 1 + bump sin 4x cos(3y + z).
[[nodiscard]] inline Samples bumpy(std::int64_t count, double bump) {
    Samples samples;
    for (std::int64_t i = 0; i < count; ++i) {
        const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(count);
        const double angle = std::fmod(2.399963229728653 * static_cast<double>(i), 6.283185307179586);
        const double flat = std::sqrt(1.0 - z * z);
        const std::array<double, 3> s{flat * std::cos(angle), flat * std::sin(angle), z};
        const double phase = 3.0 * s[1] + s[2];
        const double radius = 1.0 + bump * std::sin(4.0 * s[0]) * std::cos(phase);
        const std::array<double, 3> g{4.0 * bump * std::cos(4.0 * s[0]) * std::cos(phase),
                                      -3.0 * bump * std::sin(4.0 * s[0]) * std::sin(phase),
                                      -bump * std::sin(4.0 * s[0]) * std::sin(phase)};
        const double along = g[0] * s[0] + g[1] * s[1] + g[2] * s[2];
        std::array<double, 3> p{};
        std::array<double, 3> n{};
        for (std::size_t c = 0; c < 3; ++c) {
            p[c] = radius * s[c];
            n[c] = radius * s[c] - (g[c] - along * s[c]);
        }
        samples.add(p, n);
    }
    return samples;
}

} // namespace bench
