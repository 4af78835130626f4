// SPDX-License-Identifier: MIT
// The least of many members at each point of a block, from those alone that can be it.
#include "implicit/csg_run.h"

namespace hrbfnpr::implicit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Of numbers: what places and values are off by at most, for bounds that no rounding passes, whatever stretches them.
constexpr double rounding = 1e-7;

} // namespace

class Csg::Run::GroupRun {
public:
    GroupRun(Run& run, const CsgGroup& group, const PointBatch& points, CsgRegister& to)
        : run_(run), group_(group), op_(run.plan_.ops()[group.op]), points_(points),
          lanes_(run.scratch_.lanes[run.nested_]), to_(to), sign_(op_.takes_least() ? 1.0 : -1.0) {
        for (std::int64_t i = 0; i < points.count; ++i) {
            const glm::dvec3 p = glm::abs(place(i));
            lanes_.best[i] = infinity;
            lanes_.winner[i] = -1;
            lanes_.slack[i] = rounding * (group.size + std::max({p.x, p.y, p.z}));
        }
    }

    void operator()() {
        for (const std::int32_t root : group_.boxes) {
            if (root < 0) continue;
            ask_nearest(root);
            ask_others(root);
        }
        for (std::int64_t i = 0; i < points_.count; ++i) to_.value[i] += op_.add;
    }

private:
    [[nodiscard]] glm::dvec3 place(std::int64_t i) const noexcept { return {points_.x[i], points_.y[i], points_.z[i]}; }
    [[nodiscard]] const CsgBoxTree::Node& node(std::int32_t i) const noexcept { return run_.plan_.boxes()[i]; }

    // What a member is at least at a point: of a model by its own box, which may be turned, exactly.
    [[nodiscard]] double least(const CsgBoxTree::Node& leaf, std::int64_t lane) const noexcept {
        const CsgOp& op = run_.plan_.ops()[run_.plan_.member(leaf.first).op];
        if (op.kind != CsgOp::Kind::model) return leaf.least(place(lane), lanes_.slack[lane]);
        const CsgPlace& at = run_.plan_.place(op);
        if (sign_ * at.scale < 0.0) return -infinity;
        std::int32_t side = 0;
        const double beyond = at.shape.value(local(at, points_, lane) - at.centre, side);
        return sign_ * (at.scale * beyond + op.add);
    }

    void ask_nearest(std::int32_t root) {
        std::int64_t count = 0;
        for (std::int64_t i = 0; i < points_.count; ++i) {
            lanes_.nearest[i] =
                run_.plan_.boxes().nearest(root, place(i), lanes_.slack[i], lanes_.best[i],
                                           [&](const CsgBoxTree::Node& leaf) { return least(leaf, i); });
            if (lanes_.nearest[i] >= 0) lanes_.lane[count++] = static_cast<std::int32_t>(i);
        }
        std::sort(lanes_.lane, lanes_.lane + count, [&](std::int32_t a, std::int32_t b) {
            return std::pair(lanes_.nearest[a], a) < std::pair(lanes_.nearest[b], b);
        });
        for (std::int64_t begin = 0, end = 0; begin < count; begin = end) {
            const std::int32_t member = lanes_.nearest[lanes_.lane[begin]];
            while (end < count && lanes_.nearest[lanes_.lane[end]] == member) ++end;
            ask(member, lanes_.lane + begin, end - begin);
        }
    }

    // What is in a node, of the points that it may be the least at.
    void ask_others(std::int32_t root) {
        struct Part {
            std::int32_t node;
            std::int64_t count; // of the lanes in front
        };
        std::array<Part, CsgBoxTree::deepest> waiting;
        std::size_t parts = 0;
        for (std::int64_t i = 0; i < points_.count; ++i) lanes_.lane[i] = static_cast<std::int32_t>(i);
        waiting[parts++] = {root, points_.count};
        while (parts > 0) {
            const Part part = waiting[--parts];
            const CsgBoxTree::Node& one = node(part.node);
            const auto may_be_least = [&](std::int32_t lane) {
                if (!one.is_leaf()) return !(one.least(place(lane), lanes_.slack[lane]) > lanes_.best[lane]);
                return lanes_.nearest[lane] != one.first && !(least(one, lane) > lanes_.best[lane]);
            };
            const std::int64_t count =
                std::partition(lanes_.lane, lanes_.lane + part.count, may_be_least) - lanes_.lane;
            if (count == 0) continue;
            if (one.is_leaf()) {
                ask(one.first, lanes_.lane, count);
                continue;
            }
            waiting[parts++] = {one.second, count};
            waiting[parts++] = {one.first, count};
        }
    }

    // One member, at some of the points.
    void ask(std::int32_t member, const std::int32_t* lanes, std::int64_t count) {
        for (std::int64_t k = 0; k < count; ++k) {
            const glm::dvec3 p = place(lanes[k]);
            for (int c = 0; c < 3; ++c) lanes_.at[c][k] = p[c];
        }
        CsgRegister* const own = run_.registers_;
        CsgRegister* const answer = own + run_.plan_.registers();
        const CsgMember& part = run_.plan_.member(member);
        run_.registers_ = answer;
        ++run_.nested_;
        run_.run(run_.plan_.steps_of(part), {lanes_.at[0], lanes_.at[1], lanes_.at[2], count});
        --run_.nested_;
        run_.registers_ = own;
        for (std::int64_t k = 0; k < count; ++k)
            if (is_less(member, lanes[k], sign_ * answer->value[k])) take_over(member, lanes[k], *answer, k);
    }

    // As in pairs, one after the other: of two that are equal the first, and NaN stays.
    [[nodiscard]] bool is_less(std::int32_t member, std::int64_t lane, double value) const noexcept {
        const double best = lanes_.best[lane];
        if (lanes_.winner[lane] < 0 || value < best) return true;
        if (value == best) return member < lanes_.winner[lane];
        return std::isnan(value) && (!std::isnan(best) || member > lanes_.winner[lane]);
    }

    void take_over(std::int32_t member, std::int64_t lane, const CsgRegister& answer, std::int64_t k) noexcept {
        lanes_.best[lane] = sign_ * answer.value[k];
        lanes_.winner[lane] = member;
        run_.set(to_, lane, run_.take(answer, k));
        if (!run_.wanted_.sheet) return;
        to_.sheet[lane] = op_.merged ? 0 : answer.sheet[k] + run_.plan_.member(member).first_sheet;
    }

    Run& run_;
    const CsgGroup& group_;
    const CsgOp& op_;
    const PointBatch& points_;
    CsgLanes& lanes_;
    CsgRegister& to_;
    double sign_;
};

void Csg::Run::group(const CsgStep& step, const CsgOp& op, const PointBatch& points) {
    GroupRun(*this, plan_.group(op), points, registers_[step.to])();
}

} // namespace hrbfnpr::implicit
