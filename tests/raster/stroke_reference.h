// SPDX-License-Identifier: MIT
// The coverage of a stroke, computed plainly in doubles: the union of quads, sectors and caps, line by line.
#pragma once

#include "drawing/dot.h"
#include "geometry/vec.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace hrbfnpr::testing {

// The part of a disc, or of the plane, that is on the inner side of some lines.
struct StrokePart {
    struct Side {
        glm::dvec2 at, inward;
    };
    std::vector<Side> sides;
    glm::dvec2 centre{0.0};
    double radius = std::numeric_limits<double>::infinity();
    double middle = 0.0, reach = 0.0; // lines farther than `reach` from y = middle do not meet it

    void left_of(const glm::dvec2& from, const glm::dvec2& to) {
        const glm::dvec2 along = to - from;
        if (along.x != 0.0 || along.y != 0.0) sides.push_back({from, {along.y, -along.x}});
    }
    // Finds the interval of the line at height y that is inside.
    [[nodiscard]] bool cut(double y, double& left, double& right) const {
        left = -1e9;
        right = 1e9;
        if (std::isfinite(radius)) {
            const double square = radius * radius - (y - centre.y) * (y - centre.y);
            if (!(square > 0.0)) return false;
            left = centre.x - std::sqrt(square);
            right = centre.x + std::sqrt(square);
        }
        for (const Side& s : sides) {
            const double rest = glm::dot(s.inward, glm::dvec2(0.0, y) - s.at);
            if (s.inward.x == 0.0) {
                if (rest < 0.0) return false;
            } else if (s.inward.x > 0.0) {
                left = std::max(left, -rest / s.inward.x);
            } else {
                right = std::min(right, -rest / s.inward.x);
            }
        }
        return left < right;
    }
};

class StrokeReference {
public:
    StrokeReference(const std::vector<drawing::StrokePoint>& points, const drawing::Stroke& stroke) {
        for (std::int64_t i = stroke.first; i + 1 < stroke.first + stroke.count; ++i) {
            const drawing::StrokePoint& p = points[static_cast<std::size_t>(i)];
            const drawing::StrokePoint& q = points[static_cast<std::size_t>(i) + 1];
            const Leg leg{{p.x, p.y}, {q.x, q.y}, static_cast<double>(p.radius), static_cast<double>(q.radius)};
            if (glm::distance(leg.a, leg.b) > 1e-6) legs_.push_back(leg);
        }
        if (legs_.empty()) {
            const drawing::StrokePoint& p = points[static_cast<std::size_t>(stroke.first)];
            add_half_disc({p.x, p.y}, {0.0, 1.0}, static_cast<double>(p.radius));
            add_half_disc({p.x, p.y}, {0.0, -1.0}, static_cast<double>(p.radius));
            return;
        }
        for (const Leg& leg : legs_) add_quad(leg);
        for (std::size_t i = 1; i < legs_.size(); ++i) add_sector(legs_[i - 1], legs_[i]);
        if (stroke.closed) {
            add_sector(legs_.back(), legs_.front());
        } else {
            add_cap(legs_.front().a, -legs_.front().along(), legs_.front().radius_a, stroke.cap_begin);
            add_cap(legs_.back().b, legs_.back().along(), legs_.back().radius_b, stroke.cap_end);
        }
    }

    // Returns the covered part of each pixel of a square: exact along x, and by many lines along y.
    [[nodiscard]] std::vector<double> coverage(int side, double left, double top) const {
        constexpr int lines = 400;
        std::vector<double> cover(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), 0.0);
        std::vector<std::pair<double, double>> spans;
        for (int k = 0; k < side * lines; ++k) {
            spans.clear();
            const double y = top + (k + 0.5) / lines;
            for (const StrokePart& part : parts_) {
                if (std::abs(y - part.middle) > part.reach) continue;
                double from = 0.0;
                double to = 0.0;
                if (!part.cut(y, from, to)) continue;
                from = std::max(from - left, 0.0);
                to = std::min(to - left, static_cast<double>(side));
                if (from < to) spans.emplace_back(from, to);
            }
            std::sort(spans.begin(), spans.end());
            double* const row = cover.data() + static_cast<std::ptrdiff_t>(k / lines) * side;
            double done = 0.0;
            for (const auto& [from, to] : spans) {
                for (double x = std::max(from, done); x < to; x = std::floor(x) + 1.0)
                    row[static_cast<int>(x)] += (std::min(to, std::floor(x) + 1.0) - x) / lines;
                done = std::max(done, to);
            }
        }
        return cover;
    }

private:
    struct Leg {
        glm::dvec2 a, b;
        double radius_a, radius_b;
        [[nodiscard]] glm::dvec2 along() const { return glm::normalize(b - a); }
        [[nodiscard]] glm::dvec2 across() const { return {along().y, -along().x}; }
    };

    void add_quad(const Leg& leg) {
        const glm::dvec2 n = leg.across();
        StrokePart part;
        part.middle = leg.a.y;
        part.reach = glm::distance(leg.a, leg.b) + leg.radius_a + leg.radius_b;
        part.left_of(leg.b + leg.radius_b * n, leg.a + leg.radius_a * n);
        part.left_of(leg.a - leg.radius_a * n, leg.b - leg.radius_b * n);
        part.sides.push_back({leg.a, leg.along()});
        part.sides.push_back({leg.b, -leg.along()});
        parts_.push_back(part);
    }
    // Adds the sector of the disc around the common point of two legs that is beyond the end of the first and before
    // the beginning of the second.
    void add_sector(const Leg& before, const Leg& after) {
        StrokePart part;
        part.centre = after.a;
        part.radius = part.reach = std::max(before.radius_b, after.radius_a);
        part.middle = after.a.y;
        part.sides.push_back({after.a, before.along()});
        part.sides.push_back({after.a, -after.along()});
        parts_.push_back(part);
    }
    void add_half_disc(const glm::dvec2& at, const glm::dvec2& out, double radius) {
        StrokePart part;
        part.centre = at;
        part.radius = part.reach = radius;
        part.middle = at.y;
        part.sides.push_back({at, out});
        parts_.push_back(part);
    }
    void add_cap(const glm::dvec2& at, const glm::dvec2& out, double radius, drawing::Cap cap) {
        if (cap == drawing::Cap::round) add_half_disc(at, out, radius);
        if (cap != drawing::Cap::pointed || !(radius > 0.0)) return;
        const glm::dvec2 across(out.y, -out.x);
        const glm::dvec2 tip = at + 2.0 * static_cast<double>(drawing::point_length) * radius * out;
        StrokePart part;
        part.middle = at.y;
        part.reach = glm::distance(at, tip) + radius;
        part.left_of(tip, at + radius * across);
        part.left_of(at - radius * across, tip);
        part.sides.push_back({at, out});
        parts_.push_back(part);
    }

    std::vector<Leg> legs_;
    std::vector<StrokePart> parts_;
};

} // namespace hrbfnpr::testing
