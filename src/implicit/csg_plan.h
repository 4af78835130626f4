// SPDX-License-Identifier: MIT
// The plan by which a tree of solids is evaluated. Complements and differences become signs of leaves, offsets become
// added numbers, and transforms become one map for each leaf. The remaining nodes are shells, and minima, maxima and
// blends of two operands. Steps evaluate them in an order that needs few intermediate results and no recursion, so
// trees may be arbitrarily deep. A chain of minima or of maxima becomes a group where this saves time. The members of a
// group are in a tree of boxes, and only members whose boxes allow a lower value are evaluated.
#pragma once

#include "implicit/csg_shapes.h"

#include <span>

namespace hrbfnpr::implicit {

// A leaf that is a model, with the data that the plan needs.
struct CsgModel {
    geometry::Bounds bounds; // the box in which the model's surface is drawn
    geometry::Bounds region; // the box that contains the model's whole surface; outside, f may have any values
    std::int32_t sheets = 1;
    double lipschitz = 0.0; // a bound on |grad f|; 0: unknown
};

struct CsgOp {
    enum class Kind : std::uint8_t { shape, model, minimum, maximum, shell_of_minimum, shell_of_maximum };

    Kind kind = Kind::shape;
    std::int32_t a = -1, b = -1; // the operands, as indices of earlier ops
    std::int32_t place = -1;     // index of the leaf's CsgPlace
    std::int32_t group = -1;     // index of the group that computes this op; -1: no group
    std::int32_t registers = 1;  // the largest number of intermediate results that this op needs at a time
    std::int32_t sheets = 1;
    bool merged = false; // true if the number of sheets exceeds 32 bits; then all sheets count as one
    Blend blend;
    double thickness = 0.0;
    double add = 0.0; // the number that is added to the result of the op
    double lipschitz = 1.0;

    [[nodiscard]] bool is_leaf() const noexcept { return kind <= Kind::model; }
    [[nodiscard]] bool is_shell() const noexcept { return kind >= Kind::shell_of_minimum; }
    [[nodiscard]] bool is_sharp() const noexcept { return !is_leaf() && !is_shell() && blend.radius == 0.0; }
    [[nodiscard]] bool takes_least() const noexcept { return kind == Kind::minimum || kind == Kind::shell_of_minimum; }
};

// The transform of a leaf: f(x) = scale F(to_local x + shift), where F is the leaf's function.
struct CsgPlace {
    glm::dmat3 to_local{1.0};
    glm::dvec3 shift{0.0};
    double scale = 1.0; // negative if the leaf is turned inside out
    CsgShape shape;     // the primitive, or the box of the model
    std::int32_t model = -1;
    std::int32_t model_sheets = 0;
    glm::dvec3 centre{0.0}; // centre of the model's box
    // bounds of the model's box in the coordinates of the tree, before the leaf is turned inside out
    CsgReach reach;

    [[nodiscard]] glm::dvec3 local(const glm::dvec3& p) const noexcept { return to_local * p + shift; }
    // Returns the signed distance from a model's box, positive outside, and writes the nearest side. `p` is in the
    // model's coordinates.
    [[nodiscard]] double beyond(const glm::dvec3& p, std::int32_t& side) const noexcept {
        return shape.value(p - centre, side);
    }
};

struct CsgStep {
    enum class Kind : std::uint8_t { leaf, combine, shell, group };

    Kind kind = Kind::leaf;
    bool a_is_second = false; // true if operand a is in the register after `to`, and b in `to`
    std::int32_t op = 0;
    std::int32_t to = 0;     // index of the register for the result
    std::int32_t sheet = -1; // index of the only sheet to evaluate; -1: all sheets
    // The op that combines this step's result with the result in the previous register; -1: no op does.
    std::int32_t combined_by = -1;
};

// An operand of a group. It has separate steps.
struct CsgMember {
    std::int32_t op = 0;
    std::int32_t first_sheet = 0; // index of the member's first sheet in the group
    std::int64_t begin = 0;       // the member's steps are [begin, end)
    std::int64_t end = 0;
};

struct CsgGroup {
    std::int32_t op = 0;
    // The roots of two trees of boxes. The first tree has the members without models, which are fast to evaluate and
    // come first. The second has the members with models.
    std::array<std::int32_t, 2> boxes{-1, -1};
    double size = 0.0; // the largest absolute coordinate of the boxes
};

// A tree of boxes. Each box bounds the region where the functions of its items are low.
class CsgBoxTree {
public:
    // {f <= level} lies in the box grown by slope * level, for each level above 0.
    struct Item {
        CsgBox box;
        double slope = 1.0;
        std::int32_t item = 0;
    };
    struct Node {
        CsgBox box;
        double slope = 1.0;
        // The child nodes; if second < 0, the node is a leaf and `first` is its item.
        std::int32_t first = -1, second = -1;

        [[nodiscard]] bool is_leaf() const noexcept { return second < 0; }
        // Returns a lower bound of f at p, or -infinity if no bound is known. The bound also holds if rounding changes
        // places and values by up to `slack`.
        [[nodiscard]] double least(const glm::dvec3& p, double slack) const noexcept {
            const glm::dvec3 below = box.low - p;
            const glm::dvec3 above = p - box.high;
            const double distance = std::max({below.x, below.y, below.z, above.x, above.y, above.z}) - slack;
            return distance > 0.0 ? distance / slope : -std::numeric_limits<double>::infinity();
        }
    };
    // The largest number of nodes on the stack during a walk down the tree. It is enough for 2^16 items, because each
    // level of the tree halves the items.
    static constexpr std::size_t deepest = 32;

    explicit CsgBoxTree(base::Memory& memory) noexcept : nodes_(memory) {}

    // Adds a tree of the items, and reorders them. Returns the index of its root, or -1 if there are no items.
    std::int32_t add(std::span<Item> items);
    // Returns the item with the least bound, or -1 if all bounds are above `limit`. bound_of(node) returns the bound of
    // a leaf node.
    template <class F>
    [[nodiscard]] std::int32_t nearest(std::int32_t root, const glm::dvec3& p, double slack, double limit,
                                       F&& bound_of) const noexcept;

    [[nodiscard]] const Node& operator[](std::int32_t node) const noexcept { return nodes_[node]; }
    [[nodiscard]] std::int64_t bytes() const noexcept { return nodes_.bytes(); }

private:
    base::Array<Node> nodes_;
};

struct CsgPlan {
    enum class Groups : std::uint8_t { never, where_they_pay, always };

    // The tree must be valid: parents come before their children, each inner node has a child, and each transform is
    // invertible. Groups do not change any bit of a result.
    CsgPlan(base::Memory& memory, const CsgTree& tree, const base::Array<CsgModel>& models,
            Groups groups = Groups::where_they_pay);

    [[nodiscard]] const CsgOp& root() const noexcept { return ops[root_op]; }
    [[nodiscard]] const CsgPlace& place(const CsgOp& op) const noexcept { return places[op.place]; }
    [[nodiscard]] std::span<const CsgStep> root_steps() const noexcept {
        return steps.span().first(static_cast<std::size_t>(root_end));
    }
    [[nodiscard]] std::span<const CsgStep> steps_of(const CsgMember& member) const noexcept {
        return steps.span().subspan(static_cast<std::size_t>(member.begin),
                                    static_cast<std::size_t>(member.end - member.begin));
    }
    // An op whose steps are still to be added.
    struct Pending {
        std::int32_t op = 0;
        std::int32_t to = 0;
        std::int32_t sheet = -1;
        std::int32_t combined_by = -1;
        bool done = false; // true after the steps of its operands were added
        bool a_is_second = false;
    };
    // Appends the steps of an op to `to`. `sheet` is the only sheet to evaluate, or -1 for all.
    void add_steps(std::int32_t op, std::int32_t sheet, base::Array<CsgStep>& to, base::Array<Pending>& pending) const;

    // Returns whether the product of all transforms can be inverted in double precision.
    [[nodiscard]] bool is_finite() const noexcept;
    [[nodiscard]] std::int64_t bytes() const noexcept {
        return ops.bytes() + places.bytes() + steps.bytes() + groups.bytes() + members.bytes() + boxes.bytes();
    }

    base::Array<CsgOp> ops; // operands come before the ops that combine them
    base::Array<CsgPlace> places;
    base::Array<CsgStep> steps; // the steps of the root, then of all members
    base::Array<CsgGroup> groups;
    base::Array<CsgMember> members;
    CsgBoxTree boxes;
    std::int64_t root_end = 0; // end of the root's steps
    std::int32_t root_op = 0;
    std::int32_t nested = 0; // the largest depth of nested groups
    // Two bounds of the surface. They differ in the box that is taken for a model: `drawn` uses the box in which the
    // model is drawn, `whole` the box that contains its whole surface.
    CsgBox drawn, whole;
};

template <class F>
std::int32_t CsgBoxTree::nearest(std::int32_t root, const glm::dvec3& p, double slack, double limit,
                                 F&& bound_of) const noexcept {
    struct Part {
        std::int32_t node;
        double least;
    };
    std::array<Part, deepest> waiting;
    std::size_t count = 0;
    std::int32_t item = -1;
    waiting[count++] = {root, -std::numeric_limits<double>::infinity()};
    while (count > 0) {
        const Part part = waiting[--count];
        if (part.least > limit) continue;
        const Node& one = nodes_[part.node];
        if (one.is_leaf()) {
            const double here = bound_of(one);
            if (here > limit || (item >= 0 && here == limit)) continue;
            limit = here;
            item = one.first;
            continue;
        }
        Part near{one.first, nodes_[one.first].least(p, slack)};
        Part far{one.second, nodes_[one.second].least(p, slack)};
        if (far.least < near.least) std::swap(near, far);
        waiting[count++] = far;
        waiting[count++] = near;
    }
    return item;
}

} // namespace hrbfnpr::implicit
