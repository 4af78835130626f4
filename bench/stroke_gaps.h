// SPDX-License-Identifier: MIT
// The distances between the lines of a picture, measured across them.
#pragma once

#include "drawn_stroke.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>

namespace bench {

// All segments of all strokes, found by place.
class StrokeSegments {
public:
    struct Segment {
        std::int32_t stroke;
        std::int32_t point; // the segment runs from this point to the next
    };

    explicit StrokeSegments(const std::vector<DrawnStroke>& strokes) : strokes_(strokes) {
        for (std::size_t s = 0; s < strokes.size(); ++s)
            for (std::size_t i = 0; i + 1 < strokes[s].size(); ++i)
                add({static_cast<std::int32_t>(s), static_cast<std::int32_t>(i)});
    }
    [[nodiscard]] const StrokePoint& begin(const Segment& s) const { return at(s, 0); }
    [[nodiscard]] const StrokePoint& end(const Segment& s) const { return at(s, 1); }

    // Visits the segments whose boxes are in the cells of a box; some more than once.
    template <class Visit>
    void in_box(double x0, double y0, double x1, double y1, Visit&& visit) const {
        for (int i = cell(std::min(x0, x1)); i <= cell(std::max(x0, x1)); ++i)
            for (int j = cell(std::min(y0, y1)); j <= cell(std::max(y0, y1)); ++j)
                if (const auto found = cells_.find(key(i, j)); found != cells_.end())
                    for (const Segment& segment : found->second) visit(segment);
    }

private:
    static constexpr double side = 8.0;
    [[nodiscard]] static int cell(double x) { return static_cast<int>(std::floor(x / side)); }
    [[nodiscard]] static std::int64_t key(int i, int j) { return std::int64_t{i} * 1'000'003 + j; }
    [[nodiscard]] const StrokePoint& at(const Segment& s, int more) const {
        return strokes_[static_cast<std::size_t>(s.stroke)][static_cast<std::size_t>(s.point + more)];
    }
    void add(const Segment& s) {
        const StrokePoint& a = begin(s);
        const StrokePoint& b = end(s);
        for (int i = cell(static_cast<double>(std::min(a.x, b.x))); i <= cell(static_cast<double>(std::max(a.x, b.x)));
             ++i)
            for (int j = cell(static_cast<double>(std::min(a.y, b.y)));
                 j <= cell(static_cast<double>(std::max(a.y, b.y))); ++j)
                cells_[key(i, j)].push_back(s);
    }

    const std::vector<DrawnStroke>& strokes_;
    std::unordered_map<std::int64_t, std::vector<Segment>> cells_;
};

struct GapSettings {
    double step = 5.0;      // along the strokes, pixels
    double farthest = 20.0; // a side without a line this near is alone
    double parallel = 0.7;  // the least cosine between neighbours
};

struct Gap {
    double size = std::numeric_limits<double>::infinity(); // pixels
    std::uint32_t beside = 0;                              // id of a mark of the neighbouring line
};

// A place on a stroke, and the direction across it to one side.
struct GapRay {
    StrokePoint from;
    double tx, ty, side; // unit tangent; 1 or -1

    [[nodiscard]] double nx() const { return -side * ty; }
    [[nodiscard]] double ny() const { return side * tx; }
};

// Returns the distance at which the ray meets a segment of a nearly parallel line, or 0.
[[nodiscard]] inline double meets(const GapRay& ray, const StrokePoint& c, const StrokePoint& d, double parallel) {
    const auto ex = static_cast<double>(d.x - c.x);
    const auto ey = static_cast<double>(d.y - c.y);
    const double across = ex * ray.ny() - ey * ray.nx();
    if (std::abs(ex * ray.tx + ey * ray.ty) < parallel * std::hypot(ex, ey) || across == 0.0) return 0.0;
    const auto cx = static_cast<double>(c.x - ray.from.x);
    const auto cy = static_cast<double>(c.y - ray.from.y);
    const double along = (ray.nx() * cy - ray.ny() * cx) / across;
    return along >= 0.0 && along <= 1.0 ? std::max((ex * cy - ey * cx) / across, 0.0) : 0.0;
}

[[nodiscard]] inline std::optional<Gap> find_gap(const StrokeSegments& segments, const StrokeSegments::Segment& own,
                                                 const GapRay& ray, const GapSettings& settings) {
    constexpr int near = 8; // points along the line itself, which may return to the place later
    Gap nearest;
    const auto x = static_cast<double>(ray.from.x);
    const auto y = static_cast<double>(ray.from.y);
    const double reach = settings.farthest;
    segments.in_box(x, y, x + reach * ray.nx(), y + reach * ray.ny(), [&](const auto& other) {
        if (other.stroke == own.stroke && std::abs(other.point - own.point) < near) return;
        const double away = meets(ray, segments.begin(other), segments.end(other), settings.parallel);
        if (away > 0.0 && away < std::min(nearest.size, reach)) nearest = {away, segments.begin(other).id};
    });
    return nearest.beside != 0 ? std::optional<Gap>(nearest) : std::nullopt;
}

// Calls found(point, optional gap) for both sides of places along all strokes.
template <class Found>
void for_each_gap(const std::vector<DrawnStroke>& strokes, const GapSettings& settings, Found&& found) {
    const StrokeSegments segments(strokes);
    for (std::size_t s = 0; s < strokes.size(); ++s) {
        double next = 0.5 * settings.step; // from the start of the segment
        for (std::size_t i = 0; i + 1 < strokes[s].size(); ++i) {
            const StrokePoint& a = strokes[s][i];
            const StrokePoint& b = strokes[s][i + 1];
            const double length = distance_of(a, b);
            for (; next < length; next += settings.step)
                for (const double side : {-1.0, 1.0}) {
                    GapRay ray{a, static_cast<double>(b.x - a.x) / length, static_cast<double>(b.y - a.y) / length,
                               side};
                    ray.from.x += static_cast<float>(next / length) * (b.x - a.x);
                    ray.from.y += static_cast<float>(next / length) * (b.y - a.y);
                    const StrokeSegments::Segment own{static_cast<std::int32_t>(s), static_cast<std::int32_t>(i)};
                    found(ray.from, find_gap(segments, own, ray, settings));
                }
            next -= length;
        }
    }
}

struct Spread {
    double mean = 0.0, variation = 0.0; // variation: standard deviation over mean
};

[[nodiscard]] inline Spread spread_of(const std::vector<double>& values) {
    double sum = 0.0;
    double squares = 0.0;
    for (const double v : values) sum += v, squares += v * v;
    const auto n = static_cast<double>(values.size());
    const double mean = sum / n;
    return {mean, std::sqrt(std::max(squares / n - mean * mean, 0.0)) / mean};
}

} // namespace bench
