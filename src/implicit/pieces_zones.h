// SPDX-License-Identifier: MIT
// An implicit of pieces prepared for many points.  Cells are cut into zones; of each is known which cells have a say in
// it, and which of their sheets can be the largest or smallest there: far from a crease that is one, and f is that
// sheet with nothing to weigh.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "implicit/pieces_data.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

namespace hrbfnpr::implicit {

// A cell and where it is.
struct PiecesNode {
    std::int32_t node;
    glm::dvec3 centre;
    double half;

    // Whether it has a say at the place.
    [[nodiscard]] bool reaches(const glm::dvec3& place) const noexcept {
        const glm::dvec3 off = glm::abs(place - centre);
        return std::max({off.x, off.y, off.z}) < PiecesData::cell_reach * half;
    }
};

class PiecesZones {
public:
    // The data must outlive it.
    PiecesZones(const base::Runtime& runtime, const PiecesData& data, const base::Progress& progress);

    // A cell that has a say in a zone, and what is left of its program there: none of one without a program.
    struct Part {
        std::int32_t leaf;
        std::int32_t begin, end; // in programs()
    };
    struct Zone {
        std::int32_t begin, end; // of its parts: those whose programs are equal have the same one
        bool alone;              // one part, which has all the say
    };
    static constexpr std::int32_t nowhere = std::numeric_limits<std::int32_t>::min();

    // The zone that a place lies in, -1 - the sheet that alone rules that, or nowhere.
    [[nodiscard]] std::int32_t at(const glm::dvec3& place) const noexcept;
    [[nodiscard]] const Zone& operator[](std::int32_t zone) const noexcept { return zone_[zone]; }
    [[nodiscard]] std::span<const Part> parts(const Zone& zone) const noexcept {
        return {part_.data() + zone.begin, part_.data() + zone.end};
    }
    // The part whose program is that of all cells with a say at a place of the zone; null: they have several, or none.
    [[nodiscard]] const Part* alone_at(const Zone& zone, const glm::dvec3& place) const noexcept;
    // The one sheet of a part's program; -1: it has several, or none.
    [[nodiscard]] std::int32_t sheet_of(const Part& part) const noexcept {
        return part.end - part.begin == 1 ? program_[part.begin] : -1;
    }
    [[nodiscard]] const std::int32_t* programs() const noexcept { return program_.data(); }
    [[nodiscard]] const PiecesNode& node(std::int32_t leaf) const noexcept { return node_[leaf]; }
    // Cells of implicit::Implicit: of the places that one sheet rules, and of those of each leaf.
    [[nodiscard]] std::int64_t cells() const noexcept { return data_.sheet.size() + data_.leaves() + 1; }
    [[nodiscard]] std::int32_t cell_of(const glm::dvec3& place) const noexcept;
    [[nodiscard]] std::int64_t bytes() const noexcept {
        return top_.bytes() + node_.bytes() + level_.bytes() + cuts_.bytes() + first_.bytes() + code_.bytes() +
               zone_.bytes() + part_.bytes() + program_.bytes();
    }

private:
    class Builder;
    static constexpr int digits = 20; // of a place's coordinates, in the root cube
    static constexpr int top_levels = 4;
    using Digits = std::array<std::uint32_t, 3>;

    [[nodiscard]] bool digits_of(const glm::dvec3& place, Digits& digit) const noexcept;
    [[nodiscard]] static std::int32_t octant(const Digits& digit, int level) noexcept {
        const int shift = digits - 1 - level;
        return static_cast<std::int32_t>((digit[0] >> shift & 1U) | (digit[1] >> shift & 1U) << 1U |
                                         (digit[2] >> shift & 1U) << 2U);
    }
    [[nodiscard]] std::int32_t leaf_at(const Digits& digit) const noexcept;

    const PiecesData& data_;
    base::Array<std::int32_t> top_; // of each cube of that level: its node, or -1 - the leaf that it is part of
    base::Array<PiecesNode> node_;  // of each leaf
    base::Array<std::int8_t> level_;
    base::Array<std::int8_t> cuts_;   // 2^that zones along each of its sides; -1: none
    base::Array<std::int32_t> first_; // its first zone
    base::Array<std::int32_t> code_;  // of each zone: as at() says
    base::Array<Zone> zone_;          // those that differ
    base::Array<Part> part_;
    base::Array<std::int32_t> program_;
};

} // namespace hrbfnpr::implicit
