// SPDX-License-Identifier: MIT
// Which way the normals of samples look: outward, inward, or some this way and some that.
#pragma once

#include "picture/call.h"

namespace hrbfnpr::picture {

struct NormalsLook {
    // The sum of the winding numbers on both sides of the samples, in the middle: 1 on a closed surface with outward
    // normals, -1 with inward ones, about 0 on an open sheet or with mixed ones.
    double closed = 0.0;
    double against = 0.0;    // share of normals that look against nearly all around them
    double flipped = 0.0;    // share that makes as many neighbours differ if it is flipped at random
    double outside_in = 0.0; // share of samples where the sum is negative, of those where it tells anything

    // Whether all of them look inward, of a surface that is closed but for holes.
    [[nodiscard]] bool inward() const noexcept;
    // Whether some look against their neighbours, or one part against another.
    [[nodiscard]] bool mixed() const noexcept;
};

// Looks at winding numbers and neighbours. even: each sample stands for the same area. Normals are unit, and as many
// as the points.
[[nodiscard]] NormalsLook look_at_normals(const Points& points, const Points& normals, bool even, Pool& pool);

// What a look has found, in words.
[[nodiscard]] String normals_in_words(const NormalsLook& look, Pool& pool);
// Warns if normals that were not turned look wrong. of_mesh: they are those of faces. advice_apart: what to do is the
// note's advice, else it ends the note's text.
void tell_wrong_normals(const Call& call, const NormalsLook& look, std::size_t count, bool of_mesh,
                        bool advice_apart = false);

// Whether finite points lie along curves, where neighbours tell nothing of normals. It is not asked for very many.
[[nodiscard]] bool lie_along_curves(const Points& points, Pool& pool);

// Places with several samples whose normals differ.
struct SharedPlaces {
    std::int64_t joined = 0;   // one sample is left, with the mean normal
    std::int64_t left_out = 0; // the normals are opposite, and no sample is left
};
// Leaves at most one sample at each place whose normals differ, such as the vertices on a sharp edge of a mesh.
// Points are finite.
SharedPlaces agreed(Points& points, Points& normals, Pool& pool);

// What is known of where open surfaces were seen from.
struct SeenFrom {
    std::optional<glm::dvec3> up;
    std::optional<glm::dvec3> viewpoint;
};

// Outward normals by the library.
struct MadeNormals {
    Points normals;
    hrbfnpr_orient_info info;
};
// Makes or repairs them. mode: HRBFNPR_NORMALS_... of what is known of the given ones. normals: empty with NONE.
[[nodiscard]] MadeNormals make_normals(const Call& call, Stage& stage, const Points& points, const Points& normals,
                                       std::uint32_t mode, const SeenFrom& seen);
// What given normals are, by HRBFNPR_NORMALS_... of an orient_info: "the normals are ...".
[[nodiscard]] const char* found_in_words(std::uint32_t found) noexcept;
// What make_normals() has done with this many points, in words.
[[nodiscard]] String made_in_words(const hrbfnpr_orient_info& info, std::size_t count, Pool& pool);
// Warns if it is not sure of them, or of their side.
void tell_unsure_normals(const Call& call, const hrbfnpr_orient_info& info);

// Turns the normals of points outward, as far as that can be told, and returns what was done in words.
// mode: HRBFNPR_NORMALS_..., GIVEN keeps them.
[[nodiscard]] String settle_normals(const Call& call, Stage& stage, const Points& points, Points& normals,
                                    std::uint32_t mode, const SeenFrom& seen);
// The same by the library, whatever they look like.
[[nodiscard]] String repaired_normals(const Call& call, Stage& stage, const Points& points, Points& normals,
                                      std::uint32_t mode, const SeenFrom& seen);

} // namespace hrbfnpr::picture
