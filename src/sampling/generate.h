// Placing marks on an implicit surface.                              [NPAR 4.2, 5]
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "base/view.h"
#include "implicit/implicit.h"
#include "sampling/density.h"
#include "sampling/point_set.h"
#include "sampling/tone_part.h"

#include <array>
#include <span>

namespace hrbfnpr::sampling {

struct GroupSettings {
    bool wanted = false;
    std::int32_t levels = 3;
    bool from_stipples = false; // PAPER: start from the stipples up to `seed_level`, not from the seeds
    std::int32_t seed_level = 0;
    std::int64_t budget = 0;
    bool with_curvature = false; // fill MarkGroup::curvature
};

// Same numbers as HRBFNPR_LAYER_...: stipples, then the two sets of each group of strokes.
inline constexpr std::size_t layer_count = 5;

// Checked by the boundary; defaults as in hrbfnpr_generate_desc.
struct GenerateSettings {
    Distribution distribution = Distribution::blue_noise;
    SeedSource seed_source = SeedSource::automatic;
    std::int32_t box_resolution = 8;
    double box_jitter = 0.25;
    double initial_step = 0.0;
    double projection_tolerance = 1e-7;
    std::uint64_t random_seed = 1;
    base::InView seed_points;
    // BLUE_NOISE strokes, in object units
    double stroke_separation = 0.0; // 0 = from the budget
    double stroke_step = 0.0;       // 0 = a part of the separation
    double stroke_length = 0.0;     // 0 = no limit
    StrokeField stroke_field = StrokeField::cross;
    std::array<GroupSettings, group_count> group;
    DensitySettings density;
    std::array<TonePart, layer_count> layer;
};

// What is known of the samples that the implicit came from: 3n packed positions, empty
// for a custom implicit.  (The samples lie on the surface; their normals are gradients.)
struct SampleHint {
    std::span<const double> position;
    double spacing = 0.0;
};

// What can be refused before any work: sizes that floats do not hold, lengths that make no sense beside the model's,
// and budgets that are too large.  generate() and step_patches() check it themselves.
void check_request(const implicit::Implicit& implicit, const GenerateSettings& settings);

// Throws Error{invalid_argument, not_converged, out_of_memory, cancelled, callback}.
[[nodiscard]] PointSet generate(const base::Runtime& runtime, const implicit::Implicit& implicit,
                                const SampleHint& samples, const GenerateSettings& settings,
                                const base::Progress& progress);

// Of the implicit, roughly.
[[nodiscard]] double expected_evaluations(const SampleHint& samples, const GenerateSettings& settings) noexcept;

// Figure 5: `corners.count` squares of side 2 rho_0 in tangent planes of random seeds,
// 12 numbers each.  Returns rho_0.
double step_patches(const base::Runtime& runtime, const implicit::Implicit& implicit, const SampleHint& samples,
                    const GenerateSettings& settings, const base::OutView& corners, const base::Progress& progress);

// Ready-made marks; empty views as described at hrbfnpr_group_arrays.
struct GroupArrays {
    base::InView position, normal, direction, curvature, rank, level, stroke, width;
};
[[nodiscard]] PointSet from_arrays(const base::Runtime& runtime, const std::array<GroupArrays, group_count>& arrays,
                                   std::uint64_t random_seed);

} // namespace hrbfnpr::sampling
