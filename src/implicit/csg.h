// SPDX-License-Identifier: MIT
// An implicit function for a solid that is made from other solids.
#pragma once

#include "base/scratch_pool.h"
#include "implicit/csg_plan.h"
#include "implicit/sheets.h"

namespace hrbfnpr::implicit {

struct CsgScratch;

// The sheets of a leaf are the smooth parts of a primitive, or the sheets of a model and the six sides of the model's
// box. A sharp minimum or maximum has the sheets of both operands. A blend has one sheet for each pair of its operands'
// sheets, which is the blend of these two. It is smooth also at the ends of the blend. If one sheet of a pair is far
// away, several sheets may be the same function. So two sheets meet in a crease only where their gradients differ.
class Csg final : public Implicit, public Sheets {
public:
    // `plan`, `leaves` and `runtime` must outlive this object. `leaves` has one element for each CsgModel of the plan.
    Csg(const base::Runtime& runtime, const CsgPlan& plan, base::Array<const Implicit*>&& leaves,
        const geometry::Bounds& bounds);
    ~Csg() override;

    void evaluate(const PointBatch& points, const FieldBatch& fields) const override;
    [[nodiscard]] bool concurrent() const noexcept override { return concurrent_; }
    // Returns the number of cells of all models together. They are numbered model by model. A model without cells
    // counts as one cell.
    [[nodiscard]] std::int64_t cells() const noexcept override { return cells_; }
    [[nodiscard]] std::int32_t cell_of(const glm::dvec3& point) const noexcept override;
    [[nodiscard]] const geometry::Bounds& bounds() const noexcept override { return bounds_; }
    [[nodiscard]] double lipschitz() const noexcept override { return plan_.root().lipschitz; }
    [[nodiscard]] const Sheets* sheets() const noexcept override { return count() > 1 ? this : nullptr; }

    [[nodiscard]] std::int32_t count() const noexcept override { return plan_.root().sheets; }
    void active(const PointBatch& points, std::int32_t* sheet) const override;
    void evaluate(std::int32_t sheet, const PointBatch& points, const FieldBatch& fields) const override;

    [[nodiscard]] std::span<const Implicit* const> leaves() const noexcept { return leaves_.span(); }

private:
    struct ModelCells {
        const CsgPlace* place;
        std::int64_t first; // index of the model's first cell
    };
    void place_cells(base::Memory& memory);

    const CsgPlan& plan_;
    base::Array<const Implicit*> leaves_;
    geometry::Bounds bounds_;
    base::Array<ModelCells> model_cells_; // the models and their cells
    CsgBoxTree boxes_;                    // boxes of the models
    std::int32_t boxes_root_ = -1;
    std::int64_t cells_ = 0;
    bool concurrent_ = true;
    mutable base::ScratchPool<CsgScratch> scratch_; // one scratch object for each running call
};

} // namespace hrbfnpr::implicit
