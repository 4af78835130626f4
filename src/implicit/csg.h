// SPDX-License-Identifier: MIT
// A solid put together from others as an implicit.
#pragma once

#include "base/scratch_pool.h"
#include "implicit/csg_plan.h"
#include "implicit/sheets.h"

namespace hrbfnpr::implicit {

struct CsgScratch;

// Its sheets are those of its leaves: the smooth pieces of a primitive, the sheets of a model and the six sides of the
// box that a model ends at. A blend of two has a sheet for each pair of theirs, the blend of both, which is smooth
// around what the blend has rounded and also where it ends. So where one of the pair is far, sheets differ that are
// the same function there: a crease is where gradients differ, too.
class Csg final : public Implicit, public Sheets {
public:
    // The plan and the leaves live as long as this, the runtime too. leaves: of each CsgModel of the plan.
    Csg(const base::Runtime& runtime, const CsgPlan& plan, base::Array<const Implicit*>&& leaves,
        const geometry::Bounds& bounds);
    ~Csg() override;

    void evaluate(const PointBatch& points, const FieldBatch& fields) const override;
    [[nodiscard]] bool concurrent() const noexcept override { return concurrent_; }
    // The cells of all models, one model after the other; a model that has none counts as one cell.
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
    struct Celled {
        const CsgPlace* place;
        std::int64_t first; // its cells
    };
    void place_cells(base::Memory& memory);

    const CsgPlan& plan_;
    base::Array<const Implicit*> leaves_;
    geometry::Bounds bounds_;
    base::Array<Celled> celled_; // the models
    CsgBoxTree boxes_;           // of them
    std::int32_t boxes_root_ = -1;
    std::int64_t cells_ = 0;
    bool concurrent_ = true;
    mutable base::ScratchPool<CsgScratch> scratch_; // of the calls
};

} // namespace hrbfnpr::implicit
