// SPDX-License-Identifier: MIT
// Exact implicits with gradients and Hessians: an ellipsoid, a surface of genus 2, and tubes around closed curves (a
// torus, a trefoil).
#pragma once

#include "calls.h"

#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace bench {

// A number with its first and second derivatives; the order of the latter is xx xy xz yy yz zz.
struct Jet {
    double value = 0.0;
    glm::dvec3 gradient{0.0};
    std::array<double, 6> hessian{};
};

inline Jet operator+(const Jet& a, const Jet& b) {
    Jet sum{a.value + b.value, a.gradient + b.gradient, {}};
    for (std::size_t i = 0; i < 6; ++i) sum.hessian[i] = a.hessian[i] + b.hessian[i];
    return sum;
}
inline Jet operator*(double s, const Jet& a) {
    Jet product{s * a.value, s * a.gradient, {}};
    for (std::size_t i = 0; i < 6; ++i) product.hessian[i] = s * a.hessian[i];
    return product;
}
inline Jet operator+(const Jet& a, double s) { return {a.value + s, a.gradient, a.hessian}; }
inline Jet operator-(const Jet& a, const Jet& b) { return a + -1.0 * b; }
inline Jet operator*(const Jet& a, const Jet& b) {
    Jet product{a.value * b.value, a.value * b.gradient + b.value * a.gradient, {}};
    std::size_t at = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j, ++at)
            product.hessian[at] = a.value * b.hessian[at] + b.value * a.hessian[at] + a.gradient[i] * b.gradient[j] +
                                  a.gradient[j] * b.gradient[i];
    return product;
}

struct Shape {
    explicit Shape(const glm::dvec3& half_box) : half(half_box) {}
    Shape(const Shape&) = delete;
    Shape& operator=(const Shape&) = delete;
    virtual ~Shape() = default;
    [[nodiscard]] virtual Jet at(const glm::dvec3& p) const = 0;

    glm::dvec3 half; // half the size of its box around the origin
};

// q - 1, times half the smallest axis, where q = sum (p / axes)^2.
struct Ellipsoid : Shape {
    explicit Ellipsoid(const glm::dvec3& its_axes) : Shape(its_axes), axes(its_axes) {}
    [[nodiscard]] Jet at(const glm::dvec3& p) const override {
        const double scale = 0.5 * std::min({axes.x, axes.y, axes.z});
        const glm::dvec3 a = 1.0 / (axes * axes);
        return {scale * (glm::dot(a * p, p) - 1.0),
                2.0 * scale * (a * p),
                {2.0 * scale * a.x, 0.0, 0.0, 2.0 * scale * a.y, 0.0, 2.0 * scale * a.z}};
    }
    glm::dvec3 axes;
};

// 2 y (y^2 - 3 x^2) (1 - z^2) + (x^2 + y^2)^2 - (9 z^2 - 1) (1 - z^2) = 0, of genus 2.
struct TwoHoles : Shape {
    TwoHoles() : Shape({1.7, 1.9, 1.0}) {}
    [[nodiscard]] Jet at(const glm::dvec3& p) const override {
        const Jet x{p.x, {1, 0, 0}, {}};
        const Jet y{p.y, {0, 1, 0}, {}};
        const Jet z{p.z, {0, 0, 1}, {}};
        const Jet xx = x * x;
        const Jet yy = y * y;
        const Jet zz = z * z;
        const Jet w = -1.0 * zz + 1.0;
        const Jet r = xx + yy;
        return 0.2 * (2.0 * (y * (yy - 3.0 * xx)) * w + r * r - (9.0 * zz + -1.0) * w);
    }
};

// A closed curve c(t), 0 <= t < 2 pi, with its derivatives.
struct Ring {
    [[nodiscard]] static glm::dvec3 at(double t) { return {std::cos(t), std::sin(t), 0.0}; }
    [[nodiscard]] static glm::dvec3 first(double t) { return {-std::sin(t), std::cos(t), 0.0}; }
    [[nodiscard]] static glm::dvec3 second(double t) { return {-std::cos(t), -std::sin(t), 0.0}; }
    static constexpr double radius = 0.4;
    static constexpr glm::dvec3 half{1.4, 1.4, 0.4};
};

struct Trefoil {
    [[nodiscard]] static glm::dvec3 at(double t) {
        return {std::sin(t) + 2.0 * std::sin(2.0 * t), std::cos(t) - 2.0 * std::cos(2.0 * t), -std::sin(3.0 * t)};
    }
    [[nodiscard]] static glm::dvec3 first(double t) {
        return {std::cos(t) + 4.0 * std::cos(2.0 * t), -std::sin(t) + 4.0 * std::sin(2.0 * t),
                -3.0 * std::cos(3.0 * t)};
    }
    [[nodiscard]] static glm::dvec3 second(double t) {
        return {-std::sin(t) - 8.0 * std::sin(2.0 * t), -std::cos(t) + 8.0 * std::cos(2.0 * t),
                9.0 * std::sin(3.0 * t)};
    }
    static constexpr double radius = 0.35;
    static constexpr glm::dvec3 half{3.1, 3.35, 1.35};
};

// The distance from a closed curve, minus a radius.
template <class Curve>
struct Tube : Shape {
    Tube() : Shape(Curve::half) {
        for (int i = 0; i < starts; ++i) start.push_back(Curve::at(angle(i)));
    }
    [[nodiscard]] Jet at(const glm::dvec3& p) const override {
        const double t = nearest(p);
        const glm::dvec3 d = p - Curve::at(t);
        const glm::dvec3 c1 = Curve::first(t);
        const glm::dvec3 c2 = Curve::second(t);
        const double s = std::max(glm::length(d), 1e-9);
        const glm::dvec3 u = d / s;
        const glm::dvec3 along = glm::normalize(c1);
        const double speed = glm::dot(c1, c1);
        // The component of the curvature vector along u, and the curvature of parallel curves.
        const double k = glm::dot(c2, u) / speed;
        const double around = -k / (1.0 - s * k);
        Jet jet{s - Curve::radius, u, {}};
        std::size_t h = 0;
        for (int i = 0; i < 3; ++i)
            for (int j = i; j < 3; ++j, ++h)
                jet.hessian[h] =
                    ((i == j ? 1.0 : 0.0) - u[i] * u[j] - along[i] * along[j]) / s + around * along[i] * along[j];
        return jet;
    }

private:
    static constexpr int starts = 128;
    [[nodiscard]] static double angle(int i) { return 2.0 * std::numbers::pi * i / starts; }
    [[nodiscard]] double nearest(const glm::dvec3& p) const {
        int best = 0;
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i < starts; ++i) {
            const glm::dvec3 d = p - start[static_cast<std::size_t>(i)];
            const double squared = glm::dot(d, d);
            if (squared >= least) continue;
            least = squared;
            best = i;
        }
        double t = angle(best);
        for (int step = 0; step < 8; ++step) {
            const glm::dvec3 d = Curve::at(t) - p;
            const glm::dvec3 c1 = Curve::first(t);
            const double slope = std::max(glm::dot(c1, c1) + glm::dot(d, Curve::second(t)), 0.25 * glm::dot(c1, c1));
            const double move = glm::dot(d, c1) / slope;
            t -= move;
            if (std::abs(move) < 1e-14) break;
        }
        return t;
    }

    std::vector<glm::dvec3> start;
};

// `user` is the shape.
inline std::int32_t evaluate_shape(void* user, std::int64_t count, const double* points, double* value,
                                   double* gradient, double* hessian) {
    const auto& shape = *static_cast<const Shape*>(user);
    for (std::int64_t i = 0; i < count; ++i) {
        const Jet jet = shape.at(glm::make_vec3(points + 3 * i));
        value[i] = jet.value;
        for (int c = 0; gradient != nullptr && c < 3; ++c) gradient[3 * i + c] = jet.gradient[c];
        for (std::size_t c = 0; hessian != nullptr && c < 6; ++c)
            hessian[6 * i + static_cast<std::int64_t>(c)] = jet.hessian[c];
    }
    return 0;
}

// The shape must outlive the model.
[[nodiscard]] inline scenes::Model custom_shape(hrbfnpr_context* context, Shape& shape) {
    scenes::Check check;
    auto desc = scenes::made(hrbfnpr_custom_desc_init);
    desc.flags = HRBFNPR_CUSTOM_HAS_GRADIENT | HRBFNPR_CUSTOM_HAS_HESSIAN | HRBFNPR_CUSTOM_THREAD_SAFE;
    desc.function = evaluate_shape;
    desc.user = &shape;
    for (int c = 0; c < 3; ++c) {
        desc.bounds_min[c] = -shape.half[c];
        desc.bounds_max[c] = shape.half[c];
    }
    hrbfnpr_model* model = nullptr;
    check(hrbfnpr_model_create_custom(context, &desc, &model, check.error()));
    return scenes::Model(model);
}

} // namespace bench
