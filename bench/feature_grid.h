// SPDX-License-Identifier: MIT
// A dense reference for feature lines: rays through a fine grid of the image, the function that vanishes along a line
// at their hits, and where it changes sign from one hit to the next.
#pragma once

#include "line_calls.h"
#include "line_truth.h"
#include "plain_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace bench {

// Curvatures at one place.  II = -Hess f / |grad f|; k1 >= k2; change(u, v, w) is the derivative of II(u, v) along w,
// with u and v kept in the surface.
struct PlaceShape {
    glm::dvec3 n{0.0}, d1{0.0}, d2{0.0};
    double k1 = 0.0, k2 = 0.0;
    glm::dmat3 hessian{0.0}; // divided by |grad f|
    std::array<double, 10> third{};

    PlaceShape() = default;
    PlaceShape(const glm::dvec3& gradient, const Derivatives& d) {
        const double slope = glm::length(gradient);
        n = gradient / slope;
        const std::array<double, 6>& h = d.second;
        hessian = glm::dmat3(h[0], h[1], h[2], h[1], h[3], h[4], h[2], h[4], h[5]) / slope;
        for (std::size_t c = 0; c < third.size(); ++c) third[c] = d.third[c] / slope;
        const glm::dvec3 a =
            glm::normalize(glm::cross(n, std::abs(n.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
        const glm::dvec3 b = glm::cross(n, a);
        const double aa = bend(a, a);
        const double ab = bend(a, b);
        const double bb = bend(b, b);
        const double angle = 0.5 * std::atan2(2.0 * ab, aa - bb);
        d1 = std::cos(angle) * a + std::sin(angle) * b;
        d2 = glm::cross(n, d1);
        k1 = bend(d1, d1);
        k2 = bend(d2, d2);
    }
    [[nodiscard]] double bend(const glm::dvec3& u, const glm::dvec3& v) const { return -glm::dot(u, hessian * v); }
    [[nodiscard]] double change(const glm::dvec3& u, const glm::dvec3& v, const glm::dvec3& w) const {
        const std::array<double, 10>& t = third;
        const auto along = [&](const glm::dvec3& x) { // T(x, ., .)
            return glm::dmat3(t[0] * x.x + t[1] * x.y + t[2] * x.z, t[1] * x.x + t[3] * x.y + t[4] * x.z,
                              t[2] * x.x + t[4] * x.y + t[5] * x.z, t[1] * x.x + t[3] * x.y + t[4] * x.z,
                              t[3] * x.x + t[6] * x.y + t[7] * x.z, t[4] * x.x + t[7] * x.y + t[8] * x.z,
                              t[2] * x.x + t[4] * x.y + t[5] * x.z, t[4] * x.x + t[7] * x.y + t[8] * x.z,
                              t[5] * x.x + t[8] * x.y + t[9] * x.z);
        };
        return -glm::dot(u, along(w) * v) + bend(u, w) * bend(n, v) + bend(v, w) * bend(n, u) + bend(u, v) * bend(n, w);
    }
};

// The function g whose zero level is a line of some kind, at one place.
struct PlaceValue {
    double g = 1.0;
    double strength = -1.0;
    glm::dvec3 along{0.0}; // the direction whose reversal changes the sign of g; else 0
};

struct FeatureAsked {
    std::uint32_t kind = 0;
    const char* name = "";
    double lower = 0.0, upper = 0.0;
    double level = 0.0;
    glm::dvec3 plane{0.0, 0.0, 1.0};
    [[nodiscard]] bool is_crest() const { return kind == HRBFNPR_LINE_KIND_RIDGE || kind == HRBFNPR_LINE_KIND_VALLEY; }
};

// q1^2, the square of the view-dependent curvature [Judd et al. 2007], and its direction on the surface.
struct ViewCurvature {
    double q2 = 0.0;
    glm::dvec3 x{0.0}, s{0.0};

    ViewCurvature(const PlaceShape& p, const glm::dvec3& v) {
        const double facing = glm::dot(p.n, v);
        const glm::dvec2 m = glm::dvec2(glm::dot(v, p.d1), glm::dot(v, p.d2)) / facing;
        // Q = II P^-1, P^-1 P^-T = I + m m^T.
        const double aa = p.k1 * p.k1 * (1.0 + m.x * m.x);
        const double ab = p.k1 * p.k2 * m.x * m.y;
        const double bb = p.k2 * p.k2 * (1.0 + m.y * m.y);
        const double angle = 0.5 * std::atan2(2.0 * ab, aa - bb);
        const glm::dvec2 e(std::cos(angle), std::sin(angle));
        q2 = aa * e.x * e.x + 2.0 * ab * e.x * e.y + bb * e.y * e.y;
        const glm::dvec2 y(p.k1 * e.x, p.k2 * e.y);
        const glm::dvec2 t = y + glm::dot(m, y) * m;
        x = e.x * p.d1 + e.y * p.d2;
        s = (t.x * p.d1 + t.y * p.d2) / glm::length(t);
    }
};

// `v`: unit, to the eye or the light; `nearness`: 1 / distance.
[[nodiscard]] inline PlaceValue place_value(const FeatureAsked& asked, const PlaceShape& p, const glm::dvec3& place,
                                            const glm::dvec3& v, double nearness, double unit) {
    PlaceValue value;
    const double facing = glm::dot(p.n, v);
    const glm::dvec3 w = v - facing * p.n; // along the surface, w changes by facing II - nearness (1 - w w^T)
    switch (asked.kind) {
    case HRBFNPR_LINE_KIND_SUGGESTIVE_CONTOUR: {
        // B(w, w) with B = -II, and its derivative along w where B(w, w) is 0.
        value.g = -p.bend(w, w);
        const double b1 = p.bend(w, p.d1);
        const double b2 = p.bend(w, p.d2);
        value.strength = (-p.change(w, w, w) - 2.0 * facing * (b1 * b1 + b2 * b2)) / glm::dot(w, w) * unit * unit;
        break;
    }
    case HRBFNPR_LINE_KIND_RIDGE: value = {p.change(p.d2, p.d2, p.d2), (-p.k2 - std::abs(p.k1)) * unit, p.d2}; break;
    case HRBFNPR_LINE_KIND_VALLEY: value = {p.change(p.d1, p.d1, p.d1), (p.k1 - std::abs(p.k2)) * unit, p.d1}; break;
    case HRBFNPR_LINE_KIND_APPARENT_RIDGE: {
        const ViewCurvature q(p, v);
        // The derivative along s of x^T II M II x with M = I + w w^T / facing^2, with x kept.
        const auto bend = [&](const glm::dvec3& u) { return p.bend(u, p.d1) * p.d1 + p.bend(u, p.d2) * p.d2; };
        const glm::dvec3 y = bend(q.x);
        const glm::dvec3 dy = p.change(q.x, p.d1, q.s) * p.d1 + p.change(q.x, p.d2, q.s) * p.d2;
        const glm::dvec3 dw = facing * bend(q.s) - nearness * (q.s - glm::dot(w, q.s) * w);
        const double df = nearness * facing * glm::dot(w, q.s) - p.bend(w, q.s);
        const double wy = glm::dot(w, y) / facing;
        const double dwy = (glm::dot(dw, y) + glm::dot(w, dy)) / facing - wy * df / facing;
        value.g = (2.0 * glm::dot(y, dy) + 2.0 * wy * dwy) * std::abs(facing * facing * facing);
        value.strength = std::sqrt(q.q2) * unit;
        value.along = q.s;
        break;
    }
    case HRBFNPR_LINE_KIND_PARABOLIC: value = {p.k1 * p.k2 * unit * unit, 1.0, glm::dvec3(0.0)}; break;
    case HRBFNPR_LINE_KIND_ISOPHOTE: value = {facing - asked.level, 1.0, glm::dvec3(0.0)}; break;
    default: value = {glm::dot(asked.plane, place) - asked.level, 1.0, glm::dvec3(0.0)};
    }
    return value;
}

// The shape of a model's surface at given places on it.
class ShapeAt {
public:
    explicit ShapeAt(const hrbfnpr_model* model) : model_(model), plain_(model) {}
    [[nodiscard]] std::vector<PlaceShape> operator()(const std::vector<glm::dvec3>& places) const {
        std::vector<glm::dvec3> gradient(places.size());
        scenes::Check check;
        const auto n = static_cast<std::int64_t>(places.size());
        const hrbfnpr_array points{places.data(), n, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        const hrbfnpr_array_out out{gradient.data(), n, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        check(hrbfnpr_model_evaluate(model_, &points, nullptr, &out, nullptr, nullptr, check.error()));
        const std::vector<Derivatives> derivatives = plain_.at(places);
        std::vector<PlaceShape> shape;
        for (std::size_t i = 0; i < places.size(); ++i) shape.emplace_back(gradient[i], derivatives[i]);
        return shape;
    }
    // Moves places onto the surface by Newton steps along the gradient.
    [[nodiscard]] std::vector<glm::dvec3> onto_surface(std::vector<glm::dvec3> places) const {
        scenes::Check check;
        const auto n = static_cast<std::int64_t>(places.size());
        std::vector<double> value(places.size());
        std::vector<glm::dvec3> gradient(places.size());
        for (int step = 0; step < 4; ++step) {
            const hrbfnpr_array points{places.data(), n, 0, HRBFNPR_SCALAR_FLOAT64, 3};
            const hrbfnpr_array_out f{value.data(), n, 0, HRBFNPR_SCALAR_FLOAT64, 1};
            const hrbfnpr_array_out g{gradient.data(), n, 0, HRBFNPR_SCALAR_FLOAT64, 3};
            check(hrbfnpr_model_evaluate(model_, &points, &f, &g, nullptr, nullptr, check.error()));
            for (std::size_t i = 0; i < places.size(); ++i)
                places[i] -= value[i] / glm::dot(gradient[i], gradient[i]) * gradient[i];
        }
        return places;
    }

private:
    const hrbfnpr_model* model_;
    PlainShape plain_;
};

// The first hits of rays through a grid of the image, and the shape at the hits.
class FeatureGrid {
public:
    FeatureGrid(const hrbfnpr_model* model, const ShapeAt& shape_at, const hrbfnpr_camera& camera, int rays)
        : sight_(camera), rays_(rays), width_(static_cast<int>(camera.viewport[2]) * rays + 1),
          height_(static_cast<int>(camera.viewport[3]) * rays + 1) {
        cast(model);
        std::vector<glm::dvec3> hits;
        of_node_.assign(node_count(), -1);
        for (std::size_t i = 0; i < node_count(); ++i)
            if (hit_[i] != 0) {
                of_node_[i] = static_cast<std::int32_t>(hits.size());
                hits.push_back(position_[i]);
            }
        shape_ = shape_at(hits);
        find_cuts(model);
        find_edges();
    }

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] int rays() const { return rays_; }
    [[nodiscard]] std::size_t node_count() const {
        return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    }
    [[nodiscard]] bool is_hit(std::size_t node) const { return of_node_[node] >= 0; }
    [[nodiscard]] const glm::dvec3& position(std::size_t node) const { return position_[node]; }
    [[nodiscard]] const PlaceShape& shape(std::size_t node) const {
        return shape_[static_cast<std::size_t>(of_node_[node])];
    }
    [[nodiscard]] glm::dvec2 pixel(std::size_t node) const {
        const auto w = static_cast<std::size_t>(width_);
        return glm::dvec2(node % w, node / w) / static_cast<double>(rays_);
    }
    [[nodiscard]] const Sight& sight() const { return sight_; }
    // Returns whether no contour passes between two neighbouring hits.
    [[nodiscard]] bool joined(std::size_t a, std::size_t b) const {
        return is_hit(a) && is_hit(b) && is_near(a, b) && cut_.count(key(a, b)) == 0;
    }
    // Returns whether a contour passes within `reach` pixels.
    [[nodiscard]] bool near_contour(const glm::dvec2& pixel, double reach) const {
        const auto low = [&](double x) { return static_cast<int>(std::ceil((x - reach) * rays_)); };
        const auto high = [&](double x) { return static_cast<int>(std::floor((x + reach) * rays_)); };
        for (int y = std::max(0, low(pixel.y)); y <= std::min(height_ - 1, high(pixel.y)); ++y)
            for (int x = std::max(0, low(pixel.x)); x <= std::min(width_ - 1, high(pixel.x)); ++x)
                if (edge_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                          static_cast<std::size_t>(x)] != 0)
                    return true;
        return false;
    }

private:
    // Returns whether each hit is nearly in the tangent plane of the other.
    [[nodiscard]] bool is_near(std::size_t a, std::size_t b) const {
        const glm::dvec3 step = position_[b] - position_[a];
        const double length = glm::length(step);
        return std::abs(glm::dot(shape(a).n, step)) < 0.3 * length &&
               std::abs(glm::dot(shape(b).n, step)) < 0.3 * length;
    }
    [[nodiscard]] std::size_t key(std::size_t a, std::size_t b) const {
        return std::min(a, b) * node_count() + std::max(a, b);
    }
    void cast(const hrbfnpr_model* model) {
        std::vector<glm::dvec2> pixels;
        for (std::size_t i = 0; i < node_count(); ++i) pixels.push_back(pixel(i));
        first_hits(model, pixels, position_, hit_);
    }
    void first_hits(const hrbfnpr_model* model, const std::vector<glm::dvec2>& pixels,
                    std::vector<glm::dvec3>& position, std::vector<char>& hit) const {
        const glm::dmat4 to_world = glm::inverse(sight_.lens.to_clip);
        const auto place = [&](const glm::dvec2& pixel, double depth) {
            const glm::dvec4& v = sight_.lens.viewport;
            const glm::dvec4 p =
                to_world * glm::dvec4(2.0 * (pixel.x - v.x) / v.z - 1.0, 1.0 - 2.0 * (pixel.y - v.y) / v.w, depth, 1.0);
            return glm::dvec3(p) / p.w;
        };
        const auto n = static_cast<std::int64_t>(pixels.size());
        std::vector<glm::dvec3> origin;
        std::vector<glm::dvec3> direction;
        for (const glm::dvec2& p : pixels) {
            origin.push_back(place(p, -1.0));
            direction.push_back(glm::normalize(place(p, 1.0) - origin.back()));
        }
        position.resize(pixels.size());
        std::vector<std::uint32_t> count(pixels.size());
        scenes::Check check;
        auto hits = scenes::made(hrbfnpr_ray_hits_init);
        hits.count = {count.data(), n, 0, HRBFNPR_SCALAR_UINT32, 1};
        hits.position = {position.data(), n, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        const hrbfnpr_array origins{origin.data(), n, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        const hrbfnpr_array directions{direction.data(), n, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        check(hrbfnpr_model_cast_rays(model, &origins, &directions, nullptr, &hits, nullptr, check.error()));
        hit.clear();
        for (const std::uint32_t c : count) hit.push_back(c > 0 ? 1 : 0);
    }
    // Near its end, a contour hides little depth.  If one of two hits is much deeper, rays between them distinguish a
    // jump, which is between two of these rays, from a surface seen obliquely.
    void find_cuts(const hrbfnpr_model* model) {
        const auto w = static_cast<std::size_t>(width_);
        std::vector<std::pair<std::size_t, std::size_t>> steep;
        for (std::size_t i = 0; i < node_count(); ++i)
            for (const std::size_t k : {i + 1, i + w, i + w - 1}) {
                const bool beside = k < node_count() && (k == i + w || (k == i + 1 ? i % w + 1 < w : i % w > 0));
                if (beside && is_hit(i) && is_hit(k) && is_near(i, k) && is_steep(i, k)) steep.emplace_back(i, k);
            }
        constexpr int pieces = 16;
        std::vector<glm::dvec2> pixels;
        for (const auto& [a, b] : steep)
            for (int i = 1; i < pieces; ++i)
                pixels.push_back(glm::mix(pixel(a), pixel(b), static_cast<double>(i) / pieces));
        std::vector<glm::dvec3> position;
        std::vector<char> hit;
        first_hits(model, pixels, position, hit);
        for (std::size_t s = 0; s < steep.size(); ++s) {
            const auto [a, b] = steep[s];
            const std::size_t first = s * (pieces - 1);
            double largest = 0.0;
            for (std::size_t i = 0; i < pieces; ++i) {
                const glm::dvec3 from = i == 0 ? position_[a] : position[first + i - 1];
                const glm::dvec3 to = i + 1 == pieces ? position_[b] : position[first + i];
                largest = std::max(largest, glm::distance(from, to));
            }
            const bool missed = std::any_of(hit.begin() + static_cast<std::ptrdiff_t>(first),
                                            hit.begin() + static_cast<std::ptrdiff_t>(first + pieces - 1),
                                            [](char h) { return h == 0; });
            if (missed || largest > 0.3 * glm::distance(position_[a], position_[b])) cut_.insert(key(a, b));
        }
    }
    // Returns whether the step between two hits is deeper than wide.
    [[nodiscard]] bool is_steep(std::size_t a, std::size_t b) const {
        const glm::dvec3 step = position_[b] - position_[a];
        const double depth = glm::dot(step, glm::normalize(sight_.to(position_[a])));
        return 2.0 * depth * depth > glm::dot(step, step);
    }
    void find_edges() {
        edge_.assign(node_count(), 0);
        const auto w = static_cast<std::size_t>(width_);
        for (std::size_t i = 0; i < node_count(); ++i) {
            if (i % w + 1 < w && (is_hit(i) || is_hit(i + 1)) && !joined(i, i + 1)) edge_[i] = edge_[i + 1] = 1;
            if (i + w < node_count() && (is_hit(i) || is_hit(i + w)) && !joined(i, i + w)) edge_[i] = edge_[i + w] = 1;
        }
    }

    Sight sight_;
    int rays_, width_, height_;
    std::vector<char> hit_;
    std::vector<glm::dvec3> position_;
    std::vector<std::int32_t> of_node_; // index into shape_; -1: no hit
    std::vector<PlaceShape> shape_;
    std::unordered_set<std::size_t> cut_; // pairs of hits with a contour between them
    std::vector<char> edge_;
};

} // namespace bench
