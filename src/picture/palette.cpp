// SPDX-License-Identifier: MIT
#include "picture/palette.h"

#include "api/views.h"
#include "base/assert.h"
#include "picture/tuning_plan.h"

#include <hrbfnpr.h>

#include <algorithm>
#include <cmath>

namespace hrbfnpr::picture {
namespace {

using Lab = std::array<double, 3>; // lightness 0 .. 1, and two axes of colour

double linear_of(double coded) noexcept {
    return coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4);
}

double coded_of(double linear) noexcept {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

// Converts between sRGB and Oklab [Ottosson 2020].
Lab lab_of(const std::array<float, 3>& rgb) noexcept {
    const double r = linear_of(static_cast<double>(rgb[0]));
    const double g = linear_of(static_cast<double>(rgb[1]));
    const double b = linear_of(static_cast<double>(rgb[2]));
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

std::array<double, 3> linear_rgb_of(const Lab& lab) noexcept {
    const auto cube = [](double x) { return x * x * x; };
    const double l = cube(lab[0] + 0.3963377774 * lab[1] + 0.2158037573 * lab[2]);
    const double m = cube(lab[0] - 0.1055613458 * lab[1] - 0.0638541728 * lab[2]);
    const double s = cube(lab[0] - 0.0894841775 * lab[1] - 1.2914855480 * lab[2]);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

double squared_distance(const Lab& a, const Lab& b) noexcept {
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum;
}

std::size_t nearest_of(const Vector<Lab>& middles, const Lab& colour) noexcept {
    const auto nearer = [&](const Lab& a, const Lab& b) {
        return squared_distance(a, colour) < squared_distance(b, colour);
    };
    return static_cast<std::size_t>(std::min_element(middles.begin(), middles.end(), nearer) - middles.begin());
}

Lab mean_of(const Vector<Lab>& colours) noexcept {
    Lab sum{};
    for (const Lab& colour : colours)
        for (std::size_t i = 0; i < 3; ++i) sum[i] += colour[i] / static_cast<double>(colours.size());
    return sum;
}

// Returns the colours that groups start from: the one farthest from the mean, then the one farthest from those before,
// while they differ visibly.
Vector<Lab> first_middles(const Vector<Lab>& colours, Pool& pool) {
    Vector<Lab> middles(&pool);
    const Lab mean = mean_of(colours);
    const double least = palette_tuning.least_difference * palette_tuning.least_difference;
    while (middles.size() < palette_tuning.inks) {
        const auto distance = [&](const Lab& colour) {
            return squared_distance(colour, middles.empty() ? mean : middles[nearest_of(middles, colour)]);
        };
        const Lab* farthest = colours.data();
        for (const Lab& colour : colours)
            if (distance(colour) > distance(*farthest)) farthest = &colour;
        if (!middles.empty() && distance(*farthest) < least) break;
        middles.push_back(*farthest);
    }
    return middles;
}

// Moves each middle to the mean of the colours that are nearest to it.
void move_middles(const Vector<Lab>& colours, Vector<Lab>& middles, Pool& pool) {
    Vector<Lab> sums(middles.size(), Lab{}, &pool);
    Vector<double> counts(middles.size(), 0.0, &pool);
    for (const Lab& colour : colours) {
        const std::size_t group = nearest_of(middles, colour);
        for (std::size_t i = 0; i < 3; ++i) sums[group][i] += colour[i];
        counts[group] += 1.0;
    }
    for (std::size_t group = 0; group < middles.size(); ++group)
        if (counts[group] > 0.0)
            for (std::size_t i = 0; i < 3; ++i) middles[group][i] = sums[group][i] / counts[group];
}

// Returns a darker ink of the same hue. Its chroma is reduced until the ink can be shown.
std::array<float, 4> darker_ink(const Lab& colour) noexcept {
    const double lightness = palette_tuning.darkness * colour[0];
    double chroma = palette_tuning.chroma;
    std::array<double, 3> linear{};
    for (int step = 0; step < 32; ++step, chroma *= 0.9) {
        linear = linear_rgb_of({lightness, chroma * colour[1], chroma * colour[2]});
        const auto can_be_shown = [](double part) { return part >= 0.0 && part <= 1.0; };
        if (std::all_of(linear.begin(), linear.end(), can_be_shown)) break;
    }
    std::array<float, 4> ink{0.0F, 0.0F, 0.0F, 1.0F};
    // Inks have 8 bits, so that the note about them names them exactly.
    for (std::size_t i = 0; i < 3; ++i)
        ink[i] = static_cast<float>(std::nearbyint(255.0 * coded_of(std::clamp(linear[i], 0.0, 1.0))) / 255.0);
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
    Vector<Lab> labs(&pool);
    labs.reserve(colours.size());
    for (const std::array<float, 3>& colour : colours) labs.push_back(lab_of(colour));
    Vector<Lab> middles = first_middles(labs, pool);
    for (int round = 0; round < palette_tuning.rounds; ++round) move_middles(labs, middles, pool);
    std::sort(middles.begin(), middles.end(), [](const Lab& a, const Lab& b) { return a[0] < b[0]; });
    Vector<std::array<float, 4>> inks(&pool);
    for (const Lab& middle : middles) inks.push_back(darker_ink(middle));
    return inks;
}

} // namespace hrbfnpr::picture
