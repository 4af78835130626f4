// SPDX-License-Identifier: MIT
// Decides how a mesh is treated: which faces are turned, which edges stay sharp, which coarse faces are divided, which
// parts are left out, which tolerance a fit has, and where a surface ends.
//
// docs/input.md describes the decisions to users. Each decision is a function of facts and wishes, and measures
// nothing. A fact that takes long to measure is itself a function, which is called only if the decision depends on it.
#pragma once

#include "mesh/orient.h"

#include <functional>

namespace hrbfnpr::mesh {

// ---- Faces that look the wrong way

// Returns whether make_mesh() turns the faces of a component around.
[[nodiscard]] bool is_turned(const Component& component, Parts parts, Faces faces) noexcept;

// Whether all faces of a mesh must be turned, as inspected samples show: no (right); yes, because a terrain faces down
// along z or y; or yes, because the normals point inward.
enum class Facing { right, down_z, down_y, inward };

struct FacingFacts {
    bool closed = false; // True if the mesh is closed, so that make_mesh() has already turned it.
    // Returns the axis along which a terrain faces down, 'y' or 'z', or 0.
    std::function<char()> hangs_along;
    std::function<bool()> inward; // Returns whether all normals point inward.
};
[[nodiscard]] Facing plan_facing(const FacingFacts& facts, bool keeps_faces);

// ---- Edges that stand out

// The values equal the HRBFNPR_EDGES_ constants of hrbfnpr.h.
enum class Edges : std::uint32_t { automatic = 0, smooth = 1, sharp = 2 };

// The lengths of the edges of a component that bend by more than an angle.
struct EdgeLengths {
    double all = 0.0;
    double standing = 0.0; // the length of the edges that stand out
    double coarse = 0.0;   // the length of the edges with two faces that are far from a round surface
};

// The verdict whether a mesh or a component has edges, and the reasons.
struct CreaseEvidence {
    double length = 0.0;     // The length of the edges that bend by more than the angle, in diagonals.
    double standing = 0.0;   // The share of `length` in edges that stand out (has_creases.cpp).
    double coarse = 0.0;     // The share of `length` in edges whose two faces are far from a round surface.
    bool creases = false;    // True if the shape has edges.
    bool polyhedron = false; // True if the shape has edges because its faces are coarse. All faces are then flat.
};
[[nodiscard]] CreaseEvidence judge_edges(const EdgeLengths& lengths, double diagonal) noexcept;
// Judges a whole mesh from the sums over its components. `area_with_creases` is the area of the components with edges.
[[nodiscard]] CreaseEvidence judge_all_edges(const EdgeLengths& lengths, double diagonal, double area_with_creases,
                                             double area) noexcept;

// The edges that a fit keeps sharp.
enum class SharpEdges {
    none,   // no edges; one smooth fit is enough
    meant,  // for each component, the edges that plan_sharpness() allows
    bending // All edges that bend by more than the angle.
};
[[nodiscard]] SharpEdges plan_edges(Edges wish, const CreaseEvidence& whole, const std::function<bool()>& solids_cross);

// The limits beyond which the edges of a component are sharp.
struct Sharpness {
    double angle; // Edges that bend by more than this are sharp, in degrees.
    // Faces farther than this from the curved surface of their vertex normals stay flat.
    double coarse;
};
// Returns the limits for a component. `far` and `tolerance` are distances in the unit of the mesh.
[[nodiscard]] Sharpness plan_sharpness(double angle, double far) noexcept;
[[nodiscard]] Sharpness plan_sharpness(const CreaseEvidence& part, const CreaseEvidence& whole, double angle,
                                       double far, double tolerance) noexcept;

// The crumbs of a component: small patches of a few faces that do not lie in a plane, and small single faces.
struct Crumbs {
    std::int64_t count = 0;
    double area = 0.0;
};
// Returns whether a component stays smooth although it has edges: its faces are too coarse for its folds, so that its
// edges cut it into crumbs.
[[nodiscard]] bool is_crumbled(const Crumbs& crumbs, double area) noexcept;
// Returns the limits for such a component: no edge is sharp.
[[nodiscard]] Sharpness plan_crumbled() noexcept;

// ---- Coarse faces

// The statement of a file's normals about the edges that bend.
enum class EdgesInFile {
    // The file says nothing about edges. If a file says that all edges are smooth, this also counts as nothing, because
    // computed normals say so, too.
    nothing,
    some_are_sharp,
    all_are_sharp,
};
// Returns the meaning of a file's normals for its edges. It depends on the number of edges that bend, and on how many
// of them have separate normals for each face.
[[nodiscard]] EdgesInFile plan_edges_of_file(std::int64_t bends, std::int64_t sharp) noexcept;

// The caller's options for a picture. Distances are in diagonals.
struct MeshOptions {
    // If true, the file and the shape decide which edges are sharp. If false, `edges` and `edge_angle` decide.
    bool edges_as_given = true;
    Edges edges = Edges::automatic;
    double edge_angle = 30.0;    // in degrees
    std::int32_t rounds = -1;    // the number of subdivision rounds; below 0: as many as needed
    bool chooses_samples = true; // the result of chooses_samples()
    double tolerance = 0.0;      // 0 means the default
};

struct CoarseFacts {
    std::int64_t faces = 0;
    EdgesInFile said = EdgesInFile::nothing;
    std::function<double()> mean_edge;  // returns the mean length of edges, in diagonals
    std::function<double()> coarseness; // returns the distance of the faces from a round surface, in diagonals
    std::function<bool()> has_creases;  // returns whether a rough fit keeps some edges sharp
};

struct CoarsePlan {
    enum class Choice {
        nothing,     // The mesh is not divided.
        all_flat,    // All edges are sharp, as the normals of the file say.
        coarse_flat, // All edges are sharp, because no round surface goes through the vertices.
        divided
    };
    Choice choice = Choice::nothing;
    std::int32_t rounds = 0;  // the number of subdivision rounds
    bool parts_alone = false; // If true, only the parts with coarse faces are divided.

    [[nodiscard]] bool is_flat() const noexcept { return choice == Choice::all_flat || choice == Choice::coarse_flat; }
};
[[nodiscard]] CoarsePlan plan_coarse_faces(const CoarseFacts& facts, const MeshOptions& wishes);

// How a division changed a mesh. Lengths are in diagonals.
struct DivisionFacts {
    double moved = 0.0;      // the largest distance that a vertex moved
    double raised = 0.0;     // a high percentile of the distances between the new surface and the old faces
    double coarseness = 0.0; // a high percentile of the faces' distances from a round surface, before the division
    // Returns the largest distance of a face from a round surface, before the division.
    std::function<double()> most_coarse;
};
// Decides whether the division is kept.
[[nodiscard]] CoarsePlan::Choice judge_division(const DivisionFacts& facts, EdgesInFile said,
                                                const MeshOptions& wishes);

struct FittedEdges {
    Edges edges;
    double angle; // in degrees
};
// Returns the edges that the fit for a picture keeps sharp. `all_flat` means that all faces are flat.
[[nodiscard]] FittedEdges plan_fitted_edges(const FittedEdges& of_fit, const MeshOptions& wishes,
                                            bool all_flat) noexcept;

// ---- Parts

// Returns whether make_mesh() keeps a component.
[[nodiscard]] bool is_kept(const Component& component, bool is_largest, Parts parts) noexcept;

// Returns whether the area of a part is small enough to drop the part if it is far away. Such a part is a crumb.
[[nodiscard]] bool is_crumb(double area, double whole) noexcept;
// Returns whether a crumb is far enough away to be dropped. `distance` is its distance from all other parts, in
// diagonals of the other parts.
[[nodiscard]] bool is_lost(double distance) noexcept;

// Returns whether a part is too small for a separate surface. Such a part is left out if it touches an edge between two
// other faces.
[[nodiscard]] bool is_flap(std::int64_t faces, double area, double whole) noexcept;

// Returns whether a search for parts that cross, or are close to each other, is worthwhile.
[[nodiscard]] bool may_be_grouped(const MeshReport& mesh, std::int64_t faces) noexcept;

// ---- The samples and the tolerance of a fit

inline constexpr double default_tolerance = 0.002; // in diagonals

// The wishes of a picture that only a fit to samples can fulfil.
struct SampleOptions {
    bool count = false;       // The caller gives a number of samples.
    bool flips = false;       // The caller wants all normals to be turned.
    bool refines = false;     // The caller wants samples to be moved.
    bool judges = false;      // The caller wants outliers or flipped normals to be found.
    bool regularizes = false; // The caller wants regularization to be chosen from the noise.
};
// Returns whether a fit to the mesh chooses the number of its samples.
[[nodiscard]] bool chooses_samples(const SampleOptions& wishes) noexcept;

// The first function returns the tolerance of a fit, the second the largest allowed distance. If the wish is 0, they
// return the default.
[[nodiscard]] double plan_tolerance(double wish, double diagonal) noexcept;
[[nodiscard]] double plan_far(double wish, double tolerance) noexcept;
// Returns the tolerance for one group of parts. `across` is the diagonal of all groups together. The camera shows the
// whole, so the tolerance is between that for the whole and that for the group alone.
[[nodiscard]] double plan_tolerance_of_group(double diagonal, double across) noexcept;

// ---- Where the surface ends

enum class End {
    nowhere,    // the surface does not end
    at_places,  // the surface ends where the support of places all over the mesh ends
    at_samples, // the surface ends where the support of the fit's samples ends
    as_fitted,  // the fit has already ended the surface
};

struct EndPlan {
    End end = End::nowhere;
    double off = 0.0; // Surface farther from the mesh than this does not belong to it, in diagonals.
};

// Distances are in the unit of the mesh. A distance is NaN if it was not measured.
struct EndFacts {
    double diagonal = 1.0;
    double area = 0.0;
    double border = 0.0; // the total length of all borders
    bool has_border = false;
    bool closed = false;      // True if each edge has exactly two faces with the same orientation.
    bool has_creases = false; // true if the fit consists of sheets
    bool reached = false;     // true if the fit reached its tolerance
    double mesh_p99 = 0.0;
    double surface_p99 = 0.0;
    double surface_most = 0.0;
};
// Decides where a surface ends. `may_end` is false if the caller wants to keep the whole surface.
[[nodiscard]] EndPlan plan_end(const EndFacts& facts, bool may_end) noexcept;
// Decides where the surface of a picture ends. The fit of a picture has ended the surface only if there is a border.
[[nodiscard]] EndPlan plan_end_of_picture(const EndFacts& facts, bool may_end) noexcept;
// Decides where the surface of a picture ends if it is a fit to samples. The samples are `spacing` apart.
[[nodiscard]] EndPlan plan_end_of_samples(double spacing, double diagonal, bool may_end) noexcept;

} // namespace hrbfnpr::mesh
