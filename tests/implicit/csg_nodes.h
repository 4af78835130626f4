// SPDX-License-Identifier: MIT
// Nodes of trees of solids, and points at which to evaluate them.
#pragma once

#include "fields.h"

#include "support/csg_reference.h"

namespace test {

inline Points scattered(int count, double reach) {
    Points points;
    for (int i = 0; i < count; ++i)
        points.add({reach * scatter(3 * i), reach * scatter(3 * i + 1), reach * scatter(3 * i + 2)});
    return points;
}

inline CsgNode node(hrbfnpr::implicit::CsgKind kind, std::int64_t parent = -1) {
    CsgNode made;
    made.kind = kind;
    made.parent = parent;
    return made;
}

} // namespace test
