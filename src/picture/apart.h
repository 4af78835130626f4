// SPDX-License-Identifier: MIT
// Parts of a mesh that are not fitted with the others: parts that cross, parts that are lost, and faces left over.
//
// One function is 0 on all parts of a mesh.  Beyond its border each part goes on, and where another part is near nobody
// can say whose surface that is.  So the parts of an open mesh that cross or lie close to each other become groups,
// each a surface of its own.  Closed parts have an inside, and the library joins them as solids.
#pragma once

#include "picture/faces.h"

#include <optional>

namespace hrbfnpr::picture {

using FaceNumbers = Vector<std::int64_t>; // ascending

struct FaceGroups {
    Vector<FaceNumbers> groups; // the one of the largest area first
    std::int64_t parts = 0;     // in all of them
};

// Groups the faces of an open mesh so that no part of a group is near another; nothing if one group will do.
[[nodiscard]] std::optional<FaceGroups> find_groups(const Mesh& mesh, Pool& pool);

// Finds a few faces on an edge of two others, which modelling left over there.
[[nodiscard]] FaceNumbers find_flaps(const Mesh& mesh, Pool& pool);

struct LostParts {
    FaceNumbers faces;
    std::int64_t parts = 0;
};

// Finds the parts of next to no area without which the mesh is much smaller.
[[nodiscard]] LostParts find_lost_parts(const Mesh& mesh, Pool& pool);

} // namespace hrbfnpr::picture
