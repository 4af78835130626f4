// SPDX-License-Identifier: MIT
// Random CSG trees, and their values by a plain recursion over the nodes.
#pragma once

#include "support/csg_nodes.h"

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

namespace bench {

using hrbfnpr::test::CsgNodes;

// A random tree with at most `levels` levels, within about 3 of the origin.  Transforms are rigid, with mirroring and
// uniform scaling, so that all lengths scale by one factor.
class RandomCsg {
public:
    RandomCsg(std::uint32_t seed, int levels) : random_(seed) { add(-1, levels); }
    CsgNodes nodes;

private:
    double number(double low, double high) {
        return low + (high - low) * static_cast<double>(random_()) / 4294967296.0;
    }
    void move(hrbfnpr_csg_node& node) {
        const glm::dvec3 axis = glm::normalize(glm::dvec3(number(-1, 1), number(-1, 1), number(0.1, 1)));
        glm::dmat4 m(1.0);
        for (int i = 0; i < 3; ++i) m[3][i] = number(-0.7, 0.7);
        m = glm::rotate(m, number(-3, 3), axis) * glm::scale(glm::dmat4(1.0), glm::dvec3(number(0.7, 1.4)));
        if (number(0, 1) < 0.2) m = m * glm::scale(glm::dmat4(1.0), glm::dvec3(-1.0, 1.0, 1.0));
        for (int i = 0; i < 16; ++i) node.transform[i] = m[i / 4][i % 4];
    }
    void add(std::int64_t parent, int levels) {
        const bool leaf = levels == 1 || (parent >= 0 && number(0, 1) < 0.15);
        const auto at = static_cast<std::int64_t>(nodes.nodes.size());
        hrbfnpr_csg_node& node = nodes.add(
            static_cast<std::uint32_t>((leaf ? std::uint32_t{HRBFNPR_CSG_HALF_SPACE} : 0U) + random_() % 6), parent);
        if (number(0, 1) < 0.8) move(node);
        for (double& side : node.size) side = number(0.4, 2.0);
        node.radius = number(0.4, 1.0);
        node.second_radius = node.kind == HRBFNPR_CSG_TORUS ? node.radius * number(0.2, 0.6) : number(0.0, 1.0);
        node.height = number(0.4, 2.0);
        node.distance = node.kind == HRBFNPR_CSG_SHELL ? number(0.05, 0.3) : number(-0.1, 0.2);
        if (number(0, 1) < 0.3) node.blend = number(0.05, 0.4);
        if (number(0, 1) < 0.4) node.exponent = number(2.0, 4.0);
        const bool single = node.kind >= HRBFNPR_CSG_COMPLEMENT && node.kind <= HRBFNPR_CSG_SHELL;
        const int children = leaf ? 0 : single ? 1 : 2 + static_cast<int>(random_() % 2);
        for (int i = 0; i < children; ++i) add(at, levels - 1);
    }

    std::mt19937 random_;
};

class CsgReference {
public:
    explicit CsgReference(const CsgNodes& nodes) : nodes_(nodes) {}
    [[nodiscard]] double at(const glm::dvec3& p) const { return node(0, p); }

private:
    [[nodiscard]] static double blended(double a, double b, const hrbfnpr_csg_node& n) {
        if (n.blend == 0.0) return std::min(a, b);
        const double r = n.blend;
        const double p = n.exponent;
        if (p == 0.0) return std::min(a, b) - r / 6.0 * std::pow(std::max(0.0, 1.0 - std::abs(a - b) / r), 3.0);
        return std::max(r, std::min(a, b)) -
               std::pow(std::pow(std::max(0.0, r - a), p) + std::pow(std::max(0.0, r - b), p), 1.0 / p);
    }
    [[nodiscard]] static double cone(const hrbfnpr_csg_node& n, const glm::dvec3& p, double above) {
        const double narrows = n.radius - above;
        const double side = n.height * (std::hypot(p.x, p.y) - n.radius) + narrows * (p.z + 0.5 * n.height);
        return std::max(side / std::hypot(n.height, narrows), std::abs(p.z) - 0.5 * n.height);
    }
    [[nodiscard]] static double leaf(const hrbfnpr_csg_node& n, const glm::dvec3& p) {
        switch (n.kind) {
        case HRBFNPR_CSG_HALF_SPACE: return p.z;
        case HRBFNPR_CSG_BOX:
            return std::max(
                {std::abs(p.x) - 0.5 * n.size[0], std::abs(p.y) - 0.5 * n.size[1], std::abs(p.z) - 0.5 * n.size[2]});
        case HRBFNPR_CSG_SPHERE: return glm::length(p) - n.radius;
        case HRBFNPR_CSG_CYLINDER: return cone(n, p, n.radius);
        case HRBFNPR_CSG_CONE: return cone(n, p, n.second_radius);
        default: return std::hypot(std::hypot(p.x, p.y) - n.radius, p.z) - n.second_radius;
        }
    }
    [[nodiscard]] double node(std::size_t i, const glm::dvec3& world) const {
        const hrbfnpr_csg_node& n = nodes_.nodes[i];
        glm::dmat4 m;
        for (int k = 0; k < 16; ++k) m[k / 4][k % 4] = n.transform[k];
        const double scale = glm::length(glm::dvec3(m[0]));
        const glm::dvec3 p = glm::dvec3(glm::inverse(m) * glm::dvec4(world, 1.0));
        if (n.kind >= HRBFNPR_CSG_MODEL) return scale * leaf(n, p);
        double f = 0.0;
        bool first = true;
        for (std::size_t k = i + 1; k < nodes_.nodes.size(); ++k) {
            if (nodes_.nodes[k].parent != static_cast<std::int64_t>(i)) continue;
            const double child = node(k, p);
            if (first)
                f = child;
            else if (n.kind == HRBFNPR_CSG_UNION)
                f = blended(f, child, n);
            else
                f = -blended(-f, n.kind == HRBFNPR_CSG_INTERSECTION ? -child : child, n);
            first = false;
        }
        if (n.kind == HRBFNPR_CSG_COMPLEMENT) f = -f;
        if (n.kind == HRBFNPR_CSG_OFFSET) f -= n.distance;
        if (n.kind == HRBFNPR_CSG_SHELL) f = std::max(f, -f - n.distance);
        return scale * f;
    }

    const CsgNodes& nodes_;
};

} // namespace bench
