// SPDX-License-Identifier: MIT
#include "implicit/csg.h"

#include "implicit/csg_run.h"

namespace hrbfnpr::implicit {
namespace {

void copy(const CsgRegister& from, std::int64_t count, const FieldBatch& to) noexcept {
    if (to.value != nullptr) std::copy_n(from.value, count, to.value);
    for (std::size_t c = 0; to.wants_gradient() && c < 3; ++c) std::copy_n(from.gradient[c], count, to.gradient[c]);
    for (std::size_t c = 0; to.wants_hessian() && c < 6; ++c) std::copy_n(from.hessian[c], count, to.hessian[c]);
}

constexpr std::int64_t most_celled = 64; // each point is looked for in all of them

// work(first, points) for each block.
template <class F>
void for_blocks(const PointBatch& points, F&& work) {
    for (std::int64_t begin = 0; begin < points.count; begin += csg_block)
        work(begin, slice(points, begin, std::min(points.count, begin + csg_block)));
}

} // namespace

Csg::Csg(const base::Runtime& runtime, const CsgPlan& plan, base::Array<const Implicit*>&& leaves,
         const geometry::Bounds& bounds)
    : plan_(plan), leaves_(std::move(leaves)), bounds_(bounds), celled_(runtime.memory), scratch_(runtime) {
    for (const CsgOp& op : plan.ops()) {
        if (op.kind != CsgOp::Kind::model) continue;
        const CsgPlace& place = plan.place(op);
        const Implicit& leaf = *leaves_[place.model];
        concurrent_ = concurrent_ && leaf.concurrent();
        if (leaf.cells() == 0 || celled_.size() == most_celled) continue;
        celled_.push_back({&place, cells_});
        cells_ += leaf.cells();
    }
    if (cells_ > std::numeric_limits<std::int32_t>::max()) cells_ = 0;
}

Csg::~Csg() = default;

// In that leaf whose box the point is farthest inside of, or nearest to: others are hardly asked there.
std::int32_t Csg::cell_of(const glm::dvec3& point) const noexcept {
    if (cells_ == 0) return 0;
    double least = std::numeric_limits<double>::infinity();
    std::int64_t cell = 0;
    for (const Celled& leaf : celled_) {
        const CsgPlace& place = *leaf.place;
        const glm::dvec3 p = place.to_local * point + place.shift;
        std::int32_t side = 0;
        const double beyond = std::abs(place.scale) * place.shape.value(p - place.centre, side);
        if (!(beyond < least)) continue;
        least = beyond;
        cell = leaf.first + leaves_[place.model]->cell_of(p);
    }
    return static_cast<std::int32_t>(cell);
}

void Csg::evaluate(const PointBatch& points, const FieldBatch& fields) const {
    const base::ScratchPool<Scratch>::Lease scratch(scratch_);
    Run run(*this, *scratch, plan_.steps().span(),
            {fields.wants_gradient() || fields.wants_hessian(), fields.wants_hessian(), false});
    for_blocks(points,
               [&](std::int64_t begin, const PointBatch& block) { copy(run(block), block.count, fields.from(begin)); });
}

void Csg::SheetsOf::active(const PointBatch& points, std::int32_t* sheet) const {
    const base::ScratchPool<Scratch>::Lease scratch(csg.scratch_);
    Run run(csg, *scratch, csg.plan_.steps().span(), {false, false, true});
    for_blocks(points, [&](std::int64_t begin, const PointBatch& block) {
        std::copy_n(run(block).sheet, block.count, sheet + begin);
    });
}

void Csg::SheetsOf::evaluate(std::int32_t sheet, const PointBatch& points, const FieldBatch& fields) const {
    const base::ScratchPool<Scratch>::Lease scratch(csg.scratch_);
    csg.plan_.make_steps(sheet, scratch->steps, scratch->pending);
    Run run(csg, *scratch, scratch->steps.span(),
            {fields.wants_gradient() || fields.wants_hessian(), fields.wants_hessian(), false});
    for_blocks(points,
               [&](std::int64_t begin, const PointBatch& block) { copy(run(block), block.count, fields.from(begin)); });
}

} // namespace hrbfnpr::implicit
