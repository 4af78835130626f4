// SPDX-License-Identifier: MIT
// Finds or repairs the normals of the samples before a fit.
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "fit/fit.h"
#include "orient/orient.h"

namespace hrbfnpr::api {

// Returns whether a mode (HRBFNPR_NORMALS_*) allows samples without normals.
[[nodiscard]] bool may_lack_normals(std::uint32_t mode) noexcept;

// Owns the normals that a mode makes, and reports how they were found.
class NormalsOfFit {
public:
    // Finds or repairs the normals, and puts them into `input`.
    NormalsOfFit(const base::Work& work, std::uint32_t mode, fit::FitInput& input);

    // Returns the part of the progress for the fit itself.
    [[nodiscard]] base::Progress rest(const base::Progress& progress) const noexcept;
    void report(fit::FitReport& report) const noexcept;

private:
    static constexpr double share = 0.5; // the share of the progress for the normals

    bool made_ = false;
    bool inward_ = false;
    base::Array<double> packed_;
    orient::OrientReport found_;
};

} // namespace hrbfnpr::api
