// SPDX-License-Identifier: MIT
#include "picture/palette.h"

#include "api/views.h"
#include "base/assert.h"
#include "drawing/color.h"
#include "picture/tuning_plan.h"

#include <hrbfnpr.h>

#include <algorithm>
#include <cmath>

namespace hrbfnpr::picture {
namespace {

using Hue = std::array<double, 2>; // the two axes of colour in Oklab; grey is 0, 0

// The lightness of a colour is left out, because the tone shows it.
Hue hue_of(const std::array<float, 3>& rgb) noexcept {
    glm::dvec3 linear;
    for (int i = 0; i < 3; ++i) linear[i] = drawing::to_linear(static_cast<double>(rgb[static_cast<std::size_t>(i)]));
    const glm::dvec3 lab = drawing::oklab_of(linear);
    return {lab.y, lab.z};
}

// Converts Oklab to linear light.
std::array<double, 3> linear_rgb_of(double lightness, const Hue& hue) noexcept {
    const auto cube = [](double x) { return x * x * x; };
    const double l = cube(lightness + 0.3963377774 * hue[0] + 0.2158037573 * hue[1]);
    const double m = cube(lightness - 0.1055613458 * hue[0] - 0.0638541728 * hue[1]);
    const double s = cube(lightness - 0.0894841775 * hue[0] - 1.2914855480 * hue[1]);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

double squared_distance(const Hue& a, const Hue& b) noexcept {
    double sum = 0.0;
    for (std::size_t i = 0; i < 2; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum;
}

std::size_t nearest_of(const Vector<Hue>& middles, const Hue& colour) noexcept {
    const auto nearer = [&](const Hue& a, const Hue& b) {
        return squared_distance(a, colour) < squared_distance(b, colour);
    };
    return static_cast<std::size_t>(std::min_element(middles.begin(), middles.end(), nearer) - middles.begin());
}

Hue mean_of(const Vector<Hue>& colours) noexcept {
    Hue sum{};
    for (const Hue& colour : colours)
        for (std::size_t i = 0; i < 2; ++i) sum[i] += colour[i] / static_cast<double>(colours.size());
    return sum;
}

// Returns the largest number of inks. If there are only a few hues, each can have its own ink.
std::size_t most_inks(const Vector<Hue>& hues, Pool& pool) {
    Vector<Hue> few(&pool);
    const double same = palette_tuning.same_hue * palette_tuning.same_hue;
    for (const Hue& hue : hues) {
        if (!few.empty() && squared_distance(hue, few[nearest_of(few, hue)]) <= same) continue;
        if (few.size() == palette_tuning.few_inks) return palette_tuning.inks;
        few.push_back(hue);
    }
    return palette_tuning.few_inks;
}

// Returns the colours that groups start from: the one farthest from the mean, then the one farthest from those before,
// while they differ visibly.
Vector<Hue> first_middles(const Vector<Hue>& colours, Pool& pool) {
    Vector<Hue> middles(&pool);
    const std::size_t most = most_inks(colours, pool);
    const Hue mean = mean_of(colours);
    const double least = palette_tuning.least_difference * palette_tuning.least_difference;
    while (middles.size() < most) {
        const auto distance = [&](const Hue& colour) {
            return squared_distance(colour, middles.empty() ? mean : middles[nearest_of(middles, colour)]);
        };
        const Hue* farthest = colours.data();
        for (const Hue& colour : colours)
            if (distance(colour) > distance(*farthest)) farthest = &colour;
        if (!middles.empty() && distance(*farthest) < least) break;
        middles.push_back(*farthest);
    }
    return middles;
}

// Moves each middle to the mean of the colours that are nearest to it.
void move_middles(const Vector<Hue>& colours, Vector<Hue>& middles, Pool& pool) {
    Vector<Hue> sums(middles.size(), Hue{}, &pool);
    Vector<double> counts(middles.size(), 0.0, &pool);
    for (const Hue& colour : colours) {
        const std::size_t group = nearest_of(middles, colour);
        for (std::size_t i = 0; i < 2; ++i) sums[group][i] += colour[i];
        counts[group] += 1.0;
    }
    for (std::size_t group = 0; group < middles.size(); ++group)
        if (counts[group] > 0.0)
            for (std::size_t i = 0; i < 2; ++i) middles[group][i] = sums[group][i] / counts[group];
}

// Returns an ink of a hue. Its chroma is reduced until it can be shown. All inks are equally light, so that the nearest
// ink of a colour is the one of the nearest hue.
std::array<float, 4> ink_of(const Hue& hue) noexcept {
    constexpr double less_chroma = 0.9;
    constexpr int most_steps = 32;
    double chroma = palette_tuning.chroma;
    std::array<double, 3> linear{};
    for (int step = 0; step < most_steps; ++step, chroma *= less_chroma) {
        linear = linear_rgb_of(palette_tuning.lightness, {chroma * hue[0], chroma * hue[1]});
        const auto can_be_shown = [](double part) { return part >= 0.0 && part <= 1.0; };
        if (std::all_of(linear.begin(), linear.end(), can_be_shown)) break;
    }
    std::array<float, 4> ink{0.0F, 0.0F, 0.0F, 1.0F};
    // Inks have 8 bits, so that the note about them names them exactly.
    for (std::size_t i = 0; i < 3; ++i)
        ink[i] =
            static_cast<float>(std::nearbyint(255.0 * drawing::from_linear(std::clamp(linear[i], 0.0, 1.0))) / 255.0);
    return ink;
}

} // namespace

void add_colours(const PointSet& marks, const char* field, Vector<std::array<float, 3>>& colours) {
    auto info = defaults<hrbfnpr_point_set_info>(hrbfnpr_point_set_info_init);
    call([&](hrbfnpr_error* error) { return hrbfnpr_point_set_get_info(marks.get(), &info, error); });
    const std::int64_t step = info.marks / palette_tuning.most_colours + 1;
    for (std::int64_t layer = 0; layer < info.layers; ++layer) {
        hrbfnpr_array values{}, weights{};
        call([&](hrbfnpr_error* error) {
            return hrbfnpr_point_set_view_field(marks.get(), layer, field, &values, &weights, error);
        });
        const base::InView colour = api::in_view(values, "values", {3, api::float32_only});
        const base::InView weight = api::in_view(weights, "weights", {1, api::float32_only});
        for (std::int64_t i = 0; i < colour.count; i += step) {
            if (!weight.empty() && weight.get(i, 0) < 0.5) continue;
            std::array<float, 3>& to = colours.emplace_back();
            for (std::uint32_t k = 0; k < 3; ++k) to[k] = static_cast<float>(colour.get(i, k));
        }
    }
}

Vector<std::array<float, 4>> inks_of(const Vector<std::array<float, 3>>& colours, Pool& pool) {
    HRBFNPR_ASSERT(!colours.empty());
    Vector<Hue> hues(&pool);
    hues.reserve(colours.size());
    for (const std::array<float, 3>& colour : colours) hues.push_back(hue_of(colour));
    Vector<Hue> middles = first_middles(hues, pool);
    for (int round = 0; round < palette_tuning.rounds; ++round) move_middles(hues, middles, pool);
    Vector<std::array<float, 4>> inks(&pool);
    for (const Hue& middle : middles) inks.push_back(ink_of(middle));
    return inks;
}

} // namespace hrbfnpr::picture
