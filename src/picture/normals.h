// SPDX-License-Identifier: MIT
// Finds which way the normals of samples point: outward, inward, or mixed.
#pragma once

#include "picture/call.h"

namespace hrbfnpr::picture {

struct NormalsLook {
    // The median, over the samples, of the sum of the winding numbers on both sides of a sample. It is 1 on a closed
    // surface with outward normals, -1 with inward ones, and about 0 on an open sheet or with mixed normals.
    double closed = 0.0;
    double against = 0.0; // the share of normals that are opposite to nearly all of their neighbours
    // The share of flipped normals. It is estimated from the share of opposite pairs of neighbours, as if flips were
    // random.
    double flipped = 0.0;
    double outside_in = 0.0; // The share of negative sums of winding numbers, among the sums that differ enough from 0.

    // Returns whether all normals of a closed surface, which may have holes, point inward.
    [[nodiscard]] bool inward() const noexcept;
    // Returns whether some normals are opposite to those of their neighbours, or some parts point inward and others
    // outward.
    [[nodiscard]] bool mixed() const noexcept;
};

// Examines winding numbers and neighbours. `even` means that all samples represent the same area. Each point has one
// unit normal.
[[nodiscard]] NormalsLook look_at_normals(const Points& points, const Points& normals, bool even, Pool& pool);

// Describes a NormalsLook in words.
[[nodiscard]] String normals_in_words(const NormalsLook& look, Pool& pool);
// Warns if normals that were not turned look wrong. `of_mesh` means that they are the normals of faces. If
// `advice_apart` is set, the remedy becomes the note's advice, else it follows the note's text.
void tell_wrong_normals(const Call& call, const NormalsLook& look, std::size_t count, bool of_mesh,
                        bool advice_apart = false);

// Returns whether the points lie along curves, where neighbours tell nothing about normals. Points must be finite. For
// too many points it returns false without a test.
[[nodiscard]] bool lie_along_curves(const Points& points, Pool& pool);

// Counts positions where several samples have different normals.
struct SharedPlaces {
    std::int64_t joined = 0;   // Positions where one sample remains, with the mean normal.
    std::int64_t left_out = 0; // Positions where no sample remains, because the normals are opposite.
};
// If several samples with different normals share a position, such as a vertex on a sharp edge, leaves at most one
// sample there. The points must be finite.
SharedPlaces merge_shared_places(Points& points, Points& normals, Pool& pool);

// The directions and positions from which open surfaces were seen, if they are known.
struct ViewingHints {
    std::optional<glm::dvec3> up;
    std::optional<glm::dvec3> viewpoint;
};

// Outward normals that the library made.
struct MadeNormals {
    Points normals;
    hrbfnpr_orient_info info;
};
// The detail of a warning that advises the user to turn faces: how two common programs do so.
constexpr const char* how_to_turn_faces =
    "MeshLab: Filters, Re-Orient all faces coherently. Blender: Mesh, Normals, Recalculate Outside.";
// Makes or repairs normals. `mode`, a constant HRBFNPR_NORMALS_*, describes the given normals. For NONE, `normals` is
// empty.
[[nodiscard]] MadeNormals make_normals(const Call& call, Stage& stage, const Points& points, const Points& normals,
                                       std::uint32_t mode, const ViewingHints& seen);
// Returns words for a constant HRBFNPR_NORMALS_* of an hrbfnpr_orient_info. They complete the sentence "the normals
// are".
[[nodiscard]] const char* found_in_words(std::uint32_t found) noexcept;
// Describes in words how make_normals() changed the normals. `count` is the number of points.
[[nodiscard]] String made_in_words(const hrbfnpr_orient_info& info, std::size_t count, Pool& pool);
// Warns if the library is not sure of the normals or of their outward side.
void tell_unsure_normals(const Call& call, const hrbfnpr_orient_info& info);

// Turns the normals of points outward if the outside can be found, and describes the changes in words. `mode` is a
// constant HRBFNPR_NORMALS_*; GIVEN keeps the normals.
[[nodiscard]] String settle_normals(const Call& call, Stage& stage, const Points& points, Points& normals,
                                    std::uint32_t mode, const ViewingHints& seen);
// Like settle_normals(), but always replaces the given normals by normals of the library.
[[nodiscard]] String repaired_normals(const Call& call, Stage& stage, const Points& points, Points& normals,
                                      std::uint32_t mode, const ViewingHints& seen);

} // namespace hrbfnpr::picture
