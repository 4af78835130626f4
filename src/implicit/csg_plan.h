// SPDX-License-Identifier: MIT
// How a CSG tree is evaluated: minima and maxima of two at a time, in an order that keeps few intermediate results.
#pragma once

#include "implicit/csg_boxes.h"
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
    std::int32_t group = -1;     // whose minimum or maximum it is
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
    CsgReach reach;         // of that box, wherever it is and not turned inside out
};

struct CsgStep {
    enum class Kind : std::uint8_t { leaf, combine, shell, group };

    Kind kind = Kind::leaf;
    bool a_is_second = false; // in the register after `to`
    std::int32_t op = 0;
    std::int32_t to = 0;     // register
    std::int32_t sheet = -1; // -1: all of them
    std::int32_t than = -1;  // op of a minimum or maximum whose other side is known, in the register before
};

// One of the operands of a group, as a tree of its own.
struct CsgMember {
    std::int32_t op = 0;
    std::int32_t first_sheet = 0; // of the group's
    std::int64_t begin = 0;       // its steps
    std::int64_t end = 0;
};

// A minimum or maximum of several, without blends: only the members that can be it are asked for, the nearest first.
struct CsgGroup {
    std::int32_t op = 0;
    std::int32_t first_member = 0;
    std::array<std::int32_t, 2> boxes{-1, -1}; // roots: of members without models, and of those with some
    double size = 0.0;                         // of their numbers
};

class CsgPlan {
public:
    enum class Groups : std::uint8_t { never, where_they_pay, always };

    // The tree is valid: parents come before their children, there is a child where one is needed, transforms can be
    // undone.  The groups change no bit of a result.
    CsgPlan(base::Memory& memory, const CsgTree& tree, const base::Array<CsgModel>& models,
            Groups groups = Groups::where_they_pay);

    [[nodiscard]] const base::Array<CsgOp>& ops() const noexcept { return ops_; }
    [[nodiscard]] const CsgOp& root() const noexcept { return ops_[root_]; }
    [[nodiscard]] const CsgPlace& place(const CsgOp& op) const noexcept { return places_[op.place]; }
    // Of the root, for all sheets.
    [[nodiscard]] std::span<const CsgStep> steps() const noexcept {
        return steps_.span().first(static_cast<std::size_t>(root_steps_));
    }

    [[nodiscard]] const CsgGroup& group(const CsgOp& op) const noexcept { return groups_[op.group]; }
    [[nodiscard]] const CsgMember& member(std::int32_t i) const noexcept { return members_[i]; }
    [[nodiscard]] std::span<const CsgStep> steps_of(const CsgMember& member) const noexcept {
        return steps_.span().subspan(static_cast<std::size_t>(member.begin),
                                     static_cast<std::size_t>(member.end - member.begin));
    }
    [[nodiscard]] const CsgBoxTree& boxes() const noexcept { return boxes_; }
    // How many groups lie within each other at most, and what a run of steps keeps at a time.
    [[nodiscard]] std::int32_t nested() const noexcept { return nested_; }
    [[nodiscard]] std::int32_t registers() const noexcept { return root().registers; }

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
    [[nodiscard]] std::int64_t bytes() const noexcept {
        return ops_.bytes() + places_.bytes() + steps_.bytes() + groups_.bytes() + members_.bytes() + boxes_.bytes();
    }

private:
    struct Reaches {
        CsgReach drawn, whole;
    };
    class Builder;
    class Grouping;
    void add_steps(std::int32_t op, std::int32_t sheet, base::Array<CsgStep>& steps,
                   base::Array<Pending>& pending) const;
    void visit(const Pending& task, base::Array<CsgStep>& steps, base::Array<Pending>& pending) const;
    void visit_both(const Pending& task, base::Array<Pending>& pending) const;

    base::Array<CsgOp> ops_; // what is combined before the combination
    base::Array<CsgPlace> places_;
    base::Array<CsgStep> steps_; // the root's, then those of all members
    base::Array<CsgGroup> groups_;
    base::Array<CsgMember> members_;
    CsgBoxTree boxes_;
    std::int64_t root_steps_ = 0;
    std::int32_t nested_ = 0;
    std::int32_t root_ = 0;
    CsgReach drawn_, whole_;
};

// The least that a linear map stretches a vector by, and the most.
struct Stretch {
    double least = 1.0, most = 1.0;
};
[[nodiscard]] Stretch stretch_of(const glm::dmat3& linear) noexcept;

} // namespace hrbfnpr::implicit
