// SPDX-License-Identifier: MIT
#include "implicit/pieces_zones.h"

#include "base/list.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::implicit {
namespace {

// Zones are of the cubes of this level, or whole cells; a cell has 4 along each side at most.
constexpr int zone_level = 6;
constexpr int most_cuts = 2;
constexpr std::int64_t most_parts = 64;
constexpr std::size_t places = 9; // of a zone where programs are looked at: its corners and its middle
// A sheet is left out of a maximum or minimum if it is less than the other by so many times what their difference
// varies by between these places.
constexpr double zone_margin = 0.5;
constexpr double zone_rounding = 1e-6; // half sides
constexpr std::int64_t most_codes = 2 * PiecesData::most_operands;

using Values = std::array<double, places>;

struct Simple {
    Values value{};
    std::array<std::int32_t, most_codes> code{};
    std::int64_t size = 0;
};

void join(Simple& a, const Simple& b, std::int32_t operation) noexcept {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (std::size_t i = 0; i < places; ++i) {
        const double difference = operation == PiecesData::larger ? b.value[i] - a.value[i] : a.value[i] - b.value[i];
        least = std::min(least, difference);
        most = std::max(most, difference);
    }
    const double enough = zone_margin * (most - least);
    if (most < -enough) return;
    if (least > enough) {
        a = b;
        return;
    }
    for (std::size_t i = 0; i < places; ++i)
        a.value[i] =
            operation == PiecesData::larger ? std::max(a.value[i], b.value[i]) : std::min(a.value[i], b.value[i]);
    std::copy_n(b.code.begin(), b.size, a.code.begin() + a.size);
    a.size += b.size;
    a.code[static_cast<std::size_t>(a.size++)] = operation;
}

} // namespace

class PiecesZones::Builder {
public:
    Builder(const base::Runtime& runtime, PiecesZones& zones)
        : runtime_(runtime), zones_(zones),
          data_(zones.data_), root_{0, data_.corner + 0.5 * data_.side, 0.5 * data_.side} {}

    void run(const base::Progress& progress) {
        locate_leaves();
        fill_top();
        const std::int64_t leaves = data_.leaves();
        base::List<Made> made(runtime_.memory);
        made.reserve(leaves);
        for (std::int64_t leaf = 0; leaf < leaves; ++leaf) made.add(runtime_.memory);
        runtime_.parallel.for_chunks(leaves, 16, [&](std::int64_t begin, std::int64_t end) {
            progress.check();
            for (std::int64_t leaf = begin; leaf < end; ++leaf) make(static_cast<std::int32_t>(leaf), made[leaf]);
        });
        for (std::int64_t leaf = 0; leaf < leaves; ++leaf) keep(made[leaf]);
    }

private:
    // Of one leaf, numbered from 0.
    struct Made {
        explicit Made(base::Memory& memory) noexcept : code(memory), zone(memory), part(memory), program(memory) {}
        std::int8_t cuts = -1;
        base::Array<std::int32_t> code;
        base::Array<Zone> zone;
        base::Array<Part> part;
        base::Array<std::int32_t> program;
    };

    // Cells that have a say in one, their sheets, and these at the places of its zones: corners, then middles.
    struct Beside {
        explicit Beside(base::Memory& memory) noexcept : leaf(memory), sheet(memory), value(memory) {}
        base::Array<std::int32_t> leaf;
        base::Array<std::int32_t> sheet;
        base::Array<double> value;
        std::int64_t places = 0;
        bool plain = false; // some have no program
    };

    template <class Enters, class Visit>
    void for_leaves(Enters&& enters, Visit&& visit) const {
        struct Leveled {
            PiecesNode at;
            std::int8_t level;
        };
        Leveled stack[8 * PiecesData::most_levels];
        std::size_t depth = 0;
        stack[depth++] = {root_, 0};
        while (depth > 0) {
            const Leveled top = stack[--depth];
            const std::int32_t child = data_.child[top.at.node];
            if (child < 0) {
                visit(top.at, top.level, -1 - child);
                continue;
            }
            const double half = 0.5 * top.at.half;
            for (std::int32_t k = 0; k < 8; ++k) {
                const PiecesNode next{child + k, top.at.centre + PiecesData::child_offset(k, half), half};
                if (enters(next)) stack[depth++] = {next, static_cast<std::int8_t>(top.level + 1)};
            }
        }
    }

    void locate_leaves() {
        const std::int64_t leaves = data_.leaves();
        zones_.node_.resize_for_overwrite(leaves);
        zones_.level_.resize_for_overwrite(leaves);
        for_leaves([](const PiecesNode&) { return true; },
                   [&](const PiecesNode& at, std::int8_t level, std::int32_t leaf) {
                       zones_.node_[leaf] = at;
                       zones_.level_[leaf] = level;
                   });
    }

    void fill_top() {
        constexpr std::uint32_t along = 1U << top_levels;
        constexpr int shift = digits - top_levels;
        for (std::uint32_t z = 0; z < along; ++z)
            for (std::uint32_t y = 0; y < along; ++y)
                for (std::uint32_t x = 0; x < along; ++x) {
                    std::int32_t node = 0;
                    for (int level = 0; level < top_levels && data_.child[node] >= 0; ++level)
                        node = data_.child[node] + octant({x << shift, y << shift, z << shift}, level);
                    zones_.top_.push_back(data_.child[node] < 0 ? data_.child[node] : node);
                }
    }

    [[nodiscard]] std::span<const std::int32_t> program(std::int32_t leaf) const noexcept {
        return {data_.program.data() + data_.program_begin[leaf], data_.program.data() + data_.program_begin[leaf + 1]};
    }

    // Whether a cell has a say in the cube.
    [[nodiscard]] static bool reaches(const PiecesNode& cell, const glm::dvec3& centre, double half) noexcept {
        const glm::dvec3 off = glm::abs(cell.centre - centre);
        return std::max({off.x, off.y, off.z}) < PiecesData::cell_reach * cell.half + (1.0 + zone_rounding) * half;
    }

    void look_beside(const PiecesNode& at, Beside& beside) const {
        for_leaves([&](const PiecesNode& other) { return reaches(other, at.centre, at.half); },
                   [&](const PiecesNode&, std::int8_t, std::int32_t leaf) {
                       beside.leaf.push_back(leaf);
                       beside.plain = beside.plain || program(leaf).empty();
                       for (const std::int32_t code : program(leaf))
                           if (code >= 0 &&
                               std::find(beside.sheet.begin(), beside.sheet.end(), code) == beside.sheet.end())
                               beside.sheet.push_back(code);
                   });
    }

    void make(std::int32_t leaf, Made& made) const {
        const PiecesNode& at = zones_.node_[leaf];
        const double farthest = glm::length(glm::abs(at.centre - data_.bounds.centre()) + at.half);
        if (farthest > PiecesData::sphere_begins * 0.5 * data_.bounds.diagonal()) return;
        Beside beside(runtime_.memory);
        look_beside(at, beside);
        if (beside.sheet.empty() || beside.leaf.size() > most_parts) return;
        const bool one = beside.sheet.size() == 1 && !beside.plain;
        made.cuts = static_cast<std::int8_t>(one ? 0 : std::clamp(zone_level - zones_.level_[leaf], 0, most_cuts));
        if (beside.sheet.size() > 1) evaluate(at, made.cuts, beside);
        const std::int64_t along = std::int64_t{1} << made.cuts;
        for (std::int64_t z = 0; z < along; ++z)
            for (std::int64_t y = 0; y < along; ++y)
                for (std::int64_t x = 0; x < along; ++x) make_zone(at, {x, y, z}, along, beside, made);
    }

    void evaluate(const PiecesNode& at, int cuts, Beside& beside) const {
        const std::int64_t along = std::int64_t{1} << cuts;
        geometry::VecArray place(runtime_.memory);
        for (const std::int64_t half : {0, 1}) {
            const double step = 2.0 * at.half / static_cast<double>(along);
            const glm::dvec3 low = at.centre - at.half + 0.5 * step * static_cast<double>(half);
            for (std::int64_t z = 0; z <= along - half; ++z)
                for (std::int64_t y = 0; y <= along - half; ++y)
                    for (std::int64_t x = 0; x <= along - half; ++x) place.push_back(low + step * glm::dvec3(x, y, z));
        }
        beside.places = place.size();
        beside.value.resize_for_overwrite(beside.places * beside.sheet.size());
        for (std::int64_t s = 0; s < beside.sheet.size(); ++s)
            implicit::evaluate(runtime_.instruction_set, data_.sheet[beside.sheet[s]],
                               {place.x.data(), place.y.data(), place.z.data(), place.size()},
                               {beside.value.data() + s * beside.places, {}, {}});
    }

    using Index = std::array<std::int64_t, 3>;

    [[nodiscard]] static std::array<std::int64_t, places> places_of(const Index& zone, std::int64_t along) noexcept {
        std::array<std::int64_t, places> place{};
        const std::int64_t row = along + 1;
        for (std::size_t k = 0; k < 8; ++k) {
            const auto bit = [&](unsigned axis) { return static_cast<std::int64_t>(k >> axis & 1U); };
            place[k] = zone[0] + bit(0) + row * (zone[1] + bit(1) + row * (zone[2] + bit(2)));
        }
        place[8] = row * row * row + zone[0] + along * (zone[1] + along * zone[2]);
        return place;
    }

    void make_zone(const PiecesNode& at, const Index& index, std::int64_t along, const Beside& beside,
                   Made& made) const {
        const double half = at.half / static_cast<double>(along);
        const glm::dvec3 centre = at.centre - at.half + half * (2.0 * glm::dvec3(index[0], index[1], index[2]) + 1.0);
        const std::array<std::int64_t, places> place = places_of(index, along);
        const auto first = static_cast<std::int32_t>(made.part.size());
        for (const std::int32_t leaf : beside.leaf) {
            if (!reaches(zones_.node_[leaf], centre, half)) continue;
            const auto begin = static_cast<std::int32_t>(made.program.size());
            add_simple(program(leaf), place, beside, made.program);
            made.part.push_back(shared({leaf, begin, static_cast<std::int32_t>(made.program.size())}, first, made));
        }
        const Part& front = made.part[first];
        bool alone = front.begin < front.end;
        for (std::int64_t k = first + 1; alone && k < made.part.size(); ++k) alone = made.part[k].begin == front.begin;
        if (alone) made.part.resize(first + 1);
        keep_zone({first, static_cast<std::int32_t>(made.part.size()), alone}, made);
    }

    // One that is as another is that.
    static void keep_zone(const Zone& zone, Made& made) {
        const auto parts = [&](const Zone& of) {
            return made.part.span().subspan(static_cast<std::size_t>(of.begin),
                                            static_cast<std::size_t>(of.end - of.begin));
        };
        const std::span<const std::int32_t> codes = made.program.span();
        const Part& front = made.part[zone.begin];
        if (zone.alone && front.end - front.begin == 1) {
            made.code.push_back(-1 - codes[static_cast<std::size_t>(front.begin)]);
        } else {
            const auto same = [&](const Part& a, const Part& b) {
                return a.leaf == b.leaf && std::equal(codes.begin() + a.begin, codes.begin() + a.end,
                                                      codes.begin() + b.begin, codes.begin() + b.end);
            };
            const auto is_known = [&](const Zone& other) {
                const auto a = parts(other);
                const auto b = parts(zone);
                return other.alone == zone.alone && std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
            };
            std::int32_t known = 0;
            while (known < made.zone.size() && !is_known(made.zone[known])) ++known;
            made.code.push_back(known);
            if (known == made.zone.size()) {
                made.zone.push_back(zone);
                return;
            }
        }
        made.part.resize(zone.begin);
    }

    // A part whose program is the last one, or, where a part from `first` on has the same, that one.
    [[nodiscard]] static Part shared(const Part& part, std::int32_t first, Made& made) {
        const auto codes = [&](const Part& of) {
            return made.program.span().subspan(static_cast<std::size_t>(of.begin),
                                               static_cast<std::size_t>(of.end - of.begin));
        };
        for (std::int64_t k = first; k < made.part.size(); ++k) {
            const Part& other = made.part[k];
            const auto a = codes(other);
            const auto b = codes(part);
            if (!std::equal(a.begin(), a.end(), b.begin(), b.end())) continue;
            made.program.resize(part.begin);
            return {part.leaf, other.begin, other.end};
        }
        return part;
    }

    // Appends what is left of a program.
    static void add_simple(std::span<const std::int32_t> program, const std::array<std::int64_t, places>& place,
                           const Beside& beside, base::Array<std::int32_t>& to) {
        if (program.size() < 2) {
            for (const std::int32_t code : program) to.push_back(code);
            return;
        }
        std::array<Simple, PiecesData::most_operands + 1> stack;
        std::size_t depth = 0;
        for (const std::int32_t code : program) {
            if (code < 0) {
                --depth;
                join(stack[depth - 1], stack[depth], code);
                continue;
            }
            Simple& top = stack[depth++];
            const std::int64_t sheet = std::find(beside.sheet.begin(), beside.sheet.end(), code) - beside.sheet.begin();
            for (std::size_t i = 0; i < places; ++i) top.value[i] = beside.value[sheet * beside.places + place[i]];
            top.code[0] = code;
            top.size = 1;
        }
        for (std::int64_t i = 0; i < stack[0].size; ++i) to.push_back(stack[0].code[static_cast<std::size_t>(i)]);
    }

    void keep(const Made& made) {
        const auto parts = static_cast<std::int32_t>(zones_.part_.size());
        const auto codes = static_cast<std::int32_t>(zones_.program_.size());
        zones_.cuts_.push_back(made.cuts);
        zones_.first_.push_back(static_cast<std::int32_t>(zones_.code_.size()));
        const auto zones = static_cast<std::int32_t>(zones_.zone_.size());
        for (const std::int32_t code : made.code) zones_.code_.push_back(code >= 0 ? zones + code : code);
        for (const Zone& zone : made.zone) zones_.zone_.push_back({zone.begin + parts, zone.end + parts, zone.alone});
        for (const Part& part : made.part) zones_.part_.push_back({part.leaf, part.begin + codes, part.end + codes});
        for (const std::int32_t code : made.program) zones_.program_.push_back(code);
    }

    const base::Runtime& runtime_;
    PiecesZones& zones_;
    const PiecesData& data_;
    const PiecesNode root_;
};

PiecesZones::PiecesZones(const base::Runtime& runtime, const PiecesData& data, const base::Progress& progress)
    : data_(data), top_(runtime.memory), node_(runtime.memory), level_(runtime.memory), cuts_(runtime.memory),
      first_(runtime.memory), code_(runtime.memory), zone_(runtime.memory), part_(runtime.memory),
      program_(runtime.memory) {
    Builder(runtime, *this).run(progress);
}

bool PiecesZones::digits_of(const glm::dvec3& place, Digits& digit) const noexcept {
    constexpr double range = 1U << digits;
    const glm::dvec3 t = (place - data_.corner) * (range / data_.side);
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        if (!(t[axis] >= 0.0 && t[axis] < range)) return false;
        digit[static_cast<std::size_t>(axis)] = static_cast<std::uint32_t>(t[axis]);
    }
    return true;
}

std::int32_t PiecesZones::leaf_at(const Digits& digit) const noexcept {
    constexpr int shift = digits - top_levels;
    std::int32_t node =
        top_[std::int64_t{digit[0] >> shift | (digit[1] >> shift | digit[2] >> shift << top_levels) << top_levels}];
    if (node < 0) return -1 - node;
    int level = top_levels;
    std::int32_t child = data_.child[node];
    for (; child >= 0; child = data_.child[node]) node = child + octant(digit, level++);
    return -1 - child;
}

std::int32_t PiecesZones::at(const glm::dvec3& place) const noexcept {
    Digits digit;
    if (!digits_of(place, digit)) return nowhere;
    const std::int32_t leaf = leaf_at(digit);
    const int cuts = cuts_[leaf];
    if (cuts < 0) return nowhere;
    const int shift = digits - level_[leaf] - cuts;
    const std::uint32_t last = (1U << cuts) - 1U;
    const std::uint32_t index =
        (digit[0] >> shift & last) | ((digit[1] >> shift & last) | (digit[2] >> shift & last) << cuts) << cuts;
    return code_[first_[leaf] + static_cast<std::int32_t>(index)];
}

const PiecesZones::Part* PiecesZones::alone_at(const Zone& zone, const glm::dvec3& place) const noexcept {
    const Part* const front = part_.data() + zone.begin;
    if (zone.alone) return front;
    // Without branches: which of the parts reach a place nobody can foresee.
    const Part* found = nullptr;
    unsigned several = 0;
    for (const Part* part = front; part != part_.data() + zone.end; ++part) {
        const PiecesNode& node = node_[part->leaf];
        const glm::dvec3 off = glm::abs(place - node.centre);
        const double reach = PiecesData::cell_reach * node.half;
        const unsigned has = static_cast<unsigned>(off.x < reach) & static_cast<unsigned>(off.y < reach) &
                             static_cast<unsigned>(off.z < reach);
        const std::int32_t before = found != nullptr ? found->begin : part->begin;
        several |=
            has & (static_cast<unsigned>(part->begin == part->end) | static_cast<unsigned>(part->begin != before));
        found = has != 0 ? part : found;
    }
    return several != 0 ? nullptr : found;
}

std::int32_t PiecesZones::cell_of(const glm::dvec3& place) const noexcept {
    const std::int32_t zone = at(place);
    if (zone >= 0) return static_cast<std::int32_t>(data_.sheet.size()) + part_[zone_[zone].begin].leaf;
    return zone == nowhere ? static_cast<std::int32_t>(cells()) - 1 : -1 - zone;
}

} // namespace hrbfnpr::implicit
