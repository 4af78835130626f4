// SPDX-License-Identifier: MIT
#include "frame/hatch/marks.h"

#include "base/assert.h"
#include "base/prefetch.h"
#include "base/scratch.h"
#include "features/line_set.h"
#include "frame/hatch/tuning.h"

#include <glm/gtc/matrix_access.hpp>

#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace hrbfnpr::frame {
namespace {

// Bounds of a piece hold for its marks up to rounding.
constexpr float rounding_of_margins = 1e-3F;
constexpr float rounding_of_darkness = 1e-4F;
constexpr float most_length = 1.01F; // a unit normal's, up to rounding
// Places farther outside of the picture have no use, pixels.
constexpr float farthest = 1e6F;
// The report's step of a layer is its lines' separation, but for published strokes, which lie as they grew.
[[nodiscard]] bool has_separation(const marks::Layer& layer) noexcept {
    return layer.report.step > 0.0 && (layer.progressive || layer.kind != marks::Kind::hatch);
}

// The root of the largest eigenvalue of a symmetric matrix.
[[nodiscard]] float largest_stretch(float xx, float xy, float yy) noexcept {
    const float half = 0.5F * (xx - yy);
    return std::sqrt(0.5F * (xx + yy) + std::sqrt(half * half + xy * xy));
}

// The longest image, in pixels, of a length of 1 where w is 1, within `beyond` pixels around the picture. In a
// projection dx = (row_x - x row_w) . d / w, whose largest stretch is convex in the place, so that it is greatest in a
// corner.
[[nodiscard]] float largest_stretch(const Lens& lens, float beyond) noexcept {
    const glm::vec4 row = glm::row(lens.window, 3);
    const glm::vec4& v = lens.viewport;
    float stretch = 0.0F;
    for (const float x : {v.x - beyond, v.x + v.z + beyond}) {
        for (const float y : {v.y - beyond, v.y + v.w + beyond}) {
            const glm::vec3 a(glm::row(lens.window, 0) - x * row);
            const glm::vec3 b(glm::row(lens.window, 1) - y * row);
            stretch = std::max(stretch, largest_stretch(glm::dot(a, a), glm::dot(a, b), glm::dot(b, b)));
        }
    }
    return stretch;
}

[[nodiscard]] HatchRows rows_of(std::int64_t least_count, base::Array<float>& memory) {
    const std::int64_t stride = least_count + 2 * HatchRows::slack;
    const std::int64_t all = static_cast<std::int64_t>(HatchRow::rows) * stride;
    if (memory.size() < all) base::resize_scratch(memory, all);
    return {memory.data() + HatchRows::slack, stride};
}

[[nodiscard]] HatchLaw law_of(const LayerStyle& style, std::int32_t levels) noexcept {
    HatchLaw law{};
    law.tone_begin = style.hatch_tone_begin;
    law.tone_span = style.hatch_tone_end - style.hatch_tone_begin;
    law.share = style.share;
    law.coverage_begin = style.hatch_coverage_begin;
    law.coverage_rise = style.hatch_coverage_end - style.hatch_coverage_begin;
    law.spacing = style.hatch_spacing;
    law.pen = style.hatch_pen;
    law.white = style.hatch_white;
    law.levels = static_cast<float>(levels);
    law.per_tone_span = 1.0F / law.tone_span;
    law.per_spacing = 1.0F / law.spacing;
    law.per_pen = 1.0F / law.pen;
    law.widest_nu = hatch_tuning.widest_nu;
    law.widest = farthest;
    return law;
}

} // namespace

HatchMarks::HatchMarks(const HatchView& view, const Run& run, const ItemSight& sight, const float* taus) noexcept
    : view_(view), run_(run), item_(view.scene.item_of(run)), sight_(sight), style_(*run.style), taus_(taus),
      levels_(has_separation(*run.marks) ? std::clamp(run.marks->report.levels, 0, marks::most_levels) : 0),
      per_unit_(1.0 / item_.unit), tone_normal_(run.normal), lightest_(std::numeric_limits<float>::infinity()),
      has_bounds_(sight.seer.rigid && run.marks->stroke_order.empty()),
      beyond_(std::min(style_.hatch_taper + 6.0F * style_.hatch_shortest + 4.0F * style_.hatch_spacing,
                       view.scene.lens.diagonal)) {
    law_ = law_of(style_, levels_);
    const bool posed = run.normal != run.marks->normal.data();
    if (taus == nullptr && item_.style.tone == Tone::light && !(posed && run.has_tone_normals())) {
        if (run.has_tone_normals()) tone_normal_ = run.marks->tone_normal.data();
        lightest_ = LightTone(item_.style).lightest(1.0F - style_.hatch_tone_begin, rounding_of_darkness);
    }
    if (!has_separation(*run.marks)) return;
    separation_ = static_cast<float>(std::ldexp(run.marks->report.step / item_.unit, levels_));
    stretch_ = sight_.scale * largest_stretch(view_.scene.lens, beyond_);
    set_most_coverage();
    shown_ = most_level();
}

void HatchMarks::set_most_coverage() noexcept {
    std::array<float, steps + 1 + HatchRows::slack> darkness{};
    std::array<float, steps + 1 + HatchRows::slack> coverage{};
    for (std::size_t i = 0; i <= steps; ++i) darkness[i] = static_cast<float>(i) / static_cast<float>(steps);
    view_.loops.coverage(law_, darkness.data(), steps + 1, coverage.data());
    for (std::size_t i = 0; i <= steps; ++i)
        most_coverage_[i] = std::max(coverage[i], i > 0 ? most_coverage_[i - 1] : 0.0F);
}

// The finest level that there may be room for anywhere on the item inside the picture.
std::int32_t HatchMarks::most_level() const noexcept {
    const glm::vec4 row = glm::row(view_.scene.lens.window, 3);
    const float nearest = glm::dot(row, glm::vec4(item_.to_eye * item_.centre + item_.eye_offset, 1.0F)) -
                          glm::length(glm::vec3(row)) * sight_.scale * item_.radius;
    std::int32_t level = levels_;
    while (level > 0 && !has_room(level, nearest, 1.0F)) --level;
    return level;
}

// Whether there may be room for lines of a level where no mark is darker than `darkness` and nearer than `nearest`, the
// w of a place in the picture's projection.
bool HatchMarks::has_room(std::int32_t level, float nearest, float darkness) const noexcept {
    if (level <= 1 || !(nearest > 0.0F)) return true;
    const auto step = static_cast<std::size_t>(std::ceil(std::clamp(darkness, 0.0F, 1.0F) * static_cast<float>(steps)));
    const float wanted = std::max(style_.hatch_spacing, style_.hatch_pen / most_coverage_[step]);
    return !(1.001F * separation_ * stretch_ < std::ldexp(wanted, level - 1) * nearest);
}

// Whether a mark of the piece may be drawn. Else all are too light, face away, lie outside, or are of a level that
// there is no room for.
bool HatchMarks::may_draw(const marks::StrokePiece& piece) const noexcept {
    if (piece.level > shown_ || faces_away(piece, sight_)) return false;
    const ClusterView view = view_cluster(piece, sight_, view_.scene.lens, view_.frustum);
    if (view.beyond > beyond_ + rounding_of_margins || view.nu_min > hatch_tuning.last_nu + rounding_of_margins)
        return false;
    const float darkness = most_darkness(piece) + rounding_of_margins;
    if (darkness < style_.hatch_tone_begin) return false;
    return !(separation_ > 0.0F) || has_room(piece.level, view.nearest, darkness);
}

// An upper bound of what set_darkness() sets for marks of the piece.
float HatchMarks::most_darkness(const marks::StrokePiece& piece) const noexcept {
    if (taus_ != nullptr || item_.style.tone != Tone::light) return 1.0F;
    return 1.0F - LightTone(item_.style).least(least_lit(piece, sight_));
}

// At a place p of the ball around c, e the eye, n . (p - e) >= n . (c - e) - |n| r: where that is positive it faces
// away. Returns a bit for each mark that may be drawn.
std::uint32_t HatchMarks::marks_that_may(const marks::StrokePiece& piece) const noexcept {
    HatchBounds bounds{};
    const Seer& seer = sight_.seer;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto i = static_cast<int>(k);
        bounds.sight[k] = seer.parallel ? sight_.eye[i] : piece.centre[k] - sight_.eye[i];
        bounds.light[k] = seer.light.towards[k];
    }
    bounds.away = seer.parallel ? 0.0F : most_length * piece.radius;
    bounds.lightest = lightest_;
    const std::int64_t first = 3 * std::int64_t{piece.first};
    return view_.loops.may_draw(bounds, run_.normal + first, tone_normal_ + first, piece.count);
}

// A closed stroke's last mark may lie where its first one does.
void HatchMarks::set_extent(std::int64_t stroke, HatchStroke& seen) const noexcept {
    seen.first = run_.marks->stroke_first[stroke];
    seen.count = std::int64_t{run_.marks->stroke_first[stroke + 1]} - seen.first;
    seen.closed = false;
    if (seen.count < hatch_tuning.fewest_of_closed) return;
    const glm::vec3 begin = place(seen.first);
    const glm::vec3 end = place(seen.first + seen.count - 1);
    const glm::vec3 leaves = place(seen.first + 1) - begin;
    const glm::vec3 comes = end - place(seen.first + seen.count - 2);
    const float gap = glm::distance(begin, end);
    const float step = glm::length(leaves);
    const bool same = gap <= hatch_tuning.same_place * step;
    const auto goes_on = [&](const glm::vec3& v) {
        return glm::dot(v, begin - end) >= hatch_tuning.closed_cosine * gap * glm::length(v);
    };
    seen.closed = same || (gap <= hatch_tuning.closed_gap * step && goes_on(leaves) && goes_on(comes));
    if (same) --seen.count;
}

bool HatchMarks::see(std::int64_t stroke, std::int64_t piece, HatchStroke& seen) const {
    const marks::Layer& layer = *run_.marks;
    const std::int64_t first = layer.stroke_first[stroke];
    const std::int64_t count = std::int64_t{layer.stroke_first[stroke + 1]} - first;
    if (count < 2) return false;
    if (!run_.draws_set(layer.direction_of(layer.mark_of(first)))) return false;
    if (!find_pieces(piece, marks::pieces_of(count), seen)) return false;
    set_extent(stroke, seen);
    if (!find_marks(piece, seen)) return false;
    find_ranges(seen);
    const HatchRows rows = load(seen);
    see_rows(seen.number.span(), rows, seen.closed);
    keep(rows, seen);
    if (seen.mark.empty()) return false;
    set_ends(seen);
    return true;
}

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
        if (!run_.marks->stroke_order.empty()) continue;
        // Soon its marks are asked whether they may be drawn.
        base::prefetch_many(run_.normal + 3 * std::int64_t{own.first}, 3 * std::int64_t{own.count});
        if (run_.has_tone_normals() && run_.normal == run_.marks->normal.data())
            base::prefetch_many(run_.marks->tone_normal.data() + 3 * std::int64_t{own.first},
                                3 * std::int64_t{own.count});
    }
    // An unsteady hand goes by the numbers of the marks, and past where the tone ends.
    if (any && is_unsteady()) std::fill(seen.may_draw.begin(), seen.may_draw.end(), all);
    return any;
}

// Whether any mark may be drawn.
bool HatchMarks::find_marks(std::int64_t piece, HatchStroke& seen) const noexcept {
    const bool bounded = has_bounds_ && !is_unsteady();
    std::uint32_t any = 0;
    for (std::int64_t k = 0; k < seen.may_draw.size(); ++k) {
        std::uint32_t& bits = seen.may_draw[k];
        const marks::StrokePiece& own = run_.clusters->piece[piece + k];
        if (bits != 0 && bounded) bits = marks_that_may(own);
        any |= bits;
        if (bits == 0 || !run_.marks->stroke_order.empty()) continue;
        base::prefetch_many(run_.position + 3 * std::int64_t{own.first}, 3 * std::int64_t{own.count});
        base::prefetch_many(run_.marks->level.data() + own.first, own.count);
        const base::Array<float>& gap = run_.marks->clusters.gap;
        if (!gap.empty()) base::prefetch_many(gap.data() + own.first, own.count);
    }
    return any != 0;
}

// The ranges of marks that may be drawn, and of the marks around them that their ends, tangents and spacing need. A few
// marks between two ranges are looked at rather than left out.
void HatchMarks::find_ranges(HatchStroke& seen) const {
    const std::int64_t end = seen.first + seen.count;
    const auto add = [&](std::int64_t from, std::int64_t to) {
        from = std::max(from, seen.first);
        to = std::min(to, end);
        if (from >= to) return;
        if (!seen.range.empty() && from <= seen.range.back().end + hatch_tuning.fewest_left_out)
            seen.range.back().end = std::max(seen.range.back().end, to);
        else
            seen.range.push_back({from, to});
    };
    const auto first_of = [&](std::int64_t k) { return seen.first + k * marks::StrokePiece::most; };
    seen.range.clear();
    if (seen.closed && seen.may_draw.back() != 0)
        add(seen.first, first_of(seen.may_draw.size() - 1) + std::bit_width(seen.may_draw.back()) +
                            hatch_tuning.marks_around - seen.count);
    for (std::int64_t k = 0; k < seen.may_draw.size(); ++k)
        for (std::uint32_t bits = seen.may_draw[k]; bits != 0;) {
            const int from = std::countr_zero(bits);
            const int to = from + std::countr_one(bits >> from);
            add(first_of(k) + from - hatch_tuning.marks_around, first_of(k) + to + hatch_tuning.marks_around);
            bits = to < 32 ? bits >> to << to : 0U;
        }
    if (seen.closed && seen.may_draw[0] != 0)
        add(end + std::countr_zero(seen.may_draw[0]) - hatch_tuning.marks_around, end);
}

HatchRows HatchMarks::load(HatchStroke& seen) const {
    std::int64_t count = 0;
    for (const HatchStroke::Range& range : seen.range) count += range.end - range.begin;
    base::resize_scratch(seen.number, count);
    const HatchRows rows = rows_of(count, seen.row);
    std::int64_t at = 0;
    for (const HatchStroke::Range& range : seen.range) {
        load(range.begin, range.end - range.begin, seen.number.data() + at, rows.from(at));
        at += range.end - range.begin;
    }
    return rows;
}

// Loads marks whose places follow each other.
void HatchMarks::load(std::int64_t begin, std::int64_t count, std::uint32_t* numbers,
                      const HatchRows& rows) const noexcept {
    const marks::Layer& layer = *run_.marks;
    const bool ordered = layer.stroke_order.empty();
    const bool posed = run_.normal != layer.normal.data();
    if (ordered)
        std::iota(numbers, numbers + count, static_cast<std::uint32_t>(begin));
    else
        std::copy_n(layer.stroke_order.data() + begin, count, numbers);
    const auto put_one = [&](HatchRow to, const auto* all) {
        float* const row = rows[to];
        if (ordered)
            std::copy_n(all + begin, count, row);
        else
            for (std::int64_t i = 0; i < count; ++i) row[i] = static_cast<float>(all[numbers[i]]);
    };
    put_one(HatchRow::level, layer.level.data());
    const base::Array<float>& gap = layer.clusters.gap;
    if (gap.empty())
        std::fill_n(rows[HatchRow::gap], count, 1.0F);
    else
        put_one(HatchRow::gap, gap.data());
    const auto put = [&](HatchRow x, const float* all, float factor, float other) {
        const HatchRows row{rows[x], rows.stride};
        float* const y = row.first + row.stride;
        float* const z = y + row.stride;
        if (ordered) {
            view_.loops.load(all + 3 * begin, count, factor, other, row.first, y, z);
            return;
        }
        for (std::int64_t i = 0; i < count; ++i)
            view_.loops.load(all + 3 * std::int64_t{numbers[i]}, 1, factor, other, row.first + i, y + i, z + i);
    };
    // The inverse of some units is too large for a float, so it is split into two factors.
    const int exponent = std::ilogb(per_unit_);
    put(HatchRow::x, run_.position, std::ldexp(1.0F, exponent / 2), std::ldexp(1.0F, exponent - exponent / 2));
    put(HatchRow::normal_x, run_.normal, 1.0F, 1.0F);
    if (!run_.has_tone_normals()) return;
    if (!posed) {
        put(HatchRow::tone_x, layer.tone_normal.data(), 1.0F, 1.0F);
        return;
    }
    for (std::int64_t i = 0; i < count; ++i) {
        const glm::vec3 normal = run_.tone_normal_of(numbers[i]);
        rows[HatchRow::tone_x][i] = normal.x;
        rows[HatchRow::tone_y][i] = normal.y;
        rows[HatchRow::tone_z][i] = normal.z;
    }
}

void HatchMarks::see_rows(std::span<const std::uint32_t> numbers, const HatchRows& rows, bool closed) const noexcept {
    const auto count = static_cast<std::int64_t>(numbers.size());
    for (const HatchRow row : {HatchRow::x, HatchRow::y, HatchRow::z}) { // beside the first and the last one
        rows[row][-1] = rows[row][closed ? count - 1 : 0];
        rows[row][count] = rows[row][closed ? 0 : count - 1];
    }
    const glm::vec4& v = view_.scene.lens.viewport;
    const HatchSight how{&sight_.seer, separation_,          v.x,     v.y, v.x + v.z, v.y + v.w,
                         beyond_,      hatch_tuning.last_nu, farthest};
    const HatchRow tone = run_.has_tone_normals() ? HatchRow::tone_x : HatchRow::normal_x;
    const float* const tone_x = rows[tone];
    view_.see.see_rows(sight_.seer,
                       {rows[HatchRow::x], rows[HatchRow::y], rows[HatchRow::z], rows[HatchRow::normal_x],
                        rows[HatchRow::normal_y], rows[HatchRow::normal_z], tone_x, tone_x + rows.stride,
                        tone_x + 2 * rows.stride, count},
                       {rows[HatchRow::left], rows[HatchRow::top], rows[HatchRow::window], rows[HatchRow::depth],
                        rows[HatchRow::pixels_per_unit], rows[HatchRow::nu], rows[HatchRow::darkness],
                        rows[HatchRow::side_x], rows[HatchRow::side_y], rows[HatchRow::distance], nullptr});
    view_.loops.place(how, rows, count);
    set_darkness(numbers, rows);
    if (separation_ > 0.0F)
        view_.loops.widen(how, law_, rows, count, closed);
    else
        set_widths_alone(numbers, rows);
    view_.loops.measure(rows, count, closed);
}

void HatchMarks::set_darkness(std::span<const std::uint32_t> numbers, const HatchRows& rows) const noexcept {
    const auto count = static_cast<std::int64_t>(numbers.size());
    const Style& style = item_.style;
    float* const darkness = rows[HatchRow::darkness];
    const LightTone light(style);
    if (taus_ != nullptr)
        for (std::int64_t i = 0; i < count; ++i) darkness[i] = 1.0F - taus_[numbers[static_cast<std::size_t>(i)]];
    else if (style.tone != Tone::light)
        std::fill_n(darkness, count, 1.0F);
    else if (light.exponent == 1.0F)
        for (std::int64_t i = 0; i < count; ++i) darkness[i] = 1.0F - light_tone(darkness[i], 1.0F, light.fill);
    else
        for (std::int64_t i = 0; i < count; ++i) darkness[i] = 1.0F - light(darkness[i]);
    const DepthTone depth_tone(style, view_.scene.lens.eye_per_world);
    for (std::int64_t i = 0; depth_tone.is_on && i < count; ++i) darkness[i] *= depth_tone(rows[HatchRow::distance][i]);
    if (taus_ != nullptr) borrow_darkness(count, darkness, rows);
}

// A callback is not asked for what faces away or is far outside: such a mark takes the darkness of one beside it.
void HatchMarks::borrow_darkness(std::int64_t count, float* darkness, const HatchRows& rows) const noexcept {
    const auto asked = [&](std::int64_t i) {
        return i >= 0 && i < count && rows[HatchRow::nu][i] < 0.0F && rows[HatchRow::picture_margin][i] >= 0.0F;
    };
    for (std::int64_t i = 0; i < count; ++i) {
        if (asked(i)) continue;
        darkness[i] = asked(i - 1) ? darkness[i - 1] : asked(i + 1) ? darkness[i + 1] : 1.0F;
    }
}

// The widths of lines whose distance from each other is not known go by the style's radius.
void HatchMarks::set_widths_alone(std::span<const std::uint32_t> numbers, const HatchRows& rows) const noexcept {
    const auto count = static_cast<std::int64_t>(numbers.size());
    const float* const darkness = rows[HatchRow::darkness];
    float* const coverage = rows[HatchRow::least]; // not needed yet
    view_.loops.coverage(law_, darkness, count, coverage);
    for (std::int64_t i = 0; i < count; ++i) {
        float& picture = rows[HatchRow::picture_margin][i];
        float& width = rows[HatchRow::width][i];
        rows[HatchRow::tone_margin][i] = darkness[i] - style_.hatch_tone_begin;
        rows[HatchRow::level_margin][i] = 1.0F;
        width = 0.0F;
        if (picture == hatch_nowhere || !(rows[HatchRow::nu][i] < hatch_tuning.widest_nu)) continue;
        width = 2.0F * run_.front_ink(numbers[static_cast<std::size_t>(i)], rows[HatchRow::pixels_per_unit][i]) *
                coverage[i] / style_.hatch_coverage_end;
        if (!(width < farthest)) picture = hatch_nowhere;
    }
}

// Marks of a gap are near, too, if the gap is so short in the picture that the line may go on over it. Where marks were
// left out the straight way counts. The marks before the first and after the last near one of a closed stroke are one
// gap.
void HatchMarks::keep_short_gaps(const HatchRows& rows, const HatchStroke& seen) const noexcept {
    const std::int64_t count = seen.number.size();
    float* const near = rows[HatchRow::near];
    const float* const leg = rows[HatchRow::leg];
    const float* const width = rows[HatchRow::width];
    const auto is_near = [&](std::int64_t i) { return near[i] >= 0.0F; };
    const auto is_short = [&](float way, float widest) {
        return way < 2.0F * (hatch_tuning.least_gap * widest + hatch_tuning.least_gap_pixels + hatch_tuning.step);
    };
    std::int64_t begin = 0; // the first near mark
    while (!is_near(begin)) ++begin;
    std::int64_t end = count; // after the last one
    while (!is_near(end - 1)) --end;
    for (std::int64_t i = begin; i < end; ++i) {
        if (is_near(i)) continue;
        const std::int64_t first = i;
        float way = leg[i];
        while (!is_near(i + 1)) way += leg[++i];
        way += leg[i + 1];
        if (is_short(way, std::max(width[first - 1], width[i + 1]))) std::fill(near + first, near + i + 1, 0.0F);
    }
    if (!has_seam(seen) || (begin == 0 && end == count)) return;
    const float way = std::accumulate(leg, leg + begin + 1, 0.0F) + std::accumulate(leg + end, leg + count, 0.0F);
    if (!is_short(way, std::max(width[begin], width[end - 1]))) return;
    std::fill(near, near + begin, 0.0F);
    std::fill(near + end, near + count, 0.0F);
}

// Keeps the near marks. A gap in them begins a new chain.
void HatchMarks::keep(const HatchRows& rows, HatchStroke& seen) const {
    static_assert(sizeof(HatchMark) == PackedMark::size * sizeof(float) && std::is_trivially_copyable_v<HatchMark>);
    const std::int64_t count = seen.number.size();
    float* const near = rows[HatchRow::near];
    const auto is_near = [](float margin) { return margin >= 0.0F; };
    seen.mark.clear();
    seen.ring = false;
    if (std::none_of(near, near + count, is_near)) return;
    if (is_unsteady())
        std::fill(near, near + count, 0.0F);
    else
        keep_short_gaps(rows, seen);
    base::resize_scratch(seen.mark, count + 1 + PackedMark::at_once);
    HatchMark* to = seen.mark.data();
    for (std::int64_t i = 0; i < count;) {
        const std::int64_t first = std::find_if(near + i, near + count, is_near) - near;
        i = std::find_if_not(near + first, near + count, is_near) - near;
        view_.loops.pack(rows.from(first), i - first, &to->x);
        if (to == seen.mark.data())
            seen.first_kept = first;
        else if (first < i)
            to->begins_chain = 1.0F;
        for (std::int64_t k = first; k < i; ++k, ++to) to->id = run_.first_id + seen.number[k];
    }
    const std::int64_t kept = to - seen.mark.data();
    if (has_seam(seen) && is_near(near[0]) && is_near(near[count - 1])) {
        // The line goes on over the seam. It begins after the first gap; without gaps it is a ring.
        HatchMark* const first =
            std::find_if(seen.mark.data(), to, [](const HatchMark& m) { return m.begins_chain > 0.0F; });
        seen.ring = first == to;
        if (seen.ring) {
            *to = seen.mark[0];
        } else {
            first->begins_chain = 0.0F;
            std::rotate(seen.mark.data(), first, to);
        }
    }
    seen.mark.resize(kept + (seen.ring ? 1 : 0));
}

// How the line ends at a place where its stroke does, and where creases may be. Marks of a pose are not where creases
// are.
StrokeEnd HatchMarks::end_at(std::int64_t last, std::int64_t before) const noexcept {
    if (item_.lines == nullptr || run_.position != run_.marks->position.data()) return StrokeEnd::open;
    const glm::dvec3 place_of_last(run_.position_of(run_.marks->mark_of(last)));
    const glm::dvec3 inner(run_.position_of(run_.marks->mark_of(before)));
    const double step = glm::distance(place_of_last, inner);
    return item_.lines->has_crease_near(item_.origin + place_of_last, step) ? StrokeEnd::crease : StrokeEnd::open;
}

void HatchMarks::set_ends(HatchStroke& seen) const noexcept {
    HRBFNPR_ASSERT(!seen.mark.empty());
    const auto id_at = [&](std::int64_t at) {
        return run_.first_id + static_cast<std::uint32_t>(run_.marks->mark_of(at));
    };
    const std::int64_t last = seen.first + seen.count - 1;
    seen.begins = seen.ends = StrokeEnd::open;
    seen.has_begin = !seen.closed && seen.mark[0].id == id_at(seen.first);
    seen.has_end = !seen.closed && seen.mark.back().id == id_at(last);
    if (seen.has_begin) seen.begins = end_at(seen.first, seen.first + 1);
    if (seen.has_end) seen.ends = end_at(last, last - 1);
}

} // namespace hrbfnpr::frame
