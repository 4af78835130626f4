// SPDX-License-Identifier: MIT
#include "output/vector/join_lines.h"

#include "output/vector/look.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hrbfnpr::output {
namespace {

using glm::dvec2;

constexpr std::int64_t at_a_time = 1024;
constexpr std::int64_t compared_at_a_time = 65536;
constexpr int most_near = 8; // ends that one is compared with
constexpr double same_opacity = 1.0 / 512.0;
constexpr double least_of_ring = 4.0; // its length, of the line's width

struct Near {
    std::int32_t end;
    double square;
};

// The nearest ones, nearest first.
struct NearList {
    Near near[most_near];
    int count = 0;

    void add(std::int32_t end, double from, double& square) noexcept {
        int at = count < most_near ? count++ : most_near - 1;
        for (; at > 0 && near[at - 1].square > from; --at) near[at] = near[at - 1];
        near[at] = {end, from};
        if (count == most_near) square = near[most_near - 1].square;
    }
};

// From a place one width along the line to its end: nearer points say little of where it goes.
dvec2 direction_of(std::span<const PagePoint> points, bool at_end, double width) noexcept {
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

} // namespace

JoinLines::JoinLines(base::Memory& memory) noexcept
    : ends_(memory), outward_(memory), pairs_(memory), partner_(memory), chain_(memory), length_(memory), done_(memory),
      tree_(memory), joined_(memory) {}

std::int64_t JoinLines::join(PlotLines& from, const JoinSettings& settings, const base::Progress& progress) {
    find_ends(from, progress);
    find_pairs(from, settings, progress);
    const std::int64_t count = choose_pairs(from, progress);
    joined_.clear();
    joined_.points.reserve(from.points.size());
    done_.clear();
    done_.resize(from.lines.size());
    // Chains that have ends, from the first line of them; then rings.
    const auto lines = static_cast<std::int32_t>(from.lines.size());
    for (const bool rings : {false, true})
        for (std::int32_t line = 0; line < lines; ++line) {
            if (line % at_a_time == 0) look(progress);
            for (const std::int32_t end : {2 * line, 2 * line + 1})
                if (done_[line] == 0 && (rings || partner_[end] < 0)) add_chain(from, end);
        }
    std::swap(from.points, joined_.points);
    std::swap(from.lines, joined_.lines);
    return count;
}

void JoinLines::find_ends(const PlotLines& from, const base::Progress& progress) {
    const std::int64_t lines = from.lines.size();
    ends_.resize_for_overwrite(2 * lines);
    outward_.resize_for_overwrite(2 * lines);
    for (std::int64_t i = 0; i < lines; ++i) {
        if (i % at_a_time == 0) look(progress);
        const std::span<const PagePoint> points = from.points_of(from.lines[i]);
        ends_[2 * i] = place_of(points.front());
        ends_[2 * i + 1] = place_of(points.back());
        outward_[2 * i] = direction_of(points, false, from.lines[i].width);
        outward_[2 * i + 1] = direction_of(points, true, from.lines[i].width);
    }
    tree_.build(ends_.span(), progress);
    for (std::int32_t i = 0; i < lines; ++i) {
        if (i % at_a_time == 0) look(progress);
        if (from.lines[i].closed) {
            tree_.remove(2 * i);
            tree_.remove(2 * i + 1);
        }
    }
}

void JoinLines::find_pairs(PlotLines& from, const JoinSettings& settings, const base::Progress& progress) {
    pairs_.clear();
    for (std::int32_t a = 0; a < ends_.size(); ++a) {
        if (a % at_a_time == 0) look(progress);
        if (!tree_.holds(a)) continue;
        PlotLine& line = from.lines[a / 2];
        const double reach = settings.distance > 0.0 ? settings.distance : line.width;
        NearList found;
        double square = reach * reach;
        if (square > 0.0)
            tree_.search(ends_[a], square, [&](std::int32_t b, double from_there) {
                if (b != a) found.add(b, from_there, square);
            });
        for (int i = 0; i < found.count; ++i) {
            const std::int32_t b = found.near[i].end;
            const PlotLine& other = from.lines[b / 2];
            const double most = settings.distance > 0.0 ? settings.distance : std::min(line.width, other.width);
            // A pair is found from both of its ends, or from the one that has the fewer neighbours.
            const double cost = cost_of(line, other, a, b, std::sqrt(found.near[i].square), most, settings.sharpest);
            if (cost < 0.0) continue;
            if (settings.any_opacity || std::abs(line.opacity - other.opacity) <= same_opacity)
                pairs_.push_back({cost, std::min(a, b), std::max(a, b)});
            else
                line.goes_on = true;
        }
    }
    Looks looks(progress, compared_at_a_time);
    std::sort(pairs_.begin(), pairs_.end(), [&](const Pair& p, const Pair& q) {
        looks.count();
        if (p.cost != q.cost) return p.cost < q.cost;
        return p.a != q.a ? p.a < q.a : p.b < q.b;
    });
}

// Of going on from end a at end b; -1: they are not joined.
double JoinLines::cost_of(const PlotLine& line, const PlotLine& other, std::int32_t a, std::int32_t b, double distance,
                          double most, double sharpest) const noexcept {
    if (distance > most || (a / 2 == b / 2 && line.count < 3)) return -1.0;
    const double turn = std::acos(std::clamp(-glm::dot(outward_[a], outward_[b]), -1.0, 1.0));
    if (turn > sharpest) return -1.0;
    // A link as long as that shows, and must not be a step to the side.
    if (distance > 0.5 * std::min(line.width, other.width)) {
        const dvec2 link = (ends_[b] - ends_[a]) / distance;
        const double least = std::cos(sharpest);
        if (glm::dot(outward_[a], link) < least || glm::dot(outward_[b], -link) < least) return -1.0;
    }
    return distance / most + turn / sharpest;
}

std::int32_t JoinLines::chain_of(std::int32_t line) noexcept {
    while (chain_[line] != line) line = chain_[line] = chain_[chain_[line]];
    return line;
}

std::int64_t JoinLines::choose_pairs(const PlotLines& from, const base::Progress& progress) {
    const auto lines = static_cast<std::int32_t>(from.lines.size());
    partner_.resize_for_overwrite(2 * from.lines.size());
    std::fill(partner_.begin(), partner_.end(), -1);
    chain_.resize_for_overwrite(lines);
    length_.resize_for_overwrite(lines);
    for (std::int32_t i = 0; i < lines; ++i) {
        if (i % at_a_time == 0) look(progress);
        chain_[i] = i;
        length_[i] = length_of(from.points_of(from.lines[i]));
    }
    std::int64_t count = 0;
    Looks looks(progress, at_a_time);
    for (const Pair& pair : pairs_) {
        looks.count();
        if (partner_[pair.a] >= 0 || partner_[pair.b] >= 0) continue;
        const std::int32_t a = chain_of(pair.a / 2), b = chain_of(pair.b / 2);
        if (a == b && length_[a] < least_of_ring * from.lines[pair.a / 2].width) continue;
        if (a != b) {
            chain_[b] = a;
            length_[a] += length_[b];
        }
        partner_[pair.a] = pair.b;
        partner_[pair.b] = pair.a;
        ++count;
    }
    return count;
}

// The chain that enters a line at this end, of the mean opacity.
void JoinLines::add_chain(const PlotLines& from, std::int32_t end) {
    const PlotLine& start = from.lines[end / 2];
    PlotLine chain = start;
    chain.first = joined_.points.size();
    chain.begin = end % 2 == 0 ? start.begin : start.end;
    double length = 0.0, ink = 0.0;
    for (;;) {
        const std::int32_t number = end / 2;
        const PlotLine& line = from.lines[number];
        const std::span<const PagePoint> points = from.points_of(line);
        done_[number] = 1;
        add_points(chain.first, points, end % 2 != 0);
        const double part = length_of(points);
        length += part;
        ink += part * line.opacity;
        chain.width = std::min(chain.width, line.width);
        chain.goes_on = chain.goes_on || line.goes_on;
        chain.end = end % 2 == 0 ? line.end : line.begin;
        end = partner_[end ^ 1];
        if (end < 0 || done_[end / 2] != 0) break;
    }
    if (length > 0.0) chain.opacity = ink / length;
    if (end >= 0) { // round to the first line
        const PagePoint first = joined_.points[chain.first];
        add_points(chain.first, {&first, 1}, false);
        chain.closed = true;
    }
    chain.count = joined_.points.size() - chain.first;
    joined_.lines.push_back(chain);
}

// To the chain that begins there; but for a first point that stands where its last one does.
void JoinLines::add_points(std::int64_t chain, std::span<const PagePoint> points, bool reversed) {
    const std::int64_t before = joined_.points.size();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const PagePoint& p = points[reversed ? points.size() - 1 - i : i];
        if (i == 0 && before > chain && joined_.points[before - 1].x == p.x && joined_.points[before - 1].y == p.y)
            continue;
        joined_.points.push_back(p);
    }
}

} // namespace hrbfnpr::output
