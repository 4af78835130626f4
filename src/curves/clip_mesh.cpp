// SPDX-License-Identifier: MIT
#include "curves/clip_mesh.h"

#include "curves/level_roots.h"
#include "curves/mesh_topology.h"
#include "curves/triangle_tree.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

// In sides.
constexpr double cut_tolerance = 1e-9;
constexpr double farthest_cut = 0.35; // from where the edge says that the curve passes
constexpr int halvings = 10;

struct Edge {
    std::int32_t kept, lost; // vertices

    [[nodiscard]] bool operator<(const Edge& other) const noexcept {
        return kept != other.kept ? kept < other.kept : lost < other.lost;
    }
    [[nodiscard]] bool operator==(const Edge& other) const noexcept { return kept == other.kept && lost == other.lost; }
};

class MeshClipper {
public:
    MeshClipper(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh,
                const base::Progress& progress)
        : runtime_(runtime), level_(level), mesh_(mesh), progress_(progress), value_(runtime.memory),
          number_(runtime.memory, mesh.vertices()), edge_(runtime.memory), out_(runtime.memory) {
        level.at_vertices(runtime, mesh, value_, progress);
    }

    ClippedMesh run();

private:
    [[nodiscard]] bool keeps(std::int32_t vertex) const noexcept { return value_[vertex] <= 0.0; }
    void copy_vertices();
    void find_edges();
    void find_cuts();
    void add_cuts();
    void add_triangle(std::int64_t triangle);
    void put(const std::array<std::int32_t, 3>& corner);
    [[nodiscard]] std::int32_t cut_of(std::int32_t kept, std::int32_t lost) const noexcept {
        const Edge* const at = std::lower_bound(edge_.begin(), edge_.end(), Edge{kept, lost});
        return static_cast<std::int32_t>(out_.first_cut + (at - edge_.begin()));
    }

    const base::Runtime& runtime_;
    const Level& level_;
    const SurfaceMesh& mesh_;
    const base::Progress& progress_;
    base::Array<double> value_;        // g at the vertices
    base::Array<std::int32_t> number_; // of those that are kept
    base::Array<Edge> edge_;           // that are cut, ascending
    ClippedMesh out_;
};

void MeshClipper::copy_vertices() {
    SurfaceMesh& to = out_.mesh;
    for (std::int32_t v = 0; v < mesh_.vertices(); ++v) {
        if (!keeps(v)) continue;
        number_[v] = static_cast<std::int32_t>(to.vertices());
        to.position.push_back(mesh_.position[v]);
        to.gradient.push_back(mesh_.gradient[v]);
    }
    out_.first_cut = to.vertices();
}

void MeshClipper::find_edges() {
    for (std::int64_t e = 0; e < mesh_.corner.size(); ++e) {
        const std::int32_t a = mesh_.corner[e];
        const std::int32_t b = mesh_.corner[e - e % 3 + (e + 1) % 3];
        if (keeps(a) != keeps(b)) edge_.push_back(keeps(a) ? Edge{a, b} : Edge{b, a});
    }
    std::sort(edge_.begin(), edge_.end());
    edge_.resize(std::unique(edge_.begin(), edge_.end()) - edge_.begin());
}

// Newton's steps from where g is 0 by its values at the edge's ends; where these fail, from where halving leads.
void MeshClipper::find_cuts() {
    base::Array<std::uint8_t> found(runtime_.memory);
    out_.cut.resize(edge_.size());
    for (std::int64_t i = 0; i < edge_.size(); ++i) {
        const auto [kept, lost] = edge_[i];
        const double share = value_[kept] / (value_[kept] - value_[lost]);
        out_.cut[i].position = glm::mix(mesh_.position[kept], mesh_.position[lost], share);
    }
    bring_to_curve(runtime_, level_, {cut_tolerance * mesh_.side, farthest_cut * mesh_.side}, out_.cut, found,
                   progress_);
    base::Array<Straddle> places(runtime_.memory);
    base::Array<std::int64_t> which(runtime_.memory);
    for (std::int64_t i = 0; i < edge_.size(); ++i) {
        if (found[i] != 0) continue;
        places.push_back({mesh_.position[edge_[i].kept], mesh_.position[edge_[i].lost]});
        which.push_back(i);
    }
    base::Array<CurvePoint> halved(runtime_.memory);
    halve(runtime_, level_, places, halvings, halved, progress_);
    base::Array<CurvePoint> nearer(runtime_.memory);
    for (const CurvePoint& p : halved) nearer.push_back(p);
    bring_to_curve(runtime_, level_, {cut_tolerance * mesh_.side, 0.1 * farthest_cut * mesh_.side}, nearer, found,
                   progress_);
    for (std::int64_t i = 0; i < which.size(); ++i) out_.cut[which[i]] = found[i] != 0 ? nearer[i] : halved[i];
}

void MeshClipper::add_cuts() {
    for (const CurvePoint& p : out_.cut) {
        out_.mesh.position.push_back(p.position);
        out_.mesh.gradient.push_back(p.gradient);
    }
}

void MeshClipper::put(const std::array<std::int32_t, 3>& corner) {
    for (const std::int32_t vertex : corner) out_.mesh.corner.push_back(vertex);
}

// Of a triangle of which one corner is kept a triangle is left, of two a quadrilateral.
void MeshClipper::add_triangle(std::int64_t triangle) {
    const std::int32_t* const v = mesh_.corner.data() + 3 * triangle;
    const int kept = static_cast<int>(keeps(v[0])) + static_cast<int>(keeps(v[1])) + static_cast<int>(keeps(v[2]));
    if (kept == 0) return;
    if (kept == 3) {
        if (is_turned(mesh_, triangle)) ++out_.mesh.turned;
        return put({number_[v[0]], number_[v[1]], number_[v[2]]});
    }
    int odd = 0; // the corner that stands alone
    while (keeps(v[odd]) != (kept == 1)) ++odd;
    const std::int32_t a = v[odd];
    const std::int32_t b = v[(odd + 1) % 3];
    const std::int32_t c = v[(odd + 2) % 3];
    if (kept == 1) return put({number_[a], cut_of(a, b), cut_of(a, c)});
    const std::int32_t ab = cut_of(b, a);
    const std::int32_t ac = cut_of(c, a);
    put({number_[b], number_[c], ac});
    put({number_[b], ac, ab});
}

double area_of(const SurfaceMesh& mesh) noexcept {
    double sum = 0.0;
    for (std::int64_t t = 0; t < mesh.triangles(); ++t) {
        const std::array<glm::dvec3, 3> p = corners_of(mesh, t);
        sum += 0.5 * glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
    }
    return sum;
}

ClippedMesh MeshClipper::run() {
    out_.mesh.region = mesh_.region;
    out_.mesh.side = mesh_.side;
    out_.mesh.unresolved = mesh_.unresolved;
    out_.mesh.missed_seeds = mesh_.missed_seeds;
    copy_vertices();
    find_edges();
    find_cuts();
    add_cuts();
    for (std::int64_t t = 0; t < mesh_.triangles(); ++t) add_triangle(t);
    out_.mesh.neighbour = find_neighbours(runtime_, out_.mesh.corner, out_.mesh.vertices());
    const double before = area_of(mesh_);
    out_.left_out = before > 0.0 ? std::max(0.0, 1.0 - area_of(out_.mesh) / before) : 0.0;
    return std::move(out_);
}

} // namespace

ClippedMesh clip(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh,
                 const base::Progress& progress) {
    return MeshClipper(runtime, level, mesh, progress).run();
}

} // namespace hrbfnpr::curves
