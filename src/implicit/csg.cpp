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
    : plan_(plan), leaves_(std::move(leaves)), bounds_(bounds), celled_(runtime.memory), boxes_(runtime.memory),
      scratch_(runtime) {
    for (const Implicit* const leaf : leaves_) concurrent_ = concurrent_ && leaf->concurrent();
    place_cells(runtime.memory);
}

Csg::~Csg() = default;

void Csg::place_cells(base::Memory& memory) {
    base::Array<CsgBounded> boxes(memory);
    bool several = false;
    for (const CsgOp& op : plan_.ops()) {
        if (op.kind != CsgOp::Kind::model) continue;
        const CsgPlace& place = plan_.place(op);
        const std::int64_t own = leaves_[place.model]->cells();
        several = several || own > 0 || !celled_.empty();
        boxes.push_back({place.reach.inside, place.reach.slope, static_cast<std::int32_t>(celled_.size())});
        celled_.push_back({&place, cells_});
        cells_ += std::max<std::int64_t>(1, own);
    }
    if (!several || cells_ > std::numeric_limits<std::int32_t>::max()) cells_ = 0;
    if (cells_ > 0) boxes_root_ = boxes_.add(boxes.span());
}

// In that model whose box the point is farthest inside of, or nearest to: others are hardly asked there.
std::int32_t Csg::cell_of(const glm::dvec3& point) const noexcept {
    if (cells_ == 0) return 0;
    const std::int32_t nearest = boxes_.nearest(
        boxes_root_, point, 0.0, std::numeric_limits<double>::infinity(), [&](const CsgBoxTree::Node& leaf) {
            const CsgPlace& place = *celled_[leaf.first].place;
            std::int32_t side = 0;
            return std::abs(place.scale) * place.shape.value(place.to_local * point + place.shift - place.centre, side);
        });
    const Celled& leaf = celled_[std::max(0, nearest)];
    const CsgPlace& place = *leaf.place;
    return static_cast<std::int32_t>(leaf.first + leaves_[place.model]->cell_of(place.to_local * point + place.shift));
}

void Csg::evaluate(const PointBatch& points, const FieldBatch& fields) const {
    const base::ScratchPool<Scratch>::Lease scratch(scratch_);
    Run run(*this, *scratch, plan_.steps(),
            {fields.wants_gradient() || fields.wants_hessian(), fields.wants_hessian(), false});
    for_blocks(points,
               [&](std::int64_t begin, const PointBatch& block) { copy(run(block), block.count, fields.from(begin)); });
}

void Csg::SheetsOf::active(const PointBatch& points, std::int32_t* sheet) const {
    const base::ScratchPool<Scratch>::Lease scratch(csg.scratch_);
    Run run(csg, *scratch, csg.plan_.steps(), {false, false, true});
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
