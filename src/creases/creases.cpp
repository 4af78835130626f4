// SPDX-License-Identifier: MIT
// sheet_surfaces splits a mesh that is cut at creases (split_mesh.cpp) into one for each sheet.
//
// trace_creases runs once for a model:
// 1. add_chain makes points of the mesh's nodes, without crowded ones, and cuts chains where sheets do not meet.
// 2. set_normals sets the normals of both sheets at each point.
// 3. drop_returns drops points that are out of order.
// 4. find_tangents and halve_pieces add points where a crease turns.
// parts_in_view runs for each camera: it cuts creases where one of their sheets turns away from the eye.
#include "creases/creases.h"

#include "base/list.h"
#include "creases/tuning.h"
#include "curves/mesh_edges.h"
#include "curves/tuning.h"
#include "geometry/point_grid.h"
#include "geometry/segment.h"
#include "surface/sheets_meet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace hrbfnpr::curves {
namespace {

// ---- Curves

constexpr std::int64_t crease_points_a_task = 64;
constexpr int crease_rounds = 8; // pieces are halved at most this many times

CurvePoint as_curve_point(const CreasePoint& p) noexcept {
    CurvePoint point;
    point.position = p.position;
    point.gradient = glm::normalize(p.left - glm::dot(p.left, p.tangent) * p.tangent);
    point.level_gradient = glm::cross(p.tangent, point.gradient);
    return point;
}

// Sets the normals of both sheets at points of a crease.
void set_normals(const implicit::Sheets& sheets, const Creases& creases, std::int64_t crease,
                 std::span<CreasePoint> points) {
    std::array<surface::SheetRequest, 2 * static_cast<std::size_t>(crease_points_a_task)> requests;
    std::array<surface::SheetValue, 2 * static_cast<std::size_t>(crease_points_a_task)> values;
    while (!points.empty()) {
        const std::span<CreasePoint> some = points.first(std::min(points.size(), requests.size() / 2));
        for (std::size_t i = 0; i < some.size(); ++i) {
            requests[2 * i] = {creases.left[crease], some[i].position};
            requests[2 * i + 1] = {creases.right[crease], some[i].position};
        }
        surface::sheets_at(sheets, std::span(requests).first(2 * some.size()), values.data());
        for (std::size_t i = 0; i < some.size(); ++i) {
            some[i].left = glm::normalize(values[2 * i].gradient);
            some[i].right = glm::normalize(values[2 * i + 1].gradient);
        }
        points = points.subspan(some.size());
    }
}

// Ends a crease: makes it of the points added since the last crease, unless it is too short.
void end_crease(Creases& creases, bool closed, std::int32_t left, std::int32_t right, double side) {
    const std::int64_t first = creases.first.back();
    double length = 0.0;
    for (std::int64_t i = first + 1; i < creases.point.size(); ++i)
        length += glm::distance(creases.point[i - 1].position, creases.point[i].position);
    if (creases.point.size() - first < (closed ? 3 : 2) || !(length > crease_tuning.shortest_piece * side))
        return creases.point.resize(first);
    creases.end(closed);
    creases.left.push_back(left);
    creases.right.push_back(right);
}

void add_chain(const CreaseChains& chains, std::int64_t chain, double side, Creases& creases) {
    const std::int64_t count = chains.size_of(chain);
    const CreaseNode* const node = chains.point.data() + chains.first[chain];
    const double nearest = crease_tuning.nearest_node * side;
    const auto exact = [&](std::int64_t i) { return node[i].exact; };
    for_parts(count, chains.closed[chain] != 0, exact, [&](std::int64_t begin, std::int64_t end, bool whole) {
        const std::int64_t first = creases.first.back();
        const auto crowds = [&](std::int64_t i, const glm::dvec3& place) {
            return glm::distance(creases.point[i].position, place) < nearest;
        };
        // Narrow gaps are bridged. A crease continues across them.
        if (creases.point.size() > first && !crowds(creases.point.size() - 1, node[begin % count].position))
            end_crease(creases, false, chains.left[chain], chains.right[chain], side);
        const std::int64_t start = creases.first.back();
        for (std::int64_t i = begin; i < end; ++i) {
            CreasePoint p;
            p.position = node[i % count].position;
            const bool last = i + 1 == end && !whole;
            const std::int64_t size = creases.point.size();
            if (!last && size > start && crowds(size - 1, p.position)) continue;
            if (whole && size > start + 2 && crowds(start, p.position)) continue;
            if (size > start && creases.point.back().position == p.position) continue;
            creases.point.push_back(p);
        }
        if (whole) end_crease(creases, true, chains.left[chain], chains.right[chain], side);
    });
    end_crease(creases, false, chains.left[chain], chains.right[chain], side);
}

// Returns whether the path from a through p to b reverses at p: one of its two steps goes forwards along the crease,
// and the other backwards.
bool turns_back(const CreasePoint& a, const CreasePoint& p, const CreasePoint& b) noexcept {
    const glm::dvec3 along = glm::cross(p.left, p.right);
    const double size = glm::length(along);
    if (!(size > crease_tuning.least_crease_sine)) return false;
    const double in = glm::dot(along, glm::normalize(p.position - a.position)) / size;
    const double out = glm::dot(along, glm::normalize(b.position - p.position)) / size;
    return in * out < 0.0 && std::min(std::abs(in), std::abs(out)) > crease_tuning.returns;
}

// Drops nodes that are out of order along a crease. Near a corner this happens because Newton's steps move nodes along
// the crease.
Creases drop_returns(const Creases& found, double side) {
    Creases kept(found.first.memory());
    for (std::int64_t c = 0; c < found.count(); ++c) {
        const std::int64_t first = kept.point.size();
        for (std::int64_t i = found.first[c]; i < found.first[c + 1]; ++i) {
            const CreasePoint& p = found.point[i];
            while (kept.point.size() >= first + 2 &&
                   turns_back(kept.point[kept.point.size() - 2], kept.point.back(), p))
                kept.point.resize(kept.point.size() - 1);
            if (kept.point.size() == first || kept.point.back().position != p.position) kept.point.push_back(p);
        }
        end_crease(kept, found.closed[c] != 0, found.left[c], found.right[c], side);
    }
    return kept;
}

void find_tangents(Creases& creases) {
    for (std::int64_t c = 0; c < creases.count(); ++c) {
        const std::int64_t count = creases.size_of(c);
        const bool closed = creases.closed[c] != 0;
        CreasePoint* const point = creases.point.data() + creases.first[c];
        const auto at = [&](std::int64_t i) {
            return point[closed ? (i + count) % count : std::clamp<std::int64_t>(i, 0, count - 1)].position;
        };
        for (std::int64_t i = 0; i < count; ++i) {
            CreasePoint& p = point[i];
            const glm::dvec3 along = tangent_between(at(i) - at(i - 1), at(i + 1) - at(i));
            const glm::dvec3 cross = glm::cross(p.left, p.right);
            p.tangent = glm::length(cross) > crease_tuning.least_crease_sine
                            ? glm::normalize(glm::dot(cross, along) < 0.0 ? -cross : cross)
                            : glm::normalize(along);
        }
    }
}

// Returns the parameter along a piece at which n . v is 0, where n is the normal of a sheet and v is the line of sight.
// `from` and `to` are the values of n . v at the two ends of the piece.
double turn_of(const implicit::Sheets& sheets, std::int32_t sheet, const CubicPiece& piece, double from, double to,
               const View& view) {
    Illinois root(from, to);
    for (int step = 0; step < curve_tuning.most_steps && !root.done(curve_tuning.exact); ++step) {
        const glm::dvec3 place = piece.at(root.trial);
        const glm::dvec3 gradient = surface::sheet_at(sheets, sheet, place).gradient;
        root.take(glm::dot(gradient, view.sight(place)) / glm::length(gradient));
    }
    return std::clamp(root.trial, root.low, root.high);
}

// Returns the points of a crease, with additional points where a sheet turns towards the eye or away from it.
base::Array<CreasePoint> path_of(base::Memory& memory, const implicit::Sheets& sheets, const Creases& creases,
                                 std::int64_t crease, const View& view) {
    base::Array<CreasePoint> path(memory);
    for (std::int64_t i = creases.first[crease]; i < creases.first[crease + 1]; ++i) {
        const CreasePoint& p = creases.point[i];
        path.push_back(p);
        const std::int64_t j = creases.next(crease, i);
        if (j < 0) continue;
        const CreasePoint& q = creases.point[j];
        const CubicPiece piece(as_curve_point(p), as_curve_point(q));
        std::array<double, 2> share{};
        std::size_t count = 0;
        for (const bool left : {true, false}) {
            const double from = glm::dot(left ? p.left : p.right, view.sight(p.position));
            const double to = glm::dot(left ? q.left : q.right, view.sight(q.position));
            if ((from < 0.0) == (to < 0.0)) continue;
            const double at =
                turn_of(sheets, left ? creases.left[crease] : creases.right[crease], piece, from, to, view);
            if (at > curve_tuning.at_point && at < 1.0 - curve_tuning.at_point) share[count++] = at;
        }
        if (count == 2 && share[1] < share[0]) std::swap(share[0], share[1]);
        for (std::size_t k = 0; k < count; ++k) {
            CreasePoint turn;
            turn.position = piece.at(share[k]);
            turn.tangent = glm::normalize(piece.derivative(share[k]));
            set_normals(sheets, creases, crease, {&turn, 1});
            path.push_back(turn);
        }
    }
    return path;
}

void add_parts(const base::Array<CreasePoint>& path, bool closed, const AngleRange& angles, const View& view,
               CreaseParts& parts) {
    const std::int64_t size = path.size();
    HRBFNPR_ASSERT(size >= 2);
    // Tells which of the two sheets face the eye between point k and the next point. The test is made midway between
    // the two points, because a sheet may be just turning away at a point.
    struct Facing {
        bool left, right;
        bool operator==(const Facing&) const = default;
    };
    const auto facing_after = [&](std::int64_t k) {
        const CreasePoint& a = path[k % size];
        const CreasePoint& b = path[(k + 1) % size];
        const glm::dvec3 sight = view.sight(0.5 * (a.position + b.position));
        return Facing{glm::dot(a.left + b.left, sight) < 0.0, glm::dot(a.right + b.right, sight) < 0.0};
    };
    const auto joined = [&](std::int64_t k) { return facing_after(k) == facing_after(k + 1); };
    for_joined(closed ? size : size - 1, closed, joined, [&](std::int64_t begin, std::int64_t end, bool whole) {
        const Facing facing = facing_after(begin);
        const bool fold = facing.left != facing.right;
        const bool backwards = fold && facing.right;
        SurfaceLines& to = fold ? parts.folds : facing.left ? parts.outside : parts.inside;
        base::Array<AngleRange>& of = facing.left ? parts.of_outside : parts.of_inside;
        LineBuilder builder(to, true);
        const std::int64_t last = whole ? end - 1 : end;
        for (std::int64_t k = begin; k <= last; ++k) {
            const CreasePoint& p = path[(backwards ? last - (k - begin) : k) % size];
            const glm::dvec3 normal = !fold ? p.left + p.right : facing.left ? p.left : p.right;
            builder.add(p.position, normal, p.angle(), backwards ? -p.tangent : p.tangent);
        }
        builder.end(whole);
        if (!fold && of.size() < to.curves.count()) of.push_back(angles);
    });
}

// ---- Sheets

// The domain of one sheet of a whole surface: the places where this sheet is active.
class SheetDomain final : public implicit::Domain {
public:
    // `creases` are places along the creases of all sheets, at most a mesh side apart. A sheet may end near any crease.
    // A curve that leaves a sheet may reach another sheet with the same function, for example where two cylinders have
    // the same axis. `own` has the triangles of the sheet, and must outlive this object. `base` is the domain of the
    // whole surface, or null.
    SheetDomain(const implicit::Implicit& whole, std::int32_t sheet, std::shared_ptr<const geometry::PointGrid> creases,
                const SurfaceMesh& own, const implicit::Domain* base)
        : whole_(whole), sheet_(sheet), own_(own), creases_(std::move(creases)),
          vertices_(own.position, curve_tuning.vertex_reach * own.side), base_(base) {
        HRBFNPR_ASSERT(whole.sheets() != nullptr && sheet >= 0 && sheet < whole.sheets()->count());
    }

    [[nodiscard]] bool near_end(const glm::dvec3& place) const noexcept override {
        return (base_ != nullptr && base_->near_end(place)) || creases_->any_around(place);
    }
    // If another sheet is active at the place, returns the distance between the place and the whole surface. If this
    // distance is 0, returns the side of a mesh cell instead. The exception is a place near a vertex of this sheet: two
    // equal sheets may coincide there, and either of them may be active.
    [[nodiscard]] double beyond(const glm::dvec3& place, const glm::dvec3& gradient) const override {
        const double on_surface = curve_tuning.on_sheet * own_.side;
        if (surface::active_at(*whole_.sheets(), place) != sheet_) {
            double value = 0.0;
            glm::dvec3 slope(0.0);
            whole_.evaluate({&place.x, &place.y, &place.z, 1}, {&value, {&slope.x, &slope.y, &slope.z}, {}});
            const double off = std::abs(value) / glm::length(slope);
            if (!(off <= on_surface)) return off;
            bool is_own = false;
            vertices_.around(place, [&](std::int64_t at) {
                const glm::dvec3 vertex = own_.position[vertices_.index(at)];
                is_own = is_own || glm::distance(vertex, place) <= curve_tuning.vertex_reach * own_.side;
            });
            if (!is_own) return own_.side;
        }
        return base_ != nullptr && base_->near_end(place) ? base_->beyond(place, gradient) : -on_surface;
    }

private:
    const implicit::Implicit& whole_;
    std::int32_t sheet_;
    const SurfaceMesh& own_;
    std::shared_ptr<const geometry::PointGrid> creases_;
    geometry::PointGrid vertices_;
    const implicit::Domain* base_;
};

} // namespace

base::List<std::unique_ptr<SheetSurface>> sheet_surfaces(const base::Runtime& runtime, const implicit::Implicit& whole,
                                                         const SharpMesh& mesh) {
    base::List<std::unique_ptr<SheetSurface>> parts(runtime.memory);
    const implicit::Sheets* const all = whole.sheets();
    if (all == nullptr) return parts;
    const std::int32_t sheets = all->count();
    // The triangles of sheet s are order[begin[s]] to order[begin[s + 1] - 1].
    base::Array<std::int64_t> begin(runtime.memory, sheets + 2), order(runtime.memory, mesh.sheet.size());
    for (const std::int32_t sheet : mesh.sheet) ++begin[sheet + 2];
    for (std::int64_t s = 2; s < begin.size(); ++s) begin[s] += begin[s - 1];
    for (std::int64_t t = 0; t < mesh.sheet.size(); ++t) order[begin[mesh.sheet[t] + 1]++] = t;
    // For each vertex: 1 + its index in the part, or 0 if it is not in the part.
    base::Array<std::int32_t> number(runtime.memory, mesh.mesh.vertices());
    geometry::VecArray creases(runtime.memory);
    for (std::int32_t sheet = 0; sheet < sheets; ++sheet) {
        if (begin[sheet] == begin[sheet + 1]) continue;
        SheetSurface& part = *parts.add(std::make_unique<SheetSurface>(runtime.memory, whole, *all, sheet));
        base::Array<std::int32_t> used(runtime.memory);
        for (std::int64_t k = begin[sheet]; k < begin[sheet + 1]; ++k)
            for (std::int64_t i = 3 * order[k]; i < 3 * order[k] + 3; ++i) {
                const std::int32_t vertex = mesh.mesh.corner[i];
                if (number[vertex] == 0) {
                    part.mesh.position.push_back(mesh.mesh.position[vertex]);
                    part.mesh.gradient.push_back(mesh.mesh.gradient[vertex]);
                    number[vertex] = static_cast<std::int32_t>(part.mesh.vertices());
                    used.push_back(vertex);
                }
                part.mesh.corner.push_back(number[vertex] - 1);
            }
        for (const std::int32_t vertex : used) number[vertex] = 0;
        part.mesh.region = mesh.mesh.region;
        part.mesh.side = mesh.mesh.side;
    }
    const base::Runtime one_thread(runtime, base::Parallel()); // most parts are small
    runtime.parallel.for_each(parts.size(), [&](std::int64_t p) {
        SurfaceMesh& own = parts[p]->mesh;
        own.neighbour = find_neighbours(one_thread, own.corner, own.vertices());
    });
    for (const std::unique_ptr<SheetSurface>& part : parts)
        for (std::int64_t e = 0; e < part->mesh.corner.size(); ++e)
            if (part->mesh.neighbour[e] < 0) creases.push_back(part->mesh.position[part->mesh.corner[e]]);
    const auto grid = std::make_shared<const geometry::PointGrid>(creases, curve_tuning.border_reach * mesh.mesh.side);
    runtime.parallel.for_each(parts.size(), [&](std::int64_t p) {
        SheetSurface& part = *parts[p];
        part.domain = std::make_unique<SheetDomain>(whole, part.sheet, grid, part.mesh, mesh.mesh.domain);
        part.mesh.domain = part.domain.get();
    });
    return parts;
}

double CreasePoint::angle() const noexcept {
    const glm::dvec3 cross = glm::cross(left, right);
    const double size = 180.0 / std::numbers::pi * std::atan2(glm::length(cross), glm::dot(left, right));
    return glm::dot(cross, tangent) < 0.0 ? -size : size;
}

Creases trace_creases(const base::Work& work, const implicit::Implicit& implicit, const CreaseChains& chains,
                      double side) {
    HRBFNPR_ASSERT(side > 0.0 && chains.left.size() == chains.count() && chains.right.size() == chains.count());
    const implicit::Sheets& sheets = *implicit.sheets();
    const base::Work threads = implicit.threads(work);
    Creases creases(work.memory);
    for (std::int64_t c = 0; c < chains.count(); ++c) add_chain(chains, c, side, creases);
    threads.for_each(creases.count(), [&](std::int64_t c) {
        set_normals(sheets, creases, c,
                    {creases.point.data() + creases.first[c], static_cast<std::size_t>(creases.size_of(c))});
    });
    creases = drop_returns(creases, side);
    const auto wanted = [&](std::int64_t, std::int64_t i, std::int64_t j, CreasePoint& p) {
        const CreasePoint& a = creases.point[i];
        const CreasePoint& b = creases.point[j];
        const double length = glm::distance(a.position, b.position) / side;
        const glm::dvec3 chord = (b.position - a.position) / (length * side);
        const bool turns =
            std::min(glm::dot(a.tangent, chord), glm::dot(b.tangent, chord)) < crease_tuning.straight_turn;
        p.position = CubicPiece(as_curve_point(a), as_curve_point(b)).at(0.5);
        return length > crease_tuning.longest_piece || (turns && length > crease_tuning.shortest_piece);
    };
    const auto bring = [&](base::Array<CreasePoint>& added, const base::Array<std::int64_t>& of, const auto&) {
        base::Array<std::uint8_t> found(work.memory, added.size());
        threads.for_chunks(added.size(), crease_points_a_task, [&](std::int64_t begin, std::int64_t end) {
            std::array<surface::MeetingSearch, static_cast<std::size_t>(crease_points_a_task)> searches;
            std::array<surface::MeetingPlace, static_cast<std::size_t>(crease_points_a_task)> places;
            const auto count = static_cast<std::size_t>(end - begin);
            for (std::size_t i = 0; i < count; ++i) {
                const std::int64_t k = begin + static_cast<std::int64_t>(i);
                searches[i].meeting.add(creases.left[of[k]]);
                searches[i].meeting.add(creases.right[of[k]]);
                searches[i].from = added[k].position;
                searches[i].farthest = 0.5 * side;
            }
            surface::find_meetings(sheets, std::span(searches).first(count), 1e-9 * side, places.data());
            for (std::size_t i = 0; i < count; ++i) {
                const std::int64_t k = begin + static_cast<std::int64_t>(i);
                found[k] = places[i].found ? 1 : 0;
                if (!places[i].found) continue;
                added[k].position = places[i].position;
                added[k].left = glm::normalize(places[i].gradient[0]);
                added[k].right = glm::normalize(places[i].gradient[1]);
            }
        });
        return found;
    };
    bool changed = true;
    for (int round = 0; changed; ++round) {
        find_tangents(creases);
        changed = round < crease_rounds && halve_pieces(creases, wanted, bring);
    }
    return creases;
}

NearCreases::NearCreases(base::Memory& memory, const Creases& creases, double least, double side)
    : most_(crease_tuning.farthest_beside * side), from_(memory), to_(memory) {
    HRBFNPR_ASSERT(side > 0.0);
    geometry::VecArray middle(memory);
    const auto sharp = [&](std::int64_t i) { return std::abs(creases.point[i].angle()) >= least; };
    for (std::int64_t c = 0; c < creases.count(); ++c)
        for (std::int64_t i = creases.first[c]; i < creases.first[c + 1]; ++i) {
            const std::int64_t j = creases.next(c, i);
            if (j < 0 || !sharp(i) || !sharp(j)) continue;
            from_.push_back(creases.point[i].position);
            to_.push_back(creases.point[j].position);
            middle.push_back(0.5 * (creases.point[i].position + creases.point[j].position));
        }
    grid_.emplace(middle, 0.5 * crease_tuning.longest_piece * side + most_);
}

bool NearCreases::has(const glm::dvec3& place, double reach) const noexcept {
    bool found = false;
    grid_->around(place, [&](std::int64_t at) {
        const std::int64_t i = grid_->index(at);
        found = found || geometry::distance_to_segment(place, from_[i], to_[i]) <= std::min(reach, most_);
    });
    return found;
}

CreaseParts parts_in_view(const base::Runtime& runtime, const implicit::Sheets& sheets, const Creases& creases,
                          const View& view) {
    CreaseParts parts(runtime.memory);
    for (std::int64_t c = 0; c < creases.count(); ++c) {
        AngleRange angles;
        for (std::int64_t i = creases.first[c]; i < creases.first[c + 1]; ++i) {
            const auto angle = static_cast<float>(creases.point[i].angle());
            angles = {std::min(angles.least, angle), std::max(angles.most, angle)};
        }
        add_parts(path_of(runtime.memory, sheets, creases, c, view), creases.closed[c] != 0, angles, view, parts);
    }
    return parts;
}

SurfaceLines bent_parts(base::Memory& memory, const SurfaceLines& lines, const base::Array<AngleRange>& of,
                        CreaseSide side, double lower, double upper) {
    const Curves& curves = lines.curves;
    HRBFNPR_ASSERT(of.size() == curves.count());
    // The lines whose creases bend by at least `upper` degrees somewhere. Angles are positive if a crease bends to
    // `side`.
    SurfaceLines bent(memory);
    LineBuilder builder(bent, true);
    base::Array<double> above(memory);
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        if (static_cast<double>(std::max(angle_on(side, of[c].least), angle_on(side, of[c].most))) < upper) continue;
        for (std::int64_t i = curves.first[c]; i < curves.first[c + 1]; ++i) {
            const auto angle = static_cast<double>(angle_on(side, lines.strength[i]));
            builder.add(curves.point[i].position, curves.point[i].gradient, angle, curves.point[i].direction());
        }
        builder.end(curves.closed[c] != 0);
    }
    for (const float angle : bent.strength) above.push_back(static_cast<double>(angle) - lower);
    return parts_where(bent, above, false, true);
}

} // namespace hrbfnpr::curves
