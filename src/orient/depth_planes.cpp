// SPDX-License-Identifier: MIT
#include "orient/depth_planes.h"

#include <cmath>

namespace hrbfnpr::orient {
namespace {

constexpr std::int32_t small = 2;
constexpr double small_count = 25.0;
constexpr double small_square = 50.0; // sum of (pixels to the right)^2 of the 25

constexpr int plane_rounds = 3;
constexpr double gate = 6.5;       // standard deviations of noise: of a camera with depth steps, 2.5 of these
constexpr double least_part = 0.1; // of the disc
constexpr double ridge = 1e-2;     // pixels^2: pixels in one row tell nothing of the slope across it

constexpr std::int32_t all_pixels_up_to = 5;
constexpr int rings = 6;                                        // of 6, 12, ... pixels, of larger discs
constexpr std::int64_t most_taps = 1 + 3 * rings * (rings + 1); // of a disc
constexpr double least_weight = 0.1;

[[nodiscard]] double weight_of(double square) noexcept { return 1.0 - (1.0 - least_weight) * square; }

void add_whole_disc(std::int32_t radius, base::Array<Tap>& taps) {
    const double square = (radius + 0.5) * (radius + 0.5);
    for (std::int32_t down = -radius; down <= radius; ++down)
        for (std::int32_t across = -radius; across <= radius; ++across) {
            const double away = (static_cast<double>(across) * across + static_cast<double>(down) * down) / square;
            if (away <= 1.0) taps.push_back({across, down, weight_of(away)});
        }
}

void add_ringed_disc(std::int32_t radius, base::Array<Tap>& taps) {
    taps.push_back({0, 0, 1.0});
    for (int ring = 1; ring <= rings; ++ring)
        for (int k = 0; k < 6 * ring; ++k) {
            const double angle = (k + 0.5 * (ring % 2)) / (6 * ring) * 6.283185307179586;
            const double away = static_cast<double>(ring) / rings;
            taps.push_back({static_cast<std::int32_t>(std::lround(away * radius * std::cos(angle))),
                            static_cast<std::int32_t>(std::lround(away * radius * std::sin(angle))),
                            weight_of(away * away)});
        }
}

// Weighted least squares of a plane.
struct Sums {
    double weight = 0.0;
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
    double d = 0.0, dx = 0.0, dy = 0.0;

    void add(const Tap& tap, double depth) noexcept {
        const double w = tap.weight;
        const double wx = w * tap.across;
        const double wy = w * tap.down;
        weight += w;
        x += wx;
        y += wy;
        xx += wx * tap.across;
        xy += wx * tap.down;
        yy += wy * tap.down;
        d += w * depth;
        dx += wx * depth;
        dy += wy * depth;
    }

    [[nodiscard]] DepthPlane plane() const noexcept {
        const double mx = x / weight;
        const double my = y / weight;
        const double cxx = xx - mx * x + ridge * weight;
        const double cxy = xy - mx * y;
        const double cyy = yy - my * y + ridge * weight;
        const double bx = dx - mx * d;
        const double by = dy - my * d;
        const double determinant = cxx * cyy - cxy * cxy;
        DepthPlane plane;
        plane.across = (cyy * bx - cxy * by) / determinant;
        plane.down = (cxx * by - cxy * bx) / determinant;
        plane.value = d / weight - plane.across * mx - plane.down * my;
        return plane;
    }
};

} // namespace

std::optional<SmallPlane> small_plane(const InverseDepth& depth, std::int32_t column, std::int32_t row) noexcept {
    if (column < small || row < small || column >= depth.columns - small || row >= depth.rows - small)
        return std::nullopt;
    const double here = depth.at(column, row); // taken off: what is left of the squares is not lost in rounding
    double sum = 0.0;
    double across = 0.0;
    double down = 0.0;
    double squares = 0.0;
    for (std::int32_t y = -small; y <= small; ++y)
        for (std::int32_t x = -small; x <= small; ++x) {
            const double d = depth.at(column + x, row + y) - here;
            sum += d;
            across += x * d;
            down += y * d;
            squares += d * d;
        }
    if (!std::isfinite(squares)) return std::nullopt;
    const double off = squares - sum * sum / small_count - (across * across + down * down) / small_square;
    return SmallPlane{{here + sum / small_count, across / small_square, down / small_square},
                      std::sqrt(std::max(off, 0.0) / (small_count - 3.0))};
}

Discs::Discs(base::Memory& memory) : taps_(memory) {
    taps_.reserve(most_taps * (most - least + 1));
    for (std::int32_t radius = least; radius <= most; ++radius) {
        if (radius <= all_pixels_up_to)
            add_whole_disc(radius, taps_);
        else
            add_ringed_disc(radius, taps_);
        start_[static_cast<std::size_t>(radius - least) + 1] = taps_.size();
    }
}

std::optional<DepthPlane> plane_around(const InverseDepth& depth, std::int32_t column, std::int32_t row,
                                       std::span<const Tap> disc, const SmallPlane& first) noexcept {
    const double here = depth.at(column, row);
    const double limit = gate * first.error;
    DepthPlane plane = first.plane;
    double whole = 0.0;
    for (const Tap& tap : disc) whole += tap.weight;
    for (int round = 0; round < plane_rounds; ++round) {
        Sums sums;
        for (const Tap& tap : disc) {
            const std::int32_t x = column + tap.across;
            const std::int32_t y = row + tap.down;
            if (x < 0 || y < 0 || x >= depth.columns || y >= depth.rows) continue;
            const double d = depth.at(x, y);
            const double off = d - (plane.value + plane.across * tap.across + plane.down * tap.down);
            if (std::abs(off) <= limit) sums.add(tap, d - here);
        }
        if (!(sums.weight >= least_part * whole)) return std::nullopt;
        plane = sums.plane();
        plane.value += here;
    }
    return std::abs(plane.value - here) <= limit ? std::optional(plane) : std::nullopt;
}

} // namespace hrbfnpr::orient
