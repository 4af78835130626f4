// SPDX-License-Identifier: MIT
// Ends are paired in the order of what going on from one to the other costs, and chains of pairs become lines.
#include "geometry/point_tree.h"
#include "output/vector/plot_lines.h"
#include "output/vector/tuning.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::output {
namespace {

using glm::dvec2;

struct End {
    dvec2 place, outward; // the direction out of the line
};

// The line goes the way from a place one width along it to its end: nearer points say little of it.
dvec2 outward_of(std::span<const PagePoint> points, bool at_end, double width) noexcept {
    const std::size_t count = points.size();
    const dvec2 end = place_of(at_end ? points[count - 1] : points[0]);
    dvec2 way(0.0);
    for (std::size_t i = 1; i < count; ++i) {
        way = end - place_of(at_end ? points[count - 1 - i] : points[i]);
        if (glm::dot(way, way) >= width * width) break;
    }
    const double length = glm::length(way);
    return length > 0.0 ? way / length : dvec2(0.0);
}

// Ends 2 i and 2 i + 1 are where line i begins and ends.
base::Array<End> ends_of(const PlotLines& lines, const base::Progress& progress) {
    base::Array<End> ends(lines.points.memory());
    ends.reserve(2 * lines.lines.size());
    Looks looks(progress, steps_a_look);
    for (const PlotLine& line : lines.lines) {
        looks.count();
        const std::span<const PagePoint> points = lines.points_of(line);
        ends.push_back({place_of(points.front()), outward_of(points, false, line.width)});
        ends.push_back({place_of(points.back()), outward_of(points, true, line.width)});
    }
    return ends;
}

struct EndPair {
    double cost;
    std::int32_t a, b; // ends, the lower number first
};

// What going on from end a of a line at end b of another one costs; -1: they are not joined.
double cost_of(const PlotLine& line, const PlotLine& other, const End& a, const End& b, double most) noexcept {
    const double distance = glm::distance(a.place, b.place);
    if (distance > most) return -1.0;
    const double turn = std::acos(std::clamp(-glm::dot(a.outward, b.outward), -1.0, 1.0));
    if (turn > plot_tuning.sharpest_join) return -1.0;
    if (distance > plot_tuning.seen_link * std::min(line.width, other.width)) {
        const dvec2 link = (b.place - a.place) / distance;
        const double least = std::cos(plot_tuning.sharpest_join);
        if (glm::dot(a.outward, link) < least || glm::dot(b.outward, -link) < least) return -1.0;
    }
    return distance / most + turn / plot_tuning.sharpest_join;
}

// The pairs that may be joined, cheapest first. Notes lines that go on as a line of another opacity.
base::Array<EndPair> find_pairs(PlotLines& lines, double given, bool any_opacity, const base::Progress& progress) {
    const base::Array<End> ends = ends_of(lines, progress);
    base::Memory& memory = lines.points.memory();
    geometry::VecArray places(memory);
    base::Array<std::int32_t> free(memory); // ends of lines that are not closed
    Looks looks(progress, steps_a_look);
    for (std::int32_t end = 0; end < ends.size(); ++end) {
        looks.count();
        if (lines.lines[end / 2].closed) continue;
        places.push_back({ends[end].place, 0.0});
        free.push_back(end);
    }
    const geometry::PointTree tree(places, progress);
    const auto any = [](std::int64_t) { return true; };
    base::Array<EndPair> pairs(memory);
    for (std::int64_t at = 0; at < tree.size(); ++at) {
        looks.count();
        const std::int32_t a = free[tree.index(at)];
        PlotLine& line = lines.lines[a / 2];
        const double reach = given > 0.0 ? given : line.width;
        std::array<std::int64_t, plot_tuning.most_near + 1> near; // the end itself is one of them
        const std::int64_t count =
            tree.nearest(tree.points()[at], plot_tuning.most_near + 1, any, any, near.data(), reach);
        for (std::int64_t i = 0; i < count; ++i) {
            const std::int32_t b = free[tree.index(near[static_cast<std::size_t>(i)])];
            if (!(glm::distance(ends[a].place, ends[b].place) < reach)) break;
            if (b == a || (a / 2 == b / 2 && line.count < 3)) continue;
            const PlotLine& other = lines.lines[b / 2];
            // A pair is found from both of its ends, or from the one that has the fewer neighbours.
            const double cost =
                cost_of(line, other, ends[a], ends[b], given > 0.0 ? given : std::min(line.width, other.width));
            if (cost < 0.0) continue;
            if (any_opacity || std::abs(line.opacity - other.opacity) <= static_cast<double>(drawing::faintest_ink))
                pairs.push_back({cost, std::min(a, b), std::max(a, b)});
            else
                line.goes_on = true;
        }
    }
    Looks comparisons(progress, comparisons_a_look);
    std::sort(pairs.begin(), pairs.end(), [&](const EndPair& p, const EndPair& q) {
        comparisons.count();
        if (p.cost != q.cost) return p.cost < q.cost;
        return p.a != q.a ? p.a < q.a : p.b < q.b;
    });
    return pairs;
}

struct EndPairing {
    base::Array<std::int32_t> partner; // the end that each end is joined to; -1: none
    std::int64_t joins = 0;
};

// Takes each pair whose ends are free, unless it would close a short ring.
EndPairing choose_pairs(const PlotLines& lines, const base::Array<EndPair>& pairs, const base::Progress& progress) {
    base::Memory& memory = lines.points.memory();
    const auto count = static_cast<std::int32_t>(lines.lines.size());
    EndPairing result{base::Array<std::int32_t>(memory, 2 * std::int64_t{count})};
    std::fill(result.partner.begin(), result.partner.end(), -1);
    base::Array<std::int32_t> chain(memory, count); // for each line, another line of its chain, or the line itself
    base::Array<double> length(memory, count);      // the length of each chain, mm, at the line that `chain` leads to
    Looks looks(progress, steps_a_look);
    for (std::int32_t i = 0; i < count; ++i) {
        looks.count();
        chain[i] = i;
        length[i] = length_of(lines.points_of(lines.lines[i]));
    }
    const auto chain_of = [&](std::int32_t line) {
        while (chain[line] != line) line = chain[line] = chain[chain[line]];
        return line;
    };
    for (const EndPair& pair : pairs) {
        looks.count();
        HRBFNPR_ASSERT(pair.a < pair.b && pair.b < 2 * count);
        if (result.partner[pair.a] >= 0 || result.partner[pair.b] >= 0) continue;
        const std::int32_t a = chain_of(pair.a / 2), b = chain_of(pair.b / 2);
        if (a == b && length[a] < plot_tuning.shortest_ring * lines.lines[pair.a / 2].width) continue;
        if (a != b) {
            chain[b] = a;
            length[a] += length[b];
        }
        result.partner[pair.a] = pair.b;
        result.partner[pair.b] = pair.a;
        ++result.joins;
    }
    return result;
}

} // namespace

std::int64_t join_lines(PlotLines& lines, double distance, bool any_opacity, const base::Progress& progress) {
    const EndPairing pairing = choose_pairs(lines, find_pairs(lines, distance, any_opacity, progress), progress);
    PlotLines joined(lines.points.memory());
    joined.points.reserve(lines.points.size());
    PlotLine chain; // the one that is followed
    double length = 0.0, ink = 0.0;
    Looks looks(progress, steps_a_look);
    const auto enter = [&](std::int32_t end) {
        looks.count();
        const PlotLine& line = lines.lines[end / 2];
        const bool reversed = end % 2 != 0;
        const std::int64_t before = joined.points.size();
        if (chain.count == 0) { // it begins
            chain = line;
            chain.first = before;
            chain.begin = reversed ? line.end : line.begin;
        }
        const std::span<const PagePoint> points = lines.points_of(line);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const PagePoint& p = points[reversed ? points.size() - 1 - i : i];
            const bool stands_there = i == 0 && before > chain.first && place_of(joined.points.back()) == place_of(p);
            if (!stands_there) joined.points.push_back(p);
        }
        const double part = length_of(points);
        length += part;
        ink += part * line.opacity;
        chain.width = std::min(chain.width, line.width);
        chain.goes_on = chain.goes_on || line.goes_on;
        chain.end = reversed ? line.begin : line.end;
    };
    const auto leave = [&](bool ring) {
        if (length > 0.0) chain.opacity = ink / length; // the mean
        if (ring) {
            const PagePoint first = joined.points[chain.first];
            if (place_of(joined.points.back()) != place_of(first)) joined.points.push_back(first);
            chain.closed = true;
        }
        chain.count = joined.points.size() - chain.first;
        joined.lines.push_back(chain);
        chain = PlotLine{};
        length = ink = 0.0;
    };
    geometry::follow_chains(pairing.partner, enter, leave);
    std::swap(lines, joined);
    return pairing.joins;
}

} // namespace hrbfnpr::output
