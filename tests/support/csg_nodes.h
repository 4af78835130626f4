// SPDX-License-Identifier: MIT
// CSG trees in the caller's form.
#pragma once

#include "support/handles.h"

#include <cstdint>
#include <vector>

namespace hrbfnpr::test {

// A list of nodes, each after its parent.
struct CsgNodes {
    std::vector<hrbfnpr_csg_node> nodes;

    hrbfnpr_csg_node& add(std::uint32_t kind, std::int64_t parent = -1) {
        hrbfnpr_csg_node node;
        hrbfnpr_csg_node_init(&node, sizeof node);
        node.kind = kind;
        node.parent = parent;
        nodes.push_back(node);
        return nodes.back();
    }
    hrbfnpr_csg_node& add(std::uint32_t kind, std::int64_t parent, double x, double y, double z) {
        hrbfnpr_csg_node& node = add(kind, parent);
        node.transform[12] = x;
        node.transform[13] = y;
        node.transform[14] = z;
        return node;
    }
    [[nodiscard]] hrbfnpr_csg_desc desc() const {
        hrbfnpr_csg_desc desc;
        hrbfnpr_csg_desc_init(&desc, sizeof desc);
        desc.nodes = nodes.data();
        desc.node_count = static_cast<std::int64_t>(nodes.size());
        return desc;
    }
};

// A block with a bore and a slot, a boss that is blended to the block, and a hole through the boss.
inline CsgNodes csg_part() {
    CsgNodes part;
    part.add(HRBFNPR_CSG_DIFFERENCE);
    part.add(HRBFNPR_CSG_UNION, 0).blend = 0.3;
    hrbfnpr_csg_node& block = part.add(HRBFNPR_CSG_BOX, 1);
    block.size[0] = 3.0;
    block.size[1] = 2.0;
    hrbfnpr_csg_node& boss = part.add(HRBFNPR_CSG_CYLINDER, 1, 0.7, 0.0, 0.7);
    boss.radius = 0.6;
    hrbfnpr_csg_node& bore = part.add(HRBFNPR_CSG_CYLINDER, 0, 0.7, 0.0, 0.0);
    bore.radius = 0.3;
    bore.height = 4.0;
    hrbfnpr_csg_node& slot = part.add(HRBFNPR_CSG_BOX, 0, -0.9, 0.0, 0.4);
    slot.size[0] = 0.5;
    slot.size[1] = 3.0;
    return part;
}

} // namespace hrbfnpr::test
