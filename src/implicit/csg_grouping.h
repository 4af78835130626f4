// SPDX-License-Identifier: MIT
// Minima and maxima of many, found in a CSG plan: chains of pairs, however they hang together.
#pragma once

#include "implicit/csg_plan.h"

namespace hrbfnpr::implicit {

class CsgPlan::Grouping {
public:
    // always: also where plain pairs are quicker.
    Grouping(CsgPlan& plan, const base::Array<Reaches>& reaches, bool always);
    void run();

private:
    struct Task {
        std::int32_t op = 0;
        std::int32_t nested = 0; // groups that it is in
    };
    void visit(const Task& task);
    void collect(std::int32_t op);
    [[nodiscard]] bool joins(const CsgOp& op, const CsgOp& of) const noexcept;
    [[nodiscard]] bool pays() const noexcept;
    void make(const Task& task);
    [[nodiscard]] CsgBounded bounded(std::int32_t member, bool least, double& size) const noexcept;

    CsgPlan& plan_;
    const base::Array<Reaches>& reaches_;
    bool always_;
    base::Array<std::int32_t> models_; // below each op
    base::Array<Task> tasks_;
    base::Array<std::int32_t> found_, waiting_; // operands of a chain, in their order
    base::Array<CsgBounded> boxes_;
};

} // namespace hrbfnpr::implicit
