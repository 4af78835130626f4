// SPDX-License-Identifier: MIT
// The tuning constants of make_mesh(), of the samples on a mesh, and of plan.cpp. A diagonal is the diagonal of the
// mesh's bounds. Tuned on the meshes of tests/mesh and on files of scanners and CAD programs.
#pragma once

#include <cstdint>

namespace hrbfnpr::mesh {

struct MeshTuning {
    // Loops over faces, vertices and samples check for cancellation after this many elements. Larger: cancelled calls
    // end later.
    std::int64_t at_once = 4096;

    // ---- Vertices and faces

    // Two border vertices are merged if their distance is at most this, in diagonals. Larger: narrow slits are closed.
    double border_rounding = 1e-6;
    // The assumed rounding error of coordinates, as a share of the largest coordinate. It is that of single precision.
    // Larger: more faces are slivers.
    double coordinate_rounding = 0x1p-22;
    // The largest assumed error for the angle of a face about an edge, in radians. Larger: more faces coincide.
    double most_angle_rounding = 0.01;
    // A face is a sliver if its height is at most this share of its longest side, and at most the rounding error.
    // Larger: small faces count as slivers.
    double flattest = 1e-3;
    // Slivers may lie beside other slivers, so they are split in several rounds. This is the largest number of rounds.
    // Larger: longer rows of slivers are split.
    int most_sliver_rounds = 32;

    // ---- Orientation

    // An open component has an inside if the area of its holes is less than this share of its area. Larger: open shapes
    // such as bowls are turned, too.
    double small_holes = 0.25;
    // The number of faces of a component from which rays test whether it lies inside another component. Larger: slower,
    // and fewer parts that stick out a little are left out.
    std::int64_t tested_faces = 64;
    // At a vertex with more corners than this, normals are means over about this many corners. Larger: slow on fans.
    std::int64_t most_corners = 256;
    // A place is on a side of a face if its barycentric coordinate for the opposite corner is at most this. Larger:
    // more places are on the border.
    double on_side = 1e-9;

    // ---- The row of samples along the border of an open mesh, and the even samples inside (end_samples())

    // The distance from the border to the row of places inside it, in units of end_samples()'s `closest`. By
    // measurement, s of surface/support.h is then 1.5 on the border. Larger: the surface ends before the border.
    double row_inset = 0.943;
    // The distance between the places of the row, in units of `closest`. Larger: the end is less straight.
    double row_step = 0.15;
    // A border shorter than this, in circumferences of a circle of radius `closest`, belongs to a hole that stays
    // closed.
    double shortest_border = 1.5;
    // A place is in the row only if its distance from every border is at least this, in insets. An inset is `row_inset`
    // times `closest`. Larger: no places in sharp corners.
    double least_inset = 0.9;
    // The row replaces even samples whose distance from the border is at most this many insets. Larger: a gap beside
    // the row.
    double replaced = 1.7;
    // The spacing of a row, in spacings of the row before it. Larger: fewer rows, and holes between them.
    double row_growth = 1.5;
    // The least spacing of the last row, in spacings of the even samples. Larger: more rows. Smaller: holes beside
    // them.
    double last_row = 1.5;
    // Even samples nearer to a row than this, in spacings of the row, are left out. Larger: holes beside the rows.
    double crowded = 0.8;
    // A place of the border is covered if a place of the row is within this many insets.
    double covered = 2.0;
    // The number of candidates for each even sample. Larger: slower, more even.
    std::int64_t candidates_each = 4;
};
inline constexpr MeshTuning mesh_tuning;

// The constants of plan.cpp, in the order of its functions. Set by scripts/bench edges on figures, machine parts and
// balls of 80 to 300 000 faces, and by pictures of open and closed files.
struct PlanTuning {
    // ---- Edges that stand out. Set on the models of scripts/bench edges --only=verdict.

    // A shape has edges if at least this share of the length of edges that bend stands out. Larger: more meshes are
    // smooth.
    double enough_standing = 0.5;
    // A shape is a polyhedron if at least this share of the length of edges that bend has two faces that are far from a
    // round surface. Larger: fewer rocks have edges.
    double enough_coarse = 0.25;
    // A shape has edges only if the edges that bend are at least this long together, in diagonals. Larger: shapes with
    // a short edge are smooth.
    double shortest_edges = 0.05;
    // A mesh has creases if its components with creases have at least this share of its area. Tiny parts of a scan then
    // do not give edges to the whole scan. Larger: smooth figures on blocks need larger blocks.
    double enough_area = 0.1;
    // Faces stay flat if they are farther from a round surface than this share of `far`. Larger: fewer faces stay flat.
    double too_coarse = 0.8;
    // On a polyhedron, an edge between coarse faces is sharp if it bends by more than this share of the crease angle.
    // Larger: fewer of its edges are sharp.
    double flat_faces = 0.05;

    // A component is smooth if its edges cut it into at least this many crumbs with at least this share of its area.
    // Larger: more folds of scans are sharp, in much more time.
    std::int64_t fewest_crumbs = 1000;
    double mostly_crumbs = 0.5;

    // ---- Coarse faces

    // If fewer edges than this bend, the normals of a file say nothing about edges.
    std::int64_t fewest_of_file = 8;
    // The normals of a file say that all edges are sharp if at least this share is sharp, and that none is if at most 1
    // minus this share is. Larger: more files have some sharp edges.
    double nearly_all = 0.98;
    // A mesh is divided only if it has at most this many faces. Larger: finer meshes are examined, in more time.
    std::int64_t most_coarse = 50'000;
    // A mesh whose mean edge is shorter than this, in diagonals, is not divided: its faces bend because of noise.
    // Larger: fewer meshes are divided.
    double coarse_edge = 0.025;
    // The largest number of subdivision rounds. Each round multiplies the number of faces by four.
    std::int32_t most_rounds = 3;
    // If a division moves vertices by more than this factor times the bulge of the faces, no round surface goes through
    // the vertices. The factor is at most 1.2 on figures and rings. Larger: more meshes with long faces are divided.
    double most_moved = 1.5;
    // If a division moves places between the vertices by more than this factor times the bulge of the faces, no round
    // surface goes through the vertices. The factor is 1.8 for a ball of 156 faces, and at most 2.7 for figures.
    double most_raised = 3.0;
    // If all faces are flat, edges that bend by more than this are sharp, in degrees. Larger: fewer edges are sharp.
    double flat_bend = 5.0;

    // ---- Parts

    // Far parts are dropped only if together they have at most this share of the total area. Larger: more parts are
    // dropped.
    double lost_area = 0.001;
    // A part is dropped only if its distance from the other parts is more than (this - 1) times the diagonal of the
    // other parts. Larger: fewer parts are dropped.
    double lost_distance = 4.0;
    // A part is too small for a separate surface if it has at most this many faces, and less than the share `flap_area`
    // of the total area. Larger: more faces are removed where three faces share an edge.
    std::int64_t flap_faces = 2;
    double flap_area = 2e-4;
    // Meshes with more faces than this are one group. The first limit is for meshes of one component, the second for
    // other meshes. Larger: more meshes are grouped, in more time.
    std::int64_t most_faces_of_one = 100'000;
    std::int64_t most_faces = 300'000;

    // ---- The tolerance of a fit

    // The largest allowed distance, in tolerances, unless the caller gives it. Larger: fewer centres in details.
    double far = 5.0;

    // ---- Where the surface ends

    // The bounds of EndPlan::off, in diagonals. Larger: more of the surface beyond a mesh is kept.
    double least_off = 0.009;
    double most_off = 0.015;
    // The lower bound of EndPlan::off for an open mesh, in diagonals, and as a factor of the distance between mesh and
    // surface. Larger: rounder corners, and narrow strips end later. Smaller: more places, and torn borders.
    double least_off_exact = 0.001;
    double of_error = 5.0;
    // A long border raises EndPlan::off, so that its places are not too many, to at most this share of the width of a
    // strip. It leaves space for a row of places on either side of the strip, and for a gap between the rows.
    double of_width = 0.2;
    // Between its bounds, EndPlan::off is this factor times the 99th percentile of the mesh's distances from the
    // surface, which is large if faces are coarse. For a fit to samples, it is this factor times the spacing of the
    // samples, because the fit rounds edges by about this distance.
    double of_coarse_faces = 1.5;
    // The number of places that show where a mesh ends. Larger: the end is more exact, in more time.
    std::int64_t places = 40000;
};
inline constexpr PlanTuning plan_tuning;

} // namespace hrbfnpr::mesh
