// SPDX-License-Identifier: MIT
// Drawn feature lines against those of a dense reference: how much of each lies within a pixel of the other.
#pragma once

#include "feature_grid.h"
#include "line_models.h"
#include "line_views.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace bench {

// The lines where g changes sign between places of a grid.
struct FeatureLinesSeen {
    ImageLines lines;
    std::vector<double> strength;  // one per node
    std::vector<glm::dvec3> place; // one per node
    std::vector<double> slope;     // one per segment: the slope of g along its direction, if it has one
};

// The reference lines of one view.
class FeatureReference {
public:
    FeatureReference(const FeatureGrid& grid, const ShapeAt& shape_at, const FeatureAsked& asked,
                     const glm::dvec3& light, double diagonal, double cell)
        : grid_(grid), shape_at_(shape_at), asked_(asked), light_(light), diagonal_(diagonal), cell_(cell) {
        value_.resize(grid.node_count());
        for (std::size_t i = 0; i < grid.node_count(); ++i)
            if (grid.is_hit(i)) value_[i] = value_of(grid.shape(i), grid.position(i));
        const auto w = static_cast<std::size_t>(grid.width());
        for (std::size_t i = 0; i + w + 1 < grid.node_count(); ++i) {
            if (i % w + 1 == w) continue;
            add_triangle({i, i + 1, i + w});
            add_triangle({i + 1, i + w + 1, i + w});
        }
        if (asked.is_crest()) weigh_by_drop();
        find_parts();
    }

    // The lines that must be drawn, and the lines that may be drawn.
    [[nodiscard]] const ImageLines& wanted() const { return wanted_; }
    [[nodiscard]] const ImageLines& allowed() const { return allowed_; }
    // All places where g is 0, however weak the line is there.
    [[nodiscard]] const ImageLines& zeros() const { return seen_.lines; }
    [[nodiscard]] double undecided() const { return undecided_; } // pixels of allowed lines that need not be drawn

private:
    static constexpr double margin = 0.02;      // in strengths: near `lower`, neither answer is wrong
    static constexpr double upper_margin = 0.1; // near `upper`: the strongest place may be between a line's points

    [[nodiscard]] PlaceValue value_of(const PlaceShape& shape, const glm::dvec3& place) const {
        const glm::dvec3 to = -grid_.sight().to(place);
        const bool lit = asked_.kind == HRBFNPR_LINE_KIND_ISOPHOTE;
        const double nearness = lit || grid_.sight().orthographic ? 0.0 : 1.0 / glm::length(to);
        return place_value(asked_, shape, place, lit ? light_ : glm::normalize(to), nearness, diagonal_);
    }
    // Adds the segment of the zero level in a triangle, if there is one.
    void add_triangle(const std::array<std::size_t, 3>& corner) {
        std::array<double, 3> sign{1.0, 1.0, 1.0};
        for (std::size_t k = 0; k < 3; ++k) {
            if (!grid_.joined(corner[k], corner[(k + 1) % 3])) return;
            if (glm::dot(value_[corner[0]].along, value_[corner[k]].along) < 0.0) sign[k] = -1.0;
        }
        // Around an umbilic, the direction does not return to itself.
        if (sign[1] * sign[2] * glm::dot(value_[corner[1]].along, value_[corner[2]].along) < 0.0) {
            branch_.insert(corner.begin(), corner.end());
            return;
        }
        std::array<double, 3> g{};
        for (std::size_t k = 0; k < 3; ++k) g[k] = sign[k] * value_[corner[k]].g;
        std::array<std::size_t, 2> end{};
        std::size_t ends = 0;
        for (std::size_t k = 0; k < 3; ++k)
            if ((g[k] < 0.0) != (g[(k + 1) % 3] < 0.0))
                end[ends++] = node(corner[k], corner[(k + 1) % 3], g[k] / (g[k] - g[(k + 1) % 3]));
        if (ends != 2) return;
        seen_.lines.segment.emplace_back(end[0], end[1]);
        seen_.slope.push_back(slope(corner, g));
    }
    [[nodiscard]] double slope(const std::array<std::size_t, 3>& corner, const std::array<double, 3>& g) const {
        const glm::dvec3 ab = grid_.position(corner[1]) - grid_.position(corner[0]);
        const glm::dvec3 ac = grid_.position(corner[2]) - grid_.position(corner[0]);
        const glm::dvec3 along = value_[corner[0]].along;
        const double bb = glm::dot(ab, ab);
        const double bc = glm::dot(ab, ac);
        const double cc = glm::dot(ac, ac);
        const double b = glm::dot(ab, along);
        const double c = glm::dot(ac, along);
        return (cc * (g[1] - g[0]) - bc * (g[2] - g[0])) * b + (bb * (g[2] - g[0]) - bc * (g[1] - g[0])) * c;
    }
    std::size_t node(std::size_t a, std::size_t b, double share) {
        if (a > b) {
            std::swap(a, b);
            share = 1.0 - share;
        }
        const auto [found, is_new] = of_edge_.try_emplace(a * grid_.node_count() + b, seen_.lines.node.size());
        if (is_new) {
            seen_.lines.node.push_back(glm::mix(grid_.pixel(a), grid_.pixel(b), share));
            seen_.place.push_back(glm::mix(grid_.position(a), grid_.position(b), share));
            seen_.strength.push_back(glm::mix(value_[a].strength, value_[b].strength, share));
        }
        return found->second;
    }
    // Multiplies strengths by a factor for how much the curvature drops on both sides, as weigh_by_drop() of
    // src/features/feature_lines.cpp does (docs/how-lines-work.md). The factor goes from 0 for no drop to 1 where 2 (1
    // - k' / k) / (k s)^2 is 0.5, at s = 1 / 2k, clamped from two cells to a tenth of the diagonal.
    void weigh_by_drop() {
        const bool convex = asked_.kind == HRBFNPR_LINE_KIND_RIDGE;
        const auto bend = [&](const PlaceShape& s) { return convex ? -s.k2 : s.k1; };
        const std::vector<glm::dvec3> here = shape_at_.onto_surface(seen_.place);
        const std::vector<PlaceShape> shape = shape_at_(here);
        std::vector<glm::dvec3> aside;
        std::vector<double> turn;
        for (std::size_t i = 0; i < here.size(); ++i) {
            const double k = bend(shape[i]);
            const double least = 2.0 * cell_;
            const double step = k > 0.0 ? std::clamp(0.5 / k, least, std::max(least, 0.1 * diagonal_)) : least;
            turn.push_back(step * k);
            for (const double side : {-step, step})
                aside.push_back(here[i] + side * (convex ? shape[i].d2 : shape[i].d1));
        }
        const std::vector<PlaceShape> beside = shape_at_(shape_at_.onto_surface(aside));
        for (std::size_t i = 0; i < here.size(); ++i) {
            const double mean = 0.5 * (bend(beside[2 * i]) + bend(beside[2 * i + 1]));
            const double drop = 2.0 * (1.0 - mean / bend(shape[i])) / (turn[i] * turn[i]);
            seen_.strength[i] *= turn[i] > 0.0 ? std::clamp(drop / 0.5, 0.0, 1.0) : 0.0;
        }
    }
    // Chooses the parts that are strong throughout and strong enough somewhere. Parts that may be too short are only
    // allowed.
    void find_parts() {
        const double lower = asked_.lower;
        const auto holds = [&](std::size_t s, double least) {
            const auto [a, b] = seen_.lines.segment[s];
            const double sign = asked_.kind == HRBFNPR_LINE_KIND_RIDGE ? 1.0 : -1.0;
            const bool directed = asked_.is_crest() || asked_.kind == HRBFNPR_LINE_KIND_APPARENT_RIDGE;
            const double strength = std::min(seen_.strength[a], seen_.strength[b]);
            return strength > 0.0 && strength >= least && (!directed || sign * seen_.slope[s] > 0.0);
        };
        std::vector<std::size_t> up(seen_.lines.node.size());
        std::iota(up.begin(), up.end(), 0);
        const auto root = [&](std::size_t a) {
            while (up[a] != a) a = up[a] = up[up[a]];
            return a;
        };
        for (std::size_t s = 0; s < seen_.lines.segment.size(); ++s)
            if (holds(s, (1.0 + margin) * lower) && !branches(s))
                up[root(seen_.lines.segment[s].first)] = root(seen_.lines.segment[s].second);
        std::map<std::size_t, std::pair<double, double>> part; // its greatest strength and its length
        for (std::size_t s = 0; s < seen_.lines.segment.size(); ++s) {
            if (!holds(s, (1.0 + margin) * lower)) continue;
            const auto [a, b] = seen_.lines.segment[s];
            auto& [strongest, length] = part[root(a)];
            strongest = std::max({strongest, seen_.strength[a], seen_.strength[b]});
            length += glm::distance(seen_.place[a], seen_.place[b]);
        }
        wanted_.node = allowed_.node = seen_.lines.node;
        for (std::size_t s = 0; s < seen_.lines.segment.size(); ++s) {
            if (holds(s, (1.0 - margin) * lower)) allowed_.segment.push_back(seen_.lines.segment[s]);
            if (!holds(s, (1.0 + margin) * lower)) continue;
            const auto& [strongest, length] = part[root(seen_.lines.segment[s].first)];
            const bool sure = strongest >= (1.0 + upper_margin) * asked_.upper && length >= 1.2 * 0.01 * diagonal_;
            if (sure) wanted_.segment.push_back(seen_.lines.segment[s]);
        }
        undecided_ = length_of(allowed_) - length_of(wanted_);
    }
    // At an umbilic several lines meet, and which of them continue is not determined.
    [[nodiscard]] bool branches(std::size_t segment) const {
        const glm::dvec2 at = static_cast<double>(grid_.rays()) * seen_.lines.node[seen_.lines.segment[segment].first];
        const auto w = static_cast<std::size_t>(grid_.width());
        for (double y = std::floor(at.y) - 1.0; y <= std::ceil(at.y) + 1.0; y += 1.0)
            for (double x = std::floor(at.x) - 1.0; x <= std::ceil(at.x) + 1.0; x += 1.0)
                if (branch_.count(static_cast<std::size_t>(y) * w + static_cast<std::size_t>(x)) != 0) return true;
        return false;
    }
    [[nodiscard]] static double length_of(const ImageLines& lines) {
        double sum = 0.0;
        for (const auto& [a, b] : lines.segment) sum += glm::distance(lines.node[a], lines.node[b]);
        return sum;
    }

    const FeatureGrid& grid_;
    const ShapeAt& shape_at_;
    FeatureAsked asked_;
    glm::dvec3 light_;
    double diagonal_, cell_;
    std::vector<PlaceValue> value_; // one per place of the grid
    std::unordered_map<std::size_t, std::size_t> of_edge_;
    std::unordered_set<std::size_t> branch_; // places of the grid around umbilics
    FeatureLinesSeen seen_;
    ImageLines wanted_, allowed_;
    double undecided_ = 0.0;
};

// Compares drawn and reference lines; lengths beside contours are left out.
struct FeatureMatch {
    Nearness drawn, wanted;
    Nearness zeros;         // distances of drawn lines from all zero lines, including weak ones
    double left_out = 0.0;  // pixels of both beside contours
    double undecided = 0.0; // pixels of reference lines that may be drawn or not

    void add(const FeatureMatch& other) {
        drawn.add(other.drawn);
        wanted.add(other.wanted);
        zeros.add(other.zeros);
        left_out += other.left_out;
        undecided += other.undecided;
    }
    [[nodiscard]] static double share(const Nearness& n) { return n.length > 0.0 ? n.near / n.length : 1.0; }
    [[nodiscard]] double precision() const { return share(drawn); }
    [[nodiscard]] double recall() const { return share(wanted); }
};

// Like nearness(), but away from contours.
[[nodiscard]] inline Nearness nearness_inside(const FeatureGrid& grid, const ImageLines& lines,
                                              const ImageLines& others, double& left_out) {
    const NearLines near(others);
    Nearness found;
    Joined far(lines.node.size());
    for (const auto& [a, b] : lines.segment) {
        const double length = glm::distance(lines.node[a], lines.node[b]);
        const int pieces = std::max(1, static_cast<int>(std::ceil(length / 0.5)));
        double beyond = 0.0;
        for (int i = 0; i < pieces; ++i) {
            const glm::dvec2 p = glm::mix(lines.node[a], lines.node[b], (i + 0.5) / pieces);
            if (grid.near_contour(p, 2.0)) {
                left_out += length / pieces;
                continue;
            }
            const double distance = near.distance(p);
            found.length += length / pieces;
            found.moment += length / pieces * distance;
            (distance <= 1.0 ? found.near : beyond) += length / pieces;
        }
        if (beyond > 0.0) far.join(a, b, beyond);
    }
    found.longest = far.longest();
    return found;
}

// Returns the kinds of lines that are compared.
[[nodiscard]] inline std::vector<FeatureAsked> features_asked() {
    return {{HRBFNPR_LINE_KIND_SUGGESTIVE_CONTOUR, "suggestive", 10.0, 30.0},
            {HRBFNPR_LINE_KIND_RIDGE, "ridge", 6.0, 15.0},
            {HRBFNPR_LINE_KIND_VALLEY, "valley", 6.0, 15.0},
            {HRBFNPR_LINE_KIND_APPARENT_RIDGE, "apparent_ridge", 12.0, 25.0},
            {HRBFNPR_LINE_KIND_PARABOLIC, "parabolic"},
            {HRBFNPR_LINE_KIND_ISOPHOTE, "isophote", 0.0, 0.0, 0.5},
            {HRBFNPR_LINE_KIND_SECTION, "section"}};
}

// Returns a style that draws one kind of feature line of a model, opaque throughout.
[[nodiscard]] inline hrbfnpr_line_style feature_style(const FeatureAsked& asked) {
    hrbfnpr_line_style line = contour_style();
    line.kind = asked.kind;
    line.hidden = HRBFNPR_HIDDEN_PARTS_NONE;
    line.fade = 0.0F;
    if (asked.kind == HRBFNPR_LINE_KIND_ISOPHOTE) line.levels = {&asked.level, 1, 0, HRBFNPR_SCALAR_FLOAT64, 1};
    return line;
}

[[nodiscard]] inline LineSet make_feature_set(hrbfnpr_context* context, const hrbfnpr_model* model,
                                              const std::vector<FeatureAsked>& asked) {
    scenes::Check check;
    std::vector<hrbfnpr_line_desc> once;
    for (const FeatureAsked& a : asked) {
        if (!a.is_crest() && a.kind != HRBFNPR_LINE_KIND_PARABOLIC && a.kind != HRBFNPR_LINE_KIND_SECTION) continue;
        auto line = scenes::made(hrbfnpr_line_desc_init);
        line.kind = a.kind;
        for (glm::length_t c = 0; c < 3; ++c) line.plane[c] = a.plane[c];
        if (a.kind == HRBFNPR_LINE_KIND_SECTION) line.levels = {&a.level, 1, 0, HRBFNPR_SCALAR_FLOAT64, 1};
        once.push_back(line);
    }
    auto desc = scenes::made(hrbfnpr_line_set_desc_init);
    desc.flags = HRBFNPR_LINE_SET_WITH_CURVATURE;
    desc.lines = once.data();
    desc.line_count = static_cast<std::int64_t>(once.size());
    hrbfnpr_line_set* set = nullptr;
    check(hrbfnpr_line_set_create(context, model, &desc, nullptr, &set, check.error()));
    return LineSet(set);
}

// Returns directions that are along no axis, and not opposite to each other.
[[nodiscard]] inline std::vector<glm::dvec3> feature_directions(int count) {
    const std::vector<glm::dvec3> all{glm::normalize(glm::dvec3(-0.3, -0.2, -1.0)),
                                      glm::normalize(glm::dvec3(1.0, -0.5, 0.4)),
                                      glm::normalize(glm::dvec3(-0.5, 0.6, 0.7))};
    return {all.begin(), all.begin() + std::min<std::ptrdiff_t>(count, 3)};
}

// Returns the light of the default style, which isophotes use, in the space of the model.
[[nodiscard]] inline glm::dvec3 light_of(const hrbfnpr_camera& camera) {
    const auto style = scenes::made(hrbfnpr_style_init);
    const glm::dmat3 view(glm::make_mat4(camera.view));
    return glm::normalize(glm::inverse(view) * glm::make_vec3(style.light));
}

} // namespace bench
