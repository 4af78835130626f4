// SPDX-License-Identifier: MIT
// How near the surface of an implicit is to a mesh, both ways.
#pragma once

#include "implicit/implicit.h"
#include "mesh/face_tree.h"
#include "mesh/mesh.h"
#include "surface/support.h"

namespace hrbfnpr::mesh {

struct CompareSettings {
    double tolerance = 0.0; // 0: 0.002 diagonals of the mesh
    double far = 0.0;       // 0: 0.01 diagonals
    double support = 0.0;   // > 0: the limit of what is borne out
    std::int64_t points = 0;
    double cell_size = 0.0;
    std::uint64_t seed = 1;
};

// Of distances: NaN where there are none.
struct Spread {
    std::int64_t points = 0;
    double mean = std::numeric_limits<double>::quiet_NaN();
    double p99 = std::numeric_limits<double>::quiet_NaN();
    double most = std::numeric_limits<double>::quiet_NaN();
    double share = std::numeric_limits<double>::quiet_NaN();  // within the tolerance
    double beyond = std::numeric_limits<double>::quiet_NaN(); // share beyond `far`
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

inline constexpr double default_tolerance = 0.002; // in diagonals
inline constexpr double default_far = 0.01;
inline constexpr std::int64_t default_points = 20000;
inline constexpr double cells_a_diagonal = 128.0;

// The box that a surface is looked for in beside a mesh.
[[nodiscard]] geometry::Bounds search_region(const Mesh& mesh) noexcept;
[[nodiscard]] Spread spread_of(base::Array<double>& distance, double tolerance, double far); // reorders them

// support may be null: that of the model's samples, if it has any.
[[nodiscard]] Comparison compare(const base::Runtime& runtime, const implicit::Implicit& implicit, const Mesh& mesh,
                                 const FaceTree& tree, const surface::Support* support, const CompareSettings& settings,
                                 const base::Progress& progress);

} // namespace hrbfnpr::mesh
