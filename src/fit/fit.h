// SPDX-License-Identifier: MIT
// Computes the coefficients of a Hermite RBF implicit from samples.   [NPAR 4.1]
#pragma once

#include "base/operation.h"
#include "base/view.h"
#include "base/work.h"
#include "fit/samples.h"
#include "fit/solver_kind.h"
#include "implicit/hrbf.h"

#include <limits>
#include <optional>

namespace hrbfnpr::fit {

// The fields of the structs below mean the same as the fields of hrbfnpr_fit_desc, and messages use the names of that
// struct. Both views have 3 components of float32 or float64. Their counts are equal and at least 1, which the boundary
// checks.
enum class Repair : std::uint32_t { keep = 0, drop = 1, reorient = 2 };
enum class RegularizationMode : std::uint32_t { given = 0, automatic = 1 };

struct FitInput {
    base::InView points;
    base::InView normals;
    kernel::Kind kernel = kernel::Kind::triharmonic;
    double kernel_radius = 0.0; // 0 = automatic
    std::int32_t polynomial_degree = 1;
    double regularization = 0.0;
    std::int32_t refinement_steps = 2;
    double tolerance = 0.0;           // in the caller's unit; 0: no tolerance
    std::int64_t maximum_centres = 0; // 0 = no limit
    Repair outliers = Repair::keep;
    Repair flipped_normals = Repair::keep;
    RegularizationMode regularization_mode = RegularizationMode::given;
    SolverKind solver = SolverKind::automatic;
    std::uint32_t preconditioner_neighbours = 0; // 0 = automatic
    double solver_tolerance = 0.0;               // 0 = automatic
    // The tolerance that replaces a `solver_tolerance` of 0. If both are 0, the tolerance depends on the number of
    // centres.
    double automatic_tolerance = 0.0;
    std::int32_t iteration_limit = 200;
};

struct FitReport {
    std::int64_t samples = 0;
    std::int64_t merged_samples = 0;
    std::int64_t rescaled_normals = 0;
    double kernel_radius = 0.0; // in the caller's unit
    double regularization = 0.0;
    double value_residual_max = 0.0;
    double value_residual_rms = 0.0;
    double gradient_residual_max = 0.0;
    double gradient_residual_rms = 0.0;
    double solver_residual = 0.0;
    double condition_estimate = 0.0;
    std::int32_t iterations = 0;
    bool fallback = false;
    double seconds_assemble = 0.0;
    double seconds_solve = 0.0;
    double seconds_total = 0.0;
    std::int64_t outliers_found = 0;
    std::int64_t outliers_dropped = 0;
    std::int64_t flipped_found = 0;
    std::int64_t flipped_repaired = 0;
    std::int64_t near_duplicates = 0;
    double noise_estimate = std::numeric_limits<double>::quiet_NaN(); // in the caller's unit; NaN: not measured
    double input_distance_max = 0.0;
    double input_distance_rms = 0.0;
    double input_share_within = std::numeric_limits<double>::quiet_NaN(); // NaN: no tolerance was given
    std::int32_t choice_rounds = 0;
    SolverKind solver = SolverKind::direct; // the solver that was used
    SolverReason solver_reason = SolverReason::small;
    double seconds_clean = 0.0;
    double seconds_choose = 0.0;
    double seconds_precondition = 0.0;
    std::int64_t peak_bytes = 0;
    // The caller of fit() sets these fields, which describe the repairs of normals before the fit.
    std::uint32_t normals_found = 0;
    bool normals_inward = false;
    std::int64_t normals_turned = 0;
    double normals_confidence = std::numeric_limits<double>::quiet_NaN();
    double seconds_orient = 0.0;
};

struct FitResult {
    implicit::HrbfData data;
    FitReport report;
    // The relative residual after each iteration of the iterative solver; empty for the direct solver.
    base::Array<double> history;
    std::optional<Samples> samples = std::nullopt; // all samples after repairs; set by fit()
};

// Throws Error{invalid_argument, singular_system, out_of_memory, cancelled}.
[[nodiscard]] FitResult fit(const base::Work& work, const FitInput& input);

} // namespace hrbfnpr::fit
