// SPDX-License-Identifier: MIT
// Solids of a technical drawing, twice: as trees for the library, and as plain exact functions and rays.
#pragma once

#include "calls.h"
#include "support/csg_nodes.h"

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace bench {

// A part of a straight line that is inside a solid, between two distances from its start.
struct InsideSpan {
    double from, to;
};
using InsideSpans = std::vector<InsideSpan>; // in ascending order, and apart

[[nodiscard]] inline InsideSpans united(const InsideSpans& a, const InsideSpans& b) {
    InsideSpans all = a;
    all.insert(all.end(), b.begin(), b.end());
    std::sort(all.begin(), all.end(), [](const InsideSpan& x, const InsideSpan& y) { return x.from < y.from; });
    InsideSpans found;
    for (const InsideSpan& span : all) {
        if (!found.empty() && span.from <= found.back().to)
            found.back().to = std::max(found.back().to, span.to);
        else
            found.push_back(span);
    }
    return found;
}

[[nodiscard]] inline InsideSpans outside_of(const InsideSpans& a) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    InsideSpans found;
    double from = -infinite;
    for (const InsideSpan& span : a) {
        if (span.from > from) found.push_back({from, span.from});
        from = span.to;
    }
    if (from < infinite) found.push_back({from, infinite});
    return found;
}

using PlainFunction = std::function<double(const glm::dvec3&)>;

// A primitive solid around the origin, moved by `place`, or a combination of solids.
struct PlainSolid {
    std::uint32_t kind = HRBFNPR_CSG_UNION; // HRBFNPR_CSG_UNION, INTERSECTION, DIFFERENCE, BOX, CYLINDER, CONE, SPHERE
    std::vector<PlainSolid> of;
    glm::dvec3 size{1.0};
    double radius = 1.0, second_radius = 1.0, height = 1.0;
    glm::dmat4 place{1.0}; // a rotation and a translation

    [[nodiscard]] PlainSolid moved(const glm::dvec3& by) const {
        PlainSolid copy = *this;
        copy.place = glm::translate(glm::dmat4(1.0), by) * place;
        return copy;
    }
    [[nodiscard]] PlainSolid turned(double degrees, const glm::dvec3& axis) const {
        PlainSolid copy = *this;
        copy.place = glm::rotate(glm::dmat4(1.0), glm::radians(degrees), axis) * place;
        return copy;
    }

    // Returns the smooth functions that are 0 on the faces of all primitives. They are negative inside the primitives.
    void add_faces(const glm::dmat4& parent, std::vector<PlainFunction>& faces) const {
        const glm::dmat4 to_world = parent * place;
        for (const PlainSolid& child : of) child.add_faces(to_world, faces);
        const glm::dmat4 from_world = glm::inverse(to_world);
        const auto add = [&](auto&& f) {
            faces.emplace_back([=](const glm::dvec3& p) { return f(glm::dvec3(from_world * glm::dvec4(p, 1.0))); });
        };
        if (kind == HRBFNPR_CSG_BOX)
            for (int axis = 0; axis < 3; ++axis)
                for (const double sign : {-1.0, 1.0})
                    add([=, half = 0.5 * size[axis]](const glm::dvec3& p) { return sign * p[axis] - half; });
        if (kind == HRBFNPR_CSG_SPHERE) add([r = radius](const glm::dvec3& p) { return glm::length(p) - r; });
        if (kind != HRBFNPR_CSG_CYLINDER && kind != HRBFNPR_CSG_CONE) return;
        for (const double sign : {-1.0, 1.0})
            add([=, half = 0.5 * height](const glm::dvec3& p) { return sign * p.z - half; });
        add([mantle = mantle_of()](const glm::dvec3& p) { return mantle(p); });
    }
    // Returns a function that is 0 on the surface and negative inside.
    [[nodiscard]] double value(const glm::dvec3& at) const {
        const glm::dvec3 p(glm::inverse(place) * glm::dvec4(at, 1.0));
        if (of.empty()) {
            if (kind == HRBFNPR_CSG_BOX) {
                const glm::dvec3 out = glm::abs(p) - 0.5 * size;
                return std::max({out.x, out.y, out.z});
            }
            if (kind == HRBFNPR_CSG_SPHERE) return glm::length(p) - radius;
            return std::max(std::abs(p.z) - 0.5 * height, mantle_of()(p));
        }
        double f = of.front().value(p);
        for (std::size_t i = 1; i < of.size(); ++i) {
            const double g = of[i].value(p);
            f = kind == HRBFNPR_CSG_UNION ? std::min(f, g) : std::max(f, kind == HRBFNPR_CSG_DIFFERENCE ? -g : g);
        }
        return f;
    }
    // Returns the parts of a straight line inside the solid.
    [[nodiscard]] InsideSpans spans(const glm::dvec3& origin, const glm::dvec3& way) const {
        const glm::dmat4 from = glm::inverse(place);
        const glm::dvec3 p(from * glm::dvec4(origin, 1.0));
        const glm::dvec3 d(from * glm::dvec4(way, 0.0));
        if (of.empty()) return primitive_spans(p, d);
        InsideSpans found = of.front().spans(p, d);
        for (std::size_t i = 1; i < of.size(); ++i) {
            const InsideSpans other = of[i].spans(p, d);
            if (kind == HRBFNPR_CSG_UNION)
                found = united(found, other);
            else // An intersection is the complement of the union of complements.
                found =
                    outside_of(united(outside_of(found), kind == HRBFNPR_CSG_DIFFERENCE ? other : outside_of(other)));
        }
        return found;
    }
    void add_nodes(std::int64_t parent, hrbfnpr::test::CsgNodes& nodes) const {
        const auto number = static_cast<std::int64_t>(nodes.nodes.size());
        hrbfnpr_csg_node& node = nodes.add(kind, parent);
        for (int i = 0; i < 3; ++i) node.size[i] = size[i];
        node.radius = radius;
        node.second_radius = kind == HRBFNPR_CSG_CONE ? second_radius : 0.5;
        node.height = height;
        std::copy_n(glm::value_ptr(place), 16, node.transform);
        for (const PlainSolid& child : of) child.add_nodes(number, nodes);
    }

private:
    [[nodiscard]] std::function<double(const glm::dvec3&)> mantle_of() const {
        const double top = kind == HRBFNPR_CSG_CONE ? second_radius : radius;
        const double slope = (top - radius) / height;
        const double unit = std::sqrt(1.0 + slope * slope);
        return [=, middle = 0.5 * (radius + top)](const glm::dvec3& p) {
            return (std::hypot(p.x, p.y) - middle - slope * p.z) / unit;
        };
    }
    [[nodiscard]] InsideSpans primitive_spans(const glm::dvec3& p, const glm::dvec3& d) const {
        constexpr double infinite = std::numeric_limits<double>::infinity();
        InsideSpan span{-infinite, infinite};
        const auto keep_slab = [&](int axis, double half) {
            if (d[axis] == 0.0) {
                if (std::abs(p[axis]) > half) span.to = -infinite;
                return;
            }
            const double a = (-half - p[axis]) / d[axis];
            const double b = (half - p[axis]) / d[axis];
            span.from = std::max(span.from, std::min(a, b));
            span.to = std::min(span.to, std::max(a, b));
        };
        // Keeps the places where a s^2 + 2 b s + c < 0, for a > 0.
        const auto keep_quadratic = [&](double a, double b, double c) {
            const double root = b * b - a * c;
            if (!(root > 0.0)) {
                span.to = -infinite;
                return;
            }
            span.from = std::max(span.from, (-b - std::sqrt(root)) / a);
            span.to = std::min(span.to, (-b + std::sqrt(root)) / a);
        };
        if (kind == HRBFNPR_CSG_BOX)
            for (int axis = 0; axis < 3; ++axis) keep_slab(axis, 0.5 * size[axis]);
        if (kind == HRBFNPR_CSG_SPHERE)
            keep_quadratic(glm::dot(d, d), glm::dot(p, d), glm::dot(p, p) - radius * radius);
        if (kind == HRBFNPR_CSG_CYLINDER || kind == HRBFNPR_CSG_CONE) {
            keep_slab(2, 0.5 * height);
            const double top = kind == HRBFNPR_CSG_CONE ? second_radius : radius;
            const double slope = (top - radius) / height;
            const double r = 0.5 * (radius + top) + slope * p.z;
            const double a = d.x * d.x + d.y * d.y - slope * slope * d.z * d.z;
            const double b = p.x * d.x + p.y * d.y - r * slope * d.z;
            const double c = p.x * p.x + p.y * p.y - r * r;
            if (a > 1e-12) {
                keep_quadratic(a, b, c);
            } else if (span.from < span.to) {
                // Inside the slab the radius is positive, so the inside is where the convex cone is: between two roots,
                // or beyond one of them.
                InsideSpans found;
                std::vector<double> cuts{span.from};
                const double root = b * b - a * c;
                if (std::abs(a) <= 1e-12) {
                    if (b != 0.0) cuts.push_back(-0.5 * c / b);
                } else if (root > 0.0) {
                    cuts.push_back((-b + std::sqrt(root)) / a);
                    cuts.push_back((-b - std::sqrt(root)) / a);
                }
                cuts.push_back(span.to);
                std::sort(cuts.begin(), cuts.end());
                for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
                    const double from = std::clamp(cuts[i], span.from, span.to);
                    const double to = std::clamp(cuts[i + 1], span.from, span.to);
                    const double s = 0.5 * (from + to);
                    if (to > from && a * s * s + 2.0 * b * s + c < 0.0) found.push_back({from, to});
                }
                return united(found, {});
            }
        }
        return span.from < span.to ? InsideSpans{span} : InsideSpans{};
    }
};

// ---- Shorthands

[[nodiscard]] inline PlainSolid box(double x, double y, double z) {
    PlainSolid solid;
    solid.kind = HRBFNPR_CSG_BOX;
    solid.size = {x, y, z};
    return solid;
}
[[nodiscard]] inline PlainSolid cylinder(double radius, double height) {
    PlainSolid solid;
    solid.kind = HRBFNPR_CSG_CYLINDER;
    solid.radius = radius;
    solid.height = height;
    return solid;
}
[[nodiscard]] inline PlainSolid cone(double radius, double top, double height) {
    PlainSolid solid = cylinder(radius, height);
    solid.kind = HRBFNPR_CSG_CONE;
    solid.second_radius = top;
    return solid;
}
[[nodiscard]] inline PlainSolid ball(double radius) {
    PlainSolid solid;
    solid.kind = HRBFNPR_CSG_SPHERE;
    solid.radius = radius;
    return solid;
}
[[nodiscard]] inline PlainSolid combined(std::uint32_t kind, std::vector<PlainSolid> of) {
    PlainSolid solid;
    solid.kind = kind;
    solid.of = std::move(of);
    return solid;
}
[[nodiscard]] inline PlainSolid operator+(const PlainSolid& a, const PlainSolid& b) {
    return combined(HRBFNPR_CSG_UNION, {a, b});
}
[[nodiscard]] inline PlainSolid operator-(const PlainSolid& a, const PlainSolid& b) {
    return combined(HRBFNPR_CSG_DIFFERENCE, {a, b});
}
[[nodiscard]] inline PlainSolid operator*(const PlainSolid& a, const PlainSolid& b) {
    return combined(HRBFNPR_CSG_INTERSECTION, {a, b});
}

[[nodiscard]] inline scenes::Model model_of(hrbfnpr_context* context, const PlainSolid& solid) {
    scenes::Check check;
    hrbfnpr::test::CsgNodes nodes;
    solid.add_nodes(-1, nodes);
    const hrbfnpr_csg_desc desc = nodes.desc();
    hrbfnpr_model* model = nullptr;
    check(hrbfnpr_model_create_csg(context, &desc, &model, check.error()));
    return scenes::Model(model);
}

} // namespace bench
