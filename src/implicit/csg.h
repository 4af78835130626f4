// SPDX-License-Identifier: MIT
// A CSG tree as an implicit: minima, maxima and blends of leaves.                                    docs/csg.md
#pragma once

#include "base/scratch_pool.h"
#include "implicit/csg_plan.h"
#include "implicit/sheets.h"

namespace hrbfnpr::implicit {

// Its sheets are those of its leaves: the smooth pieces of a primitive, the sheets of a model and the six sides of the
// box that a model ends at.  A blend of two has a sheet for each pair of theirs, the blend of both, which is smooth
// around what the blend has rounded and also where it ends.  So where one of the pair is far, sheets differ that are
// the same function there: a crease is where gradients differ, too.
class Csg final : public Implicit {
public:
    // The plan and the leaves live as long as this, the runtime too.  leaves: of each CsgModel of the plan.
    Csg(const base::Runtime& runtime, const CsgPlan& plan, base::Array<const Implicit*>&& leaves,
        const geometry::Bounds& bounds);
    ~Csg() override;

    void evaluate(const PointBatch& points, const FieldBatch& fields) const override;
    [[nodiscard]] bool concurrent() const noexcept override { return concurrent_; }
    // Those of all models, one model's behind the other's; of several that have none, one for each.
    [[nodiscard]] std::int64_t cells() const noexcept override { return cells_; }
    [[nodiscard]] std::int32_t cell_of(const glm::dvec3& point) const noexcept override;
    [[nodiscard]] const geometry::Bounds& bounds() const noexcept override { return bounds_; }
    [[nodiscard]] double lipschitz() const noexcept override { return plan_.root().lipschitz; }
    [[nodiscard]] const Sheets* sheets() const noexcept override {
        return plan_.root().sheets > 1 ? &sheets_ : nullptr;
    }
    [[nodiscard]] std::span<const Implicit* const> leaves() const noexcept { return leaves_.span(); }

private:
    class Scratch;
    class Run;
    struct SheetsOf final : Sheets {
        explicit SheetsOf(const Csg& of) noexcept : csg(of) {}
        [[nodiscard]] std::int32_t count() const noexcept override { return csg.plan_.root().sheets; }
        void active(const PointBatch& points, std::int32_t* sheet) const override;
        void evaluate(std::int32_t sheet, const PointBatch& points, const FieldBatch& fields) const override;
        const Csg& csg;
    };

    const CsgPlan& plan_;
    base::Array<const Implicit*> leaves_;
    geometry::Bounds bounds_;
    struct Celled {
        const CsgPlace* place;
        std::int64_t first; // its cells
    };
    void place_cells(base::Memory& memory);

    base::Array<Celled> celled_; // the models
    CsgBoxTree boxes_;           // of them
    std::int32_t boxes_root_ = -1;
    std::int64_t cells_ = 0;
    bool concurrent_ = true;
    SheetsOf sheets_{*this};
    mutable base::ScratchPool<Scratch> scratch_; // of the calls
};

} // namespace hrbfnpr::implicit
