// SPDX-License-Identifier: MIT
#include "implicit/pieces_data.h"

namespace hrbfnpr::implicit {
namespace {

// A program leaves one value, and takes no more off the stack than is there.
[[nodiscard]] bool is_program(const std::int32_t* begin, const std::int32_t* end, std::int64_t sheets) noexcept {
    std::int32_t depth = 0;
    std::int32_t operands = 0;
    for (const std::int32_t* at = begin; at != end; ++at) {
        const bool operand = *at >= 0;
        if (operand ? *at >= sheets : *at < PiecesData::smaller) return false;
        operands += operand ? 1 : 0;
        depth += operand ? 1 : -1;
        if (depth < 1) return false;
    }
    return begin == end || (depth == 1 && operands <= PiecesData::most_operands);
}

// Every node but the root is the child of one before it, and every leaf is one node's.
[[nodiscard]] bool is_octree(const PiecesData& data) noexcept {
    const std::int64_t nodes = data.child.size();
    if (nodes < 1 || nodes > PiecesData::most_nodes) return false;
    std::int64_t next_child = 1;
    std::int64_t next_leaf = 0;
    for (std::int64_t node = 0; node < nodes; ++node) {
        const std::int32_t child = data.child[node];
        if (child >= 0) {
            if (child != next_child) return false;
            next_child += 8;
        } else if (-1 - std::int64_t{child} != next_leaf++) {
            return false;
        }
    }
    return next_child == nodes && next_leaf == data.leaves();
}

// Children follow their parents, level by level.
[[nodiscard]] bool is_shallow(const PiecesData& data) noexcept {
    std::int64_t begin = 0;
    std::int64_t end = 1;
    for (std::int32_t level = 0; level < PiecesData::most_levels; ++level) {
        std::int64_t inner = 0;
        for (std::int64_t node = begin; node < end; ++node) inner += data.child[node] >= 0 ? 1 : 0;
        if (inner == 0) return true;
        begin = end;
        end += 8 * inner;
    }
    return false;
}

} // namespace

std::int64_t PiecesData::bytes() const noexcept {
    std::int64_t sum = sheet.bytes() + child.bytes() + program_begin.bytes() + program.bytes() + plain.bytes() +
                       sample_position.bytes() + sample_normal.bytes();
    for (const HrbfData& one : sheet) sum += one.bytes();
    return sum;
}

std::int64_t PiecesData::centres() const noexcept {
    std::int64_t sum = 0;
    for (const HrbfData& one : sheet) sum += one.count();
    return sum;
}

std::int32_t PiecesData::leaf_at(const glm::dvec3& place) const noexcept {
    glm::dvec3 low = corner;
    double width = side;
    std::int64_t node = 0;
    while (child[node] >= 0) {
        width *= 0.5;
        std::int64_t octant = 0;
        for (glm::length_t axis = 0; axis < 3; ++axis)
            if (place[axis] >= low[axis] + width) {
                low[axis] += width;
                octant |= std::int64_t{1} << axis;
            }
        node = child[node] + octant;
    }
    return -1 - child[node];
}

bool is_sound(const PiecesData& data) noexcept {
    const std::int64_t leaves = data.leaves();
    if (data.sheet.empty() || leaves < 1 || data.plain.size() != 4 * leaves) return false;
    if (data.program_begin[0] != 0 || data.program_begin[leaves] != data.program.size()) return false;
    for (std::int64_t leaf = 0; leaf < leaves; ++leaf)
        if (data.program_begin[leaf] > data.program_begin[leaf + 1]) return false;
    for (std::int64_t leaf = 0; leaf < leaves; ++leaf)
        if (!is_program(data.program.data() + data.program_begin[leaf],
                        data.program.data() + data.program_begin[leaf + 1], data.sheet.size()))
            return false;
    return is_octree(data) && is_shallow(data);
}

} // namespace hrbfnpr::implicit
