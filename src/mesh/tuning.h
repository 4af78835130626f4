// SPDX-License-Identifier: MIT
// The tuning constants of making a mesh usable, of placing samples on it, and of what plan.cpp decides. A diagonal is
// that of the mesh's bounds. Set on the meshes of tests/mesh and on files of scanners and CAD programs.
#pragma once

#include <cstdint>

namespace hrbfnpr::mesh {

struct MeshTuning {
    // Loops over faces, vertices and samples look for a cancel after this many. Larger: a cancel is seen later.
    std::int64_t at_once = 4096;

    // ---- Vertices and faces

    // Vertices of borders that are this near to each other are one, in diagonals. Larger: narrow slits are closed.
    double border_rounding = 1e-6;
    // Coordinates are exact to this share of the largest one, as files in single precision have them. Larger: more
    // faces are slivers.
    double coordinate_rounding = 0x1p-22;
    // The angle of a face about an edge is at least this exact, in radians. Larger: more faces lie on each other.
    double most_angle_rounding = 0.01;
    // A face is a sliver if it is at most this high, in longest sides, and no higher than the rounding. Larger: small
    // faces are taken for slivers.
    double flattest = 1e-3;
    // Slivers may lie beside others. After this many rounds those that are left stay. Larger: longer rows are split.
    int most_sliver_rounds = 32;

    // ---- Orientation

    // An open component has an inside if its holes have less than this share of its area. Larger: bowls are turned.
    double small_holes = 0.25;
    // At this many faces of a component rays tell whether it lies inside another. Larger: slower, and fewer parts that
    // stick out by a little are left out.
    std::int64_t tested_faces = 64;
    // At a vertex with more corners than this, about this many count for its normals. Larger: slower on fans.
    std::int64_t most_corners = 256;
    // A place of a face is on its side if the corner across has at most this share. Larger: more is on the border.
    double on_side = 1e-9;

    // ---- Samples that end at the border, in lengths of end_samples()'s `closest`

    // The row of places along a border is this far inside, so that s is 1.5 on the border: measured. Larger: the
    // surface ends short of the border.
    double row_inset = 0.943;
    // Places of the row are this far apart. Larger: the end is less straight.
    double row_step = 0.15;
    // Borders that are shorter than this many circumferences of a circle of that radius are holes that stay closed.
    double shortest_border = 1.5;
    // Places of the row are at least this many insets from the border. Larger: sharp corners have none.
    double least_inset = 0.9;
    // The row replaces even samples that are within this many insets from the border. Larger: a gap beside the row.
    double replaced = 1.7;
    // A place of the border has a row if a place of the row is within this many insets.
    double covered = 2.0;
    // Even samples are chosen from this many candidates each. Larger: slower, more even.
    std::int64_t candidates_each = 4;
};
inline constexpr MeshTuning mesh_tuning;

// What plan.cpp decides, in its order. Set by scripts/bench edges, on figures, machine parts and balls of 80 to 300 000
// faces, and by pictures of open and closed files.
struct PlanTuning {
    // ---- Edges that stand out. Set on the models of scripts/bench edges --only=verdict.

    // The least share of the edges beyond the angle that stands out on a shape with edges, by length. Larger: more
    // meshes are smooth.
    double enough_standing = 0.5;
    // The least share of edges between faces that are far off, of a shape whose faces are all meant to be flat, by
    // length. Larger: fewer rocks have edges.
    double enough_coarse = 0.25;
    // The least length of the edges beyond the angle, in diagonals. Larger: shapes with a short edge are smooth.
    double shortest_edges = 0.05;
    // The least share of the area that is of components with creases, if the whole has. It keeps crumbs of a scan from
    // giving it edges. Larger: smooth figures on blocks need larger blocks.
    double enough_area = 0.1;
    // A share of `far`: faces that are farther than this from a round surface stay flat. Larger: fewer faces stay flat.
    double too_coarse = 0.8;
    // A polyhedron of coarse faces has edges from this share of the crease angle on, if its faces are that coarse
    // there. Larger: fewer of its edges are sharp.
    double flat_faces = 0.05;

    // ---- Coarse faces

    // The normals of a file say nothing if fewer edges bend.
    std::int64_t fewest_of_file = 8;
    // All edges are sharp by the normals of a file if at least this share is, and none is if at most 1 minus this share
    // is. Larger: more files have some sharp edges.
    double nearly_all = 0.98;
    // Meshes with at most this many faces may be divided. Larger: finer meshes are examined, in more time.
    std::int64_t most_coarse = 50'000;
    // A mesh whose mean edge is shorter than this, in diagonals, bends by noise and is not divided. Larger: fewer
    // meshes are divided.
    double coarse_edge = 0.025;
    // The limit of subdivision rounds. Each more: four times as many faces.
    std::int32_t most_rounds = 3;
    // No round surface goes through the vertices if they move by more than this factor times the bulge of the faces.
    // The factor of figures and rings is 1.2 at most. Larger: more meshes with long faces are divided.
    double most_moved = 1.5;
    // The same factor for places between the vertices: it is 1.8 for a ball of 156 faces, and 2.7 at most for figures.
    double most_raised = 3.0;
    // Faces that bend by this many degrees are meant to be flat, and their edges are sharp. Larger: fewer edges are
    // sharp.
    double flat_bend = 5.0;

    // ---- Parts

    // All lost parts together have at most this share of the area. Larger: more parts are lost.
    double lost_area = 0.001;
    // Parts are lost beyond a distance of (this - 1) times the size of all other parts. Larger: fewer parts are lost.
    double lost_distance = 4.0;
    // Parts with at most this many faces, and this share of the total area, are too small for a surface of their own.
    // Larger: more faces are removed where three meet in an edge.
    std::int64_t flap_faces = 2;
    double flap_area = 2e-4;
    // Meshes with more faces are one group; the first limit is for parts connected by vertices. Larger: more meshes are
    // grouped, in more time.
    std::int64_t most_faces_of_one = 100'000;
    std::int64_t most_faces = 300'000;

    // ---- How near the surface is to come

    // No place is farther off than this many tolerances. Larger: fewer centres in details.
    double far = 5.0;

    // ---- Where the surface ends

    // The lower and upper bounds of EndPlan::off, in diagonals. Larger: more of the surface beyond a mesh stays.
    double least_off = 0.009;
    double most_off = 0.015;
    // The lower bound of EndPlan::off where the fit is exact, in diagonals. Larger: narrow strips end later.
    double least_off_exact = 0.001;
    // A fit is exact if it is at most this far from the mesh, in diagonals, as fits of planes are.
    double exact = 2e-4;
    // The lower bound as a share of a strip's width. It leaves room for a row of places on either side and a gap
    // between.
    double of_width = 0.2;
    // The lower bound in mean distances of the places. Larger: the surface ends farther beyond the last places.
    double of_places = 1.5;
    // Between the bounds, EndPlan::off is this factor times the 99th percentile of the mesh's distances from the
    // surface, which is large all over coarse faces, or times the spacing of samples, by which they round edges off.
    double of_coarse_faces = 1.5;
    // This many places show where a mesh ends. Larger: the end is more exact, and takes longer to find.
    std::int64_t places = 40000;
};
inline constexpr PlanTuning plan_tuning;

} // namespace hrbfnpr::mesh
