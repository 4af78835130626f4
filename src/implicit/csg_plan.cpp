// SPDX-License-Identifier: MIT
// A plan is made in four steps: 1. frames: the transform of each node of the tree, and whether the node is turned
// inside out; 2. parts: an op for each leaf and for each pair of operands, with bounding boxes; 3. groups: chains of
// minima or of maxima; 4. steps: for the root, and for each member of a group.
#include "implicit/csg_plan.h"

#include "base/assert.h"
#include "implicit/tuning.h"

#include <glm/matrix.hpp>

#include <utility>

namespace hrbfnpr::implicit {
namespace {

// The transform of a node of the tree, and whether the node is turned inside out.
struct Frame {
    glm::dmat3 linear{1.0};
    glm::dvec3 translation{0.0};
    double scale = 1.0;
    bool turned = false;
    std::int32_t first = -1, next = -1; // the first child, and the next sibling
    std::int32_t op = -1;
};

base::Array<Frame> frames_of(base::Memory& memory, const CsgTree& tree) {
    base::Array<Frame> frames(memory);
    for (const CsgNode& node : tree) {
        Frame frame{node.linear, node.translation, stretch_factors(node.linear).least};
        if (node.parent >= 0) {
            HRBFNPR_ASSERT(node.parent < frames.size());
            const Frame& parent = frames[node.parent];
            frame.linear = parent.linear * node.linear;
            frame.translation = parent.linear * node.translation + parent.translation;
            frame.scale *= parent.scale;
        }
        frames.push_back(frame);
    }
    for (std::int64_t i = tree.size() - 1; i > 0; --i)
        frames[i].next = std::exchange(frames[tree[i].parent].first, static_cast<std::int32_t>(i));
    for (std::int64_t i = 1; i < tree.size(); ++i) {
        const std::int64_t parent = tree[i].parent;
        const CsgKind kind = tree[parent].kind;
        const bool turns = kind == CsgKind::complement || (kind == CsgKind::subtract && frames[parent].first != i);
        frames[i].turned = frames[parent].turned != turns;
    }
    return frames;
}

// An op, with two bounds of its solid. They differ in the box that is taken for a model: `drawn` uses the box in which
// the model is drawn, `whole` the box that contains its whole surface.
struct BoundedOp {
    CsgOp op;
    CsgReach drawn, whole;
    std::int32_t models = 0; // number of models in the subtree

    template <class F>
    void set_reaches(F&& reach) noexcept(noexcept(reach(drawn))) {
        drawn = reach(drawn);
        whole = reach(whole);
    }
};

void count_sheets(CsgOp& op, std::int64_t count) noexcept {
    op.merged = count > std::numeric_limits<std::int32_t>::max();
    op.sheets = op.merged ? 1 : static_cast<std::int32_t>(count);
}

BoundedOp pair_of(const BoundedOp& a, const BoundedOp& b, std::int32_t a_op, std::int32_t b_op, bool least,
                  const Blend& blend) {
    BoundedOp both;
    both.op.kind = least ? CsgOp::Kind::minimum : CsgOp::Kind::maximum;
    both.op.a = a_op;
    both.op.b = b_op;
    both.op.blend = blend;
    both.op.registers = std::max({a.op.registers, b.op.registers, std::min(a.op.registers, b.op.registers) + 1});
    const std::int64_t m = a.op.sheets;
    const std::int64_t n = b.op.sheets;
    count_sheets(both.op, blend.radius > 0.0 ? m * n : m + n);
    const bool known = a.op.lipschitz > 0.0 && b.op.lipschitz > 0.0;
    both.op.lipschitz = known ? blend.steepness() * std::max(a.op.lipschitz, b.op.lipschitz) : 0.0;
    const auto reach = least ? reach_of_minimum : reach_of_maximum;
    both.drawn = reach(a.drawn, b.drawn, blend);
    both.whole = reach(a.whole, b.whole, blend);
    both.models = a.models + b.models;
    return both;
}

BoundedOp shell_of(const BoundedOp& part, std::int32_t op, bool least, double thickness) {
    BoundedOp shell = part;
    shell.op = {};
    shell.op.kind = least ? CsgOp::Kind::shell_of_minimum : CsgOp::Kind::shell_of_maximum;
    shell.op.a = op;
    shell.op.thickness = thickness;
    shell.op.registers = part.op.registers;
    shell.op.lipschitz = part.op.lipschitz;
    count_sheets(shell.op, 2 * std::int64_t{part.op.sheets});
    shell.set_reaches([&](const CsgReach& reach) {
        return least ? reach_of_minimum(reach, reach.complement().shifted(thickness), {})
                     : reach_of_maximum(reach, reach.complement().shifted(-thickness), {});
    });
    return shell;
}

BoundedOp leaf_of(const CsgNode& node, const Frame& frame, const base::Array<CsgModel>& models, CsgPlace& place) {
    BoundedOp part;
    place.to_local = glm::inverse(frame.linear);
    place.shift = -(place.to_local * frame.translation);
    place.scale = frame.turned ? -frame.scale : frame.scale;
    if (node.kind == CsgKind::model) {
        HRBFNPR_ASSERT(node.model >= 0 && node.model < models.size());
        const CsgModel& model = models[node.model];
        const auto reach = [&](const geometry::Bounds& bounds) {
            return CsgShape(bounds.size())
                .reach(frame.linear, frame.linear * bounds.centre() + frame.translation, frame.scale);
        };
        part.models = 1;
        part.op.kind = CsgOp::Kind::model;
        part.op.lipschitz = model.lipschitz > 0.0 ? std::max(1.0, model.lipschitz) : 0.0;
        count_sheets(part.op, std::int64_t{model.sheets} + 6);
        part.drawn = reach(model.bounds);
        part.whole = place.reach = reach(model.region);
        place.model = static_cast<std::int32_t>(node.model);
        place.model_sheets = model.sheets;
        place.centre = model.region.centre();
        place.shape = CsgShape(model.region.size());
    } else {
        place.shape = CsgShape(node);
        part.op.sheets = place.shape.sheets();
        part.drawn = part.whole = place.shape.reach(frame.linear, frame.translation, frame.scale);
    }
    if (frame.turned) part.set_reaches([](const CsgReach& reach) { return reach.complement(); });
    return part;
}

// Returns a part for each node of the tree. The part of the root is the last.
base::Array<BoundedOp> parts_of(base::Memory& memory, const CsgTree& tree, const base::Array<CsgModel>& models,
                                base::Array<CsgPlace>& places) {
    base::Array<Frame> frames = frames_of(memory, tree);
    base::Array<BoundedOp> parts(memory);
    const auto add = [&](const BoundedOp& part) {
        parts.push_back(part);
        return static_cast<std::int32_t>(parts.size() - 1);
    };
    for (std::int64_t i = tree.size() - 1; i >= 0; --i) {
        const CsgNode& node = tree[i];
        Frame& frame = frames[i];
        if (is_leaf(node.kind)) {
            CsgPlace place;
            BoundedOp part = leaf_of(node, frame, models, place);
            part.op.place = static_cast<std::int32_t>(places.size());
            places.push_back(place);
            frame.op = add(part);
            continue;
        }
        frame.op = frames[frame.first].op;
        if (node.kind == CsgKind::offset) {
            const double more = (frame.turned ? node.distance : -node.distance) * frame.scale;
            parts[frame.op].op.add += more;
            parts[frame.op].set_reaches([&](const CsgReach& reach) { return reach.shifted(more); });
        } else if (node.kind == CsgKind::shell) {
            frame.op = add(shell_of(parts[frame.op], frame.op, frame.turned, node.distance * frame.scale));
        } else if (node.kind != CsgKind::complement) {
            const bool least = (node.kind == CsgKind::unite) != frame.turned;
            const Blend blend{node.blend * frame.scale, node.exponent};
            for (std::int32_t child = frames[frame.first].next; child >= 0; child = frames[child].next) {
                const std::int32_t b = frames[child].op;
                frame.op = add(pair_of(parts[frame.op], parts[b], frame.op, b, least, blend));
            }
        }
    }
    return parts;
}

// Finds the operands of a chain of minima or of maxima, in order.
void find_members(const base::Array<BoundedOp>& parts, const CsgOp& of, base::Array<std::int32_t>& waiting,
                  base::Array<std::int32_t>& found) {
    found.clear();
    waiting.clear();
    waiting.push_back(of.b);
    waiting.push_back(of.a);
    while (!waiting.empty()) {
        const std::int32_t next = waiting.back();
        waiting.resize(waiting.size() - 1);
        const CsgOp& op = parts[next].op;
        if (op.is_sharp() && op.kind == of.kind && op.add == 0.0 && !op.merged) {
            waiting.push_back(op.b);
            waiting.push_back(op.a);
        } else {
            found.push_back(next);
        }
    }
}

CsgGroup group_of(CsgPlan& plan, const base::Array<BoundedOp>& parts, std::int32_t op,
                  const base::Array<std::int32_t>& found) {
    const CsgOp& of = plan.ops[op];
    CsgGroup group;
    group.op = op;
    std::int32_t sheets = 0;
    base::Array<CsgBoxTree::Item> items(found.memory());
    for (const std::int32_t part : found) {
        const CsgReach& whole = parts[part].whole;
        const CsgReach reach = of.takes_least() ? whole : whole.complement();
        for (int axis = 0; axis < 3; ++axis)
            for (const double end : {reach.inside.low[axis], reach.inside.high[axis]})
                if (std::isfinite(end)) group.size = std::max(group.size, std::abs(end));
        items.push_back({reach.inside, reach.slope, static_cast<std::int32_t>(plan.members.size())});
        plan.members.push_back({part, sheets, 0, 0});
        sheets += of.merged ? 0 : plan.ops[part].sheets;
    }
    const auto dear = std::partition(items.begin(), items.end(), [&](const CsgBoxTree::Item& item) {
        return parts[plan.members[item.item].op].models == 0;
    });
    group.boxes = {plan.boxes.add({items.begin(), dear}), plan.boxes.add({dear, items.end()})};
    return group;
}

// Makes groups where they are faster than pairs. If `always` is true, it makes them everywhere.
void make_groups(CsgPlan& plan, const base::Array<BoundedOp>& parts, bool always) {
    struct Task {
        std::int32_t op;
        std::int32_t nested; // number of groups that contain the op
    };
    base::Memory& memory = plan.ops.memory();
    base::Array<Task> tasks(memory);
    base::Array<std::int32_t> found(memory), waiting(memory);
    const auto pays = [&] {
        const auto dear =
            std::count_if(found.begin(), found.end(), [&](std::int32_t op) { return parts[op].models > 0; });
        return always || dear >= 2 || found.size() >= (dear == 1 ? csg_tuning.beside_model : csg_tuning.primitives);
    };
    tasks.push_back({plan.root_op, 0});
    while (!tasks.empty()) {
        const Task task = tasks.back();
        tasks.resize(tasks.size() - 1);
        CsgOp& op = plan.ops[task.op];
        if (op.is_leaf()) continue;
        const bool may = op.is_sharp() && task.nested < csg_tuning.nested;
        if (may) find_members(parts, op, waiting, found);
        if (may && pays()) {
            op.group = static_cast<std::int32_t>(plan.groups.size());
            plan.groups.push_back(group_of(plan, parts, task.op, found));
            plan.nested = std::max(plan.nested, task.nested + 1);
            for (const std::int32_t part : found) tasks.push_back({part, task.nested + 1});
            continue;
        }
        for (const std::int32_t part : {op.a, op.b})
            if (part >= 0) tasks.push_back({part, task.nested});
    }
}

} // namespace

CsgPlan::CsgPlan(base::Memory& memory, const CsgTree& tree, const base::Array<CsgModel>& models, Groups how)
    : ops(memory), places(memory), steps(memory), groups(memory), members(memory), boxes(memory) {
    HRBFNPR_ASSERT(!tree.empty() && tree[0].parent < 0);
    const base::Array<BoundedOp> parts = parts_of(memory, tree, models, places);
    for (const BoundedOp& part : parts) ops.push_back(part.op);
    root_op = static_cast<std::int32_t>(ops.size() - 1);
    drawn = parts[root_op].drawn.surface();
    whole = parts[root_op].whole.surface();
    if (how != Groups::never) make_groups(*this, parts, how == Groups::always);
    base::Array<Pending> pending(memory);
    add_steps(root_op, -1, steps, pending);
    root_end = steps.size();
    for (CsgMember& member : members) {
        member.begin = steps.size();
        add_steps(member.op, -1, steps, pending);
        member.end = steps.size();
    }
}

bool CsgPlan::is_finite() const noexcept {
    return std::all_of(places.begin(), places.end(), [](const CsgPlace& place) {
        double sum = glm::dot(place.shift, place.shift);
        for (int column = 0; column < 3; ++column) sum += glm::dot(place.to_local[column], place.to_local[column]);
        return std::isfinite(sum) && std::isfinite(1.0 / place.scale) && std::isfinite(place.scale);
    });
}

// Orders the operands of an op: the operand that needs more registers comes first. A model comes last, because the
// other operand may show that the model is not needed.
void CsgPlan::add_steps(std::int32_t op, std::int32_t only, base::Array<CsgStep>& to,
                        base::Array<Pending>& pending) const {
    HRBFNPR_ASSERT(op >= 0 && op < ops.size() && only < ops[op].sheets);
    pending.clear();
    pending.push_back({op, 0, only, -1, false, false});
    while (!pending.empty()) {
        Pending task = pending.back();
        pending.resize(pending.size() - 1);
        const CsgOp& of = ops[task.op];
        if (of.merged) task.sheet = -1;
        const bool grouped = of.group >= 0 && task.sheet < 0;
        if (of.is_leaf() || grouped || task.done) {
            const auto kind = of.is_leaf()    ? CsgStep::Kind::leaf
                              : grouped       ? CsgStep::Kind::group
                              : of.is_shell() ? CsgStep::Kind::shell
                                              : CsgStep::Kind::combine;
            to.push_back({kind, task.a_is_second, task.op, task.to, task.sheet, task.combined_by});
            continue;
        }
        task.done = true;
        const CsgOp& a = ops[of.a];
        const std::int32_t sheet = task.sheet;
        if (of.is_shell() || (sheet >= 0 && of.is_sharp())) {
            const bool second = sheet >= a.sheets;
            pending.push_back(task);
            pending.push_back({second && !of.is_shell() ? of.b : of.a, task.to, second ? sheet - a.sheets : sheet});
            continue;
        }
        const CsgOp& b = ops[of.b];
        task.a_is_second = b.kind != CsgOp::Kind::model && (a.kind == CsgOp::Kind::model || b.registers > a.registers);
        Pending first{of.a, task.to, sheet >= 0 ? sheet / b.sheets : -1};
        Pending second{of.b, task.to, sheet >= 0 ? sheet % b.sheets : -1};
        if (task.a_is_second) std::swap(first, second);
        ++second.to;
        second.combined_by = sheet < 0 ? task.op : -1;
        pending.push_back(task);
        pending.push_back(second);
        pending.push_back(first);
    }
}

// Splits the items into two halves along the axis on which their centres are spread most. Adds a tree of each half.
std::int32_t CsgBoxTree::add(std::span<Item> items) {
    if (items.empty()) return -1;
    if (items.size() == 1) {
        nodes_.push_back({items[0].box, items[0].slope, items[0].item, -1});
        return static_cast<std::int32_t>(nodes_.size() - 1);
    }
    // Returns twice the coordinate of the centre, or 0 for a box that is infinite along the axis.
    const auto centre = [](const Item& item, int axis) {
        const double sum = item.box.low[axis] + item.box.high[axis];
        return std::isfinite(sum) ? sum : 0.0;
    };
    int widest = 0;
    double width = -1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto [low, high] = std::minmax_element(items.begin(), items.end(), [&](const Item& a, const Item& b) {
            return centre(a, axis) < centre(b, axis);
        });
        const double between = centre(*high, axis) - centre(*low, axis);
        if (between > width) {
            width = between;
            widest = axis;
        }
    }
    std::sort(items.begin(), items.end(), [&](const Item& a, const Item& b) {
        return std::pair(centre(a, widest), a.item) < std::pair(centre(b, widest), b.item);
    });
    const std::size_t half = items.size() / 2;
    const std::int32_t first = add(items.first(half));
    const std::int32_t second = add(items.subspan(half));
    const Node& a = nodes_[first];
    const Node& b = nodes_[second];
    // An empty box has low > high, and distances from it are still computed from its faces.
    const CsgBox box{glm::min(a.box.low, b.box.low), glm::max(a.box.high, b.box.high)};
    nodes_.push_back({box, std::max(a.slope, b.slope), first, second});
    return static_cast<std::int32_t>(nodes_.size() - 1);
}

} // namespace hrbfnpr::implicit
