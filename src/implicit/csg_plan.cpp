// SPDX-License-Identifier: MIT
#include "implicit/csg_grouping.h"

#include <glm/matrix.hpp>

#include <utility>

namespace hrbfnpr::implicit {
namespace {

constexpr std::int64_t most_sheets = std::numeric_limits<std::int32_t>::max();

// Where a node of the tree is, and whether what is inside there is outside here.
struct Frame {
    glm::dmat3 linear{1.0};
    glm::dvec3 translation{0.0};
    double scale = 1.0;
    bool turned = false;
    std::int32_t first = -1, next = -1; // child, sibling
    std::int32_t op = -1;
};

} // namespace

// Singular values: columns turned until they are at right angles [Hestenes 1958].
Stretch stretch_of(const glm::dmat3& linear) noexcept {
    const double size = std::max({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])});
    if (!(size > 0.0 && std::isfinite(size))) return {0.0, size};
    glm::dmat3 m = linear / size;
    constexpr int most_sweeps = 30;
    bool turned = true;
    for (int sweep = 0; sweep < most_sweeps && turned; ++sweep) {
        turned = false;
        for (const auto& [p, q] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
            const double slant = glm::dot(m[p], m[q]);
            if (std::abs(slant) <= 1e-16 * glm::length(m[p]) * glm::length(m[q])) continue;
            turned = true;
            const double ratio = 0.5 * (glm::dot(m[q], m[q]) - glm::dot(m[p], m[p])) / slant;
            const double tangent = std::copysign(1.0, ratio) / (std::abs(ratio) + std::hypot(1.0, ratio));
            const double c = 1.0 / std::hypot(1.0, tangent);
            const glm::dvec3 column = m[p];
            m[p] = c * (column - tangent * m[q]);
            m[q] = c * (tangent * column + m[q]);
        }
    }
    const double a = glm::length(m[0]);
    const double b = glm::length(m[1]);
    const double d = glm::length(m[2]);
    return {size * std::min({a, b, d}), size * std::max({a, b, d})};
}

class CsgPlan::Builder {
public:
    Builder(CsgPlan& plan, base::Memory& memory, const CsgTree& tree, const base::Array<CsgModel>& models)
        : plan_(plan), tree_(tree), models_(models), frames_(memory, tree.size()), reaches_(memory) {}

    void run() {
        place_all();
        for (std::int64_t i = tree_.size() - 1; i >= 0; --i) frames_[i].op = op_of(i);
        plan_.root_ = frames_[0].op;
        plan_.drawn_ = reaches_[plan_.root_].drawn;
        plan_.whole_ = reaches_[plan_.root_].whole;
    }
    [[nodiscard]] const base::Array<Reaches>& reaches() const noexcept { return reaches_; }

private:
    // From the root down.
    void place_all() {
        for (std::int64_t i = 0; i < tree_.size(); ++i) {
            const CsgNode& node = tree_[i];
            Frame frame;
            frame.linear = node.linear;
            frame.translation = node.translation;
            frame.scale = stretch_of(node.linear).least;
            if (node.parent >= 0) {
                const Frame& parent = frames_[node.parent];
                frame.linear = parent.linear * node.linear;
                frame.translation = parent.linear * node.translation + parent.translation;
                frame.scale *= parent.scale;
            }
            frames_[i] = frame;
        }
        for (std::int64_t i = tree_.size() - 1; i > 0; --i) {
            Frame& parent = frames_[tree_[i].parent];
            frames_[i].next = parent.first;
            parent.first = static_cast<std::int32_t>(i);
        }
        turn_all();
    }
    void turn_all() {
        for (std::int64_t i = 1; i < tree_.size(); ++i) {
            const std::int64_t parent = tree_[i].parent;
            const CsgKind kind = tree_[parent].kind;
            const bool turns = kind == CsgKind::complement || (kind == CsgKind::subtract && frames_[parent].first != i);
            frames_[i].turned = frames_[parent].turned != turns;
        }
    }

    std::int32_t op_of(std::int64_t i) {
        const CsgNode& node = tree_[i];
        const Frame& frame = frames_[i];
        switch (node.kind) {
        case CsgKind::complement: return frames_[frame.first].op;
        case CsgKind::offset: return shifted(frames_[frame.first].op, frame, node.distance);
        case CsgKind::shell: return shell(frames_[frame.first].op, frame, node.distance);
        case CsgKind::unite:
        case CsgKind::intersect:
        case CsgKind::subtract: return combination(node, frame);
        default: return leaf(node, frame);
        }
    }

    std::int32_t push(const CsgOp& op, const Reaches& reach) {
        plan_.ops_.push_back(op);
        reaches_.push_back(reach);
        return static_cast<std::int32_t>(plan_.ops_.size() - 1);
    }

    std::int32_t shifted(std::int32_t at, const Frame& frame, double distance) {
        const double add = (frame.turned ? distance : -distance) * frame.scale;
        plan_.ops_[at].add += add;
        Reaches& reach = reaches_[at];
        reach = {reach.drawn.shifted(add), reach.whole.shifted(add)};
        return at;
    }

    static CsgReach shell_of(const CsgReach& reach, double thickness, bool least) noexcept {
        return least ? reach_of_minimum(reach, reach.turned().shifted(thickness), {})
                     : reach_of_maximum(reach, reach.turned().shifted(-thickness), {});
    }

    std::int32_t shell(std::int32_t at, const Frame& frame, double distance) {
        CsgOp op;
        op.kind = frame.turned ? CsgOp::Kind::shell_of_minimum : CsgOp::Kind::shell_of_maximum;
        op.a = at;
        op.thickness = distance * frame.scale;
        op.registers = plan_.ops_[at].registers;
        op.lipschitz = plan_.ops_[at].lipschitz;
        count_sheets(op, 2 * std::int64_t{plan_.ops_[at].sheets});
        const Reaches reach = reaches_[at];
        return push(
            op, {shell_of(reach.drawn, op.thickness, frame.turned), shell_of(reach.whole, op.thickness, frame.turned)});
    }

    std::int32_t combination(const CsgNode& node, const Frame& frame) {
        const bool least = (node.kind == CsgKind::unite) != frame.turned;
        std::int32_t all = frames_[frame.first].op;
        for (std::int32_t child = frames_[frame.first].next; child >= 0; child = frames_[child].next)
            all = pair(all, frames_[child].op, least, {node.blend * frame.scale, node.exponent});
        return all;
    }

    std::int32_t pair(std::int32_t a, std::int32_t b, bool least, const Blend& blend) {
        const CsgOp& one = plan_.ops_[a];
        const CsgOp& other = plan_.ops_[b];
        CsgOp op;
        op.kind = least ? CsgOp::Kind::minimum : CsgOp::Kind::maximum;
        op.a = a;
        op.b = b;
        op.blend = blend;
        op.registers = std::max({one.registers, other.registers, std::min(one.registers, other.registers) + 1});
        const std::int64_t m = one.sheets;
        const std::int64_t n = other.sheets;
        count_sheets(op, blend.radius > 0.0 ? m * n : m + n);
        const bool known = one.lipschitz > 0.0 && other.lipschitz > 0.0;
        const double steeper = blend.radius > 0.0 ? blend.steepness() : 1.0;
        op.lipschitz = known ? steeper * std::max(one.lipschitz, other.lipschitz) : 0.0;
        const auto reach = [&](const CsgReach& of_a, const CsgReach& of_b) {
            return least ? reach_of_minimum(of_a, of_b, blend) : reach_of_maximum(of_a, of_b, blend);
        };
        const Reaches both{reach(reaches_[a].drawn, reaches_[b].drawn), reach(reaches_[a].whole, reaches_[b].whole)};
        return push(op, both);
    }

    static void count_sheets(CsgOp& op, std::int64_t count) noexcept {
        op.merged = count > most_sheets;
        op.sheets = op.merged ? 1 : static_cast<std::int32_t>(count);
    }

    std::int32_t leaf(const CsgNode& node, const Frame& frame) {
        CsgPlace place;
        place.to_local = glm::inverse(frame.linear);
        place.shift = -(place.to_local * frame.translation);
        place.scale = frame.turned ? -frame.scale : frame.scale;
        place.shape = CsgShape(node);
        CsgOp op;
        op.place = static_cast<std::int32_t>(plan_.places_.size());
        Reaches reach;
        if (node.kind == CsgKind::model) {
            reach = place_model(node, frame, place, op);
        } else {
            op.sheets = place.shape.sheets();
            const CsgReach both = reach_of(place.shape, frame.linear, frame.translation, frame.scale);
            reach = {both, both};
        }
        if (frame.turned) reach = {reach.drawn.turned(), reach.whole.turned()};
        plan_.places_.push_back(place);
        return push(op, reach);
    }

    Reaches place_model(const CsgNode& node, const Frame& frame, CsgPlace& place, CsgOp& op) {
        const CsgModel& model = models_[node.model];
        op.kind = CsgOp::Kind::model;
        op.lipschitz = model.lipschitz > 0.0 ? std::max(1.0, model.lipschitz) : 0.0;
        count_sheets(op, std::int64_t{model.sheets} + 6);
        place.model = static_cast<std::int32_t>(node.model);
        place.model_sheets = model.sheets;
        place.centre = model.region.centre();
        place.shape = box_of(model.region);
        const auto reach = [&](const geometry::Bounds& bounds) {
            return reach_of(box_of(bounds), frame.linear, frame.linear * bounds.centre() + frame.translation,
                            frame.scale);
        };
        place.reach = reach(model.region);
        return {reach(model.bounds), place.reach};
    }
    static CsgShape box_of(const geometry::Bounds& bounds) noexcept {
        CsgNode box;
        box.kind = CsgKind::box;
        box.size = bounds.size();
        return CsgShape(box);
    }

    CsgPlan& plan_;
    const CsgTree& tree_;
    const base::Array<CsgModel>& models_;
    base::Array<Frame> frames_;
    base::Array<Reaches> reaches_; // of each op
};

CsgPlan::CsgPlan(base::Memory& memory, const CsgTree& tree, const base::Array<CsgModel>& models, Groups groups)
    : ops_(memory), places_(memory), steps_(memory), groups_(memory), members_(memory), boxes_(memory) {
    Builder builder(*this, memory, tree, models);
    builder.run();
    if (groups != Groups::never) Grouping(*this, builder.reaches(), groups == Groups::always).run();
    base::Array<Pending> pending(memory);
    add_steps(root_, -1, steps_, pending);
    root_steps_ = steps_.size();
    for (CsgMember& member : members_) {
        member.begin = steps_.size();
        add_steps(member.op, -1, steps_, pending);
        member.end = steps_.size();
    }
}

bool CsgPlan::is_finite() const noexcept {
    return std::all_of(places_.begin(), places_.end(), [](const CsgPlace& place) {
        double sum = glm::dot(place.shift, place.shift);
        for (int column = 0; column < 3; ++column) sum += glm::dot(place.to_local[column], place.to_local[column]);
        return std::isfinite(sum) && std::isfinite(1.0 / place.scale) && std::isfinite(place.scale);
    });
}

void CsgPlan::make_steps(std::int32_t sheet, base::Array<CsgStep>& steps, base::Array<Pending>& pending) const {
    steps.clear();
    add_steps(root_, sheet, steps, pending);
}

void CsgPlan::add_steps(std::int32_t op, std::int32_t sheet, base::Array<CsgStep>& steps,
                        base::Array<Pending>& pending) const {
    pending.clear();
    pending.push_back({op, 0, sheet, -1, false, false});
    while (!pending.empty()) {
        const Pending task = pending.back();
        pending.resize(pending.size() - 1);
        visit(task, steps, pending);
    }
}

void CsgPlan::visit(const Pending& task, base::Array<CsgStep>& steps, base::Array<Pending>& pending) const {
    const CsgOp& op = ops_[task.op];
    const std::int32_t sheet = op.merged ? -1 : task.sheet;
    const bool grouped = op.group >= 0 && sheet < 0;
    if (op.is_leaf() || grouped || task.done) {
        const auto kind = op.is_leaf()    ? CsgStep::Kind::leaf
                          : grouped       ? CsgStep::Kind::group
                          : op.is_shell() ? CsgStep::Kind::shell
                                          : CsgStep::Kind::combine;
        steps.push_back({kind, task.a_is_second, task.op, task.to, sheet, task.than});
        return;
    }
    Pending rest = task;
    rest.done = true;
    rest.sheet = sheet;
    if (op.is_shell() || (sheet >= 0 && op.blend.radius == 0.0)) {
        const std::int32_t first = ops_[op.a].sheets;
        const bool second = sheet >= first;
        pending.push_back(rest);
        pending.push_back(
            {second && !op.is_shell() ? op.b : op.a, task.to, second ? sheet - first : sheet, -1, false, false});
        return;
    }
    visit_both(rest, pending);
}

// The one that needs more registers first; a model after what may show that it is not needed.
void CsgPlan::visit_both(const Pending& task, base::Array<Pending>& pending) const {
    const CsgOp& op = ops_[task.op];
    const CsgOp& a = ops_[op.a];
    const CsgOp& b = ops_[op.b];
    Pending rest = task;
    rest.a_is_second = b.kind != CsgOp::Kind::model && (a.kind == CsgOp::Kind::model || b.registers > a.registers);
    const std::int32_t of_b = task.sheet >= 0 ? task.sheet % b.sheets : -1;
    const std::int32_t of_a = task.sheet >= 0 ? task.sheet / b.sheets : -1;
    const std::int32_t than = task.sheet < 0 ? task.op : -1;
    pending.push_back(rest);
    if (rest.a_is_second) {
        pending.push_back({op.a, task.to + 1, of_a, than, false, false});
        pending.push_back({op.b, task.to, of_b, -1, false, false});
    } else {
        pending.push_back({op.b, task.to + 1, of_b, than, false, false});
        pending.push_back({op.a, task.to, of_a, -1, false, false});
    }
}

} // namespace hrbfnpr::implicit
