// SPDX-License-Identifier: MIT
// Which marks of a stroke are looked at.
#include "base/prefetch.h"
#include "frame/depth_layers/hatch_marks.h"

#include <bit>

namespace hrbfnpr::frame {
namespace {

// Marks around those that may be drawn: the first one that is not, the next one, for its tangent, and the next one,
// for the spacing there.
constexpr std::int64_t around = 3;
// Between marks that may be drawn no fewer are left out.
constexpr std::int64_t fewest_left_out = 16;

} // namespace

// Whether any piece may be drawn.
bool HatchMarks::find_pieces(std::int64_t piece, std::int64_t count, HatchStroke& seen) const {
    constexpr std::uint32_t all = ~std::uint32_t{0} >> (32 - marks::StrokePiece::most);
    seen.may_draw.clear();
    bool any = false;
    for (std::int64_t k = 0; k < count; ++k) {
        const marks::StrokePiece& own = run_.clusters->piece[piece + k];
        seen.may_draw.push_back(may_draw(own) ? all >> (marks::StrokePiece::most - own.count) : 0U);
        if (seen.may_draw.back() == 0) continue;
        any = true;
        expect_normals(own);
    }
    // An unsteady hand goes by the numbers of the marks, and past where the tone ends.
    if (any && has_hand()) std::fill(seen.may_draw.begin(), seen.may_draw.end(), all);
    return any;
}

// Whether any mark may be drawn.
bool HatchMarks::find_marks(std::int64_t piece, HatchStroke& seen) const noexcept {
    const bool limited = limits_.any() && !has_hand();
    std::uint32_t any = 0;
    for (std::int64_t k = 0; k < seen.may_draw.size(); ++k) {
        std::uint32_t& bits = seen.may_draw[k];
        const marks::StrokePiece& own = run_.clusters->piece[piece + k];
        if (bits != 0 && limited) bits = limits_.may_draw(own);
        if (bits != 0) expect_places(own);
        any |= bits;
    }
    return any != 0;
}

// Those that may be drawn, and around them the marks that their ends, tangents and spacing need.  Between two of them a
// few are looked at rather than left out.
void HatchMarks::find_ranges(HatchStroke& seen) const {
    const std::int64_t end = seen.first + seen.count;
    const auto add = [&](std::int64_t from, std::int64_t to) {
        from = std::max(from, seen.first);
        to = std::min(to, end);
        if (from >= to) return;
        if (!seen.range.empty() && from <= seen.range.back().end + fewest_left_out)
            seen.range.back().end = std::max(seen.range.back().end, to);
        else
            seen.range.push_back({from, to});
    };
    const auto first_of = [&](std::int64_t k) { return seen.first + k * marks::StrokePiece::most; };
    seen.range.clear();
    if (seen.closed && seen.may_draw.back() != 0)
        add(seen.first,
            first_of(seen.may_draw.size() - 1) + std::bit_width(seen.may_draw.back()) + around - seen.count);
    for (std::int64_t k = 0; k < seen.may_draw.size(); ++k)
        for (std::uint32_t bits = seen.may_draw[k]; bits != 0;) {
            const int from = std::countr_zero(bits);
            const int to = from + std::countr_one(bits >> from);
            add(first_of(k) + from - around, first_of(k) + to + around);
            bits = to < 32 ? bits >> to << to : 0U;
        }
    if (seen.closed && seen.may_draw[0] != 0) add(end + std::countr_zero(seen.may_draw[0]) - around, end);
}

// Soon its marks are asked whether they may be drawn ...
void HatchMarks::expect_normals(const marks::StrokePiece& piece) const noexcept {
    const marks::Layer& layer = *run_.marks;
    if (!layer.stroke_order.empty()) return;
    const std::int64_t first = 3 * std::int64_t{piece.first};
    const std::int64_t count = 3 * std::int64_t{piece.count};
    base::prefetch_many(run_.normal + first, count);
    if (run_.has_tone_normals() && run_.normal == layer.normal.data())
        base::prefetch_many(layer.tone_normal.data() + first, count);
}

// ... and those that may be where they are.
void HatchMarks::expect_places(const marks::StrokePiece& piece) const noexcept {
    const marks::Layer& layer = *run_.marks;
    if (!layer.stroke_order.empty()) return;
    base::prefetch_many(run_.position + 3 * std::int64_t{piece.first}, 3 * std::int64_t{piece.count});
    base::prefetch_many(layer.level.data() + piece.first, piece.count);
    if (!layer.clusters.gap.empty()) base::prefetch_many(layer.clusters.gap.data() + piece.first, piece.count);
}

} // namespace hrbfnpr::frame
