// SPDX-License-Identifier: MIT
// How near the surface of an implicit is to a mesh, both ways; and how that surface is found.
#pragma once

#include "implicit/implicit.h"
#include "mesh/face_tree.h"
#include "surface/support.h"

namespace hrbfnpr::curves {
struct SurfaceMesh;
}

namespace hrbfnpr::mesh {

struct CompareSettings {
    double tolerance = 0.0; // 0: 0.002 diagonals of the mesh
    double far = 0.0;       // 0: 0.01 diagonals
    double support = 0.0;   // > 0: surface is left out that the support does not bear out to this limit
    std::int64_t points = 0;
    double cell_size = 0.0;
    std::uint64_t seed = 1;
};

// A summary of distances. Without any all but `points` are NaN.
struct Spread {
    std::int64_t points = 0;
    double mean = std::numeric_limits<double>::quiet_NaN();
    double p99 = std::numeric_limits<double>::quiet_NaN();
    double most = std::numeric_limits<double>::quiet_NaN();
    double share = std::numeric_limits<double>::quiet_NaN();  // within the tolerance
    double beyond = std::numeric_limits<double>::quiet_NaN(); // share beyond `far`

    // Tells whether at least a share is within the tolerance, and nothing beyond `far`.
    [[nodiscard]] bool is_within(double least_share, double farthest) const noexcept {
        return points > 0 && share >= least_share && most <= farthest;
    }
};

struct Comparison {
    Spread surface; // places on the surface, from the mesh
    Spread mesh;    // places on the mesh, from the surface
    double left_out = 0.0;
    double normal_mean = std::numeric_limits<double>::quiet_NaN(); // degrees
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

// Returns the box that a surface is looked for in beside a mesh.
[[nodiscard]] geometry::Bounds search_region(const Mesh& mesh) noexcept;
[[nodiscard]] Spread spread_of(base::Array<double>& distance, double tolerance, double far); // reorders them

struct SurfaceSearch {
    geometry::Bounds region; // The surface is looked for in it.
    double side = 0.0;       // of cells
    bool finer = false;      // Cells are halved, and again, where the surface is thinner than they are.
    double precision = 1e-9; // of the surface's vertices, in diagonals
    std::int64_t count = 0;  // of places
    std::uint64_t seed = 1;
    // If it is not null, places that it does not bear out up to the limit are left out.
    const surface::Support* support = nullptr;
    double limit = 0.0;
};

struct SurfacePlaces {
    explicit SurfacePlaces(base::Memory& memory) noexcept : position(memory), gradient(memory) {}

    geometry::VecArray position;
    geometry::VecArray gradient; // of f
};

// Returns the surface that the seeds are near to, or places of a coarse lattice lead to, as triangles.
[[nodiscard]] curves::SurfaceMesh find_surface(const base::Work& work, const implicit::Implicit& implicit,
                                               const geometry::VecArray& seeds, const SurfaceSearch& search);

// Drops places beyond the support's limit, if there is a support.
void leave_out(const base::Work& work, const SurfaceSearch& search, SurfacePlaces& places);

// support may be null; otherwise it is that of the model's samples.
[[nodiscard]] Comparison compare(const base::Work& work, const implicit::Implicit& implicit, const Mesh& mesh,
                                 const FaceTree& tree, const surface::Support* support,
                                 const CompareSettings& settings);

} // namespace hrbfnpr::mesh
