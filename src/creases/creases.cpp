// SPDX-License-Identifier: MIT
#include "creases/creases.h"

#include "surface/sheets_meet.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hrbfnpr::curves {
namespace {

constexpr std::int64_t nodes_a_task = 16;
constexpr int crease_rounds = 8;
constexpr double degrees = 57.29577951308232;
// In sides.
constexpr double crease_tolerance = 1e-9;
constexpr double nearest_node = 0.1; // nodes of the mesh that are nearer to the one before say nothing more
constexpr double longest_piece = 1.0;
constexpr double shortest_piece = 1e-3; // of a piece that is halved, and of a crease
constexpr double farthest_node = 0.5;
// Between points, by the cosine: 0.1 radians.
constexpr double straight_turn = 0.995;
// The cosine of the angle to the crease beyond which a step is along it, or back.
constexpr double returns = 0.7;
// The sine of the angle between sheets below which the way along the crease is that of its points.
constexpr double least_crease_sine = 1e-3;

CurvePoint as_curve_point(const CreasePoint& p) noexcept {
    CurvePoint point;
    point.position = p.position;
    const glm::dvec3 across = p.left - glm::dot(p.left, p.tangent) * p.tangent;
    point.gradient = glm::normalize(across);
    point.level_gradient = glm::cross(p.tangent, point.gradient);
    return point;
}

class Tracer {
public:
    Tracer(const base::Runtime& runtime, const implicit::Implicit& implicit, double side) noexcept
        : runtime_(runtime), implicit_(implicit), sheets_(*implicit.sheets()), side_(side), creases_(runtime.memory) {}

    [[nodiscard]] Creases run(const CreaseChains& chains, const base::Progress& progress);

private:
    void add_chain(const CreaseChains& chains, std::int64_t chain);
    [[nodiscard]] bool is_gap(const CreaseChains& chains, std::int64_t first, std::int64_t count, std::int64_t k,
                              const glm::dvec3& place) const noexcept;
    void add_points(base::Array<CreasePoint>& points, bool closed, std::int32_t left, std::int32_t right);
    void measure(const base::Progress& progress);
    void drop_returns();
    void find_tangents();
    [[nodiscard]] bool refine(const base::Progress& progress);
    [[nodiscard]] std::int64_t next(std::int64_t crease, std::int64_t i) const noexcept {
        if (i + 1 < creases_.first[crease + 1]) return i + 1;
        return creases_.closed[crease] != 0 ? creases_.first[crease] : -1;
    }

    const base::Runtime& runtime_;
    const implicit::Implicit& implicit_;
    const implicit::Sheets& sheets_;
    double side_;
    Creases creases_;
};

void Tracer::add_points(base::Array<CreasePoint>& points, bool closed, std::int32_t left, std::int32_t right) {
    double length = 0.0;
    for (std::int64_t i = 1; i < points.size(); ++i)
        length += glm::distance(points[i - 1].position, points[i].position);
    if (points.size() >= (closed ? 3 : 2) && length > shortest_piece * side_) {
        for (const CreasePoint& p : points) creases_.point.push_back(p);
        creases_.first.push_back(creases_.point.size());
        creases_.closed.push_back(closed ? 1 : 0);
        creases_.left.push_back(left);
        creases_.right.push_back(right);
    }
    points.clear();
}

// Whether from a place to the next exact node of a chain after node k it is so near that the crease goes on.
bool Tracer::is_gap(const CreaseChains& chains, std::int64_t first, std::int64_t count, std::int64_t k,
                    const glm::dvec3& place) const noexcept {
    for (std::int64_t i = k + 1; i < count; ++i)
        if (const CreaseNode& next = chains.node[first + i]; next.exact)
            return glm::distance(next.position, place) < nearest_node * side_;
    return false;
}

// Nodes that crowd are left out, but for ends; where sheets could not be told apart there is no crease.
void Tracer::add_chain(const CreaseChains& chains, std::int64_t chain) {
    const std::int64_t first = chains.first[chain];
    const std::int64_t count = chains.first[chain + 1] - first;
    const bool closed = chains.closed[chain] != 0;
    std::int64_t begin = 0; // of a closed one a node that is not exact, if there is one
    while (closed && begin < count && chains.node[first + begin].exact) ++begin;
    const bool whole = closed && begin == count;
    base::Array<CreasePoint> points(runtime_.memory);
    const auto end = [&](bool is_closed) { add_points(points, is_closed, chains.left[chain], chains.right[chain]); };
    const std::int64_t steps = closed && !whole ? count + 1 : count;
    for (std::int64_t k = 0; k < steps; ++k) {
        const CreaseNode& node = chains.node[first + (begin + k) % count];
        if (!node.exact) {
            if (whole || points.empty() || !is_gap(chains, first, count, begin + k, points[points.size() - 1].position))
                end(false);
            continue;
        }
        const bool last = k + 1 == steps || !chains.node[first + (begin + k + 1) % count].exact;
        const std::int64_t size = points.size();
        const auto crowds = [&](std::int64_t i, double within) {
            return i >= 0 && size > i && glm::distance(points[i].position, node.position) < within * side_;
        };
        if (last && !whole)
            while (points.size() > 1 &&
                   glm::distance(points[points.size() - 1].position, node.position) < nearest_node * side_)
                points.resize(points.size() - 1);
        if (!last && crowds(size - 1, nearest_node)) continue;
        if (whole && (crowds(size - 1, nearest_node) || (size > 2 && crowds(0, nearest_node)))) continue;
        if (points.size() > 0 && points[points.size() - 1].position == node.position) continue;
        CreasePoint p;
        p.position = node.position;
        points.push_back(p);
    }
    end(whole);
}

// Normals of both sheets at all points.
void Tracer::measure(const base::Progress& progress) {
    implicit_.threads(runtime_.parallel).for_each(creases_.count(), [&](std::int64_t c) {
        progress.check();
        for (std::int64_t i = creases_.first[c]; i < creases_.first[c + 1]; ++i) {
            CreasePoint& p = creases_.point[i];
            if (p.left != glm::dvec3(0.0)) continue;
            p.left = glm::normalize(surface::sheet_at(sheets_, creases_.left[c], p.position).gradient);
            p.right = glm::normalize(surface::sheet_at(sheets_, creases_.right[c], p.position).gradient);
        }
    });
}

// Whether a crease that comes from a to p and goes on to b turns back there.
bool turns_back(const CreasePoint& a, const CreasePoint& p, const CreasePoint& b) noexcept {
    const glm::dvec3 along = glm::cross(p.left, p.right);
    const double size = glm::length(along);
    if (!(size > least_crease_sine)) return false;
    const double in = glm::dot(along, glm::normalize(p.position - a.position)) / size;
    const double out = glm::dot(along, glm::normalize(b.position - p.position)) / size;
    return in * out < 0.0 && std::min(std::abs(in), std::abs(out)) > returns;
}

// Beside a corner nodes may not stand in the order in which edges of the mesh cross the crease, as Newton's steps lead
// them along it.
void Tracer::drop_returns() {
    const Creases found = std::exchange(creases_, Creases(runtime_.memory));
    creases_.first.push_back(0);
    base::Array<CreasePoint> kept(runtime_.memory);
    for (std::int64_t c = 0; c < found.count(); ++c) {
        for (std::int64_t i = found.first[c]; i < found.first[c + 1]; ++i) {
            const CreasePoint& p = found.point[i];
            while (kept.size() >= 2 && turns_back(kept[kept.size() - 2], kept[kept.size() - 1], p))
                kept.resize(kept.size() - 1);
            if (kept.empty() || kept[kept.size() - 1].position != p.position) kept.push_back(p);
        }
        add_points(kept, found.closed[c] != 0, found.left[c], found.right[c]);
    }
}

void Tracer::find_tangents() {
    for (std::int64_t c = 0; c < creases_.count(); ++c) {
        const std::int64_t first = creases_.first[c];
        const std::int64_t count = creases_.first[c + 1] - first;
        const bool closed = creases_.closed[c] != 0;
        const auto at = [&](std::int64_t i) {
            return creases_.point[first + (closed ? (i + count) % count : std::clamp<std::int64_t>(i, 0, count - 1))]
                .position;
        };
        for (std::int64_t i = 0; i < count; ++i) {
            CreasePoint& p = creases_.point[first + i];
            const glm::dvec3 in = at(i) - at(i - 1);
            const glm::dvec3 out = at(i + 1) - at(i);
            const double a = glm::dot(in, in);
            const double b = glm::dot(out, out);
            const glm::dvec3 along = a > 0.0 && b > 0.0 ? in / a + out / b : in + out;
            const glm::dvec3 cross = glm::cross(p.left, p.right);
            p.tangent = glm::length(cross) > least_crease_sine
                            ? glm::normalize(glm::dot(cross, along) < 0.0 ? -cross : cross)
                            : glm::normalize(along);
        }
    }
}

// A point more where a crease turns too much between two.  Returns whether there were any.
bool Tracer::refine(const base::Progress& progress) {
    base::Array<CreasePoint> added(runtime_.memory);
    base::Array<std::int64_t> after(runtime_.memory), of(runtime_.memory);
    for (std::int64_t c = 0; c < creases_.count(); ++c)
        for (std::int64_t i = creases_.first[c]; i < creases_.first[c + 1]; ++i) {
            const std::int64_t j = next(c, i);
            if (j < 0) continue;
            const CreasePoint& a = creases_.point[i];
            const CreasePoint& b = creases_.point[j];
            const double length = glm::distance(a.position, b.position) / side_;
            const glm::dvec3 chord = (b.position - a.position) / (length * side_);
            const bool turns = std::min(glm::dot(a.tangent, chord), glm::dot(b.tangent, chord)) < straight_turn;
            if (!(length > longest_piece || (turns && length > shortest_piece))) continue;
            CreasePoint p;
            p.position = CubicPiece(as_curve_point(a), as_curve_point(b)).at(0.5);
            added.push_back(p);
            after.push_back(i);
            of.push_back(c);
        }
    implicit_.threads(runtime_.parallel)
        .for_chunks(added.size(), nodes_a_task, [&](std::int64_t begin, std::int64_t end) {
            progress.check();
            for (std::int64_t k = begin; k < end; ++k) {
                surface::Meeting meeting;
                meeting.add(creases_.left[of[k]]);
                meeting.add(creases_.right[of[k]]);
                const surface::MeetingPlace at = surface::find_meeting(sheets_, meeting, added[k].position,
                                                                       crease_tolerance * side_, farthest_node * side_);
                if (!at.found) continue;
                added[k].position = at.position;
                added[k].left = glm::normalize(at.gradient[0]);
                added[k].right = glm::normalize(at.gradient[1]);
            }
        });
    base::Array<CreasePoint> points(runtime_.memory);
    std::int64_t k = 0;
    bool changed = false;
    for (std::int64_t c = 0; c < creases_.count(); ++c) {
        const std::int64_t first = points.size();
        for (std::int64_t i = creases_.first[c]; i < creases_.first[c + 1]; ++i) {
            points.push_back(creases_.point[i]);
            if (k >= after.size() || after[k] != i) continue;
            if (added[k].left != glm::dvec3(0.0)) {
                points.push_back(added[k]);
                changed = true;
            }
            ++k;
        }
        creases_.first[c] = first; // not read any more
    }
    creases_.first[creases_.count()] = points.size();
    creases_.point = std::move(points);
    find_tangents();
    return changed;
}

Creases Tracer::run(const CreaseChains& chains, const base::Progress& progress) {
    creases_.first.push_back(0);
    for (std::int64_t c = 0; c < chains.chains(); ++c) add_chain(chains, c);
    measure(progress);
    drop_returns();
    find_tangents();
    for (int round = 0; round < crease_rounds && refine(progress); ++round) continue;
    return std::move(creases_);
}

} // namespace

double CreasePoint::angle() const noexcept {
    const glm::dvec3 cross = glm::cross(left, right);
    const double size = degrees * std::atan2(glm::length(cross), glm::dot(left, right));
    return glm::dot(cross, tangent) < 0.0 ? -size : size;
}

Creases trace_creases(const base::Runtime& runtime, const implicit::Implicit& implicit, const CreaseChains& chains,
                      double side, const base::Progress& progress) {
    return Tracer(runtime, implicit, side).run(chains, progress);
}

} // namespace hrbfnpr::curves
