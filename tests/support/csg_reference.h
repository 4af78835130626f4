// SPDX-License-Identifier: MIT
// Random CSG trees, and their plain evaluation by recursion from the root.
#pragma once

#include "implicit/csg_shapes.h"
#include "implicit/implicit.h"

#include <glm/matrix.hpp>

#include <cmath>
#include <random>
#include <vector>

namespace test {

using hrbfnpr::implicit::CsgKind;
using hrbfnpr::implicit::CsgNode;

using Nodes = std::vector<CsgNode>;

inline hrbfnpr::implicit::CsgTree tree_of(hrbfnpr::base::Memory& memory, const Nodes& nodes) {
    hrbfnpr::implicit::CsgTree tree(memory);
    for (const CsgNode& node : nodes) tree.push_back(node);
    return tree;
}

// The least factor by which a transform stretches lengths, over all directions.
inline double least_stretch(const glm::dmat3& linear) {
    // Inverse iteration: squaring the matrix 20 times makes a million steps.
    glm::dmat3 m = glm::inverse(glm::transpose(linear) * linear);
    for (int i = 0; i < 20; ++i) {
        m = m / (m[0][0] + m[1][1] + m[2][2]);
        m = m * m;
    }
    const glm::dvec3 v = glm::normalize(m * glm::dvec3(0.36, 0.48, 0.8));
    return glm::length(linear * v);
}

struct CsgReference {
    const Nodes& nodes;
    std::vector<const hrbfnpr::implicit::Implicit*> models;
    std::vector<hrbfnpr::geometry::Bounds> regions;

    [[nodiscard]] double at(const glm::dvec3& p) const { return node(0, p); }

private:
    [[nodiscard]] static double blended(double a, double b, const CsgNode& n) {
        const double r = n.blend;
        if (r == 0.0) return std::min(a, b);
        if (n.exponent == 0.0) {
            const double h = std::max(0.0, 1.0 - std::abs(a - b) / r);
            return std::min(a, b) - r / 6.0 * h * h * h;
        }
        const double in_a = std::max(0.0, r - a);
        const double in_b = std::max(0.0, r - b);
        return std::max(r, std::min(a, b)) -
               std::pow(std::pow(in_a, n.exponent) + std::pow(in_b, n.exponent), 1.0 / n.exponent);
    }
    [[nodiscard]] static double box(const glm::dvec3& p, const glm::dvec3& half) {
        return std::max({std::abs(p.x) - half.x, std::abs(p.y) - half.y, std::abs(p.z) - half.z});
    }
    [[nodiscard]] static double cone(const glm::dvec3& p, double below, double above, double height) {
        const double rho = std::sqrt(p.x * p.x + p.y * p.y);
        const double length = std::sqrt(height * height + (below - above) * (below - above));
        const double side = (height * (rho - below) + (below - above) * (p.z + 0.5 * height)) / length;
        return std::max(side, std::abs(p.z) - 0.5 * height);
    }
    [[nodiscard]] double model(const CsgNode& n, const glm::dvec3& p) const {
        double f = 0.0;
        hrbfnpr::implicit::FieldBatch fields;
        fields.value = &f;
        models[static_cast<std::size_t>(n.model)]->evaluate({&p.x, &p.y, &p.z, 1}, fields);
        const hrbfnpr::geometry::Bounds& region = regions[static_cast<std::size_t>(n.model)];
        return std::max(f, box(p - region.centre(), 0.5 * region.size()));
    }
    [[nodiscard]] double leaf(const CsgNode& n, const glm::dvec3& p) const {
        switch (n.kind) {
        case CsgKind::model: return model(n, p);
        case CsgKind::half_space: return p.z;
        case CsgKind::box: return box(p, 0.5 * n.size);
        case CsgKind::sphere: return glm::length(p) - n.radius;
        case CsgKind::cylinder: return cone(p, n.radius, n.radius, n.height);
        case CsgKind::cone: return cone(p, n.radius, n.second_radius, n.height);
        default: break;
        }
        const double across = std::sqrt(p.x * p.x + p.y * p.y) - n.radius;
        return std::sqrt(across * across + p.z * p.z) - n.second_radius;
    }
    [[nodiscard]] double node(std::size_t i, const glm::dvec3& world) const {
        const CsgNode& n = nodes[i];
        const glm::dvec3 p = glm::inverse(n.linear) * (world - n.translation);
        const double scale = least_stretch(n.linear);
        if (hrbfnpr::implicit::is_leaf(n.kind)) return scale * leaf(n, p);
        double f = 0.0;
        bool first = true;
        for (std::size_t k = i + 1; k < nodes.size(); ++k) {
            if (nodes[k].parent != static_cast<std::int64_t>(i)) continue;
            const double child = node(k, p);
            if (first)
                f = child;
            else if (n.kind == CsgKind::unite)
                f = blended(f, child, n);
            else
                f = -blended(-f, n.kind == CsgKind::intersect ? -child : child, n);
            first = false;
        }
        if (n.kind == CsgKind::complement) f = -f;
        if (n.kind == CsgKind::offset) f -= n.distance;
        if (n.kind == CsgKind::shell) f = std::max(f, -f - n.distance);
        return scale * f;
    }
};

// A random tree with at most `levels` levels and nodes of all kinds but models, within about 3 of the origin.
class RandomTree {
public:
    RandomTree(std::uint32_t seed, int levels, bool blends) : random_(seed), blends_(blends) { add(-1, levels); }
    [[nodiscard]] const Nodes& nodes() const { return nodes_; }

private:
    double number(double low, double high) {
        return low + (high - low) * static_cast<double>(random_()) / 4294967296.0;
    }
    glm::dmat3 turn() {
        const glm::dvec3 axis = glm::normalize(glm::dvec3(number(-1, 1), number(-1, 1), number(0.1, 1)));
        const double angle = number(-3, 3);
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        glm::dmat3 m;
        for (int i = 0; i < 3; ++i) {
            glm::dvec3 e(0.0);
            e[i] = 1.0;
            m[i] = c * e + s * glm::cross(axis, e) + (1.0 - c) * glm::dot(axis, e) * axis;
        }
        return m;
    }
    void move(CsgNode& node) {
        if (number(0, 1) < 0.2) return;
        node.linear = (number(0, 1) < 0.8 ? number(0.6, 1.4) : -number(0.6, 1.4)) * turn();
        if (number(0, 1) < 0.25)
            node.linear = node.linear * glm::dmat3(number(0.7, 1.5), 0, 0, number(-0.3, 0.3), number(0.7, 1.5), 0, 0, 0,
                                                   number(0.7, 1.5));
        node.translation = {number(-0.8, 0.8), number(-0.8, 0.8), number(-0.8, 0.8)};
    }
    void add(std::int64_t parent, int levels) {
        CsgNode node;
        node.parent = parent;
        const bool leaf = levels == 1 || number(0, 1) < 0.1;
        const std::uint32_t kinds = static_cast<std::uint32_t>(CsgKind::torus);
        const auto first = static_cast<std::uint32_t>(CsgKind::half_space);
        do node.kind = static_cast<CsgKind>(leaf ? first + random_() % (kinds - first + 1) : random_() % 6);
        while (parent < 0 && node.kind == CsgKind::half_space);
        move(node);
        node.size = {number(0.4, 2), number(0.4, 2), number(0.4, 2)};
        node.radius = number(0.4, 1);
        node.second_radius = node.kind == CsgKind::torus ? node.radius * number(0.2, 0.6) : number(0, 1);
        node.height = number(0.4, 2);
        node.distance = number(-0.1, 0.2);
        if (node.kind == CsgKind::shell) node.distance = number(0.05, 0.3);
        if (blends_ && number(0, 1) < 0.4) node.blend = number(0.05, 0.5);
        if (number(0, 1) < 0.4) node.exponent = number(2, 4);
        const auto at = static_cast<std::int64_t>(nodes_.size());
        nodes_.push_back(node);
        if (leaf) return;
        const bool single = hrbfnpr::implicit::children_of(node.kind) == 1;
        const int children = single ? 1 : 1 + static_cast<int>(random_() % 3);
        for (int i = 0; i < children; ++i) add(at, levels - 1);
    }

    std::mt19937 random_;
    bool blends_;
    Nodes nodes_;
};

} // namespace test
