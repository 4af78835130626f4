// SPDX-License-Identifier: MIT
// What a fit does about its normals first.
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "fit/fit.h"
#include "orient/orient.h"

namespace hrbfnpr::api {

// Whether a HRBFNPR_NORMALS_... needs no normals.
[[nodiscard]] bool may_lack_normals(std::uint32_t mode) noexcept;

// The normals that a mode makes, for as long as it lives, and what was found.
class NormalsOfFit {
public:
    // Puts them into the input.
    NormalsOfFit(const base::Work& work, std::uint32_t mode, fit::FitInput& input);

    // What is left of the progress.
    [[nodiscard]] base::Progress rest(const base::Progress& progress) const noexcept;
    void report(fit::FitReport& report) const noexcept;

private:
    static constexpr double share = 0.5; // of the progress

    bool made_ = false;
    bool inward_ = false;
    base::Array<double> packed_;
    orient::OrientReport found_;
};

} // namespace hrbfnpr::api
