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

[[nodiscard]] inline glm::dvec3 local(const CsgPlace& place, const PointBatch& points, std::int64_t i) noexcept {
    return place.to_local * glm::dvec3(points.x[i], points.y[i], points.z[i]) + place.shift;
}

// What a group knows of the points of a block while it looks for the members that they need.
struct CsgLanes {
    double best[csg_block]; // the least so far, turned where the group takes the most
    double slack[csg_block];
    std::int32_t winner[csg_block];  // the member that it is; -1: none yet
    std::int32_t nearest[csg_block]; // the member that was asked first
    std::int32_t lane[csg_block];    // those that are still looked at are in front
    double at[3][csg_block];         // of those that a member is asked for, side by side
};

class Csg::Scratch {
public:
    explicit Scratch(const base::Runtime& runtime) noexcept
        : registers(runtime.memory), lanes(runtime.memory), steps(runtime.memory), pending(runtime.memory) {}

    base::Array<CsgRegister> registers; // of the plan, then of groups in groups
    base::Array<CsgLanes> lanes;
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
        scratch.registers.resize_for_overwrite((plan_.nested() + 1) * std::int64_t{plan_.registers()});
        scratch.lanes.resize_for_overwrite(plan_.nested());
        registers_ = scratch.registers.data();
    }

    // At most csg_block points; the result is of the first register.
    const CsgRegister& operator()(const PointBatch& points) {
        run(steps_, points);
        return registers_[0];
    }

private:
    void run(std::span<const CsgStep> steps, const PointBatch& points);
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

    void group(const CsgStep& step, const CsgOp& op, const PointBatch& points);
    class GroupRun;

    void put(CsgRegister& to, std::int64_t lane, const CsgOp& op, const CsgPlace& place,
             const CsgJet& jet) const noexcept;
    [[nodiscard]] CsgJet take(const CsgRegister& from, std::int64_t lane) const noexcept;
    void set(CsgRegister& to, std::int64_t lane, const CsgJet& jet) const noexcept;

    const Csg& csg_;
    const CsgPlan& plan_;
    Scratch& scratch_;
    std::span<const CsgStep> steps_;
    Wanted wanted_;
    CsgRegister* registers_ = nullptr; // of the steps that are being done
    std::int64_t nested_ = 0;          // groups that these are in
};

} // namespace hrbfnpr::implicit
