// SPDX-License-Identifier: MIT
// The settings of generate().
#pragma once

#include "base/view.h"
#include "frame/scene/still.h"
#include "hatching/hatching.h"
#include "marks/point_set.h"
#include "published/growth.h"
#include "stipples/blue_noise.h"

#include <array>
#include <span>
#include <vector>

namespace hrbfnpr::generate {

inline constexpr std::int64_t default_budget = 40000;

// The settings of one layer.
struct LayerSettings {
    marks::Kind kind = marks::Kind::stipples;
    marks::LayerName name{}; // empty: the default name of its kind
    std::int64_t budget = default_budget;
    bool with_curvature = false; // whether Layer::curvature is filled
    // The length over which normals for tone are averaged, in diagonals. -1: completed() chooses it.
    double tone_smoothing = -1.0;
    // The tone range of each of the two directions. If `begin` and `end` are both 0, Settings::tone_ranges decides.
    std::array<marks::TonePart, 2> part{marks::TonePart{0.0, 0.0}, marks::TonePart{0.0, 0.0}};
    stipples::DensitySettings density;
    hatching::Settings hatching;
    published::Settings published;

    [[nodiscard]] bool has_strokes() const noexcept { return kind != marks::Kind::stipples; }
};

struct SeedSettings {
    marks::SeedSource source = marks::SeedSource::automatic;
    base::InView points;
    std::int32_t box_resolution = 8;
    double box_jitter = 0.25;
    double initial_step = 0.0;
};

// The values equal those of hrbfnpr_generate_desc.tone_ranges.
enum class ToneRanges : std::uint32_t { full = 0, in_turn = 1 };

// All settings. The API boundary checks the values. The defaults equal those of hrbfnpr_generate_desc.
struct Settings {
    marks::Distribution distribution = marks::Distribution::blue_noise;
    double projection_tolerance = 1e-7;
    std::uint64_t random_seed = 1;
    SeedSettings seeds;
    std::vector<LayerSettings> layers; // if empty, there is one layer of stipples
    std::int64_t shared_budget = 0;
    ToneRanges tone_ranges = ToneRanges::full;
    // The drawing of a still picture, for which marks that it does not need are left out. Null: all marks are placed.
    const frame::Still* still = nullptr;
};

// Returns the settings with values for everything that the caller left open: layers, levels, tone ranges, and the
// budget of each layer. Throws Error{invalid_argument} for settings that are wrong for every model.
[[nodiscard]] Settings completed(Settings settings);

// The samples to which the model was fitted: 3n packed coordinates on the surface. Empty if the model is a function of
// the caller.
struct SampleHint {
    std::span<const double> position;
    double spacing = 0.0;
};

} // namespace hrbfnpr::generate
