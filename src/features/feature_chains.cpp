// SPDX-License-Identifier: MIT
#include "features/feature_chains.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hrbfnpr::curves {
namespace {

constexpr std::int64_t triangles_a_task = 8192;

// A root in [0, 1] of the cubic with these values and slopes at 0 and 1; the values have unlike signs.
double cubic_root(double at_0, double at_1, double slope_0, double slope_1, double start) noexcept {
    const double c2 = 3.0 * (at_1 - at_0) - 2.0 * slope_0 - slope_1;
    const double c3 = slope_0 + slope_1 - 2.0 * (at_1 - at_0);
    double low = 0.0;
    double high = 1.0;
    double s = start;
    for (int step = 0; step < 8; ++step) {
        const double g = at_0 + s * (slope_0 + s * (c2 + s * c3));
        ((g < 0.0) == (at_0 < 0.0) ? low : high) = s;
        const double newton = s - g / (slope_0 + s * (2.0 * c2 + s * 3.0 * c3));
        s = newton > low && newton < high ? newton : 0.5 * (low + high);
    }
    return s;
}

class Edges {
public:
    Edges(const SurfaceMesh& mesh, const base::Array<FeatureValue>& value, bool directed, double least) noexcept
        : mesh_(mesh), value_(value), directed_(directed), least_(least) {}

    [[nodiscard]] std::int32_t corner(std::int64_t triangle, int k) const noexcept {
        return mesh_.corner[3 * triangle + k % 3];
    }
    // Of an edge both triangles say the same.
    [[nodiscard]] bool changes_sign(std::int32_t a, std::int32_t b) const noexcept {
        return negative(a) != (negative(b) != turned(a, b));
    }
    [[nodiscard]] FeatureCrossing crossing(std::int64_t triangle, int k) const noexcept {
        const auto [a, b] = std::minmax({corner(triangle, k), corner(triangle, k + 1)});
        const double g_a = value_[a].g;
        const double g_b = turned(a, b) ? -value_[b].g : value_[b].g;
        const double s = root(a, b, g_a, g_b);
        const double strength = (1.0 - s) * value_[a].strength + s * value_[b].strength;
        const double facing = (1.0 - s) * value_[a].facing + s * value_[b].facing;
        // At a contour an apparent ridge's g has a pole, not a root.
        const bool seen = facing >= 0.0 && (!directed_ || (value_[a].facing >= 0.0 && value_[b].facing >= 0.0));
        return {a, b, s, g_a, g_b, strength, strength > 0.0 && strength >= least_ && seen, 0.0};
    }
    // The two edges that a line through the triangle crosses, as bits 1, 2, 4; 0: there is no line.
    [[nodiscard]] std::uint8_t crossed(std::int64_t triangle) const noexcept {
        unsigned bits = 0;
        int count = 0;
        bool counts = false;
        for (int k = 0; k < 3; ++k) {
            if (!changes_sign(corner(triangle, k), corner(triangle, k + 1))) continue;
            bits |= 1U << static_cast<unsigned>(k);
            ++count;
            counts = counts || crossing(triangle, k).counts;
        }
        return count == 2 && counts ? static_cast<std::uint8_t>(bits) : std::uint8_t{0};
    }
    // Whether a walk over this edge goes out of the triangle with what is negative to the left.
    [[nodiscard]] bool leaves(std::int64_t triangle, int k) const noexcept { return !negative(corner(triangle, k)); }
    [[nodiscard]] std::int64_t across(std::int64_t triangle, int k) const noexcept {
        return mesh_.neighbour[3 * triangle + k];
    }

    // Of the linear g along the mean direction, times twice the area.
    [[nodiscard]] double slope(std::int64_t triangle) const noexcept {
        if (!directed_) return 0.0;
        const std::int32_t a = corner(triangle, 0);
        const std::int32_t b = corner(triangle, 1);
        const std::int32_t c = corner(triangle, 2);
        const double b_sign = turned(a, b) ? -1.0 : 1.0;
        const double c_sign = turned(a, c) ? -1.0 : 1.0;
        const glm::dvec3 along = value_[a].along + b_sign * value_[b].along + c_sign * value_[c].along;
        const glm::dvec3 ab = mesh_.position[b] - mesh_.position[a];
        const glm::dvec3 ac = mesh_.position[c] - mesh_.position[a];
        const double to_b = b_sign * value_[b].g - value_[a].g;
        const double to_c = c_sign * value_[c].g - value_[a].g;
        const double bb = glm::dot(ab, ab);
        const double bc = glm::dot(ab, ac);
        const double cc = glm::dot(ac, ac);
        const double area = std::sqrt(bb * cc - bc * bc);
        const double sum =
            (cc * to_b - bc * to_c) * glm::dot(ab, along) + (bb * to_c - bc * to_b) * glm::dot(ac, along);
        return area > 0.0 ? sum / area : 0.0;
    }

private:
    [[nodiscard]] bool negative(std::int32_t vertex) const noexcept { return value_[vertex].g < 0.0; }
    [[nodiscard]] bool turned(std::int32_t a, std::int32_t b) const noexcept {
        return directed_ && glm::dot(value_[a].along, value_[b].along) < 0.0;
    }

    // Where between a and b; by a cubic where gradients are known.
    [[nodiscard]] double root(std::int32_t a, std::int32_t b, double g_a, double g_b) const noexcept {
        const double linear = g_a / (g_a - g_b);
        if (!(linear >= 0.0 && linear <= 1.0)) return 0.5;
        if (directed_) return linear;
        const glm::dvec3 edge = mesh_.position[b] - mesh_.position[a];
        const double slope_a = glm::dot(value_[a].gradient, edge);
        const double slope_b = glm::dot(value_[b].gradient, edge);
        return slope_a != 0.0 || slope_b != 0.0 ? cubic_root(g_a, g_b, slope_a, slope_b, linear) : linear;
    }

    const SurfaceMesh& mesh_;
    const base::Array<FeatureValue>& value_;
    bool directed_;
    double least_;
};

// Walks from triangle to triangle, each of which is crossed once.
class ChainWalker {
public:
    ChainWalker(base::Memory& memory, const Edges& edges, base::Array<std::uint8_t>& crossed, bool directed)
        : edges_(edges), crossed_(crossed), directed_(directed), chains_(memory) {
        chains_.first.push_back(0);
    }

    // A chain that ends at one of the triangle's edges.
    void open(std::int64_t triangle) {
        for (int k = 0; k < 3; ++k) {
            if (!has(triangle, k)) continue;
            const std::int64_t before = edges_.across(triangle, k);
            if (before >= 0 && crossed_[before] != 0) continue;
            const bool backwards = !directed_ && edges_.leaves(triangle, k);
            chains_.crossing.push_back(edges_.crossing(triangle, k));
            walk(triangle, k);
            close(false, backwards);
            return;
        }
    }
    void loop(std::int64_t triangle) {
        if (crossed_[triangle] == 0) return;
        int k = 0;
        while (!has(triangle, k)) ++k;
        const bool backwards = !directed_ && edges_.leaves(triangle, k);
        walk(triangle, k);
        close(true, backwards);
    }
    [[nodiscard]] FeatureChains result() && { return std::move(chains_); }

private:
    [[nodiscard]] bool has(std::int64_t triangle, int k) const noexcept {
        return (crossed_[triangle] & (1U << static_cast<unsigned>(k))) != 0;
    }
    // From its edge `entry` on, to the end or back to the beginning; what is passed is crossed no more.
    void walk(std::int64_t triangle, int entry) {
        while (triangle >= 0 && crossed_[triangle] != 0) {
            int exit = (entry + 1) % 3;
            if (!has(triangle, exit)) exit = (entry + 2) % 3;
            crossed_[triangle] = 0;
            const double slope = edges_.slope(triangle);
            if (chains_.crossing.size() > chains_.first.back())
                chains_.crossing.back().slope += slope;
            else
                first_slope_ = slope;
            chains_.crossing.push_back(edges_.crossing(triangle, exit));
            chains_.crossing.back().slope = slope;
            const std::int64_t next = edges_.across(triangle, exit);
            for (entry = 0; next >= 0 && edges_.across(next, entry) != triangle;) ++entry;
            triangle = next;
        }
    }
    void close(bool closed, bool backwards) {
        if (closed) chains_.crossing.back().slope += first_slope_;
        if (backwards) std::reverse(chains_.crossing.data() + chains_.first.back(), chains_.crossing.end());
        chains_.first.push_back(chains_.crossing.size());
        chains_.closed.push_back(closed ? 1 : 0);
    }

    const Edges& edges_;
    base::Array<std::uint8_t>& crossed_;
    bool directed_;
    FeatureChains chains_;
    double first_slope_ = 0.0; // of a loop's first triangle, whose entry stands last
};

} // namespace

FeatureChains find_feature_chains(const base::Runtime& runtime, const SurfaceMesh& mesh,
                                  const base::Array<FeatureValue>& value, bool directed, double least,
                                  const base::Progress& progress) {
    const Edges edges(mesh, value, directed, least);
    base::Array<std::uint8_t> crossed(runtime.memory);
    crossed.resize_for_overwrite(mesh.triangles());
    runtime.parallel.for_chunks(mesh.triangles(), triangles_a_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t t = begin; t < end; ++t) crossed[t] = edges.crossed(t);
    });
    ChainWalker walker(runtime.memory, edges, crossed, directed);
    for (std::int64_t t = 0; t < mesh.triangles(); ++t)
        if (crossed[t] != 0) walker.open(t);
    for (std::int64_t t = 0; t < mesh.triangles(); ++t) walker.loop(t);
    return std::move(walker).result();
}

FeatureChains keep_extrema(const FeatureChains& chains, double sign) {
    FeatureChains kept(chains.first.memory());
    kept.first.push_back(0);
    for (std::int64_t c = 0; c < chains.chains(); ++c) {
        const std::int64_t first = chains.first[c];
        const std::int64_t count = chains.first[c + 1] - first;
        const bool closed = chains.closed[c] != 0;
        const auto is_one = [&](std::int64_t i) {
            double sum = 0.0;
            for (std::int64_t k = i - 2; k <= i + 2; ++k)
                if (closed || (k >= 0 && k < count)) sum += chains.crossing[first + (k + 2 * count) % count].slope;
            return sign * sum > 0.0;
        };
        for_parts(count, closed, is_one, [&](std::int64_t begin, std::int64_t end, bool whole) {
            for (std::int64_t i = begin; i < end; ++i) kept.crossing.push_back(chains.crossing[first + i % count]);
            kept.first.push_back(kept.crossing.size());
            kept.closed.push_back(whole ? 1 : 0);
        });
    }
    return kept;
}

} // namespace hrbfnpr::curves
