// SPDX-License-Identifier: MIT
// The tuning constants of making a mesh usable, and of placing samples on it. A diagonal is that of the mesh's bounds.
// Set on the meshes of tests/mesh and on files of scanners and CAD programs.
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

} // namespace hrbfnpr::mesh
