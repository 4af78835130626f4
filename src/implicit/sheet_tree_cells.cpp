// SPDX-License-Identifier: MIT
// Zones are made leaf by leaf on all threads, in three steps: 1. find the cells that reach the leaf, and their sheets;
// 2. evaluate these sheets at the corners and the middles of the leaf's zones; 3. for each zone, find the cells that
// reach it, and remove from their programs the sheets that cannot be the largest or smallest.
#include "implicit/sheet_tree_cells.h"

#include "base/assert.h"
#include "implicit/tuning.h"

#include <cmath>

namespace hrbfnpr::implicit {
namespace {

// Returns whether a program leaves exactly one value on the stack, and never takes more values than the stack has.
[[nodiscard]] bool is_program(std::span<const std::int32_t> program, std::int64_t sheets) noexcept {
    std::int32_t depth = 0;
    std::int32_t operands = 0;
    for (const std::int32_t code : program) {
        const bool operand = code >= 0;
        if (operand ? code >= sheets : code < SheetTreeData::minimum) return false;
        operands += operand ? 1 : 0;
        depth += operand ? 1 : -1;
        if (depth < 1) return false;
    }
    return program.empty() || (depth == 1 && operands <= SheetTreeData::most_operands);
}

// Returns whether the tree is valid: children come after their parents, level by level; each node except the root is
// the child of one earlier node; and each leaf belongs to one node.
[[nodiscard]] bool is_octree(const SheetTreeData& data) noexcept {
    const std::int64_t nodes = data.child.size();
    if (nodes < 1 || nodes > SheetTreeData::most_nodes) return false;
    std::int64_t next_child = 1;
    std::int64_t next_leaf = 0;
    std::int32_t level = 0;
    for (std::int64_t node = 0, level_end = 1; node < nodes; ++node) {
        if (node == level_end) {
            ++level;
            level_end = next_child;
        }
        const std::int32_t child = data.child[node];
        if (child < 0 ? -1 - std::int64_t{child} != next_leaf++ : child != next_child) return false;
        if (child >= 0) next_child += 8;
    }
    return next_child == nodes && next_leaf == data.leaves() && level < SheetTreeData::most_levels;
}

// The number of places in a zone where programs are evaluated: eight corners and the middle.
constexpr std::size_t zone_places = 9;

// A program without the operands that cannot affect the result in a zone, and the program's values at the zone's
// places.
struct SimplifiedProgram {
    std::array<double, zone_places> value{};
    std::array<std::int32_t, std::size_t{2 * SheetTreeData::most_operands}> code{};
    std::size_t size = 0;
};

// Joins two operands by an operation. It omits an operand if the other one wins at all places of the zone by more than
// zone_tuning.margin times the range of their difference.
void join(SimplifiedProgram& a, const SimplifiedProgram& b, std::int32_t operation) noexcept {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (std::size_t i = 0; i < zone_places; ++i) {
        const double difference =
            operation == SheetTreeData::maximum ? b.value[i] - a.value[i] : a.value[i] - b.value[i];
        least = std::min(least, difference);
        most = std::max(most, difference);
    }
    const double enough = zone_tuning.margin * (most - least);
    if (most < -enough) return;
    if (least > enough) {
        a = b;
        return;
    }
    for (std::size_t i = 0; i < zone_places; ++i)
        a.value[i] =
            operation == SheetTreeData::maximum ? std::max(a.value[i], b.value[i]) : std::min(a.value[i], b.value[i]);
    HRBFNPR_ASSERT(a.size + b.size < a.code.size());
    std::copy_n(b.code.begin(), b.size, a.code.begin() + static_cast<std::ptrdiff_t>(a.size));
    a.size += b.size;
    a.code[a.size++] = operation;
}

// Calls visit(cell, level, leaf) for each leaf. A cell for which enters(cell) is false is skipped with all leaves below
// it.
template <class Enters, class Visit>
void for_leaves(const SheetTreeData& data, const SheetTreeNode& at, std::int8_t level, Enters&& enters, Visit&& visit) {
    const std::int32_t first = data.child[at.node];
    if (first < 0) return visit(at, level, -1 - first);
    for (std::int32_t k = 7; k >= 0; --k)
        if (const SheetTreeNode next = at.child(first, k); enters(next))
            for_leaves(data, next, static_cast<std::int8_t>(level + 1), enters, visit);
}

// Returns whether the weight of a cell is above 0 somewhere in the cube.
[[nodiscard]] bool reaches(const SheetTreeNode& cell, const SheetTreeNode& cube) noexcept {
    const glm::dvec3 off = glm::abs(cell.centre - cube.centre);
    return std::max({off.x, off.y, off.z}) <
           SheetTreeData::cell_reach * cell.half + (1.0 + zone_tuning.rounding) * cube.half;
}

template <class T>
[[nodiscard]] std::span<const T> range(const base::Array<T>& array, std::int64_t begin, std::int64_t end) noexcept {
    HRBFNPR_ASSERT(begin >= 0 && begin <= end && end <= array.size());
    return {array.data() + begin, array.data() + end};
}

[[nodiscard]] bool equal(std::span<const std::int32_t> a, std::span<const std::int32_t> b) noexcept {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

// The cells that reach a leaf, their sheets, and the values of these sheets at the corners and then at the middles of
// the leaf's zones.
struct LeafSurroundings {
    explicit LeafSurroundings(base::Memory& memory) noexcept : leaf(memory), sheet(memory), value(memory) {}
    base::Array<std::int32_t> leaf;
    base::Array<std::int32_t> sheet;
    base::Array<double> value; // sorted by sheet
    std::int64_t places = 0;
    bool trees = false; // true if some programs have operations

    [[nodiscard]] std::int64_t number_of(std::int32_t code) const noexcept {
        return std::find(sheet.begin(), sheet.end(), code) - sheet.begin();
    }
};

[[nodiscard]] LeafSurroundings find_surroundings(const SheetTreeData& data, const SheetTreeNode& at,
                                                 base::Memory& memory) {
    LeafSurroundings surroundings(memory);
    for_leaves(
        data, root_of(data), 0, [&](const SheetTreeNode& other) { return reaches(other, at); },
        [&](const SheetTreeNode&, std::int8_t, std::int32_t leaf) {
            const std::span<const std::int32_t> program = data.program_of(leaf);
            surroundings.leaf.push_back(leaf);
            surroundings.trees = surroundings.trees || program.size() > 1;
            for (const std::int32_t code : program)
                if (code >= 0 && surroundings.number_of(code) == surroundings.sheet.size())
                    surroundings.sheet.push_back(code);
        });
    return surroundings;
}

// Appends a simplified program, without the operands that cannot affect the result in the zone with these places.
void simplify(std::span<const std::int32_t> program, const std::array<std::int64_t, zone_places>& at,
              const LeafSurroundings& surroundings, base::Array<std::int32_t>& to) {
    if (program.size() < 2) {
        for (const std::int32_t code : program) to.push_back(code);
        return;
    }
    std::array<SimplifiedProgram, SheetTreeData::most_operands + 1> stack;
    std::size_t depth = 0;
    for (const std::int32_t code : program) {
        if (code < 0) {
            HRBFNPR_ASSERT(depth >= 2);
            --depth;
            join(stack[depth - 1], stack[depth], code);
            continue;
        }
        SimplifiedProgram& top = stack[depth++];
        const std::int64_t column = surroundings.places * surroundings.number_of(code);
        HRBFNPR_ASSERT(column + surroundings.places <= surroundings.value.size());
        for (std::size_t i = 0; i < zone_places; ++i) top.value[i] = surroundings.value[column + at[i]];
        top.code[0] = code;
        top.size = 1;
    }
    for (std::size_t i = 0; i < stack[0].size; ++i) to.push_back(stack[0].code[i]);
}

// The zones of one leaf. Indices of parts and programs start at 0 for each leaf.
struct LeafZones {
    explicit LeafZones(base::Memory& memory) noexcept : code(memory), zone(memory), part(memory), program(memory) {}
    std::int8_t cuts = -1;
    base::Array<std::int32_t> code;
    base::Array<SheetTreeZones::Zone> zone;
    base::Array<SheetTreeZones::Part> part;
    base::Array<std::int32_t> program;
};

// Adds a zone. Equal programs in the zone are stored once.
void add_zone(const SheetTreeData& data, const base::Array<SheetTreeNode>& nodes, const SheetTreeNode& at,
              const std::array<std::int64_t, zone_places>& its, const LeafSurroundings& surroundings, LeafZones& made) {
    using Part = SheetTreeZones::Part;
    const auto program = [&](const Part& part) { return range(made.program, part.begin, part.end); };
    const auto first = static_cast<std::int32_t>(made.part.size());
    for (const std::int32_t leaf : surroundings.leaf) {
        if (!reaches(nodes[leaf], at)) continue;
        Part part{leaf, static_cast<std::int32_t>(made.program.size()), 0};
        simplify(data.program_of(leaf), its, surroundings, made.program);
        part.end = static_cast<std::int32_t>(made.program.size());
        const Part* const known = std::find_if(made.part.begin() + first, made.part.end(),
                                               [&](const Part& other) { return equal(program(other), program(part)); });
        if (known != made.part.end()) {
            made.program.resize(part.begin);
            part = {leaf, known->begin, known->end};
        }
        made.part.push_back(part);
    }
    HRBFNPR_ASSERT(made.part.size() > first);
    const Part front = made.part[first];
    const bool alone =
        front.begin < front.end && std::all_of(made.part.begin() + first, made.part.end(),
                                               [&](const Part& part) { return part.begin == front.begin; });
    const bool one_sheet = alone && front.end - front.begin == 1;
    if (alone) made.part.resize(one_sheet ? first : first + 1);
    made.code.push_back(one_sheet ? -1 - made.program[front.begin] : static_cast<std::int32_t>(made.zone.size()));
    if (!one_sheet) made.zone.push_back({first, static_cast<std::int32_t>(made.part.size())});
}

[[nodiscard]] LeafZones zones_of(const base::Runtime& runtime, const SheetTreeData& data,
                                 const base::Array<SheetTreeNode>& nodes, std::int32_t leaf, int level) {
    LeafZones made(runtime.memory);
    const SheetTreeNode& at = nodes[leaf];
    const double farthest = glm::length(glm::abs(at.centre - data.bounds.centre()) + at.half);
    if (farthest > SheetTreeData::sphere_begins * 0.5 * data.bounds.diagonal()) return made;
    LeafSurroundings surroundings = find_surroundings(data, at, runtime.memory);
    if (surroundings.sheet.empty() || surroundings.leaf.size() > zone_tuning.parts) return made;
    made.cuts = static_cast<std::int8_t>(std::clamp(zone_tuning.level - level, 0, zone_tuning.cuts));
    const std::int64_t along = std::int64_t{1} << made.cuts;
    const double half = at.half / static_cast<double>(along);
    const glm::dvec3 low = at.centre - at.half;
    geometry::VecArray place(runtime.memory);
    for (const std::int64_t middle : {0, 1})
        for (std::int64_t z = 0; z <= along - middle; ++z)
            for (std::int64_t y = 0; y <= along - middle; ++y)
                for (std::int64_t x = 0; x <= along - middle; ++x)
                    place.push_back(low + half * static_cast<double>(middle) + 2.0 * half * glm::dvec3(x, y, z));
    surroundings.places = place.size();
    if (surroundings.trees) surroundings.value.resize_for_overwrite(surroundings.places * surroundings.sheet.size());
    for (std::int64_t s = 0; s < surroundings.value.size() / surroundings.places; ++s)
        implicit::evaluate(runtime.instruction_set, data.sheet[surroundings.sheet[s]],
                           {place.x.data(), place.y.data(), place.z.data(), place.size()},
                           {surroundings.value.data() + s * surroundings.places, {}, {}});
    const std::int64_t row = along + 1;
    for (std::int64_t i = 0; i < along * along * along; ++i) {
        const std::int64_t x = i % along;
        const std::int64_t y = i / along % along;
        const std::int64_t z = i / along / along;
        std::array<std::int64_t, zone_places> its{};
        for (std::int64_t k = 0; k < 8; ++k)
            its[static_cast<std::size_t>(k)] = x + k % 2 + row * (y + k / 2 % 2 + row * (z + k / 4));
        its[8] = row * row * row + i;
        add_zone(data, nodes, {0, low + half * (2.0 * glm::dvec3(x, y, z) + 1.0), half}, its, surroundings, made);
    }
    return made;
}

} // namespace

std::int64_t SheetTreeData::bytes() const noexcept {
    std::int64_t sum = sheet.bytes() + child.bytes() + program_begin.bytes() + program.bytes() + plain.bytes() +
                       sample_position.bytes() + sample_normal.bytes();
    for (const HrbfData& one : sheet) sum += one.bytes();
    return sum;
}

std::int64_t SheetTreeData::centres() const noexcept {
    std::int64_t sum = 0;
    for (const HrbfData& one : sheet) sum += one.count();
    return sum;
}

std::int32_t SheetTreeData::leaf_at(const glm::dvec3& place) const noexcept {
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

bool is_sound(const SheetTreeData& data) noexcept {
    const std::int64_t leaves = data.leaves();
    if (data.sheet.empty() || leaves < 1 || data.plain.size() != 4 * leaves) return false;
    if (data.program_begin[0] != 0 || data.program_begin[leaves] != data.program.size()) return false;
    if (!std::is_sorted(data.program_begin.begin(), data.program_begin.end())) return false;
    for (std::int32_t leaf = 0; leaf < leaves; ++leaf)
        if (!is_program(data.program_of(leaf), data.sheet.size())) return false;
    return is_octree(data);
}

SheetTreeZones::SheetTreeZones(const base::Work& work, const SheetTreeData& data)
    : data_(data), top_(work.memory), node_(work.memory), level_(work.memory), cuts_(work.memory), first_(work.memory),
      code_(work.memory), zone_(work.memory), part_(work.memory), program_(work.memory) {
    const std::int64_t leaves = data.leaves();
    node_.resize_for_overwrite(leaves);
    level_.resize_for_overwrite(leaves);
    for_leaves(
        data, root_of(data), 0, [](const SheetTreeNode&) { return true; },
        [&](const SheetTreeNode& at, std::int8_t level, std::int32_t leaf) {
            node_[leaf] = at;
            level_[leaf] = level;
        });
    constexpr std::uint32_t along = 1U << top_levels;
    constexpr int shift = digits - top_levels;
    for (std::uint32_t i = 0; i < along * along * along; ++i) {
        const Digits digit{i % along << shift, i / along % along << shift, i / along / along << shift};
        std::int32_t node = 0;
        for (int level = 0; level < top_levels && data.child[node] >= 0; ++level)
            node = data.child[node] + octant(digit, level);
        top_.push_back(data.child[node] < 0 ? data.child[node] : node);
    }
    base::List<LeafZones> made(work.memory);
    made.reserve(leaves);
    for (std::int64_t leaf = 0; leaf < leaves; ++leaf) made.add(work.memory);
    work.for_chunks(leaves, 16, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t leaf = begin; leaf < end; ++leaf)
            made[leaf] = zones_of(work, data, node_, static_cast<std::int32_t>(leaf), level_[leaf]);
    });
    for (const LeafZones& one : made) {
        const auto parts = static_cast<std::int32_t>(part_.size());
        const auto codes = static_cast<std::int32_t>(program_.size());
        const auto zones = static_cast<std::int32_t>(zone_.size());
        cuts_.push_back(one.cuts);
        first_.push_back(static_cast<std::int32_t>(code_.size()));
        for (const std::int32_t code : one.code) code_.push_back(code >= 0 ? zones + code : code);
        for (const Zone& zone : one.zone) zone_.push_back({zone.begin + parts, zone.end + parts});
        for (const Part& part : one.part) part_.push_back({part.leaf, part.begin + codes, part.end + codes});
        for (const std::int32_t code : one.program) program_.push_back(code);
    }
}

std::int32_t SheetTreeZones::code_at(const glm::dvec3& place) const noexcept {
    constexpr double width = 1U << digits;
    const glm::dvec3 t = (place - data_.corner) * (width / data_.side);
    Digits digit;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        if (!(t[axis] >= 0.0 && t[axis] < width)) return nowhere;
        digit[static_cast<std::size_t>(axis)] = static_cast<std::uint32_t>(t[axis]);
    }
    constexpr int top_shift = digits - top_levels;
    std::int32_t node = top_[std::int64_t{digit[0] >> top_shift |
                                          (digit[1] >> top_shift | digit[2] >> top_shift << top_levels) << top_levels}];
    std::int32_t child = node < 0 ? node : data_.child[node];
    for (int level = top_levels; child >= 0; child = data_.child[node]) node = child + octant(digit, level++);
    const std::int32_t leaf = -1 - child;
    const int cuts = cuts_[leaf];
    if (cuts < 0) return nowhere;
    const int shift = digits - level_[leaf] - cuts;
    const std::uint32_t last = (1U << cuts) - 1U;
    const std::uint32_t index =
        (digit[0] >> shift & last) | ((digit[1] >> shift & last) | (digit[2] >> shift & last) << cuts) << cuts;
    return code_[first_[leaf] + static_cast<std::int32_t>(index)];
}

SheetTreeZones::Candidates SheetTreeZones::candidates_at(const glm::dvec3& place) const noexcept {
    const std::int32_t code = code_at(place);
    if (code == nowhere) return {};
    if (code < 0) return {-1 - code, {}};
    const Zone& zone = zone_[code];
    const std::span<const Part> parts = range(part_, zone.begin, zone.end);
    if (parts.size() == 1) return {-1, parts};
    // Branches would be mispredicted here, because it is unpredictable which parts reach the place. So the loop has no
    // branches. `found` is the last part that reaches it. `mixed` is set if programs of these parts differ, or if one
    // has no program.
    const Part* found = nullptr;
    unsigned mixed = 0;
    for (const Part& part : parts) {
        const SheetTreeNode& node = node_[part.leaf];
        const glm::dvec3 off = glm::abs(place - node.centre);
        const double reach = SheetTreeData::cell_reach * node.half;
        const unsigned has = static_cast<unsigned>(off.x < reach) & static_cast<unsigned>(off.y < reach) &
                             static_cast<unsigned>(off.z < reach);
        const std::int32_t before = found != nullptr ? found->begin : part.begin;
        mixed |= has & (static_cast<unsigned>(part.begin == part.end) | static_cast<unsigned>(part.begin != before));
        found = has != 0 ? &part : found;
    }
    if (mixed != 0 || found == nullptr) return {-1, parts};
    if (found->end - found->begin == 1) return {program_[found->begin], {}};
    return {-1, {found, 1}};
}

std::int32_t SheetTreeZones::cell_of(const glm::dvec3& place) const noexcept {
    const std::int32_t code = code_at(place);
    if (code >= 0) return static_cast<std::int32_t>(data_.sheet.size()) + part_[zone_[code].begin].leaf;
    return code == nowhere ? static_cast<std::int32_t>(cells()) - 1 : -1 - code;
}

} // namespace hrbfnpr::implicit
