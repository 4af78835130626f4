// SPDX-License-Identifier: MIT
// Decides what becomes of a mesh: which faces are turned, which edges stay sharp, which coarse faces are divided, which
// parts are left out, how near a surface is to come, and where it ends.
//
// docs/input.md describes the results to users. Each is a function of facts and wishes and measures
// nothing itself. A fact that takes long to measure is a function, which is called only if the decision depends on it.
#pragma once

#include "mesh/orient.h"

#include <functional>

namespace hrbfnpr::mesh {

// ---- Faces that look the wrong way

// Tells whether make_mesh() turns a component inside out.
[[nodiscard]] bool is_turned(const Component& component, Parts parts, Faces faces) noexcept;

// The reasons to turn all faces of a mesh after an inspection of samples.
enum class Facing { right, down_z, down_y, inward };

struct FacingFacts {
    bool closed = false; // make_mesh() has already turned it.
    // The axis along which a terrain faces down, 'y' or 'z', or 0.
    std::function<char()> hangs_along;
    std::function<bool()> inward; // All normals point inward.
};
[[nodiscard]] Facing plan_facing(const FacingFacts& facts, bool keeps_faces);

// ---- Edges that stand out

// The values equal those of the constants HRBFNPR_EDGES_ of hrbfnpr.h.
enum class Edges : std::uint32_t { automatic = 0, smooth = 1, sharp = 2 };

// The lengths of the edges of a component that bend by more than an angle.
struct EdgeLengths {
    double all = 0.0;
    double standing = 0.0; // length of the edges that stand out
    double coarse = 0.0;   // length of the edges whose two faces are both far from a round surface
};

// The verdict on a mesh or a component, with its reasons.
struct CreaseEvidence {
    double length = 0.0;     // The length of the edges that bend by more than the angle, in diagonals.
    double standing = 0.0;   // The share of this length whose edges stand out.
    double coarse = 0.0;     // The share of this length whose edges have two faces that are far from a round surface.
    bool creases = false;    // The shape has edges.
    bool polyhedron = false; // The shape has edges because its faces are coarse: all are flat.
};
[[nodiscard]] CreaseEvidence judge_edges(const EdgeLengths& lengths, double diagonal) noexcept;
// Judges the whole from the sums over its components. `area_with_creases` is the area of the components that have
// edges.
[[nodiscard]] CreaseEvidence judge_all_edges(const EdgeLengths& lengths, double diagonal, double area_with_creases,
                                             double area) noexcept;

// The edges that a fit keeps sharp.
enum class SharpEdges {
    none,   // One smooth fit is enough.
    meant,  // Each component has the edges that plan_sharpness() gives it.
    bending // All edges that bend by more than the angle.
};
[[nodiscard]] SharpEdges plan_edges(Edges wish, const CreaseEvidence& whole, const std::function<bool()>& solids_cross);

// The limits beyond which the edges of a component are sharp.
struct Sharpness {
    double angle; // Edges that bend by more are sharp, in degrees.
    // Faces stay flat if they are farther than this from the curved surface that their vertex normals imply.
    double coarse;
};
// `far` and `tolerance` are distances in the unit of the mesh.
[[nodiscard]] Sharpness plan_sharpness(double angle, double far) noexcept;
[[nodiscard]] Sharpness plan_sharpness(const CreaseEvidence& part, const CreaseEvidence& whole, double angle,
                                       double far, double tolerance) noexcept;

// ---- Coarse faces

// The statement of a file's normals about the edges that bend.
enum class EdgesInFile {
    nothing, // The file says nothing, or that all edges are smooth, which is also what computed normals look like.
    some_are_sharp,
    all_are_sharp,
};
// Reads the statement from the number of edges that bend, and the number of these at which faces have normals of their
// own.
[[nodiscard]] EdgesInFile plan_edges_of_file(std::int64_t bends, std::int64_t sharp) noexcept;

// The caller's options for a picture. Distances are in diagonals.
struct MeshOptions {
    // True: the file and its shape decide which edges are sharp. False: `edges` and `edge_angle` decide.
    bool edges_as_given = true;
    Edges edges = Edges::automatic;
    double edge_angle = 30.0;    // degrees
    std::int32_t rounds = -1;    // subdivision rounds; below 0: as many as needed
    bool chooses_samples = true; // see chooses_samples()
    double tolerance = 0.0;      // 0: the default
};

struct CoarseFacts {
    std::int64_t faces = 0;
    EdgesInFile said = EdgesInFile::nothing;
    std::function<double()> mean_edge;  // in diagonals
    std::function<double()> coarseness; // how far the faces are from a round surface, in diagonals
    std::function<bool()> has_creases;  // A rough fit keeps some edges sharp.
};

struct CoarsePlan {
    enum class Choice {
        nothing,     // The mesh stays as it is.
        all_flat,    // All edges are sharp, because the normals of the file say so.
        coarse_flat, // All edges are sharp, because no round surface goes through the vertices.
        divided
    };
    Choice choice = Choice::nothing;
    std::int32_t rounds = 0;  // subdivision rounds
    bool parts_alone = false; // Only the parts with coarse faces are divided.

    [[nodiscard]] bool is_flat() const noexcept { return choice == Choice::all_flat || choice == Choice::coarse_flat; }
};
[[nodiscard]] CoarsePlan plan_coarse_faces(const CoarseFacts& facts, const MeshOptions& wishes);

// The effects of a division, in diagonals.
struct DivisionFacts {
    double moved = 0.0;                  // the farthest that a vertex moved
    double raised = 0.0;                 // how far most places between the vertices are from the faces
    double coarseness = 0.0;             // how far most faces were from a round surface before the division
    std::function<double()> most_coarse; // how far the worst face was from a round surface before the division
};
// Decides whether the division stays.
[[nodiscard]] CoarsePlan::Choice judge_division(const DivisionFacts& facts, EdgesInFile said,
                                                const MeshOptions& wishes);

struct FittedEdges {
    Edges edges;
    double angle; // degrees
};
// Returns the edges that a picture asks of its fit. `all_flat`: all faces are flat.
[[nodiscard]] FittedEdges plan_fitted_edges(const FittedEdges& of_fit, const MeshOptions& wishes,
                                            bool all_flat) noexcept;

// ---- Parts

// Tells whether make_mesh() keeps a component.
[[nodiscard]] bool is_kept(const Component& component, bool is_largest, Parts parts) noexcept;

// Tells whether a part has so little area that it is dropped if it is far away (a crumb).
[[nodiscard]] bool is_crumb(double area, double whole) noexcept;
// Tells whether a crumb is so far away that it is dropped. `distance` is its distance from all other parts, in
// diagonals of these parts.
[[nodiscard]] bool is_lost(double distance) noexcept;

// Tells whether a part is too small for a separate surface. Such a part is left out if it hangs on an edge of two other
// faces.
[[nodiscard]] bool is_flap(std::int64_t faces, double area, double whole) noexcept;

// Tells whether parts that cross or are close to each other should be searched for.
[[nodiscard]] bool may_be_grouped(const MeshReport& mesh, std::int64_t faces) noexcept;

// ---- How near the surface is to come

inline constexpr double default_tolerance = 0.002; // in diagonals

// The options of a picture that only a fit to samples supports.
struct SampleOptions {
    bool count = false;       // a number of samples
    bool flips = false;       // all normals are to be turned
    bool refines = false;     // the samples move
    bool judges = false;      // outliers or flipped normals are to be found
    bool regularizes = false; // the regularization is chosen from the noise
};
// Tells whether a fit to the mesh takes as many samples as it needs.
[[nodiscard]] bool chooses_samples(const SampleOptions& wishes) noexcept;

// Return the tolerance of a fit, and the distance that no place may exceed. If the wish is 0 they return the default.
[[nodiscard]] double plan_tolerance(double wish, double diagonal) noexcept;
[[nodiscard]] double plan_far(double wish, double tolerance) noexcept;
// Returns the tolerance for a group of parts. All groups together are `across` wide. The camera is as far away as for
// the whole, so the tolerance lies between that of the whole and that of the group alone.
[[nodiscard]] double plan_tolerance_of_group(double diagonal, double across) noexcept;

// ---- Where the surface ends

enum class End {
    nowhere,    // The surface stays whole.
    at_places,  // The surface ends where places all over the mesh end.
    at_samples, // The surface ends where the samples of the fit end.
    as_fitted,  // The fit has already ended the surface.
};

struct EndPlan {
    End end = End::nowhere;
    double off = 0.0; // Surface farther than this from the mesh does not belong to it, in diagonals.
};

// Distances are in the unit of the mesh. A distance that was not found is NaN.
struct EndFacts {
    double diagonal = 1.0;
    double area = 0.0;
    double border = 0.0; // the length of all borders
    bool has_border = false;
    bool closed = false;      // Each edge has two faces that agree.
    bool has_creases = false; // The fit consists of sheets.
    bool reached = false;     // The fit reached its tolerance.
    double mesh_p99 = 0.0;
    double surface_p99 = 0.0;
    double surface_most = 0.0;
};
// `may_end` is false if the caller keeps all of the surface.
[[nodiscard]] EndPlan plan_end(const EndFacts& facts, bool may_end) noexcept;
// Decides where the surface of a picture ends. The fit of a picture has only ended surfaces with a border.
[[nodiscard]] EndPlan plan_end_of_picture(const EndFacts& facts, bool may_end) noexcept;
// Decides where the surface of a picture ends that is a fit to samples `spacing` apart.
[[nodiscard]] EndPlan plan_end_of_samples(double spacing, double diagonal, bool may_end) noexcept;

} // namespace hrbfnpr::mesh
