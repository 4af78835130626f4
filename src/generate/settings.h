// What to generate.
#pragma once

#include "base/view.h"
#include "marks/point_set.h"
#include "marks/tone_part.h"
#include "published/growth.h"
#include "stipples/density.h"
#include "strokes/settings.h"

#include <array>
#include <span>

namespace hrbfnpr::generate {

struct GroupSettings {
    bool wanted = false;
    std::int64_t budget = 0;
    bool with_curvature = false; // fill MarkGroup::curvature
    published::Settings published;
};

struct SeedSettings {
    marks::SeedSource source = marks::SeedSource::automatic;
    base::InView points;
    std::int32_t box_resolution = 8;
    double box_jitter = 0.25;
    double initial_step = 0.0;
};

// Same numbers as HRBFNPR_LAYER_...: stipples, then the two sets of each group of strokes.
inline constexpr std::size_t layer_count = 5;

// Checked by the boundary; defaults as in hrbfnpr_generate_desc.
struct Settings {
    marks::Distribution distribution = marks::Distribution::blue_noise;
    double projection_tolerance = 1e-7;
    std::uint64_t random_seed = 1;
    SeedSettings seeds;
    stipples::DensitySettings density;
    strokes::Settings strokes;
    std::array<GroupSettings, marks::group_count> group;
    std::array<marks::TonePart, layer_count> layer;
};

// What is known of the samples that the implicit came from: 3n packed positions, empty
// for a custom implicit.  (The samples lie on the surface; their normals are gradients.)
struct SampleHint {
    std::span<const double> position;
    double spacing = 0.0;
};

} // namespace hrbfnpr::generate
