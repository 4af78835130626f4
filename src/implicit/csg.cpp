// SPDX-License-Identifier: MIT
// Runs the steps of a plan for one block of points after another. Each step fills a register, which holds an
// intermediate result at all points of the block. A leaf is computed from coordinates; a minimum, maximum or blend is
// computed from two registers. A model is evaluated only at points where, judged by its box, it can affect the result.
// A group first evaluates, at each point, the member whose box is nearest. Then it evaluates the members whose boxes
// allow a lower value. Points that need the same member are evaluated together.
#include "implicit/csg.h"

#include "implicit/lanes.h"
#include "implicit/tuning.h"

#include <numeric>
#include <utility>

namespace hrbfnpr::implicit {
namespace {

constexpr std::int64_t csg_block = CsgTuning::block;
constexpr double infinity = std::numeric_limits<double>::infinity();

// An intermediate result at all points of a block.
struct Register : FieldLanes<std::size_t{csg_block}> {
    std::int32_t sheet[csg_block];
};

// The members of a group at the points of a block.
struct GroupSearch {
    const CsgOp* op;
    PointBatch points;
    Register* to;
    double sign;            // 1 if the group is a minimum, -1 if it is a maximum
    double best[csg_block]; // the least value of sign * f until now
    double slack[csg_block];
    std::int32_t least_member[csg_block]; // the member with that value; -1: none yet
    std::int32_t nearest[csg_block];      // the member that was evaluated first
    // indices of points in the block; the points that are still being searched come first
    std::int32_t lane[csg_block];
    PointLanes<std::size_t{csg_block}> asked; // the points at which a member is evaluated
};

// Converts a Hessian from the coordinates of a leaf to those of the solid: returns scale M^T H M with M = to_local.
std::array<double, 6> transform_hessian(const std::array<double, 6>& h, const CsgPlace& place) noexcept {
    const glm::dmat3 full(h[0], h[1], h[2], h[1], h[3], h[4], h[2], h[4], h[5]);
    const glm::dmat3 m = place.scale * (glm::transpose(place.to_local) * full * place.to_local);
    return {m[0][0], m[1][0], m[2][0], m[1][1], m[2][1], m[2][2]};
}

// Returns f(a, b) with its derivatives, by the chain rule.
Jet apply_chain_rule(const BlendJet& f, const Jet& a, const Jet& b) noexcept {
    Jet jet{f.value, f.by_a * a.gradient + f.by_b * b.gradient, {}};
    std::size_t at = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j, ++at)
            jet.hessian[at] = f.by_a * a.hessian[at] + f.by_b * b.hessian[at] +
                              f.by_aa * a.gradient[i] * a.gradient[j] +
                              f.by_ab * (a.gradient[i] * b.gradient[j] + b.gradient[i] * a.gradient[j]) +
                              f.by_bb * b.gradient[i] * b.gradient[j];
    return jet;
}

} // namespace

struct CsgScratch {
    explicit CsgScratch(const base::Runtime& runtime) noexcept
        : registers(runtime.memory), searches(runtime.memory), steps(runtime.memory), pending(runtime.memory) {}

    base::Array<Register> registers; // registers of the plan, followed by those of nested groups
    base::Array<GroupSearch> searches;
    base::Array<CsgStep> steps;
    base::Array<CsgPlan::Pending> pending;
    PointLanes<std::size_t{csg_block}> asked; // points at which a model is evaluated, in its own coordinates
    Register answer;
};

namespace {

class StepRunner {
public:
    // `columns` is how many numbers are computed for each point: 1 for the value, 4 with the gradient, 10 with the
    // Hessian.
    StepRunner(const CsgPlan& plan, std::span<const Implicit* const> leaves, CsgScratch& scratch, int columns,
               bool sheet)
        : plan_(plan), leaves_(leaves), scratch_(scratch), columns_(columns), wants_sheet_(sheet) {
        scratch.registers.resize_for_overwrite((plan.nested + 1) * std::int64_t{plan.root().registers});
        scratch.searches.resize_for_overwrite(plan.nested);
        registers_ = scratch.registers.data();
    }

    // Runs the steps. The result is in the first register.
    const Register& operator()(std::span<const CsgStep> steps, const PointBatch& points);

private:
    void copy(const Register& from, std::int64_t k, Register& to, std::int64_t lane) const noexcept {
        for (int c = 0; c < columns_; ++c) to.field[c][lane] = from.field[c][k];
    }
    // Writes the value and derivatives of a leaf. `jet` is in the leaf's coordinates.
    void set_leaf(Register& to, std::int64_t lane, const CsgOp& op, const CsgPlace& place,
                  const Jet& jet) const noexcept {
        Jet here{place.scale * jet.value + op.add, glm::dvec3(0.0), {}};
        if (columns_ > 1) here.gradient = place.scale * (jet.gradient * place.to_local);
        if (columns_ > 4) here.hessian = transform_hessian(jet.hessian, place);
        to.set(lane, here, columns_);
    }

    void shape(const CsgStep& step, const CsgOp& op, const PointBatch& points) noexcept;
    void model(const CsgStep& step, const CsgOp& op, const PointBatch& points);
    void evaluate_model(const CsgStep& step, const CsgPlace& place);
    [[nodiscard]] bool is_needed(const CsgStep& step, const CsgOp& op, const CsgPlace& place, std::int64_t lane,
                                 double beyond) const noexcept;
    void take_extremum(const CsgStep& step, const CsgOp& op, std::int64_t count) noexcept;
    void blend_operands(const CsgStep& step, const CsgOp& op, std::int64_t count) noexcept;
    void shell(const CsgStep& step, const CsgOp& op, std::int64_t count) noexcept;

    void evaluate_group(const CsgGroup& group, const PointBatch& points, Register& to);
    [[nodiscard]] double lower_bound_of(const CsgBoxTree::Node& leaf, const GroupSearch& search,
                                        std::int64_t lane) const noexcept;
    void evaluate_nearest(std::int32_t root, GroupSearch& search);
    void evaluate_others(std::int32_t root, GroupSearch& search);
    void evaluate_member(std::int32_t member, std::span<const std::int32_t> lanes, GroupSearch& search);

    const CsgPlan& plan_;
    std::span<const Implicit* const> leaves_;
    CsgScratch& scratch_;
    int columns_;
    bool wants_sheet_;
    Register* registers_ = nullptr; // registers of the steps that are running
    std::int64_t nested_ = 0;       // the number of groups around the steps that are running
};

void StepRunner::shape(const CsgStep& step, const CsgOp& op, const PointBatch& points) noexcept {
    const CsgPlace& place = plan_.place(op);
    Register& to = registers_[step.to];
    for (std::int64_t i = 0; i < points.count; ++i) {
        const glm::dvec3 p = place.local(point_at(points, i));
        std::int32_t sheet = step.sheet;
        double value = 0.0;
        if (sheet < 0) value = place.shape.value(p, sheet);
        if (step.sheet < 0 && columns_ == 1)
            to.field[0][i] = place.scale * value + op.add;
        else
            set_leaf(to, i, op, place, place.shape.jet(sheet, p));
        if (wants_sheet_) to.sheet[i] = sheet;
    }
}

// Returns whether a model can affect the result at a point where its value is known to be at least `beyond`, which is
// the distance from its box.
bool StepRunner::is_needed(const CsgStep& step, const CsgOp& op, const CsgPlace& place, std::int64_t lane,
                           double beyond) const noexcept {
    const CsgOp& both = plan_.ops[step.combined_by];
    if (both.takes_least() != (place.scale > 0.0)) return true;
    const double sign = place.scale > 0.0 ? 1.0 : -1.0;
    const double other = sign * registers_[step.to - 1].field[0][lane];
    const double least = sign * (place.scale * beyond + op.add);
    const double radius = both.blend.radius;
    return !(least > (both.blend.exponent > 0.0 ? std::max(radius, other) : other + radius));
}

// Evaluates a model. Its value is the larger of f and the distance from its box, because f may be anything outside the
// box.
void StepRunner::evaluate_model(const CsgStep& step, const CsgPlace& place) {
    PointLanes<std::size_t{csg_block}>& asked = scratch_.asked;
    Register& answer = scratch_.answer;
    const FieldBatch fields = answer.fields(true, columns_ > 1, columns_ > 4);
    const Implicit& model = *leaves_[static_cast<std::size_t>(place.model)];
    const Sheets* const sheets = model.sheets();
    std::fill_n(answer.sheet, asked.count, std::max(0, step.sheet));
    if (step.sheet >= 0 && sheets != nullptr) return sheets->evaluate(step.sheet, asked.points(), fields);
    model.evaluate(asked.points(), fields);
    if (step.sheet >= 0) return;
    if (wants_sheet_ && sheets != nullptr) sheets->active(asked.points(), answer.sheet);
    for (std::int64_t k = 0; k < asked.count; ++k) {
        const glm::dvec3 p = point_at(asked.points(), k);
        std::int32_t side = 0;
        const double beyond = place.beyond(p, side);
        const bool ends = beyond > 0.0 ? !(answer.field[0][k] >= beyond) : beyond > answer.field[0][k];
        if (!ends) continue;
        answer.set(k, place.shape.jet(side, p - place.centre), columns_);
        answer.sheet[k] = place.model_sheets + side;
    }
}

void StepRunner::model(const CsgStep& step, const CsgOp& op, const PointBatch& points) {
    const CsgPlace& place = plan_.place(op);
    Register& to = registers_[step.to];
    PointLanes<std::size_t{csg_block}>& asked = scratch_.asked;
    asked.count = 0;
    for (std::int64_t i = 0; i < points.count; ++i) {
        const glm::dvec3 p = place.local(point_at(points, i));
        std::int32_t side = 0;
        if (step.sheet >= place.model_sheets) {
            set_leaf(to, i, op, place, place.shape.jet(step.sheet - place.model_sheets, p - place.centre));
        } else if (step.combined_by >= 0 && !is_needed(step, op, place, i, place.beyond(p, side))) {
            to.set(i, {place.scale > 0.0 ? infinity : -infinity, glm::dvec3(0.0), {}}, columns_);
            to.sheet[i] = 0;
        } else {
            asked.add(p, i);
        }
    }
    if (asked.count == 0) return;
    evaluate_model(step, place);
    for (std::int64_t k = 0; k < asked.count; ++k) {
        set_leaf(to, asked.index[k], op, place, scratch_.answer.take(k, columns_));
        to.sheet[asked.index[k]] = scratch_.answer.sheet[k];
    }
}

void StepRunner::take_extremum(const CsgStep& step, const CsgOp& op, std::int64_t count) noexcept {
    Register& first = registers_[step.to];
    if (step.sheet < 0) { // if a single sheet is wanted, only one operand was evaluated
        const Register& second = registers_[step.to + 1];
        const double sign = op.takes_least() ? 1.0 : -1.0;
        const std::int32_t sheets_of_a = plan_.ops[op.a].sheets;
        for (std::int64_t i = 0; i < count; ++i) {
            const double one = sign * first.field[0][i];
            const double other = sign * second.field[0][i];
            const bool takes_b = step.a_is_second ? takes_lower(other, one) : takes_lower(one, other);
            const bool takes_second = takes_b != step.a_is_second;
            if (wants_sheet_)
                first.sheet[i] = op.merged ? 0 : (takes_second ? second : first).sheet[i] + (takes_b ? sheets_of_a : 0);
            if (takes_second) copy(second, i, first, i);
        }
    }
    for (std::int64_t i = 0; i < count; ++i) first.field[0][i] += op.add;
}

void StepRunner::blend_operands(const CsgStep& step, const CsgOp& op, std::int64_t count) noexcept {
    Register& first = registers_[step.to];
    const Register& second = registers_[step.to + 1];
    const Register& a = step.a_is_second ? second : first;
    const Register& b = step.a_is_second ? first : second;
    const std::int32_t sheets_of_b = plan_.ops[op.b].sheets;
    for (std::int64_t i = 0; i < count; ++i) {
        if (wants_sheet_) first.sheet[i] = op.merged ? 0 : a.sheet[i] * sheets_of_b + b.sheet[i];
        const double u = a.field[0][i];
        const double v = b.field[0][i];
        const BlendJet blend = op.takes_least() ? op.blend.minimum(u, v) : op.blend.maximum(u, v);
        Jet jet{blend.value, glm::dvec3(0.0), {}};
        if (columns_ > 1) jet = apply_chain_rule(blend, a.take(i, columns_), b.take(i, columns_));
        jet.value += op.add;
        first.set(i, jet, columns_);
    }
}

void StepRunner::shell(const CsgStep& step, const CsgOp& op, std::int64_t count) noexcept {
    Register& to = registers_[step.to];
    const std::int32_t sheets = plan_.ops[op.a].sheets;
    const double sign = op.takes_least() ? 1.0 : -1.0;
    for (std::int64_t i = 0; i < count; ++i) {
        double& value = to.field[0][i];
        const bool inner =
            step.sheet >= 0 ? step.sheet >= sheets : takes_lower(sign * value, op.thickness - sign * value);
        if (inner) value = sign * op.thickness - value;
        for (int c = 1; inner && c < columns_; ++c) to.field[c][i] = -to.field[c][i];
        if (wants_sheet_) to.sheet[i] = op.merged ? 0 : to.sheet[i] + (inner ? sheets : 0);
        value += op.add;
    }
}

// Returns a lower bound of a member's value at a point. For a model the bound is computed from its box, which may be
// rotated.
double StepRunner::lower_bound_of(const CsgBoxTree::Node& leaf, const GroupSearch& search,
                                  std::int64_t lane) const noexcept {
    const glm::dvec3 p = point_at(search.points, lane);
    const CsgOp& op = plan_.ops[plan_.members[leaf.first].op];
    if (op.kind != CsgOp::Kind::model) return leaf.least(p, search.slack[lane]);
    const CsgPlace& place = plan_.place(op);
    if (search.sign * place.scale < 0.0) return -infinity;
    std::int32_t side = 0;
    return search.sign * (place.scale * place.beyond(place.local(p), side) + op.add);
}

// Evaluates a member at some lanes, and keeps the values that are lower than those found before. The results equal
// those of combining members one after the other: the first of two equal values wins, and NaN stays.
void StepRunner::evaluate_member(std::int32_t member, std::span<const std::int32_t> lanes, GroupSearch& search) {
    const CsgMember& part = plan_.members[member];
    search.asked.count = 0;
    for (const std::int32_t lane : lanes) search.asked.add(point_at(search.points, lane), lane);
    Register* const own = std::exchange(registers_, registers_ + plan_.root().registers);
    ++nested_;
    const Register& answer = (*this)(plan_.steps_of(part), search.asked.points());
    --nested_;
    registers_ = own;
    for (std::int64_t k = 0; k < search.asked.count; ++k) {
        const std::int32_t lane = search.asked.index[k];
        const double value = search.sign * answer.field[0][k];
        double& best = search.best[lane];
        std::int32_t& least_member = search.least_member[lane];
        const bool wins = least_member < 0 || value < best || (value == best && member < least_member) ||
                          (std::isnan(value) && (!std::isnan(best) || member > least_member));
        if (!wins) continue;
        best = value;
        least_member = member;
        copy(answer, k, *search.to, lane);
        if (wants_sheet_) search.to->sheet[lane] = search.op->merged ? 0 : answer.sheet[k] + part.first_sheet;
    }
}

void StepRunner::evaluate_nearest(std::int32_t root, GroupSearch& search) {
    std::int32_t* const begin = search.lane;
    std::int32_t* const end = begin + search.points.count;
    std::iota(begin, end, 0);
    for (std::int64_t i = 0; i < search.points.count; ++i)
        search.nearest[i] =
            plan_.boxes.nearest(root, point_at(search.points, i), search.slack[i], search.best[i],
                                [&](const CsgBoxTree::Node& leaf) { return lower_bound_of(leaf, search, i); });
    const auto nearest = [&](std::int32_t lane) { return search.nearest[lane]; };
    std::sort(begin, end,
              [&](std::int32_t a, std::int32_t b) { return std::pair(nearest(a), a) < std::pair(nearest(b), b); });
    for (std::int32_t* lane = begin; lane != end;) {
        const std::int32_t member = nearest(*lane);
        std::int32_t* const next = std::find_if(lane, end, [&](std::int32_t i) { return nearest(i) != member; });
        if (member >= 0) evaluate_member(member, {lane, next}, search);
        lane = next;
    }
}

// Walks down the tree of boxes. At each box it keeps the points at which a member in the box may have a value that is
// not greater than the current least value.
void StepRunner::evaluate_others(std::int32_t root, GroupSearch& search) {
    struct Part {
        std::int32_t node;
        std::int64_t count; // the number of points that are still being searched; these points come first
    };
    std::array<Part, CsgBoxTree::deepest> waiting;
    std::size_t parts = 0;
    waiting[parts++] = {root, search.points.count};
    while (parts > 0) {
        const Part part = waiting[--parts];
        const CsgBoxTree::Node& node = plan_.boxes[part.node];
        const auto may_be_least = [&](std::int32_t lane) {
            if (node.is_leaf())
                return search.nearest[lane] != node.first && !(lower_bound_of(node, search, lane) > search.best[lane]);
            return !(node.least(point_at(search.points, lane), search.slack[lane]) > search.best[lane]);
        };
        const std::int64_t count = std::partition(search.lane, search.lane + part.count, may_be_least) - search.lane;
        if (count == 0) continue;
        if (node.is_leaf()) {
            evaluate_member(node.first, {search.lane, search.lane + count}, search);
            continue;
        }
        HRBFNPR_ASSERT(parts + 2 <= waiting.size());
        waiting[parts++] = {node.second, count};
        waiting[parts++] = {node.first, count};
    }
}

void StepRunner::evaluate_group(const CsgGroup& group, const PointBatch& points, Register& to) {
    HRBFNPR_ASSERT(nested_ < scratch_.searches.size() && points.count <= csg_block);
    GroupSearch& search = scratch_.searches[nested_];
    search.op = &plan_.ops[group.op];
    search.points = points;
    search.to = &to;
    search.sign = search.op->takes_least() ? 1.0 : -1.0;
    for (std::int64_t i = 0; i < points.count; ++i) {
        const glm::dvec3 p = glm::abs(point_at(points, i));
        search.best[i] = infinity;
        search.least_member[i] = -1;
        search.slack[i] = csg_tuning.rounding * (group.size + std::max({p.x, p.y, p.z}));
    }
    for (const std::int32_t root : group.boxes) {
        if (root < 0) continue;
        evaluate_nearest(root, search);
        evaluate_others(root, search);
    }
    for (std::int64_t i = 0; i < points.count; ++i) to.field[0][i] += search.op->add;
}

const Register& StepRunner::operator()(std::span<const CsgStep> steps, const PointBatch& points) {
    HRBFNPR_ASSERT(points.count <= csg_block);
    for (const CsgStep& step : steps) {
        const CsgOp& op = plan_.ops[step.op];
        if (step.kind == CsgStep::Kind::group)
            evaluate_group(plan_.groups[op.group], points, registers_[step.to]);
        else if (step.kind == CsgStep::Kind::shell)
            shell(step, op, points.count);
        else if (op.kind == CsgOp::Kind::model)
            model(step, op, points);
        else if (op.kind == CsgOp::Kind::shape)
            shape(step, op, points);
        else if (op.blend.radius > 0.0)
            blend_operands(step, op, points.count);
        else
            take_extremum(step, op, points.count);
    }
    return registers_[0];
}

int columns_of(const FieldBatch& fields) noexcept {
    if (fields.wants_hessian()) return 10;
    return fields.wants_gradient() ? 4 : 1;
}

// Evaluates the points block by block. Calls take(result, first, count) for each block.
template <class F>
void for_blocks(StepRunner run, std::span<const CsgStep> steps, const PointBatch& points, F&& take) {
    for (std::int64_t begin = 0; begin < points.count; begin += csg_block) {
        const std::int64_t count = std::min(csg_block, points.count - begin);
        take(run(steps, slice(points, begin, begin + count)), begin, count);
    }
}

void copy_blocks(const StepRunner& run, std::span<const CsgStep> steps, const PointBatch& points,
                 const FieldBatch& fields) {
    for_blocks(run, steps, points, [&](const Register& from, std::int64_t begin, std::int64_t count) {
        for_columns(fields.from(begin),
                    [&](std::size_t c, double* column) { std::copy_n(from.field[c], count, column); });
    });
}

} // namespace

Csg::Csg(const base::Runtime& runtime, const CsgPlan& plan, base::Array<const Implicit*>&& leaves,
         const geometry::Bounds& bounds)
    : plan_(plan), leaves_(std::move(leaves)), bounds_(bounds), model_cells_(runtime.memory), boxes_(runtime.memory),
      scratch_(runtime) {
    for (const Implicit* const leaf : leaves_) concurrent_ = concurrent_ && leaf->concurrent();
    place_cells(runtime.memory);
}

Csg::~Csg() = default;

void Csg::place_cells(base::Memory& memory) {
    base::Array<CsgBoxTree::Item> boxes(memory);
    bool several = false;
    for (const CsgOp& op : plan_.ops) {
        if (op.kind != CsgOp::Kind::model) continue;
        const CsgPlace& place = plan_.place(op);
        const std::int64_t own = leaves_[place.model]->cells();
        several = several || own > 0 || !model_cells_.empty();
        boxes.push_back({place.reach.inside, place.reach.slope, static_cast<std::int32_t>(model_cells_.size())});
        model_cells_.push_back({&place, cells_});
        cells_ += std::max<std::int64_t>(1, own);
    }
    if (!several || cells_ > std::numeric_limits<std::int32_t>::max()) cells_ = 0;
    if (cells_ > 0) boxes_root_ = boxes_.add(boxes.span());
}

// A point belongs to the model whose box contains it most deeply, or, if no box contains it, to the nearest one. Other
// models are seldom evaluated there.
std::int32_t Csg::cell_of(const glm::dvec3& point) const noexcept {
    if (cells_ == 0) return 0;
    const std::int32_t nearest = boxes_.nearest(boxes_root_, point, 0.0, infinity, [&](const CsgBoxTree::Node& leaf) {
        const CsgPlace& place = *model_cells_[leaf.first].place;
        std::int32_t side = 0;
        return std::abs(place.scale) * place.beyond(place.local(point), side);
    });
    const ModelCells& leaf = model_cells_[std::max(0, nearest)];
    return static_cast<std::int32_t>(leaf.first + leaves_[leaf.place->model]->cell_of(leaf.place->local(point)));
}

void Csg::evaluate(const PointBatch& points, const FieldBatch& fields) const {
    const base::ScratchPool<CsgScratch>::Lease scratch(scratch_);
    const StepRunner run(plan_, leaves_.span(), *scratch, columns_of(fields), false);
    copy_blocks(run, plan_.root_steps(), points, fields);
}

void Csg::active(const PointBatch& points, std::int32_t* sheet) const {
    const base::ScratchPool<CsgScratch>::Lease scratch(scratch_);
    for_blocks(StepRunner(plan_, leaves_.span(), *scratch, 1, true), plan_.root_steps(), points,
               [&](const Register& from, std::int64_t begin, std::int64_t count) {
                   std::copy_n(from.sheet, count, sheet + begin);
               });
}

void Csg::evaluate(std::int32_t sheet, const PointBatch& points, const FieldBatch& fields) const {
    const base::ScratchPool<CsgScratch>::Lease scratch(scratch_);
    scratch->steps.clear();
    plan_.add_steps(plan_.root_op, sheet, scratch->steps, scratch->pending);
    const StepRunner run(plan_, leaves_.span(), *scratch, columns_of(fields), false);
    copy_blocks(run, scratch->steps.span(), points, fields);
}

} // namespace hrbfnpr::implicit
