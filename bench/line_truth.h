// SPDX-License-Identifier: MIT
// Drawn lines against known lines: how much of each lies within a pixel of the other.
#pragma once

#include "exact_contours.h"
#include "line_calls.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <string>
#include <unordered_map>
#include <vector>

namespace bench {

// Distances to lines in the image, up to a reach.
class NearLines {
public:
    static constexpr double reach = 4.0;

    explicit NearLines(const ImageLines& lines) : lines_(lines) {
        for (std::size_t s = 0; s < lines.segment.size(); ++s) {
            const auto [a, b] = lines.segment[s];
            const glm::dvec2 low = glm::min(lines.node[a], lines.node[b]) - reach;
            const glm::dvec2 high = glm::max(lines.node[a], lines.node[b]) + reach;
            for (std::int64_t y = cell(low.y); y <= cell(high.y); ++y)
                for (std::int64_t x = cell(low.x); x <= cell(high.x); ++x) of_cell_[key(x, y)].push_back(s);
        }
    }
    [[nodiscard]] double distance(const glm::dvec2& p) const {
        const auto found = of_cell_.find(key(cell(p.x), cell(p.y)));
        double nearest = reach;
        if (found == of_cell_.end()) return nearest;
        for (const std::size_t s : found->second) {
            const auto [a, b] = lines_.segment[s];
            nearest = std::min(nearest, to_segment(p, lines_.node[a], lines_.node[b]));
        }
        return nearest;
    }

private:
    static constexpr double side = 8.0;
    [[nodiscard]] static std::int64_t cell(double x) { return static_cast<std::int64_t>(std::floor(x / side)); }
    [[nodiscard]] static std::int64_t key(std::int64_t x, std::int64_t y) { return x * 1'000'003 + y; }
    [[nodiscard]] static double to_segment(const glm::dvec2& p, const glm::dvec2& from, const glm::dvec2& to) {
        const glm::dvec2 along = to - from;
        const double squared = glm::dot(along, along);
        const double share = squared > 0.0 ? std::clamp(glm::dot(p - from, along) / squared, 0.0, 1.0) : 0.0;
        return glm::distance(p, from + share * along);
    }

    const ImageLines& lines_;
    std::unordered_map<std::int64_t, std::vector<std::size_t>> of_cell_;
};

// How much of some lines is near other lines.
struct Nearness {
    double length = 0.0;  // pixels
    double near = 0.0;    // pixels within a pixel of the others
    double moment = 0.0;  // distance times length
    double longest = 0.0; // the longest connected piece that is farther away

    void add(const Nearness& other) {
        length += other.length;
        near += other.near;
        moment += other.moment;
        longest = std::max(longest, other.longest);
    }
};

// The lengths of connected pieces, by their nodes.
class Joined {
public:
    explicit Joined(std::size_t nodes) : up_(nodes), length_(nodes, 0.0) { std::iota(up_.begin(), up_.end(), 0); }
    void join(std::size_t a, std::size_t b, double length) {
        a = root(a);
        b = root(b);
        length_[a] += length;
        if (a == b) return;
        up_[b] = a;
        length_[a] += length_[b];
    }
    [[nodiscard]] double longest() const {
        return length_.empty() ? 0.0 : *std::max_element(length_.begin(), length_.end());
    }

private:
    [[nodiscard]] std::size_t root(std::size_t a) {
        while (up_[a] != a) a = up_[a] = up_[up_[a]];
        return a;
    }
    std::vector<std::size_t> up_;
    std::vector<double> length_;
};

[[nodiscard]] inline Nearness nearness(const ImageLines& lines, const ImageLines& others) {
    const NearLines near(others);
    Nearness found;
    Joined far(lines.node.size());
    for (const auto& [a, b] : lines.segment) {
        const double length = glm::distance(lines.node[a], lines.node[b]);
        const int pieces = std::max(1, static_cast<int>(std::ceil(length / 0.5)));
        double beyond = 0.0;
        for (int i = 0; i < pieces; ++i) {
            const double distance = near.distance(glm::mix(lines.node[a], lines.node[b], (i + 0.5) / pieces));
            found.moment += length / pieces * distance;
            (distance <= 1.0 ? found.near : beyond) += length / pieces;
        }
        found.length += length;
        if (beyond > 0.0) far.join(a, b, beyond);
    }
    found.longest = far.longest();
    return found;
}

[[nodiscard]] inline ImageLines image_lines(const std::vector<Polyline>& polylines) {
    ImageLines lines;
    for (const Polyline& polyline : polylines) {
        std::vector<glm::dvec2> line;
        for (const glm::dvec3& p : polyline.window) line.emplace_back(p);
        lines.add_line(line);
    }
    return lines;
}

// A shape and its contours.
struct Exact {
    std::string name;
    std::unique_ptr<Shape> shape;
    std::unique_ptr<Contours> contours;
};

[[nodiscard]] inline std::vector<Exact> exact_shapes() {
    std::vector<Exact> shapes;
    const auto add = [&](const char* name, std::unique_ptr<Shape> shape, std::unique_ptr<Contours> contours) {
        shapes.push_back({name, std::move(shape), std::move(contours)});
    };
    const glm::dvec3 axes(1.0, 0.6, 0.35);
    add("sphere", std::make_unique<Ellipsoid>(glm::dvec3(1.0)), std::make_unique<EllipsoidContours>(glm::dvec3(1.0)));
    add("ellipsoid", std::make_unique<Ellipsoid>(axes), std::make_unique<EllipsoidContours>(axes));
    add("torus", std::make_unique<Tube<Ring>>(), std::make_unique<TubeContours<Ring>>());
    add("trefoil tube", std::make_unique<Tube<Trefoil>>(), std::make_unique<TubeContours<Trefoil>>());
    auto holes = std::make_unique<TwoHoles>();
    auto contours = std::make_unique<MeshContours>(*holes, 160);
    add("genus 2", std::move(holes), std::move(contours));
    return shapes;
}

} // namespace bench
