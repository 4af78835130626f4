// SPDX-License-Identifier: MIT
// Finds parts of a mesh that are not fitted together with the rest: crossing parts, "lost parts" (tiny and far away),
// and flaps (small parts that are attached to a larger part along an edge).
//
// One implicit function is fitted to a mesh, and its surface continues past the border of each open part. Where two
// parts are near each other, one function cannot separate their continuations. So parts of an open mesh that cross, or
// are near each other, are put into different groups, and each group gets a separate surface. Closed parts need no
// groups, because the library joins them as solids.
#pragma once

#include "picture/faces.h"

#include <optional>

namespace hrbfnpr::picture {

using FaceNumbers = Vector<std::int64_t>; // face indices in ascending order

struct FaceGroups {
    Vector<FaceNumbers> groups; // The faces of each group. The group with the largest area comes first.
    std::int64_t parts = 0;     // The number of parts in all groups.
};

// Groups the faces of an open mesh so that no two parts of a group are near each other. Returns nullopt if one group is
// enough.
[[nodiscard]] std::optional<FaceGroups> find_groups(const Mesh& mesh, Pool& pool);

// Finds flaps: small parts that touch a larger part only along an edge. Modelling programs sometimes leave them.
[[nodiscard]] FaceNumbers find_flaps(const Mesh& mesh, Pool& pool);

struct LostParts {
    FaceNumbers faces;
    std::int64_t parts = 0;
};

// Finds lost parts: tiny parts that are far from the rest and make the bounds of the mesh much larger.
[[nodiscard]] LostParts find_lost_parts(const Mesh& mesh, Pool& pool);

} // namespace hrbfnpr::picture
