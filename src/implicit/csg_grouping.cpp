// SPDX-License-Identifier: MIT
#include "implicit/csg_grouping.h"

namespace hrbfnpr::implicit {
namespace {

constexpr std::int32_t most_nested = 8; // each takes a part of the stack
// Plain pairs of so few primitives are quicker.
constexpr std::int64_t many = 16;
constexpr std::int64_t some = 3; // with a model among them

bool is_sharp(const CsgOp& op) noexcept { return !op.is_leaf() && !op.is_shell() && op.blend.radius == 0.0; }

} // namespace

CsgPlan::Grouping::Grouping(CsgPlan& plan, const base::Array<Reaches>& reaches, bool always)
    : plan_(plan), reaches_(reaches), always_(always), models_(plan.ops_.memory(), plan.ops_.size()),
      tasks_(plan.ops_.memory()), found_(plan.ops_.memory()), waiting_(plan.ops_.memory()), boxes_(plan.ops_.memory()) {
    for (std::int64_t i = 0; i < plan.ops_.size(); ++i) {
        const CsgOp& op = plan.ops_[i];
        models_[i] = op.kind == CsgOp::Kind::model ? 1 : 0;
        for (const std::int32_t part : {op.a, op.b})
            if (part >= 0) models_[i] += models_[part];
    }
}

void CsgPlan::Grouping::run() {
    tasks_.push_back({plan_.root_, 0});
    while (!tasks_.empty()) {
        const Task task = tasks_.back();
        tasks_.resize(tasks_.size() - 1);
        visit(task);
    }
}

void CsgPlan::Grouping::visit(const Task& task) {
    const CsgOp& op = plan_.ops_[task.op];
    if (op.is_leaf()) return;
    if (is_sharp(op) && task.nested < most_nested) {
        collect(task.op);
        if (pays()) return make(task);
    }
    for (const std::int32_t part : {op.a, op.b})
        if (part >= 0) tasks_.push_back({part, task.nested});
}

// Whether a part of a minimum is one itself, of the same operands.
bool CsgPlan::Grouping::joins(const CsgOp& op, const CsgOp& of) const noexcept {
    return is_sharp(op) && op.kind == of.kind && op.add == 0.0 && !op.merged;
}

void CsgPlan::Grouping::collect(std::int32_t op) {
    const CsgOp& of = plan_.ops_[op];
    found_.clear();
    waiting_.clear();
    waiting_.push_back(of.b);
    waiting_.push_back(of.a);
    while (!waiting_.empty()) {
        const std::int32_t next = waiting_.back();
        waiting_.resize(waiting_.size() - 1);
        const CsgOp& part = plan_.ops_[next];
        if (joins(part, of)) {
            waiting_.push_back(part.b);
            waiting_.push_back(part.a);
        } else {
            found_.push_back(next);
        }
    }
}

bool CsgPlan::Grouping::pays() const noexcept {
    const auto dear = std::count_if(found_.begin(), found_.end(), [&](std::int32_t op) { return models_[op] > 0; });
    return always_ || dear >= 2 || found_.size() >= (dear == 1 ? some : many);
}

CsgBounded CsgPlan::Grouping::bounded(std::int32_t member, bool least, double& size) const noexcept {
    const CsgReach& whole = reaches_[plan_.members_[member].op].whole;
    const CsgReach reach = least ? whole : whole.turned();
    for (int axis = 0; axis < 3; ++axis)
        for (const double end : {reach.inside.low[axis], reach.inside.high[axis]})
            if (std::isfinite(end)) size = std::max(size, std::abs(end));
    return {reach.inside, reach.slope, member};
}

void CsgPlan::Grouping::make(const Task& task) {
    CsgOp& op = plan_.ops_[task.op];
    op.group = static_cast<std::int32_t>(plan_.groups_.size());
    plan_.nested_ = std::max(plan_.nested_, task.nested + 1);
    CsgGroup group;
    group.op = task.op;
    group.first_member = static_cast<std::int32_t>(plan_.members_.size());
    std::int32_t sheets = 0;
    for (const std::int32_t part : found_) {
        plan_.members_.push_back({part, sheets, 0, 0});
        sheets += op.merged ? 0 : plan_.ops_[part].sheets;
        tasks_.push_back({part, task.nested + 1});
    }
    for (const bool dear : {false, true}) {
        boxes_.clear();
        for (std::int64_t i = 0; i < found_.size(); ++i)
            if ((models_[found_[i]] > 0) == dear)
                boxes_.push_back(
                    bounded(group.first_member + static_cast<std::int32_t>(i), op.takes_least(), group.size));
        group.boxes[dear ? 1 : 0] = plan_.boxes_.add(boxes_.span());
    }
    plan_.groups_.push_back(group);
}

} // namespace hrbfnpr::implicit
