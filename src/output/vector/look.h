// SPDX-License-Identifier: MIT
// How long work goes on without a look at its operation.
#pragma once

#include "base/operation.h"

#include <cstdint>

namespace hrbfnpr::output {

// Looks for a cancel, and calls the caller's callback: the work goes on, however far it is.
inline void look(const base::Progress& progress) { progress.update(0.0); }

// Looks after so many steps.
class Looks {
public:
    Looks(const base::Progress& progress, std::int64_t steps) noexcept : progress_(progress), steps_(steps) {}
    void count(std::int64_t steps = 1) {
        if ((counted_ += steps) < steps_) return;
        counted_ = 0;
        look(progress_);
    }

private:
    const base::Progress& progress_;
    std::int64_t steps_, counted_ = 0;
};

} // namespace hrbfnpr::output
