// SPDX-License-Identifier: MIT
// The first half of a frame by layers: from clusters of marks to ink and splats.     [NPAR 6, 6.2]
#pragma once

#include "base/runtime.h"
#include "drawing/drawing.h"
#include "drawing/tiles.h"
#include "frame/scene/cluster_view.h"
#include "frame/scene/tone_calls.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::frame {

// How the marks of an item lie.
enum class Overlap : unsigned char {
    random,     // anywhere: coverage = 1 - exp(-x)
    blue_noise, // apart from each other: measured
    lines       // evenly spaced lines in so many layers
};

// Ink per area x of a blue-noise order whose discs cover 0, 1/16, 2/16 ... of it: measured on a flat patch, over
// prefixes of 5 to 100 % and radii of 1 to 3 pixels (docs/quality.md).
inline constexpr std::array<float, 17> blue_noise_ink = {0.0F,    0.0625F, 0.1250F, 0.1875F, 0.2500F, 0.3125F,
                                                         0.3755F, 0.4400F, 0.5068F, 0.5772F, 0.6528F, 0.7362F,
                                                         0.8318F, 0.9479F, 1.1005F, 1.3370F, 3.0000F};

// The ink of a disc as it is drawn, square pixels: its rim falls off over a pixel, and below half a pixel of radius it
// gets paler instead of smaller.
[[nodiscard]] inline float disc_ink(float radius) noexcept {
    constexpr float pi = 3.14159265F;
    const float drawn = std::max(radius, smallest_radius);
    const float dimmed = radius / drawn;
    return pi * (drawn * drawn + 1.0F / 12.0F) * dimmed * dimmed;
}

[[nodiscard]] inline float root(float x, float n) noexcept {
    return n == 2.0F ? std::sqrt(x) : n == 3.0F ? std::cbrt(x) : std::pow(x, 1.0F / n);
}

// How much ink a tone takes: from coverage to ink per area, discs that overlap counted twice.
// coverage in [0, 1]; at 1 the result is large.  layers: how many lie over each other, of lines.
[[nodiscard]] inline float ink_for(float coverage, Overlap overlap, float layers) noexcept {
    const float left = std::max(1.0F - coverage, 1e-4F);
    switch (overlap) {
    case Overlap::random: return -std::log(left);
    case Overlap::lines: return layers == 1.0F ? coverage : layers * (1.0F - root(left, layers));
    case Overlap::blue_noise: break;
    }
    const float at = std::clamp(coverage, 0.0F, 1.0F) * 16.0F;
    const auto cell = static_cast<std::size_t>(std::min(at, 15.0F));
    const float part = at - static_cast<float>(cell);
    return blue_noise_ink[cell] + (blue_noise_ink[cell + 1] - blue_noise_ink[cell]) * part;
}

// How much ink there is per area of an item's image, if all of its marks are shown.
struct ItemInk {
    struct Term {
        const Pen* pen = nullptr;
        float marks_per_area = 0.0F; // in eye space
        float step = 0.0F;           // between the marks of a stroke, eye units; 0: no strokes
    };
    std::int64_t first = 0, end = 0; // of its terms
    // ink_for() of these coverages, so that a mark need not take a root.
    std::array<float, needed_steps + 1> needed{};
};

// What a layer lets through, by |nu|.
struct TransmittanceTable {
    static constexpr std::size_t steps = 256;
    std::array<float, steps + 1> front, back;
    float halo;

    [[nodiscard]] float at(float nu) const noexcept {
        const auto step = static_cast<std::size_t>(std::min(std::abs(nu), 1.0F) * steps + 0.5F);
        return nu > 0.0F ? back[step] : front[step];
    }
};

class Gather {
public:
    explicit Gather(const base::Runtime& runtime) noexcept;

    // Throws Error{callback, out_of_memory}.
    // Fills the dots and splats of `drawing`.
    void run(Scene& scene, drawing::Drawing& drawing);

    [[nodiscard]] Counts info() const noexcept;

    // Of the last run.
    [[nodiscard]] std::span<const ItemSight> sights() const noexcept { return sights_.span(); } // of each item
    [[nodiscard]] const Frustum& frustum() const noexcept { return frustum_; }
    [[nodiscard]] const base::Array<float>& taus() const noexcept { return tau_; } // by place, of callbacks
    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    friend class Gatherer;

    void set_up(const Scene& scene);
    void add_pieces(const Scene& scene);
    [[nodiscard]] ItemInk ink_of(const Scene& scene, std::int64_t first);
    [[nodiscard]] float ink_per_pixel(const ItemInk& item, float pixels_per_unit) const noexcept;
    void ask_tones(Scene& scene);
    void ask_cluster(const Scene& scene, const Run& run, const marks::Cluster& cluster);

    // Consecutive clusters of a run: the unit of work.
    struct Work {
        std::int32_t run;
        std::int32_t begin, end;  // clusters
        std::int64_t first_place; // of its marks in the arrays
    };

    const base::Runtime& runtime_;
    SeeLoops loops_;
    Frustum frustum_;
    base::Array<ItemSight> sights_;
    base::Array<ItemInk> item_inks_;
    base::Array<ItemInk::Term> terms_; // of all items
    base::Array<TransmittanceTable> transmittances_;
    base::Array<std::int32_t> transmittance_of_; // each item's
    base::Array<Work> work_;
    base::Array<Counts> counts_;
    std::int64_t unused_ = 0; // marks that are in no work
    base::Array<float> tau_;  // of the marks whose tone is a callback's, by place
    ToneCalls tone_calls_;
};

} // namespace hrbfnpr::frame
