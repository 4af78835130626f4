// SPDX-License-Identifier: MIT
// Finds or repairs the normals of the samples before a fit.
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "fit/fit.h"
#include "orient/orient.h"

namespace hrbfnpr::api {

// Tells whether a HRBFNPR_NORMALS_* mode needs no normals.
[[nodiscard]] bool may_lack_normals(std::uint32_t mode) noexcept;

// Owns the normals that a mode makes, and reports the findings.
class NormalsOfFit {
public:
    // Puts the normals into `input`.
    NormalsOfFit(const base::Work& work, std::uint32_t mode, fit::FitInput& input);

    // Returns the part of the progress that remains for the fit.
    [[nodiscard]] base::Progress rest(const base::Progress& progress) const noexcept;
    void report(fit::FitReport& report) const noexcept;

private:
    static constexpr double share = 0.5; // the share of the progress that the normals take

    bool made_ = false;
    bool inward_ = false;
    base::Array<double> packed_;
    orient::OrientReport found_;
};

} // namespace hrbfnpr::api
