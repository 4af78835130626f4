// SPDX-License-Identifier: MIT
// 1. make_mesh makes a mesh of the surface, cuts it where samples end (clip_mesh) and at creases (split_mesh), and
//    repeats this with smaller cells if walls are too thin for them.
// 2. border_lines, exact_border make a line of the mesh's border edges (border_vertices). exact_border drops crowded
//    points (thinned_border) and adds points where the border turns (halve_pieces).
// 3. measured_mesh computes curvatures, if lines need them.
// 4. find finds the lines that do not depend on the view. Sections of a surface with creases end where the planes cross
//    creases (find_section_corners, end_at_corners), and lines whose ends meet are joined (join).
#include "features/line_set.h"

#include "base/assert.h"
#include "base/clock.h"
#include "features/soft_edges.h"
#include "features/tuning.h"
#include "geometry/point_grid.h"
#include "implicit/evaluate_all.h"
#include "surface/project.h"
#include "surface/region.h"
#include "surface/sheets_meet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace hrbfnpr::curves {
namespace {

geometry::VecArray given_seeds(base::Memory& memory, std::span<const double> given) {
    geometry::VecArray seeds(memory);
    for (std::size_t i = 0; i + 2 < given.size(); i += 3) seeds.push_back({given[i], given[i + 1], given[i + 2]});
    return seeds;
}

// Projects the points of a lattice onto the surface, and returns those that stay in the region.
geometry::VecArray found_seeds(const base::Work& work, const implicit::Implicit& surface,
                               const geometry::Bounds& region) {
    surface::Projection points(work.memory);
    const glm::dvec3 step = (region.max - region.min) / static_cast<double>(feature_tuning.lattice);
    for (std::int64_t z = 0; z < feature_tuning.lattice; ++z)
        for (std::int64_t y = 0; y < feature_tuning.lattice; ++y)
            for (std::int64_t x = 0; x < feature_tuning.lattice; ++x)
                points.position.push_back(region.min + step * (glm::dvec3(x, y, z) + 0.5));
    surface::project(work, surface, {}, points);
    geometry::VecArray seeds(work.memory);
    for (std::int64_t i = 0; i < points.position.size(); ++i)
        if (points.status[i] == surface::ProjectionStatus::converged && region.contains(points.position[i]))
            seeds.push_back(points.position[i]);
    return seeds;
}

// Makes the caller's lines. Additional points keep the cubics straight, and lines are cut at corners.
SurfaceLines own_lines(const base::Work& work, const implicit::Implicit& surface, const LineRequest& request,
                       double side) {
    HRBFNPR_ASSERT(side > 0.0);
    const geometry::VecArray points = given_seeds(work.memory, request.points);
    geometry::VecArray gradient(work.memory, points.size());
    implicit::evaluate_all(work, surface, points,
                           {nullptr, {gradient.x.data(), gradient.y.data(), gradient.z.data()}, {}});
    SurfaceLines lines(work.memory);
    LineBuilder builder(lines, true);
    for (std::size_t l = 0; l + 1 < request.first.size(); ++l) {
        const std::int64_t begin = request.first[l];
        const std::int64_t end = request.first[l + 1];
        for (std::int64_t i = begin; i < end; ++i) {
            const glm::dvec3 way = i > begin ? points[i] - points[i - 1] : glm::dvec3(0.0);
            const double steps = std::min(1e4, std::ceil(glm::length(way) / side));
            for (double k = 1.0; k < steps; k += 1.0)
                builder.add(points[i - 1] + k / steps * way, glm::mix(gradient[i - 1], gradient[i], k / steps), 1.0);
            builder.add(points[i], gradient[i], 1.0);
            if (i == begin || i + 1 == end) continue;
            const glm::dvec3 next = points[i + 1] - points[i];
            if (!(glm::dot(way, next) < feature_tuning.own_corner * glm::length(way) * glm::length(next))) continue;
            builder.end(false);
            builder.add(points[i], gradient[i], 1.0);
        }
        builder.end(false);
    }
    return lines;
}

// ---- Triangles of the caller

// Returns whether the cells of a mesh miss much of the surface.
bool is_torn(const SurfaceMesh& mesh) noexcept {
    return mesh.missed_seeds > 0 ||
           static_cast<double>(mesh.turned) > feature_tuning.torn_share * static_cast<double>(mesh.triangles());
}

// Returns whether nearly all vertices are on the surface that a mesh of cells approximates. Vertices inside other
// solids are not.
bool are_on_surface(const base::Work& work, const implicit::Implicit& surface, const GivenTriangles& triangles,
                    const SurfaceMesh& mesh) {
    geometry::VecArray place(work.memory);
    for (const glm::dvec3& vertex : triangles.vertex)
        place.push_back(glm::clamp(vertex, mesh.region.min, mesh.region.max));
    base::Array<double> value(work.memory, place.size());
    geometry::VecArray gradient(work.memory, place.size());
    implicit::evaluate_all(work, surface, place,
                           {value.data(), {gradient.x.data(), gradient.y.data(), gradient.z.data()}, {}});
    std::int64_t off = 0;
    for (std::int64_t i = 0; i < place.size(); ++i)
        off += std::abs(value[i]) <= mesh.side * glm::length(gradient[i]) ? 0 : 1;
    return static_cast<double>(off) <= feature_tuning.vertices_off * static_cast<double>(place.size());
}

// ---- The border

constexpr int most_rounds = 6; // each round halves the pieces that turn too much

struct BorderPoint {
    CurvePoint point;
    bool exact = false; // whether f = g = 0 at the point; false: the region ends there
};

Chains<std::int32_t> border_vertices(base::Memory& memory, const SurfaceMesh& mesh) {
    HRBFNPR_ASSERT(mesh.neighbour.size() == mesh.corner.size());
    base::Array<std::int32_t> after(memory, mesh.vertices()); // for each vertex, 1 + the next vertex along the border
    for (std::int64_t e = 0; e < mesh.corner.size(); ++e)
        if (mesh.neighbour[e] < 0) after[start_of(mesh, e)] = 1 + end_of(mesh, e);
    Chains<std::int32_t> chains(memory);
    for (std::int64_t start = 0; start < mesh.vertices(); ++start) {
        if (after[start] == 0) continue;
        std::int64_t at = start;
        while (after[at] != 0) {
            chains.point.push_back(static_cast<std::int32_t>(at));
            at = std::exchange(after[at], 0) - 1;
        }
        if (at != start) chains.point.push_back(static_cast<std::int32_t>(at));
        chains.end(at == start);
    }
    return chains;
}

// Drops points of the cut that are too close together, except next to the end of the region.
Chains<BorderPoint> thinned_border(const Chains<std::int32_t>& border, const ClippedMesh& clipped) {
    HRBFNPR_ASSERT(clipped.mesh.vertices() - clipped.first_cut == clipped.cut.size());
    Chains<BorderPoint> chains(border.first.memory());
    for (std::int64_t c = 0; c < border.count(); ++c) {
        const std::int32_t* const vertex = border.point.data() + border.first[c];
        const std::int64_t count = border.size_of(c);
        const bool closed = border.closed[c] != 0;
        const std::int64_t first = chains.point.size();
        const auto is_cut = [&](std::int64_t i) {
            return (closed || (i >= 0 && i < count)) && vertex[(i + count) % count] >= clipped.first_cut;
        };
        for (std::int64_t i = 0; i < count; ++i) {
            BorderPoint p;
            p.exact = is_cut(i);
            if (p.exact) {
                p.point = clipped.cut[vertex[i] - clipped.first_cut];
            } else {
                p.point.position = clipped.mesh.position[vertex[i]];
                p.point.gradient = clipped.mesh.gradient[vertex[i]];
            }
            const auto crowds = [&](std::int64_t other) {
                return glm::distance(chains.point[other].point.position, p.point.position) <
                       feature_tuning.border_gap * clipped.mesh.side;
            };
            const std::int64_t size = chains.point.size();
            const bool last = closed && i + 1 == count;
            if (is_cut(i - 1) && is_cut(i) && is_cut(i + 1) && size > first + (last ? 2 : 0) &&
                (crowds(size - 1) || (last && crowds(first))))
                continue;
            chains.point.push_back(p);
        }
        chains.end(closed);
    }
    return chains;
}

// Returns the mesh's border edges as lines. The surface lies to the left, as seen from outside.
SurfaceLines border_lines(base::Memory& memory, const SurfaceMesh& mesh) {
    const Chains<std::int32_t> border = border_vertices(memory, mesh);
    SurfaceLines lines(memory);
    LineBuilder builder(lines);
    for (std::int64_t c = 0; c < border.count(); ++c) {
        for (std::int64_t i = border.first[c]; i < border.first[c + 1]; ++i)
            builder.add(mesh.position[border.point[i]], mesh.gradient[border.point[i]], 1.0);
        builder.end(border.closed[c] != 0);
    }
    return lines;
}

// Returns the border of a mesh that was cut along g = 0. Points of the cut are on f = g = 0 and have exact tangents.
// Points are added where the curve turns.
SurfaceLines exact_border(const base::Work& work, const Level& level, const ClippedMesh& clipped) {
    const double side = clipped.mesh.side;
    Chains<BorderPoint> chains = thinned_border(border_vertices(work.memory, clipped.mesh), clipped);
    const auto wanted = [&](std::int64_t, std::int64_t i, std::int64_t j, BorderPoint& p) {
        const BorderPoint& a = chains.point[i];
        const BorderPoint& b = chains.point[j];
        if (!a.exact || !b.exact) return false;
        const bool turns = glm::dot(glm::normalize(a.point.direction()), glm::normalize(b.point.direction())) <
                           feature_tuning.border_turn;
        const double length = glm::distance(a.point.position, b.point.position) / side;
        p.exact = true;
        p.point.position = CubicPiece(a.point, b.point).at(0.5);
        return length > feature_tuning.longest_border_piece || (turns && length > feature_tuning.shortest_border_piece);
    };
    const auto bring = [&](base::Array<BorderPoint>& added, const auto&, const auto&) {
        base::Array<CurvePoint> points(work.memory);
        for (const BorderPoint& p : added) points.push_back(p.point);
        base::Array<std::uint8_t> found(work.memory);
        bring_to_curve(work, level, {1e-9 * side, 0.2 * side}, points, found);
        for (std::int64_t k = 0; k < added.size(); ++k) added[k].point = points[k];
        return found;
    };
    for (int round = 0; round < most_rounds && halve_pieces(chains, wanted, bring); ++round) continue;
    SurfaceLines lines(work.memory);
    LineBuilder builder(lines);
    for (std::int64_t c = 0; c < chains.count(); ++c) {
        for (std::int64_t i = chains.first[c]; i < chains.first[c + 1]; ++i) {
            const CurvePoint& p = chains.point[i].point;
            builder.add(p.position, p.gradient, 1.0, chains.point[i].exact ? p.direction() : glm::dvec3(0.0));
        }
        builder.end(chains.closed[c] != 0);
    }
    return lines;
}

// Returns whether the whole border was cut, so that no part of it is at the end of the region.
bool is_all_cut(const ClippedMesh& clipped) noexcept {
    const SurfaceMesh& mesh = clipped.mesh;
    for (std::int64_t e = 0; e < mesh.corner.size(); ++e)
        if (mesh.neighbour[e] < 0 && (start_of(mesh, e) < clipped.first_cut || end_of(mesh, e) < clipped.first_cut))
            return false;
    return true;
}

// ---- Sections

constexpr int corner_steps = 20;           // the greatest number of Newton steps
constexpr double corner_tolerance = 1e-10; // the search ends after a step shorter than this, in sides
constexpr double same_place = 1e-9;        // ends closer than this are joined, in sides

struct SectionCorner {
    glm::dvec3 place;
    glm::dvec3 left, right; // unit normals of the two sheets
    std::int32_t level;
};

base::Array<SectionCorner> find_section_corners(base::Memory& memory, const implicit::Sheets& sheets,
                                                const Creases& creases, const glm::dvec3& plane,
                                                std::span<const double> levels, double side) {
    base::Array<SectionCorner> corners(memory);
    for (std::int64_t c = 0; c < creases.count(); ++c)
        for (std::int64_t i = creases.first[c]; i < creases.first[c + 1]; ++i) {
            const std::int64_t j = creases.next(c, i);
            if (j < 0) continue;
            const glm::dvec3 a = creases.point[i].position;
            const glm::dvec3 b = creases.point[j].position;
            for (std::size_t l = 0; l < levels.size(); ++l) {
                const double from = glm::dot(plane, a) - levels[l];
                const double to = glm::dot(plane, b) - levels[l];
                if ((from < 0.0) == (to < 0.0)) continue;
                const glm::dvec3 start = glm::mix(a, b, from / (from - to));
                std::array<surface::SheetValue, 3> values;
                glm::dvec3 at = start;
                const auto look = [&] {
                    values = {surface::sheet_at(sheets, creases.left[c], at),
                              surface::sheet_at(sheets, creases.right[c], at),
                              {glm::dot(plane, at) - levels[l], plane}};
                };
                look();
                for (int step = 0; step < corner_steps; ++step) {
                    const glm::dvec3 way = surface::step_to_zero(values);
                    const bool lost = !(glm::distance(at + way, start) <= feature_tuning.corner_reach * side);
                    at = lost ? start : at + way;
                    look();
                    if (lost || glm::length(way) <= corner_tolerance * side) break;
                }
                corners.push_back({at, glm::normalize(values[0].gradient), glm::normalize(values[1].gradient),
                                   static_cast<std::int32_t>(l)});
            }
        }
    return corners;
}

// Moves the ends of lines to corners. If the last points of a line lie beyond the corner, they are spread between the
// corner and the last point that does not. The normal at the corner is that of the line's own sheet.
void end_at_corners(const base::Runtime& runtime, const base::Array<SectionCorner>& corners, double side,
                    FeatureLines& lines) {
    geometry::VecArray places(runtime.memory);
    for (const SectionCorner& corner : corners) places.push_back(corner.place);
    const geometry::PointGrid grid(places, feature_tuning.corner_reach * side);
    for (std::int64_t l = 0; l < lines.count(); ++l)
        for (const std::int64_t inward : {1, -1}) {
            if (lines.closed[l] != 0) continue;
            const std::int64_t end = inward > 0 ? lines.first[l] : lines.first[l + 1] - 1;
            const std::int64_t count = lines.size_of(l);
            double least = feature_tuning.corner_reach * side;
            const SectionCorner* nearest = nullptr;
            grid.around(lines.point[end].position, [&](std::int64_t at) {
                const SectionCorner& corner = corners[grid.index(at)];
                const double distance = glm::distance(corner.place, lines.point[end].position);
                if (corner.level != lines.level[l] || !(distance < least)) return;
                least = distance;
                nearest = &corner;
            });
            if (nearest == nullptr) continue;
            const auto at = [&](std::int64_t k) { return lines.point[end + k * inward].position; };
            std::int64_t kept = 1;
            while (kept + 1 < count && glm::dot(nearest->place - at(kept), at(kept) - at(kept + 1)) <= 0.0) ++kept;
            const glm::dvec3 inner = glm::normalize(lines.point[end + std::min(count - 1, kept) * inward].normal);
            const bool is_left = glm::dot(inner, nearest->left) >= glm::dot(inner, nearest->right);
            for (std::int64_t k = 0; k < kept; ++k) {
                const double share = static_cast<double>(k) / static_cast<double>(kept);
                FeaturePoint& p = lines.point[end + k * inward];
                p.position = glm::mix(nearest->place, at(kept), share);
                p.normal = glm::mix(is_left ? nearest->left : nearest->right, inner, share);
            }
        }
}

// Joins open lines where the end of one coincides with the start of another. A line whose own ends coincide becomes
// closed.
SurfaceLines join(base::Memory& memory, const SurfaceLines& lines, double side) {
    const Curves& curves = lines.curves;
    const auto start = [&](std::int64_t line) { return curves.first[line]; };
    const auto last = [&](std::int64_t line) { return curves.first[line + 1] - 1; };
    // For each line, the line joined to its end or start; -1: none.
    base::Array<std::int64_t> after(memory, curves.count()), before(memory, curves.count());
    std::fill(after.begin(), after.end(), -1);
    std::fill(before.begin(), before.end(), -1);
    geometry::VecArray starts(memory);
    for (std::int64_t l = 0; l < curves.count(); ++l) starts.push_back(curves.point[start(l)].position);
    const geometry::PointGrid grid(starts, side);
    for (std::int64_t l = 0; l < curves.count(); ++l) {
        if (curves.closed[l] != 0) continue;
        const glm::dvec3 end = curves.point[last(l)].position;
        grid.around(end, [&](std::int64_t at) {
            const std::int64_t next = grid.index(at);
            if (curves.closed[next] != 0 || after[l] >= 0 || before[next] >= 0 ||
                !(glm::distance(starts[next], end) <= same_place * side))
                return;
            after[l] = next;
            before[next] = l;
        });
    }
    const auto turns = [&](std::int64_t line, std::int64_t next) {
        return glm::dot(glm::normalize(curves.point[last(line)].direction()),
                        glm::normalize(curves.point[start(next)].direction())) < feature_tuning.smooth;
    };
    SurfaceLines joined(memory);
    LineBuilder builder(joined);
    // Adds a point. At a corner, the point is moved slightly towards the point `towards`.
    const auto put = [&](std::int64_t at, std::int64_t towards) {
        const CurvePoint& p = curves.point[at];
        const glm::dvec3 way = curves.point[towards].position - p.position;
        const double length = glm::length(way);
        const double share = length > 0.0 ? std::min(0.25, feature_tuning.around_corner * side / length) : 0.0;
        builder.add(p.position + share * way, p.gradient, static_cast<double>(lines.strength[at]), p.direction());
    };
    base::Array<std::uint8_t> done(memory, curves.count());
    for (const bool from_ends : {true, false}) // first for open chains, then for closed ones
        for (std::int64_t l = 0; l < curves.count(); ++l) {
            if (done[l] != 0 || (from_ends && (before[l] >= 0 || curves.closed[l] != 0))) continue;
            for (std::int64_t at = l; at >= 0 && done[at] == 0; at = after[at]) {
                done[at] = 1;
                const std::int64_t a = before[at];
                const std::int64_t b = after[at];
                put(start(at), start(at) + (a >= 0 && turns(a, at) ? 1 : 0));
                for (std::int64_t i = start(at) + 1; i < last(at); ++i) put(i, i);
                // At a smooth joint the last point is omitted, since it equals the first point of the next line.
                if (b < 0 || turns(at, b)) put(last(at), last(at) - (b < 0 ? 0 : 1));
            }
            builder.end(!from_ends);
        }
    return joined;
}

// Sections of a mesh that is cut at creases consist of one line for each sheet. Moves the lines' ends to where both
// sheets of a crease and the plane are 0, and joins them there. A corner between two lines stays sharp. side: side of
// the mesh's cells.
SurfaceLines joined_sections(const base::Runtime& runtime, const implicit::Sheets& sheets, const Creases& creases,
                             const glm::dvec3& plane, std::span<const double> levels, double side,
                             FeatureLines& sections) {
    HRBFNPR_ASSERT(side > 0.0);
    const base::Array<SectionCorner> corners =
        find_section_corners(runtime.memory, sheets, creases, plane, levels, side);
    if (!corners.empty()) end_at_corners(runtime, corners, side, sections);
    const SurfaceLines lines = as_lines(runtime.memory, sections);
    return lines.curves.count() > 0 ? join(runtime.memory, lines, side) : SurfaceLines(runtime.memory);
}

// Returns whether lines of this kind that are found once need the derivatives of f at the vertices of the mesh.
bool needs_curvatures(LineKind kind) noexcept {
    return !is_given(kind) && kind != LineKind::soft_edge && needs_shape(feature_of(kind));
}

} // namespace

FeatureKind feature_of(LineKind kind) noexcept {
    switch (kind) {
    case LineKind::ridge: return FeatureKind::ridge;
    case LineKind::valley: return FeatureKind::valley;
    case LineKind::apparent_ridge: return FeatureKind::apparent_ridge;
    case LineKind::parabolic: return FeatureKind::parabolic;
    case LineKind::isophote: return FeatureKind::isophote;
    case LineKind::section: return FeatureKind::section;
    default: return FeatureKind::suggestive_contour;
    }
}

// Returns the default thresholds, which were chosen by eye on scans and on smooth models.
Thresholds default_thresholds(LineKind kind) noexcept {
    switch (kind) {
    case LineKind::suggestive_contour: return {10.0, 30.0};
    case LineKind::ridge:
    case LineKind::valley: return {6.0, 15.0};
    case LineKind::apparent_ridge: return {12.0, 25.0};
    case LineKind::crease: return {15.0, 30.0};    // in degrees
    case LineKind::soft_edge: return {15.0, 35.0}; // in degrees
    case LineKind::intersection: return {feature_tuning.least_crossing, feature_tuning.least_crossing};
    default: return {0.0, 0.0};
    }
}

void LineSet::make_mesh(const base::Work& work, const LineSetSettings& settings) {
    MeshSettings mesh;
    mesh.region = surface::search_region(surface_);
    mesh.side = settings.side;
    const bool automatic = !(settings.side > 0.0);
    if (automatic)
        mesh.side = settings.spacing > 0.0
                        ? std::max(settings.spacing / feature_tuning.sides_a_spacing, 1e-9 * surface_.diagonal())
                        : surface_.diagonal() / feature_tuning.sides_a_diagonal;
    const geometry::VecArray seeds = settings.seeds.empty() ? found_seeds(work.part(0.0, 0.2), surface_, mesh.region)
                                                            : given_seeds(work.memory, settings.seeds);
    mesh.domain = settings.support.domain;
    double last = std::numeric_limits<double>::infinity(); // the side in the previous round
    for (double from = 0.2;; from = 0.5 * (1.0 + from)) {
        mesh_ = automatic ? triangulate_of_any_size(work.part(from, 0.5 * (1.0 + from)), surface_, seeds, mesh)
                          : triangulate(work.part(from, 0.5 * (1.0 + from)), surface_, seeds, mesh);
        cut_mesh(work);
        // Where walls are thinner than the cells, creases cut very many triangles. With smaller cells, fewer are cut.
        const bool last_one =
            !automatic || 4 * mesh_->triangles() > feature_tuning.most_triangles_of_finer || mesh.side >= last;
        const bool missed = mesh_->missed_seeds > 0;
        if (surface_.sheets() != nullptr && (last_one || !missed)) split_mesh(work);
        if (is_torn(*mesh_) && use_triangles(work, settings.triangles)) break;
        if (last_one || !is_thin()) break;
        last = mesh.side;
        mesh.side *= 0.5;
    }
    if (mesh_->triangles() == 0 && left_out_ > 0.0)
        fail(Status::not_converged,
             "the whole surface is too far from the samples; use a support larger than %g, or support_points nearer to "
             "the surface",
             domain_->limit());
    if (mesh_->triangles() == 0)
        fail(Status::not_converged, "no surface was found for the lines, because f has no zero near the seeds; give "
                                    "seed_points on the surface");
    sheets_.emplace(work, *mesh_);
}

bool LineSet::is_thin() const noexcept {
    const bool many = 4 * mesh_->triangles() > feature_tuning.most_triangles_of_finer;
    const double turned = static_cast<double>(mesh_->turned) / static_cast<double>(mesh_->triangles());
    return mesh_->missed_seeds > 0 || turned > (many ? feature_tuning.torn_share : feature_tuning.turned_share);
}

// Cuts the mesh where the surface ends, and finds its border.
void LineSet::cut_mesh(const base::Work& work) {
    if (domain_ != nullptr)
        clip_mesh(work);
    else
        border_ = border_lines(work.memory, *mesh_);
}

bool LineSet::use_triangles(const base::Work& work, const GivenTriangles& triangles) {
    if (triangles.empty() || !are_on_surface(work, surface_, triangles, *mesh_)) return false;
    GivenMeshSettings settings;
    settings.region = mesh_->region;
    settings.side = mesh_->side;
    if (domain_ != nullptr)
        settings.strip = feature_tuning.strip * (domain_->closest() > 0.0 ? domain_->closest() : mesh_->side);
    settings.triangle_limit = feature_tuning.most_triangles;
    const auto share = [](const SurfaceMesh& mesh) {
        return static_cast<double>(mesh.turned) / static_cast<double>(std::max<std::int64_t>(mesh.triangles(), 1));
    };
    SurfaceMesh of_triangles = mesh_of_triangles(work.without_progress(), surface_, triangles, settings);
    SurfaceMesh of_cells = std::exchange(*mesh_, std::move(of_triangles));
    SurfaceLines border = std::exchange(border_, SurfaceLines(work.memory));
    Creases creases = std::exchange(creases_, Creases(work.memory));
    base::List<std::unique_ptr<SheetSurface>> parts =
        std::exchange(parts_, base::List<std::unique_ptr<SheetSurface>>(work.memory));
    const bool border_exact = border_exact_;
    const double left_out = left_out_;
    cut_mesh(work);
    if (surface_.sheets() != nullptr) split_mesh(work);
    if (mesh_->triangles() > 0 && share(*mesh_) <= share(of_cells)) return true;
    mesh_ = std::move(of_cells);
    border_ = std::move(border);
    keep_creases(std::move(creases), mesh_->side);
    parts_ = std::move(parts);
    border_exact_ = border_exact;
    left_out_ = left_out;
    return false;
}

// If no normals are given, the normals of the surface are used.
void LineSet::measure_support(const base::Work& work, const SupportSettings& settings) {
    const geometry::VecArray points = given_seeds(work.memory, settings.points);
    geometry::VecArray normals = given_seeds(work.memory, settings.normals);
    if (normals.empty()) {
        normals.resize(points.size());
        implicit::evaluate_all(work, surface_, points,
                               {nullptr, {normals.x.data(), normals.y.data(), normals.z.data()}, {}});
    }
    for (std::int64_t i = 0; i < normals.size(); ++i) normals.set(i, glm::normalize(normals[i]));
    own_domain_.emplace(surface::Support(work, points, normals, 0.0), settings.limit, 0.0);
    domain_ = &*own_domain_;
}

void LineSet::keep_creases(Creases creases, double side) {
    creases_ = std::move(creases);
    near_creases_.reset();
    const Thresholds by = thresholds_of(LineKind::crease, {});
    if (creases_.count() > 0) near_creases_.emplace(creases_.point.memory(), creases_, by.lower, side);
}

void LineSet::split_mesh(const base::Work& work) {
    SharpMesh sharp = split_at_creases(work.part(0.0, 0.0), surface_, std::move(*mesh_));
    keep_creases(trace_creases(work, surface_, sharp.creases, sharp.mesh.side), sharp.mesh.side);
    parts_ = sheet_surfaces(work, surface_, sharp);
    mesh_ = std::move(sharp.mesh);
}

void LineSet::clip_mesh(const base::Work& work) {
    border_level_.emplace(surface_, domain_->support(), domain_->limit());
    ClippedMesh clipped = clip(work, *border_level_, *mesh_);
    border_ = exact_border(work, *border_level_, clipped);
    border_exact_ = is_all_cut(clipped);
    if (own_domain_) {
        geometry::VecArray border(work.memory);
        for (const CurvePoint& p : clipped.cut) border.push_back(p.position);
        own_domain_->set_border(border, curve_tuning.border_reach * mesh_->side);
    }
    mesh_ = std::move(clipped.mesh);
    mesh_->domain = domain_;
    left_out_ = clipped.left_out;
}

SurfaceLines LineSet::find_lines(const base::Work& work, const LineRequest& request) const {
    if (is_given(request.kind)) return own_lines(work, surface_, request, mesh_->side);
    FeatureRequest feature;
    feature.kind = feature_of(request.kind);
    feature.plane = glm::normalize(request.plane);
    feature.levels = request.levels;
    const Thresholds thresholds = thresholds_of(request.kind, request.thresholds);
    feature.lower = thresholds.lower;
    feature.upper = thresholds.upper;
    feature.shortest = request.shortest;
    FeatureLines found = find_feature_lines(work, features(), feature);
    const implicit::Sheets* const sheets = surface_.sheets();
    if (sheets == nullptr || feature.kind != FeatureKind::section) return as_lines(work.memory, found);
    return joined_sections(work, *sheets, creases_, feature.plane, feature.levels, mesh_->side, found);
}

void LineSet::find(const base::Work& work, const LineRequest& request) {
    const auto add = [&](SurfaceLines lines, bool concave) {
        FoundLines& found = found_.add(work.memory);
        found.kind = request.kind;
        found.name = request.name;
        found.lines = std::move(lines);
        found.concave = concave;
    };
    if (request.kind != LineKind::soft_edge) return add(find_lines(work, request), false);
    const Thresholds by = thresholds_of(request.kind, request.thresholds);
    SoftEdges edges = find_soft_edges(work, surface_, *mesh_, {by.lower, by.upper, request.shortest});
    add(std::move(edges.convex), false);
    add(std::move(edges.concave), true);
}

LineSet::LineSet(const base::Work& work, const implicit::Implicit& surface,
                 std::unique_ptr<const implicit::ShapeSource> shape, const LineSetSettings& settings)
    : surface_(surface), source_(std::move(shape)), shaped_(work.memory), border_(work.memory), creases_(work.memory),
      parts_(work.memory), found_(work.memory) {
    const base::Stopwatch watch;
    domain_ = settings.support.domain;
    if (domain_ == nullptr && settings.support.limit > 0.0) measure_support(work, settings.support);
    make_mesh(work.part(0.0, 0.4), settings);
    bool with_shape = settings.with_shape;
    for (const LineRequest& request : settings.lines) with_shape = with_shape || needs_curvatures(request.kind);
    if (with_shape) shaped_ = measured_mesh(work.part(0.4, 0.7), surface_, *source_, *mesh_);
    for (const LineRequest& request : settings.lines) find(work.part(0.7, 0.7), request);
    seconds_ = watch.seconds();
    work.runtime().log(base::LogLevel::info,
                       "lines: %lld triangles of cells of %.3g in %.3f s; %lld face the wrong way, %lld seeds missed",
                       static_cast<long long>(mesh_->triangles()), mesh_->side, seconds_,
                       static_cast<long long>(mesh_->turned), static_cast<long long>(mesh_->missed_seeds));
    work.update(1.0);
}

std::int64_t LineSet::bytes() const noexcept {
    std::int64_t bytes = mesh_->bytes() + sheets_->bytes() + shaped_.bytes() + border_.bytes();
    if (own_domain_) bytes += own_domain_->support().bytes();
    bytes += creases_.bytes() + (near_creases_ ? near_creases_->bytes() : 0);
    for (const std::unique_ptr<SheetSurface>& part : parts_) bytes += part->mesh.bytes();
    for (const FoundLines& found : found_) bytes += found.lines.bytes();
    return bytes;
}

} // namespace hrbfnpr::curves
