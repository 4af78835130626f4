// SPDX-License-Identifier: MIT
// The steps of a CSG plan, done for a block of points.
#pragma once

#include "base/runtime.h"
#include "implicit/csg.h"

namespace hrbfnpr::implicit {

inline constexpr std::int64_t csg_block = 128;

// An intermediate result for all points of a block.
struct CsgRegister {
    double value[csg_block];
    double gradient[3][csg_block];
    double hessian[6][csg_block];
    std::int32_t sheet[csg_block];
};

class Csg::Scratch {
public:
    explicit Scratch(const base::Runtime& runtime) noexcept
        : registers(runtime.memory), steps(runtime.memory), pending(runtime.memory) {}

    base::Array<CsgRegister> registers;
    base::Array<CsgStep> steps;
    base::Array<CsgPlan::Pending> pending;

    // What a model is asked for: points in its own coordinates, and which of the block they are.
    std::int32_t lane[csg_block];
    double at[3][csg_block];
    CsgRegister answer;
};

class Csg::Run {
public:
    struct Wanted {
        bool gradient = false;
        bool hessian = false;
        bool sheet = false;
    };
    Run(const Csg& csg, Scratch& scratch, std::span<const CsgStep> steps, Wanted wanted)
        : csg_(csg), plan_(csg.plan_), scratch_(scratch), steps_(steps), wanted_(wanted) {
        scratch.registers.resize_for_overwrite(plan_.root().registers);
    }

    // At most csg_block points; the result is of the first register.
    const CsgRegister& operator()(const PointBatch& points);

private:
    void shape(const CsgStep& step, const CsgOp& op, const PointBatch& points) noexcept;
    void model(const CsgStep& step, const CsgOp& op, const PointBatch& points);
    void ask(const CsgStep& step, const CsgPlace& place, std::int64_t count);
    void end_at_box(const CsgPlace& place, std::int64_t k) noexcept;
    [[nodiscard]] bool is_needed(const CsgStep& step, const CsgOp& op, const CsgPlace& place, std::int64_t lane,
                                 double beyond) const noexcept;
    void combine(const CsgStep& step, const CsgOp& op, std::int64_t count) noexcept;
    void pick(const CsgStep& step, const CsgOp& op, std::int64_t count) noexcept;
    void mix(const CsgStep& step, const CsgOp& op, std::int64_t count) noexcept;
    void shell(const CsgStep& step, const CsgOp& op, std::int64_t count) noexcept;

    void put(CsgRegister& to, std::int64_t lane, const CsgOp& op, const CsgPlace& place,
             const CsgJet& jet) const noexcept;
    [[nodiscard]] CsgJet take(const CsgRegister& from, std::int64_t lane) const noexcept;
    void set(CsgRegister& to, std::int64_t lane, const CsgJet& jet) const noexcept;

    const Csg& csg_;
    const CsgPlan& plan_;
    Scratch& scratch_;
    std::span<const CsgStep> steps_;
    Wanted wanted_;
};

} // namespace hrbfnpr::implicit
