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

// work(first, points) for each block.
template <class F>
void for_blocks(const PointBatch& points, F&& work) {
    for (std::int64_t begin = 0; begin < points.count; begin += csg_block)
        work(begin, slice(points, begin, std::min(points.count, begin + csg_block)));
}

} // namespace

Csg::Csg(const base::Runtime& runtime, const CsgPlan& plan, base::Array<const Implicit*>&& leaves,
         const geometry::Bounds& bounds)
    : plan_(plan), leaves_(std::move(leaves)), bounds_(bounds), scratch_(runtime) {
    std::int64_t most = 0;
    for (const CsgOp& op : plan.ops()) {
        if (op.kind != CsgOp::Kind::model) continue;
        const CsgPlace& place = plan.place(op);
        const Implicit& leaf = *leaves_[place.model];
        concurrent_ = concurrent_ && leaf.concurrent();
        if (leaf.cells() <= most) continue;
        most = leaf.cells();
        celled_ = &place;
    }
}

Csg::~Csg() = default;

std::int64_t Csg::cells() const noexcept { return celled_ != nullptr ? leaves_[celled_->model]->cells() : 0; }

std::int32_t Csg::cell_of(const glm::dvec3& point) const noexcept {
    if (celled_ == nullptr) return 0;
    return leaves_[celled_->model]->cell_of(celled_->to_local * point + celled_->shift);
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
