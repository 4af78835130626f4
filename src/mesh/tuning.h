// SPDX-License-Identifier: MIT
// The tuning constants of make_mesh(), of the samples on a mesh, and of plan.cpp. A diagonal is the diagonal of the
// mesh's bounds. Tuned on the meshes of tests/mesh and on files of scanners and CAD programs.
#pragma once

#include <cstdint>

namespace hrbfnpr::mesh {

struct MeshTuning {
    // Loops over faces, vertices and samples check for cancellation after this many. Larger: calls react later to a
    // cancellation.
    std::int64_t at_once = 4096;

    // ---- Vertices and faces

    // Border vertices at most this far apart are merged, in diagonals. Larger: narrow slits are closed.
    double border_rounding = 1e-6;
    // The rounding error of coordinates, as a share of the largest one: that of files in single precision. Larger: more
    // faces are slivers.
    double coordinate_rounding = 0x1p-22;
    // The largest error that is assumed for the angle of a face about an edge, in radians. Larger: more faces lie on
    // each other.
    double most_angle_rounding = 0.01;
    // A face is a sliver if its height is at most this share of its longest side, and at most the rounding error.
    // Larger: small faces are taken for slivers.
    double flattest = 1e-3;
    // Slivers may lie beside others, so they are split in rounds. The slivers left after this many rounds stay. Larger:
    // longer rows are split.
    int most_sliver_rounds = 32;

    // ---- Orientation

    // An open component has an inside if its holes have less than this share of its area. Larger: open shapes such as
    // bowls are turned, too.
    double small_holes = 0.25;
    // Rays from this many faces of a component tell whether it lies inside another. Larger: slower, and fewer parts
    // that stick out a little are left out.
    std::int64_t tested_faces = 64;
    // At a vertex with more corners than this, a normal is the mean over about this many corners. Larger: slower on
    // fans.
    std::int64_t most_corners = 256;
    // A place is on a side of a face if the opposite corner's share in it is at most this. Larger: more places are on
    // the border.
    double on_side = 1e-9;

    // ---- Samples that end at the border, in lengths of end_samples()'s `closest`

    // The row of places along a border is this far inside it: by measurement, s of surface/support.h is then 1.5 on the
    // border. Larger: the surface ends short of the border.
    double row_inset = 0.943;
    // Places of the row are this far apart. Larger: the end is less straight.
    double row_step = 0.15;
    // Borders shorter than this many circumferences of a circle of radius `closest` are holes that stay closed.
    double shortest_border = 1.5;
    // A place belongs to the row only if it is at least this many insets from the border. Larger: sharp corners have
    // none.
    double least_inset = 0.9;
    // The row replaces even samples that are within this many insets from the border. Larger: a gap beside the row.
    double replaced = 1.7;
    // The row covers a place of the border if one of the row's places is nearer than this many insets.
    double covered = 2.0;
    // The number of candidates for each even sample. Larger: slower, more even.
    std::int64_t candidates_each = 4;
};
inline constexpr MeshTuning mesh_tuning;

// The constants of plan.cpp, in the order of its functions. Set by scripts/bench edges, on figures, machine parts and
// balls of 80 to 300 000 faces, and by pictures of open and closed files.
struct PlanTuning {
    // ---- Edges that stand out. Set on the models of scripts/bench edges --only=verdict.

    // A shape has edges if at least this share of its edges beyond the angle stands out, by length. Larger: more meshes
    // are smooth.
    double enough_standing = 0.5;
    // A shape is a polyhedron if at least this share of its edges beyond the angle, by length, has two faces that are
    // far from a round surface. Larger: fewer rocks have edges.
    double enough_coarse = 0.25;
    // The least length of the edges beyond the angle, in diagonals. Larger: shapes with a short edge are smooth.
    double shortest_edges = 0.05;
    // A mesh has creases if its components with creases hold at least this share of its area. So tiny parts of a scan
    // do not give the whole scan edges. Larger: smooth figures on blocks need larger blocks.
    double enough_area = 0.1;
    // Faces farther than this share of `far` from a round surface stay flat. Larger: fewer faces stay flat.
    double too_coarse = 0.8;
    // An edge of a polyhedron is sharp if its faces are coarse and it bends by more than this share of the crease
    // angle. Larger: fewer of its edges are sharp.
    double flat_faces = 0.05;

    // ---- Coarse faces

    // The normals of a file say nothing about its edges if fewer edges than this bend.
    std::int64_t fewest_of_file = 8;
    // The normals of a file say that all edges are sharp if at least this share is, and that none is if at most 1 minus
    // this share is. Larger: more files have some sharp edges.
    double nearly_all = 0.98;
    // Meshes with at most this many faces may be divided. Larger: finer meshes are examined, in more time.
    std::int64_t most_coarse = 50'000;
    // A mesh whose mean edge is shorter than this, in diagonals, is not divided: its faces bend because of noise.
    // Larger: fewer meshes are divided.
    double coarse_edge = 0.025;
    // The largest number of subdivision rounds. Each round makes four times as many faces.
    std::int32_t most_rounds = 3;
    // No round surface goes through the vertices if the division moves them by more than this factor times the bulge of
    // the faces. Figures and rings reach a factor of 1.2 at most. Larger: more meshes with long faces are divided.
    double most_moved = 1.5;
    // No round surface goes through the vertices if the division moves places between the vertices by more than this
    // factor times the bulge of the faces. The factor is 1.8 for a ball of 156 faces, and 2.7 at most for figures.
    double most_raised = 3.0;
    // If all faces are flat, edges that bend by more than this many degrees are sharp. Larger: fewer edges are sharp.
    double flat_bend = 5.0;

    // ---- Parts

    // Far parts are dropped only if all of them together have at most this share of the area. Larger: more parts are
    // dropped.
    double lost_area = 0.001;
    // A part is dropped only if it is farther from all other parts than (this - 1) times their size. Larger: fewer
    // parts are dropped.
    double lost_distance = 4.0;
    // Parts with at most this many faces, and at most this share of the total area, are too small for a separate
    // surface. Larger: more faces are removed where three meet in an edge.
    std::int64_t flap_faces = 2;
    double flap_area = 2e-4;
    // Meshes with more faces are one group. The first limit holds for meshes of one component (connected by vertices),
    // the second for all others. Larger: more meshes are grouped, in more time.
    std::int64_t most_faces_of_one = 100'000;
    std::int64_t most_faces = 300'000;

    // ---- How near the surface is to come

    // No place may be farther off than this many tolerances, unless the caller gives another limit. Larger: fewer
    // centres in details.
    double far = 5.0;

    // ---- Where the surface ends

    // The lower and upper bounds of EndPlan::off, in diagonals. Larger: more of the surface beyond a mesh stays.
    double least_off = 0.009;
    double most_off = 0.015;
    // The lower bound of EndPlan::off where the fit is exact, in diagonals. Larger: narrow strips end later.
    double least_off_exact = 0.001;
    // A fit is exact if it is at most this far from the mesh, in diagonals, as fits of planes are.
    double exact = 2e-4;
    // The lower bound as a share of a strip's width. It leaves room for a row of places on either side of the strip and
    // a gap between the rows.
    double of_width = 0.2;
    // The lower bound in mean distances of the places. Larger: the surface ends farther beyond the last places.
    double of_places = 1.5;
    // Between the bounds, EndPlan::off is this factor times the 99th percentile of the mesh's distances from the
    // surface, which is large where faces are coarse. For a fit to samples it is this factor times their spacing,
    // because the fit rounds edges off by that much.
    double of_coarse_faces = 1.5;
    // The end of a mesh is found from this many places. Larger: the end is more exact, and takes longer to find.
    std::int64_t places = 40000;
};
inline constexpr PlanTuning plan_tuning;

} // namespace hrbfnpr::mesh
