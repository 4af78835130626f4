// SPDX-License-Identifier: MIT
// Finds the surface of an implicit, and measures its distances from a mesh in both directions.
#pragma once

#include "implicit/implicit.h"
#include "mesh/face_tree.h"
#include "surface/support.h"

namespace hrbfnpr::curves {
struct SurfaceMesh;
}

namespace hrbfnpr::mesh {

struct CompareSettings {
    double tolerance = 0.0; // 0 means 0.002 diagonals of the mesh.
    double far = 0.0;       // 0 means 0.01 diagonals.
    double support = 0.0;   // If above 0, surface with a larger support value than this is left out.
    std::int64_t points = 0;
    double cell_size = 0.0;
    std::uint64_t seed = 1;
};

// A summary of distances. If there are no distances, all members except `points` are NaN.
struct DistanceStatistics {
    std::int64_t points = 0;
    double mean = std::numeric_limits<double>::quiet_NaN();
    double p99 = std::numeric_limits<double>::quiet_NaN();
    double most = std::numeric_limits<double>::quiet_NaN();
    double share = std::numeric_limits<double>::quiet_NaN();  // the share within the tolerance
    double beyond = std::numeric_limits<double>::quiet_NaN(); // the share of the distances above `far`

    // Returns whether at least `least_share` of the distances is within the tolerance and no distance is beyond
    // `farthest`.
    [[nodiscard]] bool is_within(double least_share, double farthest) const noexcept {
        return points > 0 && share >= least_share && most <= farthest;
    }
};

struct Comparison {
    DistanceStatistics surface; // distances from places on the surface to the mesh
    DistanceStatistics mesh;    // distances from places on the mesh to the surface
    double left_out = 0.0;
    double normal_mean = std::numeric_limits<double>::quiet_NaN(); // in degrees
    double normal_p99 = std::numeric_limits<double>::quiet_NaN();
    std::int64_t components = 0;
    std::int64_t genus = -1;
    double tolerance = 0.0;
    double diagonal = 0.0;
    double seconds = 0.0;
};

inline constexpr double default_far = 0.01; // in diagonals
inline constexpr std::int64_t default_points = 20000;
inline constexpr double cells_a_diagonal = 128.0;

// Returns the box around a mesh in which the surface is searched for.
[[nodiscard]] geometry::Bounds search_region(const Mesh& mesh) noexcept;
// Summarizes distances. The call reorders `distance`.
[[nodiscard]] DistanceStatistics statistics_of(base::Array<double>& distance, double tolerance, double far);

struct SurfaceSearch {
    geometry::Bounds region; // The box in which the surface is searched for.
    double side = 0.0;       // the side length of a cell
    bool finer = false;      // If set, cells are halved repeatedly where the surface is thinner than a cell.
    double precision = 1e-9; // the precision of the surface's vertices, in diagonals
    std::int64_t count = 0;  // the number of places on the surface
    std::uint64_t seed = 1;
    // If not null, places whose support value is above the limit are left out.
    const surface::Support* support = nullptr;
    double limit = 0.0;
};

struct SurfacePlaces {
    explicit SurfacePlaces(base::Memory& memory) noexcept : position(memory), gradient(memory) {}

    geometry::VecArray position;
    geometry::VecArray gradient; // the gradient of f
};

// Returns triangles of the surface. The search begins at the seeds, and at points of a coarse lattice, which it
// projects onto the surface.
[[nodiscard]] curves::SurfaceMesh find_surface(const base::Work& work, const implicit::Implicit& implicit,
                                               const geometry::VecArray& seeds, const SurfaceSearch& search);

// Drops the places whose support value is above the limit, if there is a support.
void drop_unsupported(const base::Work& work, const SurfaceSearch& search, SurfacePlaces& places);

// Compares the surface with the mesh in both directions. `support`, which may be null, is the support of the model's
// samples.
[[nodiscard]] Comparison compare(const base::Work& work, const implicit::Implicit& implicit, const Mesh& mesh,
                                 const FaceTree& tree, const surface::Support* support,
                                 const CompareSettings& settings);

} // namespace hrbfnpr::mesh
