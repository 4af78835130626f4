// SPDX-License-Identifier: MIT
// How a CSG tree is evaluated: minima and maxima of two at a time, in an order that keeps few intermediate results.
#pragma once

#include "implicit/csg_reach.h"
#include "implicit/implicit.h"

namespace hrbfnpr::implicit {

// What a leaf that is a model is known by.
struct CsgModel {
    geometry::Bounds bounds; // that its surface is drawn in
    geometry::Bounds region; // beyond which it has none, whatever its f is
    std::int32_t sheets = 1;
    double lipschitz = 0.0; // 0 = not known
};

struct CsgOp {
    enum class Kind : std::uint8_t { shape, model, minimum, maximum, shell_of_minimum, shell_of_maximum };

    Kind kind = Kind::shape;
    std::int32_t a = -1, b = -1; // what is combined
    std::int32_t place = -1;     // of a leaf
    std::int32_t registers = 1;  // results that it needs at a time
    std::int32_t sheets = 1;
    bool merged = false; // more sheets than there are numbers: taken for one
    Blend blend;
    double thickness = 0.0;
    double add = 0.0; // to the result
    double lipschitz = 1.0;

    [[nodiscard]] bool is_leaf() const noexcept { return kind <= Kind::model; }
    [[nodiscard]] bool is_shell() const noexcept { return kind >= Kind::shell_of_minimum; }
    [[nodiscard]] bool takes_least() const noexcept { return kind == Kind::minimum || kind == Kind::shell_of_minimum; }
};

// Where a leaf is: f = scale F(to_local x + shift).
struct CsgPlace {
    glm::dmat3 to_local{1.0};
    glm::dvec3 shift{0.0};
    double scale = 1.0; // negative: turned inside out
    CsgShape shape;     // of a model the box that it ends at
    std::int32_t model = -1;
    std::int32_t model_sheets = 0;
    glm::dvec3 centre{0.0}; // of that box
};

struct CsgStep {
    enum class Kind : std::uint8_t { leaf, combine, shell };

    Kind kind = Kind::leaf;
    bool a_is_second = false; // in the register after `to`
    std::int32_t op = 0;
    std::int32_t to = 0;     // register
    std::int32_t sheet = -1; // -1: all of them
    std::int32_t than = -1;  // op of a minimum or maximum whose other side is known, in the register before
};

class CsgPlan {
public:
    // The tree is valid: parents come before their children, there is a child where one is needed, transforms can be
    // undone.
    CsgPlan(base::Memory& memory, const CsgTree& tree, const base::Array<CsgModel>& models);

    [[nodiscard]] const base::Array<CsgOp>& ops() const noexcept { return ops_; }
    [[nodiscard]] const CsgOp& root() const noexcept { return ops_[root_]; }
    [[nodiscard]] const CsgPlace& place(const CsgOp& op) const noexcept { return places_[op.place]; }
    [[nodiscard]] const base::Array<CsgStep>& steps() const noexcept { return steps_; }

    // The steps for one sheet; -1: for all.
    struct Pending {
        std::int32_t op = 0;
        std::int32_t to = 0;
        std::int32_t sheet = -1;
        std::int32_t than = -1;
        bool done = false; // what it is made of
        bool a_is_second = false;
    };
    void make_steps(std::int32_t sheet, base::Array<CsgStep>& steps, base::Array<Pending>& pending) const;

    // Whether all transforms together can be undone in doubles.
    [[nodiscard]] bool is_finite() const noexcept;
    // Where the surface may be: counting what models are drawn in, and all that they may have.
    [[nodiscard]] CsgBox drawn_box() const noexcept { return drawn_.surface(); }
    [[nodiscard]] CsgBox whole_box() const noexcept { return whole_.surface(); }
    [[nodiscard]] std::int64_t bytes() const noexcept { return ops_.bytes() + places_.bytes() + steps_.bytes(); }

private:
    struct Reaches {
        CsgReach drawn, whole;
    };
    class Builder;
    void visit(const Pending& task, base::Array<CsgStep>& steps, base::Array<Pending>& pending) const;
    void visit_both(const Pending& task, base::Array<Pending>& pending) const;

    base::Array<CsgOp> ops_; // what is combined before the combination
    base::Array<CsgPlace> places_;
    base::Array<CsgStep> steps_;
    std::int32_t root_ = 0;
    CsgReach drawn_, whole_;
};

// The least that a linear map stretches a vector by, and the most.
struct Stretch {
    double least = 1.0, most = 1.0;
};
[[nodiscard]] Stretch stretch_of(const glm::dmat3& linear) noexcept;

} // namespace hrbfnpr::implicit
