// SPDX-License-Identifier: MIT
// 1. make_mesh: the surface as a mesh, cut where samples end (clip_mesh) and at creases (split_mesh); with smaller
// cells
//    again where walls are too thin for them.
// 2. measured_mesh: curvatures, if lines need them.
// 3. find: the lines that do not depend on the view.
#include "features/line_set.h"

#include "base/assert.h"
#include "base/clock.h"
#include "curves/tuning.h"
#include "features/border.h"
#include "features/sections.h"
#include "features/tuning.h"
#include "implicit/evaluate_all.h"
#include "surface/project.h"
#include "surface/region.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hrbfnpr::curves {
namespace {

geometry::VecArray given_seeds(base::Memory& memory, std::span<const double> given) {
    geometry::VecArray seeds(memory);
    for (std::size_t i = 0; i + 2 < given.size(); i += 3) seeds.push_back({given[i], given[i + 1], given[i + 2]});
    return seeds;
}

// Points of a lattice brought onto the surface: those that stay in the region.
geometry::VecArray found_seeds(const base::Runtime& runtime, const implicit::Implicit& surface,
                               const geometry::Bounds& region, const base::Progress& progress) {
    surface::Projection points(runtime.memory);
    const glm::dvec3 step = (region.max - region.min) / static_cast<double>(feature_tuning.lattice);
    for (std::int64_t z = 0; z < feature_tuning.lattice; ++z)
        for (std::int64_t y = 0; y < feature_tuning.lattice; ++y)
            for (std::int64_t x = 0; x < feature_tuning.lattice; ++x)
                points.position.push_back(region.min + step * (glm::dvec3(x, y, z) + 0.5));
    surface::project(runtime, surface, {}, points, progress);
    geometry::VecArray seeds(runtime.memory);
    for (std::int64_t i = 0; i < points.position.size(); ++i)
        if (points.status[i] == surface::ProjectionStatus::converged && region.contains(points.position[i]))
            seeds.push_back(points.position[i]);
    return seeds;
}

// Lines of the caller's, with points between so that cubics are straight, and cut at corners.
SurfaceLines own_lines(const base::Runtime& runtime, const implicit::Implicit& surface, const LineRequest& request,
                       double side, const base::Progress& progress) {
    HRBFNPR_ASSERT(side > 0.0);
    const geometry::VecArray points = given_seeds(runtime.memory, request.points);
    geometry::VecArray gradient(runtime.memory, points.size());
    implicit::evaluate_all(runtime, surface, points,
                           {nullptr, {gradient.x.data(), gradient.y.data(), gradient.z.data()}, {}}, progress);
    SurfaceLines lines(runtime.memory);
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

// Chosen by eye on scans and on smooth models.
Thresholds default_thresholds(LineKind kind) noexcept {
    switch (kind) {
    case LineKind::suggestive_contour: return {10.0, 30.0};
    case LineKind::ridge:
    case LineKind::valley: return {6.0, 15.0};
    case LineKind::apparent_ridge: return {12.0, 25.0};
    case LineKind::crease: return {15.0, 30.0}; // degrees
    default: return {0.0, 0.0};
    }
}

void LineSet::make_mesh(const base::Runtime& runtime, const LineSetSettings& settings, const base::Progress& progress) {
    MeshSettings mesh;
    mesh.region = surface::search_region(surface_);
    mesh.side = settings.side;
    const bool automatic = !(settings.side > 0.0);
    if (automatic)
        mesh.side = settings.spacing > 0.0
                        ? std::max(settings.spacing / feature_tuning.sides_a_spacing, 1e-9 * surface_.diagonal())
                        : surface_.diagonal() / feature_tuning.sides_a_diagonal;
    const geometry::VecArray seeds = settings.seeds.empty()
                                         ? found_seeds(runtime, surface_, mesh.region, progress.part(0.0, 0.2))
                                         : given_seeds(runtime.memory, settings.seeds);
    mesh.domain = settings.support.domain;
    double last = std::numeric_limits<double>::infinity(); // the side before
    for (double from = 0.2;; from = 0.5 * (1.0 + from)) {
        mesh_ = automatic
                    ? triangulate_of_any_size(runtime, surface_, seeds, mesh, progress.part(from, 0.5 * (1.0 + from)))
                    : triangulate(runtime, surface_, seeds, mesh, progress.part(from, 0.5 * (1.0 + from)));
        if (domain_ != nullptr) clip_mesh(runtime, progress);
        if (domain_ == nullptr) border_ = border_lines(runtime.memory, *mesh_);
        // If walls are thinner than the cells, creases cut very many triangles, and fewer where cells are smaller.
        const bool last_one =
            !automatic || 4 * mesh_->triangles() > feature_tuning.most_triangles_of_finer || mesh.side >= last;
        const bool missed = mesh_->missed_seeds > 0;
        if (surface_.sheets() != nullptr && (last_one || !missed)) split_mesh(runtime, progress);
        const bool many = 4 * mesh_->triangles() > feature_tuning.most_triangles_of_finer;
        const double turned = static_cast<double>(mesh_->turned) / static_cast<double>(mesh_->triangles());
        const bool thin = missed || turned > (many ? feature_tuning.torn_share : feature_tuning.turned_share);
        if (last_one || !thin) break;
        last = mesh.side;
        mesh.side *= 0.5;
    }
    if (mesh_->triangles() == 0 && left_out_ > 0.0)
        fail(Status::not_converged,
             "all of the surface lies beyond its samples: give a larger support than %g, or "
             "support_points nearer to the surface",
             domain_->limit());
    if (mesh_->triangles() == 0)
        fail(Status::not_converged, "no surface was found to draw lines of: f has no zero near the seeds; give "
                                    "seed_points on the surface");
    sheets_.emplace(runtime, *mesh_, progress);
}

// Where no normals are given, the surface's own are taken.
void LineSet::measure_support(const base::Runtime& runtime, const SupportSettings& settings,
                              const base::Progress& progress) {
    const geometry::VecArray points = given_seeds(runtime.memory, settings.points);
    geometry::VecArray normals = given_seeds(runtime.memory, settings.normals);
    if (normals.empty()) {
        normals.resize(points.size());
        implicit::evaluate_all(runtime, surface_, points,
                               {nullptr, {normals.x.data(), normals.y.data(), normals.z.data()}, {}}, progress);
    }
    for (std::int64_t i = 0; i < normals.size(); ++i) normals.set(i, glm::normalize(normals[i]));
    own_domain_.emplace(surface::Support(runtime, points, normals, 0.0, progress), settings.limit, 0.0);
    domain_ = &*own_domain_;
}

void LineSet::split_mesh(const base::Runtime& runtime, const base::Progress& progress) {
    SharpMesh sharp = split_at_creases(runtime, surface_, std::move(*mesh_), progress.part(0.0, 0.0));
    creases_ = trace_creases(runtime, surface_, sharp.creases, sharp.mesh.side, progress.part(0.0, 0.0));
    const Thresholds by = thresholds_of(LineKind::crease, {});
    if (creases_.count() > 0) near_creases_.emplace(runtime.memory, creases_, by.lower, sharp.mesh.side);
    parts_ = sheet_parts(runtime, surface_, sharp);
    mesh_ = std::move(sharp.mesh);
}

void LineSet::clip_mesh(const base::Runtime& runtime, const base::Progress& progress) {
    border_level_.emplace(surface_, domain_->support(), domain_->limit());
    ClippedMesh clipped = clip(runtime, *border_level_, *mesh_, progress);
    border_ = exact_border(runtime, *border_level_, clipped, progress);
    border_exact_ = is_all_cut(clipped);
    if (own_domain_) {
        geometry::VecArray border(runtime.memory);
        for (const CurvePoint& p : clipped.cut) border.push_back(p.position);
        own_domain_->set_border(border, curve_tuning.border_reach * mesh_->side);
    }
    mesh_ = std::move(clipped.mesh);
    mesh_->domain = domain_;
    left_out_ = clipped.left_out;
}

SurfaceLines LineSet::find(const base::Runtime& runtime, const LineRequest& request,
                           const base::Progress& progress) const {
    if (request.kind == LineKind::own) return own_lines(runtime, surface_, request, mesh_->side, progress);
    FeatureRequest feature;
    feature.kind = feature_of(request.kind);
    feature.plane = glm::normalize(request.plane);
    feature.levels = request.levels;
    const Thresholds thresholds = thresholds_of(request.kind, request.thresholds);
    feature.lower = thresholds.lower;
    feature.upper = thresholds.upper;
    feature.shortest = request.shortest;
    FeatureLines found = find_feature_lines(runtime, features(), feature, progress);
    const implicit::Sheets* const sheets = surface_.sheets();
    if (sheets == nullptr || feature.kind != FeatureKind::section) return as_lines(runtime.memory, found);
    return joined_sections(runtime, *sheets, creases_, feature.plane, feature.levels, mesh_->side, found);
}

LineSet::LineSet(const base::Runtime& runtime, const implicit::Implicit& surface,
                 std::unique_ptr<const implicit::ShapeSource> shape, const LineSetSettings& settings,
                 const base::Progress& progress)
    : surface_(surface), source_(std::move(shape)), shaped_(runtime.memory), border_(runtime.memory),
      creases_(runtime.memory), parts_(runtime.memory), found_(runtime.memory) {
    const base::Stopwatch watch;
    domain_ = settings.support.domain;
    if (domain_ == nullptr && settings.support.limit > 0.0) measure_support(runtime, settings.support, progress);
    make_mesh(runtime, settings, progress.part(0.0, 0.4));
    bool with_shape = settings.with_shape;
    for (const LineRequest& request : settings.lines)
        with_shape = with_shape || (request.kind != LineKind::own && needs_shape(feature_of(request.kind)));
    if (with_shape) shaped_ = measured_mesh(runtime, surface_, *source_, *mesh_, progress.part(0.4, 0.7));
    for (const LineRequest& request : settings.lines) {
        FoundLines& found = found_.add(runtime.memory);
        found.kind = request.kind;
        found.name = request.name;
        found.lines = find(runtime, request, progress.part(0.7, 0.7));
    }
    seconds_ = watch.seconds();
    runtime.log(base::LogLevel::info,
                "lines: %lld triangles of cells of %.3g in %.3f s, %lld look away, %lld seeds missed",
                static_cast<long long>(mesh_->triangles()), mesh_->side, seconds_,
                static_cast<long long>(mesh_->turned), static_cast<long long>(mesh_->missed_seeds));
    progress.update(1.0);
}

std::int64_t LineSet::bytes() const noexcept {
    std::int64_t bytes = mesh_->bytes() + sheets_->bytes() + shaped_.bytes() + border_.bytes();
    if (own_domain_) bytes += own_domain_->support().bytes();
    bytes += creases_.bytes() + (near_creases_ ? near_creases_->bytes() : 0);
    for (const std::unique_ptr<SheetPart>& part : parts_) bytes += part->mesh.bytes();
    for (const FoundLines& found : found_) bytes += found.lines.bytes();
    return bytes;
}

} // namespace hrbfnpr::curves
