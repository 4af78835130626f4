// SPDX-License-Identifier: MIT
#include "mesh/pieces/patch_samples.h"

#include "geometry/cell_set.h"
#include "geometry/point_tree.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::mesh {
namespace {

constexpr double wanted = 3000.0; // places of a patch, about
constexpr double thinned = 0.7;   // no two in one cell of so many spacings ...
constexpr double thinned_crease = 0.35;
constexpr double around_tip = 3.0;    // spacings: where a sheet is not held as near to tips of cones
constexpr double tip_tolerance = 4.0; // of that far from creases
constexpr double most_cuts = 64.0;    // of an edge

[[nodiscard]] glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& other) noexcept {
    const double length = glm::length(v);
    return length > 1e-12 ? v / length : other;
}

// A cubic triangle through three corners, along their tangent planes.
class CurvedFace {
public:
    CurvedFace(const std::array<glm::dvec3, 3>& p, const glm::dvec3* n) noexcept : p_(p), n_{n[0], n[1], n[2]} {
        glm::dvec3 edges(0.0);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            ahead_[i] = third(i, j);
            back_[i] = third(j, i);
            edges += ahead_[i] + back_[i];
        }
        const glm::dvec3 middle = (p[0] + p[1] + p[2]) / 3.0;
        middle_ = edges / 6.0 + 0.5 * (edges / 6.0 - middle);
    }
    [[nodiscard]] glm::dvec3 at(const glm::dvec3& s) const noexcept {
        glm::dvec3 sum = 6.0 * s.x * s.y * s.z * middle_;
        for (std::size_t i = 0; i < 3; ++i) {
            const double a = s[static_cast<glm::length_t>(i)];
            const double b = s[static_cast<glm::length_t>((i + 1) % 3)];
            sum += a * a * a * p_[i] + 3.0 * a * a * b * ahead_[i] + 3.0 * a * b * b * back_[i];
        }
        return sum;
    }
    [[nodiscard]] glm::dvec3 normal(const glm::dvec3& s) const noexcept {
        return unit_or(s.x * n_[0] + s.y * n_[1] + s.z * n_[2], n_[0]);
    }

private:
    [[nodiscard]] glm::dvec3 third(std::size_t i, std::size_t j) const noexcept {
        return (2.0 * p_[i] + p_[j] - glm::dot(p_[j] - p_[i], n_[i]) * n_[i]) / 3.0;
    }
    std::array<glm::dvec3, 3> p_, n_, ahead_, back_;
    glm::dvec3 middle_;
};

class Sampler {
public:
    Sampler(const base::Runtime& runtime, const Mesh& mesh, const Creases& creases, const PatchNormals& normals,
            std::span<const std::int32_t> faces, const PatchTolerance& tolerance, const base::Progress& progress)
        : runtime_(runtime), mesh_(mesh), creases_(creases), normal_(normals.normal), tip_(normals.tip), faces_(faces),
          tolerance_(tolerance), progress_(progress), taken_(runtime.memory), taken_crease_(runtime.memory),
          result_(runtime.memory) {
        double area = 0.0;
        for (const std::int32_t face : faces) area += 0.5 * glm::length(doubled_area(mesh.corners(face)));
        spacing_ = std::max(std::sqrt(area / wanted), 1e-4 * mesh.bounds.diagonal());
        grid_ = {mesh.bounds.min - spacing_, std::max(thinned * spacing_, 1e-5 * mesh.bounds.diagonal())};
        crease_grid_ = {mesh.bounds.min - spacing_, std::max(thinned_crease * spacing_, 1e-5 * mesh.bounds.diagonal())};
    }

    [[nodiscard]] PatchSamples run() {
        for (const std::int32_t face : faces_)
            for (int k = 0; k < 3; ++k)
                if (creases_.cut[3 * std::int64_t{face} + k] == 1) add_crease(face, k);
        const std::int64_t on_creases = result_.samples.position.size();
        for (const std::int32_t face : faces_) add_face(face);
        measure(on_creases);
        return std::move(result_);
    }

private:
    void add(const glm::dvec3& place, const glm::dvec3& normal, bool crease) {
        geometry::CellSet& set = crease ? taken_crease_ : taken_;
        if (!set.insert(geometry::CellGrid::pack((crease ? crease_grid_ : grid_).cell_of(place)))) return;
        if (crease) taken_.insert(geometry::CellGrid::pack(grid_.cell_of(place)));
        result_.samples.position.push_back(place);
        result_.samples.normal.push_back(normal);
    }

    // No sheet has several normals at a tip: it is rounded as finely as the places around it are.
    void add_corner(std::int32_t face, std::size_t k, bool crease) {
        const std::int64_t corner = 3 * std::int64_t{face} + static_cast<std::int64_t>(k);
        const glm::dvec3 place = mesh_.corners(face)[k];
        if (tip_[corner] == 0) return add(place, normal_[corner], crease);
        if (std::find(tips_.begin(), tips_.end(), place) == tips_.end()) tips_.push_back(place);
    }

    [[nodiscard]] std::int64_t cuts(double length, double spacing) const noexcept {
        return static_cast<std::int64_t>(std::clamp(length / spacing, 1.0, most_cuts));
    }

    // Each patch has the places between vertices on its own curved surface: what is common to both is where these meet.
    void add_crease(std::int32_t face, int k) {
        const auto p = mesh_.corners(face);
        const auto a = static_cast<std::size_t>(k);
        const auto b = static_cast<std::size_t>((k + 1) % 3);
        const glm::dvec3* const n = normal_.data() + 3 * std::int64_t{face};
        for (const std::size_t end : {a, b}) add_corner(face, end, true);
        const std::int64_t parts = cuts(glm::distance(p[a], p[b]), 0.5 * spacing_);
        if (parts == 1) return;
        const CurvedFace curved(p, n);
        for (std::int64_t i = 1; i < parts; ++i) {
            const double t = static_cast<double>(i) / static_cast<double>(parts);
            glm::dvec3 shares(0.0);
            shares[k] = 1.0 - t;
            shares[(k + 1) % 3] = t;
            add(curved.at(shares), curved.normal(shares), true);
        }
    }

    void add_face(std::int32_t face) {
        const auto p = mesh_.corners(face);
        const glm::dvec3* const n = normal_.data() + 3 * std::int64_t{face};
        for (std::size_t k = 0; k < 3; ++k) add_corner(face, k, false);
        const double longest =
            std::max({glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])});
        const std::int64_t parts = cuts(longest, spacing_);
        if (parts == 1) return;
        const CurvedFace curved(p, n);
        for (std::int64_t i = 0; i <= parts; ++i)
            for (std::int64_t j = 0; i + j <= parts; ++j) {
                const glm::dvec3 shares =
                    glm::dvec3(static_cast<double>(i), static_cast<double>(j), static_cast<double>(parts - i - j)) /
                    static_cast<double>(parts);
                if (std::max({shares.x, shares.y, shares.z}) == 1.0) continue;
                const int opposite = shares.x == 0.0 ? 1 : shares.y == 0.0 ? 2 : shares.z == 0.0 ? 0 : -1;
                if (opposite >= 0 && creases_.cut[3 * std::int64_t{face} + opposite] == 1) continue;
                add(curved.at(shares), curved.normal(shares), false);
            }
    }

    void measure(std::int64_t on_creases) {
        fit::measure_extent(runtime_, result_.samples, progress_);
        const std::int64_t count = result_.samples.position.size();
        result_.tolerance.resize(count);
        geometry::VecArray crease(runtime_.memory);
        for (std::int64_t i = 0; i < on_creases; ++i) crease.push_back(result_.samples.position[i]);
        const geometry::PointTree tree(crease, progress_);
        runtime_.parallel.for_chunks(count, 512, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i) {
                std::int64_t found = 0;
                const bool any = tree.nearest(
                                     result_.samples.position[i], 1, [](std::int64_t) { return true; },
                                     [](std::int64_t) { return true; }, &found) > 0;
                const double distance =
                    any ? glm::distance(result_.samples.position[i], tree.points()[found]) : tolerance_.ramp;
                const double share = std::clamp(distance / tolerance_.ramp, 0.0, 1.0);
                result_.tolerance[i] =
                    std::max(tolerance_.crease + share * share * (tolerance_.far - tolerance_.crease),
                             at_tips(result_.samples.position[i]));
            }
        });
    }

    // What is rounded there is off by as much as its centres are apart.
    [[nodiscard]] double at_tips(const glm::dvec3& place) const noexcept {
        double most = 0.0;
        for (const glm::dvec3& tip : tips_)
            most = std::max(most, 1.0 - glm::distance(place, tip) / (around_tip * spacing_));
        return most * tip_tolerance * tolerance_.far;
    }

    const base::Runtime& runtime_;
    const Mesh& mesh_;
    const Creases& creases_;
    const base::Array<glm::dvec3>& normal_;
    const base::Array<std::uint8_t>& tip_;
    base::Array<glm::dvec3> tips_{runtime_.memory};
    std::span<const std::int32_t> faces_;
    const PatchTolerance tolerance_;
    const base::Progress& progress_;
    double spacing_ = 0.0;
    geometry::CellGrid grid_, crease_grid_;
    geometry::CellSet taken_, taken_crease_;
    PatchSamples result_;
};

} // namespace

PatchSamples sample_patch(const base::Runtime& runtime, const Mesh& mesh, const Creases& creases,
                          const PatchNormals& normals, std::span<const std::int32_t> faces,
                          const PatchTolerance& tolerance, const base::Progress& progress) {
    return Sampler(runtime, mesh, creases, normals, faces, tolerance, progress).run();
}

} // namespace hrbfnpr::mesh
