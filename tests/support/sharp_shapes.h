// SPDX-License-Identifier: MIT
// Shapes with creases: maxima and minima of functions with exact derivatives.
#pragma once

#include "implicit/sheets.h"
#include "support/analytic.h"

#include <memory>
#include <utility>
#include <vector>

namespace hrbfnpr::test {

using FieldFunction = std::function<Field(const glm::dvec3&)>;

inline FieldFunction plane(const glm::dvec3& direction, double offset) {
    const glm::dvec3 n = glm::normalize(direction);
    return [=](const glm::dvec3& p) { return Field{glm::dot(n, p) - offset, n, {}}; };
}

inline FieldFunction sphere(const glm::dvec3& centre, double radius) {
    return [=](const glm::dvec3& p) {
        const double r = std::max(1e-12, glm::distance(p, centre));
        const glm::dvec3 n = (p - centre) / r;
        return Field{r - radius, n, identity(1.0 / r) + outer(n, n, -1.0 / r)};
    };
}

// A cone about the z axis. Its radius changes by `slope` with z.
inline FieldFunction cone(double radius, double slope, const glm::dvec3& axis_at = glm::dvec3(0.0)) {
    return [=](const glm::dvec3& p) {
        const double x = p.x - axis_at.x;
        const double y = p.y - axis_at.y;
        const double r = std::max(1e-12, std::hypot(x, y));
        const glm::dvec3 out(x / r, y / r, 0.0);
        const glm::dvec3 around(-out.y, out.x, 0.0);
        const double unit = std::sqrt(1.0 + slope * slope);
        return Field{(r - radius - slope * p.z) / unit, (out - glm::dvec3(0.0, 0.0, slope)) / unit,
                     outer(around, around, 1.0 / (r * unit))};
    };
}

inline FieldFunction cylinder(double radius, const glm::dvec3& axis_at = glm::dvec3(0.0)) {
    return cone(radius, 0.0, axis_at);
}

// The complement of a shape.
inline FieldFunction without(const FieldFunction& f) {
    return [=](const glm::dvec3& p) {
        Field field = f(p);
        field.value = -field.value;
        field.gradient = -field.gradient;
        for (double& h : field.hessian) h = -h;
        return field;
    };
}

// The shape of f(turn p).
inline FieldFunction turned(const FieldFunction& f, const glm::dmat3& turn) {
    return [=](const glm::dvec3& p) {
        Field field = f(turn * p);
        const Hessian& h = field.hessian;
        const glm::dmat3 own(h[0], h[1], h[2], h[1], h[3], h[4], h[2], h[4], h[5]);
        const glm::dmat3 m = glm::transpose(turn) * own * turn;
        return Field{
            field.value, glm::transpose(turn) * field.gradient, {m[0][0], m[0][1], m[0][2], m[1][1], m[1][2], m[2][2]}};
    };
}

// A tree of maxima and minima of functions.
struct Sharp {
    enum class Kind { leaf, max, min };
    Kind kind = Kind::leaf;
    FieldFunction field;
    std::vector<Sharp> of;

    Sharp(FieldFunction f) : field(std::move(f)) {} // NOLINT: a leaf is a tree
    Sharp(Kind k, std::vector<Sharp> children) : kind(k), of(std::move(children)) {}
};
inline Sharp max_of(std::vector<Sharp> of) { return {Sharp::Kind::max, std::move(of)}; }
inline Sharp min_of(std::vector<Sharp> of) { return {Sharp::Kind::min, std::move(of)}; }

class SharpShape : public Analytic, public implicit::Sheets {
public:
    SharpShape(const geometry::Bounds& bounds, Sharp tree) : Analytic(bounds), tree_(std::move(tree)) {
        collect(tree_);
    }

    [[nodiscard]] Field at(const glm::dvec3& p) const override { return chosen(tree_, p).first; }
    [[nodiscard]] const implicit::Sheets* sheets() const noexcept override { return this; }
    [[nodiscard]] std::int32_t count() const noexcept override { return static_cast<std::int32_t>(leaf_.size()); }
    [[nodiscard]] Field sheet_at(std::int32_t sheet, const glm::dvec3& p) const {
        return leaf_[static_cast<std::size_t>(sheet)]->field(p);
    }
    [[nodiscard]] std::int32_t active_at(const glm::dvec3& p) const {
        const Sharp* const leaf = chosen(tree_, p).second;
        for (std::size_t i = 0; i < leaf_.size(); ++i)
            if (leaf_[i] == leaf) return static_cast<std::int32_t>(i);
        return -1;
    }
    void active(const implicit::PointBatch& points, std::int32_t* sheet) const override {
        for (std::int64_t i = 0; i < points.count; ++i) sheet[i] = active_at({points.x[i], points.y[i], points.z[i]});
    }
    void evaluate(const implicit::PointBatch& points, const implicit::FieldBatch& fields) const override {
        Analytic::evaluate(points, fields);
    }
    void evaluate(std::int32_t sheet, const implicit::PointBatch& points,
                  const implicit::FieldBatch& fields) const override {
        AnyField(bounds(), leaf_[static_cast<std::size_t>(sheet)]->field).evaluate(points, fields);
    }

private:
    void collect(const Sharp& tree) {
        if (tree.kind == Sharp::Kind::leaf) leaf_.push_back(&tree);
        for (const Sharp& child : tree.of) collect(child);
    }
    static std::pair<Field, const Sharp*> chosen(const Sharp& tree, const glm::dvec3& p) {
        if (tree.kind == Sharp::Kind::leaf) return {tree.field(p), &tree};
        std::pair<Field, const Sharp*> best{};
        for (const Sharp& child : tree.of) {
            const std::pair<Field, const Sharp*> here = chosen(child, p);
            const bool better = tree.kind == Sharp::Kind::max ? here.first.value > best.first.value
                                                              : here.first.value < best.first.value;
            if (best.second == nullptr || better) best = here;
        }
        return best;
    }

    Sharp tree_;
    std::vector<const Sharp*> leaf_;
};

// A rotation with which no lattice is aligned.
inline glm::dmat3 odd_turn() {
    const glm::dvec3 z = glm::normalize(glm::dvec3(0.31, -0.22, 0.93));
    const glm::dvec3 x = glm::normalize(glm::cross(glm::dvec3(0.1, 0.97, 0.2), z));
    return glm::transpose(glm::dmat3(x, glm::cross(z, x), z));
}

// The sides of a box about the origin, with half sizes `half`.
inline std::vector<Sharp> sides(const glm::dvec3& half, const glm::dmat3& turn = glm::dmat3(1.0)) {
    std::vector<Sharp> all;
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            glm::dvec3 n(0.0);
            n[axis] = sign;
            all.emplace_back(turned(plane(n, half[axis]), turn));
        }
    return all;
}

// A cube with half edge 1.
inline std::unique_ptr<SharpShape> sharp_cube(const glm::dmat3& turn = odd_turn()) {
    return std::make_unique<SharpShape>(cube(1.75), max_of(sides(glm::dvec3(1.0), turn)));
}
inline std::unique_ptr<SharpShape> bored_cube(double radius = 0.6, const glm::dmat3& turn = odd_turn()) {
    std::vector<Sharp> all = sides(glm::dvec3(1.0), turn);
    all.emplace_back(turned(without(cylinder(radius)), turn));
    return std::make_unique<SharpShape>(cube(1.75), max_of(std::move(all)));
}
// A shaft of radius 1 up to z = 0, and of radius 0.5 up to z = 1.2.
inline std::unique_ptr<SharpShape> stepped_shaft() {
    return std::make_unique<SharpShape>(
        geometry::Bounds{{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.2}},
        min_of({max_of({cylinder(1.0), plane({0, 0, 1}, 0.0), plane({0, 0, -1}, 1.0)}),
                max_of({cylinder(0.5), plane({0, 0, 1}, 1.2), plane({0, 0, -1}, 0.5)})}));
}
inline std::unique_ptr<SharpShape> two_balls(bool joined) {
    std::vector<Sharp> both{sphere({-0.5, 0.0, 0.0}, 1.0), sphere({0.5, 0.1, 0.0}, 1.0)};
    return std::make_unique<SharpShape>(geometry::Bounds{{-1.5, -1.0, -1.0}, {1.5, 1.1, 1.0}},
                                        joined ? min_of(std::move(both)) : max_of(std::move(both)));
}
inline std::unique_ptr<SharpShape> capped_cone() {
    return std::make_unique<SharpShape>(geometry::Bounds{{-1.0, -1.0, -1.0}, {1.0, 1.0, 0.7}},
                                        max_of({cone(0.6, -0.4), plane({0, 0, -1}, 1.0), plane({0, 0, 1}, 0.7)}));
}
// A half ball whose upper side has a crease along y. The slopes of its sides fall by the factor e for every third of a
// unit of y.
inline std::unique_ptr<SharpShape> fading_wedge() {
    const auto slope = [](double sign) {
        return [sign](const glm::dvec3& p) {
            const double a = sign * 0.5 * std::exp(-3.0 * (p.y + 1.0));
            return Field{p.z + a * p.x, {a, -3.0 * a * p.x, 1.0}, {0.0, -3.0 * a, 0.0, 9.0 * a * p.x, 0.0, 0.0}};
        };
    };
    return std::make_unique<SharpShape>(cube(1.0), max_of({Sharp(FieldFunction(slope(1.0))),
                                                           Sharp(FieldFunction(slope(-1.0))), sphere({0, 0, 0}, 1.0)}));
}

} // namespace hrbfnpr::test
