// SPDX-License-Identifier: MIT
// The contours of exact shapes: in closed form, or from a fine mesh of the benchmark's own.
#pragma once

#include "exact_shapes.h"
#include "orbit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace bench {

// Lines in the image.
struct ImageLines {
    std::vector<glm::dvec2> node;
    std::vector<std::pair<std::size_t, std::size_t>> segment;

    void add_line(const std::vector<glm::dvec2>& line) {
        const std::size_t first = node.size();
        node.insert(node.end(), line.begin(), line.end());
        for (std::size_t i = first + 1; i < node.size(); ++i) segment.emplace_back(i - 1, i);
    }
};

// The lines of sight of a camera.
struct Sight {
    explicit Sight(const hrbfnpr_camera& camera)
        : lens(camera), orthographic(camera.projection[15] != 0.0),
          along(-glm::dvec3(lens.view[0][2], lens.view[1][2], lens.view[2][2])) {}
    // Returns a vector of any length along the line of sight to a place.
    [[nodiscard]] glm::dvec3 to(const glm::dvec3& p) const { return orthographic ? along : p - lens.eye; }

    Lens lens;
    bool orthographic;
    glm::dvec3 along;
};

class Contours {
public:
    Contours() = default;
    Contours(const Contours&) = delete;
    Contours& operator=(const Contours&) = delete;
    virtual ~Contours() = default;
    [[nodiscard]] virtual ImageLines of(const Sight& sight) const = 0;
};

// q = p / axes is on the unit sphere, where the contour is a circle about the direction to the eye.
class EllipsoidContours : public Contours {
public:
    explicit EllipsoidContours(const glm::dvec3& axes) : axes_(axes) {}
    [[nodiscard]] ImageLines of(const Sight& sight) const override {
        const glm::dvec3 to_eye = (sight.orthographic ? -sight.along : sight.lens.eye) / axes_;
        const double distance = glm::length(to_eye);
        const double height = sight.orthographic ? 0.0 : 1.0 / distance;
        const glm::dvec3 n = to_eye / distance;
        const glm::dvec3 a =
            glm::normalize(glm::cross(n, std::abs(n.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
        const glm::dvec3 b = glm::cross(n, a);
        const double radius = std::sqrt(1.0 - height * height);
        constexpr int pieces = 8192;
        std::vector<glm::dvec2> line;
        for (int i = 0; i <= pieces; ++i) {
            const double u = 2.0 * std::numbers::pi * i / pieces;
            const glm::dvec3 q = height * n + radius * (std::cos(u) * a + std::sin(u) * b);
            line.push_back(sight.lens.image_of(q * axes_));
        }
        ImageLines lines;
        lines.add_line(line);
        return lines;
    }

private:
    glm::dvec3 axes_;
};

// The contour of a tube around c(t): c + r u with the unit normal u satisfies u . (c - eye) + r = 0. For each t there
// are two solutions, on either side of the line of sight, or none if the eye looks along the tube.
template <class Curve>
class TubeContours : public Contours {
public:
    [[nodiscard]] ImageLines of(const Sight& sight) const override {
        ImageLines lines;
        std::vector<Place> places;
        constexpr int pieces = 4096;
        places.push_back(at(sight, 0.0));
        for (int i = 1; i <= pieces; ++i) refine(sight, at(sight, 2.0 * std::numbers::pi * i / pieces), places, 0);
        std::vector<glm::dvec2> side[2];
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Place& p = places[i];
            if (p.is) {
                for (std::size_t s = 0; s < 2; ++s) side[s].push_back(p.image[s]);
                // The two sides meet where the contour ends.
                const bool begins = i > 0 && !places[i - 1].is;
                if (begins) lines.add_line({p.image[0], p.image[1]});
            }
            const bool ends = !p.is || i + 1 == places.size();
            if (!ends || side[0].empty()) continue;
            for (std::vector<glm::dvec2>& line : side) lines.add_line(line);
            if (!p.is) lines.add_line({side[0].back(), side[1].back()});
            for (std::vector<glm::dvec2>& line : side) line.clear();
        }
        return lines;
    }

private:
    struct Place {
        double t;
        bool is;
        glm::dvec2 image[2];
    };
    [[nodiscard]] static Place at(const Sight& sight, double t) {
        const glm::dvec3 c = Curve::at(t);
        const glm::dvec3 along = glm::normalize(Curve::first(t));
        const glm::dvec3 d = sight.to(c);
        const glm::dvec3 across = d - glm::dot(d, along) * along;
        const double length = glm::length(across);
        const double cosine = sight.orthographic ? 0.0 : -Curve::radius / length;
        Place place{t, cosine > -1.0, {}};
        if (!place.is) return place;
        const glm::dvec3 m = across / length;
        const glm::dvec3 b = glm::cross(along, m);
        const double sine = std::sqrt(1.0 - cosine * cosine);
        for (int s = 0; s < 2; ++s)
            place.image[s] = sight.lens.image_of(c + Curve::radius * (cosine * m + (s == 0 ? sine : -sine) * b));
        return place;
    }
    // Adds places from the last one up to `to`, at most half a pixel apart in the image.
    static void refine(const Sight& sight, const Place& to, std::vector<Place>& places, int depth) {
        const Place& from = places.back();
        const bool near = from.is == to.is && (!to.is || (glm::distance(from.image[0], to.image[0]) < 0.5 &&
                                                          glm::distance(from.image[1], to.image[1]) < 0.5));
        if (!near && depth < 40) {
            refine(sight, at(sight, 0.5 * (from.t + to.t)), places, depth + 1);
            refine(sight, to, places, depth + 1);
            return;
        }
        places.push_back(to);
    }
};

// The contour of any shape. The zero level is cut by the tetrahedra of a fine lattice; on the resulting triangles,
// zeros of n . sight are found and then moved onto both zero sets.
class MeshContours : public Contours {
public:
    MeshContours(const Shape& shape, int cells) : shape_(shape), cells_(cells) { triangulate(); }

    [[nodiscard]] ImageLines of(const Sight& sight) const override {
        std::vector<double> facing(vertex_.size());
        for (std::size_t v = 0; v < vertex_.size(); ++v) facing[v] = glm::dot(gradient_[v], sight.to(vertex_[v]));
        ImageLines lines;
        std::unordered_map<std::uint64_t, std::size_t> nodes;
        const auto node = [&](std::size_t a, std::size_t b) {
            if (a > b) std::swap(a, b);
            const auto [found, is_new] = nodes.try_emplace(std::uint64_t{a} << 32 | b, lines.node.size());
            if (is_new) {
                const double share = facing[a] / (facing[a] - facing[b]);
                lines.node.push_back(sight.lens.image_of(settled(sight, glm::mix(vertex_[a], vertex_[b], share))));
            }
            return found->second;
        };
        for (const std::array<std::size_t, 3>& t : triangle_)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t a = t[k];
                const std::size_t b = t[(k + 1) % 3];
                const std::size_t c = t[(k + 2) % 3];
                if ((facing[a] < 0.0) == (facing[b] < 0.0) || (facing[a] < 0.0) == (facing[c] < 0.0)) continue;
                const std::size_t from = node(a, b);
                const std::size_t to = node(a, c);
                lines.segment.emplace_back(from, to);
            }
        return lines;
    }

private:
    // Takes Newton steps of least length to f = 0 and n . sight = 0.
    [[nodiscard]] glm::dvec3 settled(const Sight& sight, glm::dvec3 p) const {
        for (int step = 0; step < 6; ++step) {
            const Jet f = shape_.at(p);
            const glm::dvec3 v = sight.to(p);
            const std::array<double, 6>& h = f.hessian;
            const glm::dmat3 hessian(h[0], h[1], h[2], h[1], h[3], h[4], h[2], h[4], h[5]);
            const glm::dvec3 a = f.gradient;
            const glm::dvec3 b = hessian * v + (sight.orthographic ? glm::dvec3(0.0) : a);
            const double aa = glm::dot(a, a);
            const double ab = glm::dot(a, b);
            const double bb = glm::dot(b, b);
            const double det = aa * bb - ab * ab;
            if (!(det > 1e-18 * aa * bb)) break;
            const double g = glm::dot(a, v);
            glm::dvec3 move = ((f.value * bb - g * ab) * a + (g * aa - f.value * ab) * b) / det;
            const double most = step_;
            if (glm::length(move) > most) move *= most / glm::length(move);
            p -= move;
        }
        return p;
    }
    [[nodiscard]] std::size_t vertex_on(std::uint64_t a, std::uint64_t b) {
        const auto [found, is_new] = on_edge_.try_emplace(a * 0x100000000ULL + b, vertex_.size());
        if (is_new) {
            const double share = value_[a] / (value_[a] - value_[b]);
            glm::dvec3 p = glm::mix(place(a), place(b), share);
            Jet f = shape_.at(p);
            p -= f.value / glm::dot(f.gradient, f.gradient) * f.gradient;
            f = shape_.at(p);
            vertex_.push_back(p);
            gradient_.push_back(f.gradient);
        }
        return found->second;
    }
    [[nodiscard]] glm::dvec3 place(std::uint64_t i) const {
        const auto n = static_cast<std::uint64_t>(cells_ + 1);
        const glm::dvec3 at(static_cast<double>(i % n), static_cast<double>(i / n % n), static_cast<double>(i / n / n));
        return box_ * (2.0 * at / static_cast<double>(cells_) - 1.0);
    }
    void cut(const std::array<std::uint64_t, 4>& corner) {
        std::vector<std::size_t> on;
        std::array<std::uint64_t, 4> in{};
        std::size_t inside = 0;
        std::size_t outside = 4;
        for (const std::uint64_t c : corner) in[value_[c] < 0.0 ? inside++ : --outside] = c;
        if (inside == 0 || inside == 4) return;
        for (std::size_t i = 0; i < inside; ++i)
            for (std::size_t k = 0; k < 4 - inside; ++k) {
                // With two corners on each side, go around the quadrilateral.
                const std::size_t o = inside + (inside == 2 && i == 1 ? 1 - k : k);
                on.push_back(vertex_on(std::min(in[i], in[o]), std::max(in[i], in[o])));
            }
        triangle_.push_back({on[0], on[1], on[2]});
        if (on.size() == 4) triangle_.push_back({on[0], on[2], on[3]});
    }
    void triangulate() {
        const auto n = static_cast<std::uint64_t>(cells_ + 1);
        step_ = 4.0 * std::max({box_.x, box_.y, box_.z}) / cells_;
        value_.resize(n * n * n);
        for (std::uint64_t i = 0; i < value_.size(); ++i) value_[i] = shape_.at(place(i)).value;
        constexpr std::array<std::array<int, 3>, 6> orders{
            {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
        const std::array<std::uint64_t, 3> stride{1, n, n * n};
        for (std::uint64_t z = 0; z + 1 < n; ++z)
            for (std::uint64_t y = 0; y + 1 < n; ++y)
                for (std::uint64_t x = 0; x + 1 < n; ++x)
                    for (const std::array<int, 3>& order : orders) {
                        std::array<std::uint64_t, 4> corner{x + n * (y + n * z)};
                        for (std::size_t k = 0; k < 3; ++k)
                            corner[k + 1] = corner[k] + stride[static_cast<std::size_t>(order[k])];
                        cut(corner);
                    }
        on_edge_.clear();
        value_.clear();
    }

    const Shape& shape_;
    int cells_;
    glm::dvec3 box_ = 1.03 * shape_.half;
    double step_ = 0.0;
    std::vector<double> value_;
    std::unordered_map<std::uint64_t, std::size_t> on_edge_;
    std::vector<glm::dvec3> vertex_, gradient_;
    std::vector<std::array<std::size_t, 3>> triangle_;
};

} // namespace bench
