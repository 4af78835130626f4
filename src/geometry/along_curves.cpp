// SPDX-License-Identifier: MIT
#include "geometry/along_curves.h"

#include "geometry/cell_grid.h"

#include <algorithm>
#include <array>
#include <span>

namespace hrbfnpr::geometry {
namespace {

constexpr std::int64_t most_asked = 256;
constexpr std::int64_t fewest = 16; // fewer points than this are never said to lie along curves
constexpr std::int64_t thinner = 4;
constexpr std::int64_t fewest_thinned = 256;
constexpr std::int64_t most_thinned = 200000;
// A test of a point's nearest neighbours. A point passes if its neighbours deviate from a line by less than `across`
// times their extent along it. Points lie along curves if more than `share` of them pass. Tests with more neighbours
// tolerate more noise. For points all over a surface, the shares that pass the three tests are at most 0.12, 0.00 and
// 0.00 (0.12 on the layers of a scan, else at most 0.03). For wires and sections with noise of 0.001 diagonals, at
// least one share exceeds its limit.
struct LineTest {
    std::size_t neighbours;
    double across;
    double share;
};
constexpr std::array<LineTest, 3> line_tests{{{4, 0.2, 0.2}, {12, 0.25, 0.07}, {24, 0.25, 0.07}}};
constexpr std::size_t most = line_tests.back().neighbours;

// Tests the offsets of a point's neighbours. Power iterations find the line with the largest sum of squares.
bool lie_on_line(std::span<const glm::dvec3> offsets, double across) noexcept {
    double all = 0.0;
    for (const glm::dvec3& offset : offsets) all += glm::dot(offset, offset);
    glm::dvec3 line = offsets.back();
    double along = 0.0;
    for (int round = 0; round < 8; ++round) {
        glm::dvec3 next(0.0);
        for (const glm::dvec3& offset : offsets) next += glm::dot(offset, line) * offset;
        line = glm::normalize(next);
    }
    for (const glm::dvec3& offset : offsets) {
        const double component = glm::dot(offset, line);
        along += component * component;
    }
    return all - along < across * across * along;
}

// Applies each test to one point, and counts the tests that it passes. Points that coincide with it are ignored.
void apply_line_tests(const PointTree& tree, std::int64_t at,
                      std::array<std::int64_t, line_tests.size()>& on_lines) noexcept {
    constexpr std::size_t asked = most + 8;
    const glm::dvec3 p = tree.points()[at];
    std::array<std::int64_t, asked> found;
    const auto any = [](std::int64_t /*at*/) { return true; };
    const auto there = static_cast<std::size_t>(tree.nearest(p, asked, any, any, found.data()));
    std::array<glm::dvec3, most> offsets;
    std::size_t count = 0;
    for (std::size_t k = 0; k < there && count < most; ++k) {
        const glm::dvec3 offset = tree.points()[found[k]] - p;
        if (glm::dot(offset, offset) > 0.0) offsets[count++] = offset;
    }
    if (count == 0) return;
    const double unit = glm::length(offsets[count - 1]);
    for (std::size_t k = 0; k < count; ++k) offsets[k] /= unit;
    for (std::size_t k = 0; k < line_tests.size(); ++k)
        if (count >= line_tests[k].neighbours &&
            lie_on_line({offsets.data(), line_tests[k].neighbours}, line_tests[k].across))
            ++on_lines[k];
}

bool lie_on_lines(const PointTree& tree) noexcept {
    if (tree.size() < fewest) return false;
    const std::int64_t asked = std::min(tree.size(), most_asked);
    std::array<std::int64_t, line_tests.size()> on_lines{};
    for (std::int64_t k = 0; k < asked; ++k) apply_line_tests(tree, k * tree.size() / asked, on_lines);
    for (std::size_t k = 0; k < line_tests.size(); ++k)
        if (static_cast<double>(on_lines[k]) > line_tests[k].share * static_cast<double>(asked)) return true;
    return false;
}

} // namespace

// Tests all points, and then thinned subsets of them, because noise matters less where points are farther apart. The
// points of a subset are picked at random: every fourth point of a grid would lie along lines.
bool lie_along_curves(const PointTree& tree) {
    if (lie_on_lines(tree)) return true;
    if (tree.size() > most_thinned) return false;
    for (std::int64_t step = thinner; tree.size() / step >= fewest_thinned; step *= thinner) {
        VecArray some(tree.points().memory());
        for (std::int64_t at = 0; at < tree.size(); ++at)
            if (hash_bits(static_cast<std::uint64_t>(at)) % static_cast<std::uint64_t>(step) == 0)
                some.push_back(tree.points()[at]);
        if (lie_on_lines(PointTree(some, {}))) return true;
    }
    return false;
}

} // namespace hrbfnpr::geometry
