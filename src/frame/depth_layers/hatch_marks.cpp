// SPDX-License-Identifier: MIT
#include "frame/depth_layers/hatch_marks.h"

#include "base/scratch.h"
#include "frame/scene/tone.h"

#include <glm/gtc/matrix_access.hpp>

#include <cmath>
#include <numeric>
#include <utility>

namespace hrbfnpr::frame {
namespace {

// Lines end where n . v is above this, just before the contour.
constexpr float last_nu = -0.03F;
// Of marks that face away by more than this, only that is asked.
constexpr float widest_nu = 0.2F;
// What is known of a whole piece holds for its marks up to rounding.
constexpr float smallest_margin = 1e-3F;
// A stroke is closed if its ends are no farther apart than this, in steps from mark to mark, and go on into each other
// with at least this cosine.  Ends that are nearer than `same_place` are one mark.
constexpr float closed_gap = 1.5F;
constexpr float closed_cosine = 0.8F;
constexpr float same_place = 0.1F;
constexpr std::int64_t fewest_of_closed = 4;
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

// Of the image of a length of 1 where w is 1, pixels, so many of them around the picture: in a projection,
// dx = (row_x - x row_w) . d / w.  The largest stretch of that is convex in the place, so that it is greatest in a
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

// Four sums, so that none waits for the one before.
[[nodiscard]] float sum(const float* terms, std::int64_t count) noexcept {
    std::array<float, 4> sums{};
    std::int64_t at = 0;
    for (; at + 4 <= count; at += 4)
        for (std::size_t k = 0; k < 4; ++k) sums[k] += terms[at + static_cast<std::int64_t>(k)];
    for (; at < count; ++at) sums[0] += terms[at];
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

// Of at least `count` marks.
[[nodiscard]] HatchRows rows_of(std::int64_t count, base::Array<float>& memory) {
    const std::int64_t stride = count + 2 * HatchRows::slack;
    const std::int64_t all = static_cast<std::int64_t>(HatchRow::rows) * stride;
    if (memory.size() < all) base::resize_scratch(memory, all);
    return {memory.data() + HatchRows::slack, stride};
}

// Of marks in a gap.
[[nodiscard]] float most_open(const HatchRows& rows, std::int64_t count) noexcept {
    const auto openness = [&](std::int64_t i) {
        return hatch_openness(rows[HatchRow::tone_margin][i], rows[HatchRow::level_margin][i],
                              std::min(rows[HatchRow::rim_margin][i], rows[HatchRow::picture_margin][i]));
    };
    if (count == 0) return 0.0F;
    float most = openness(count / 2); // of most gaps that is enough
    for (std::int64_t i = 0; i < count && most < 1.0F; ++i) most = std::max(most, openness(i));
    return most;
}

[[nodiscard]] float least_alone(const HatchRows& rows, std::int64_t count) noexcept {
    float least = 1.0F;
    for (std::int64_t i = 0; i < count; ++i)
        least = std::min(least, hatch_level_alone(rows[HatchRow::tone_margin][i], rows[HatchRow::rim_margin][i]));
    return least;
}

} // namespace

HatchMarks::HatchMarks(const Gather& gather, const HatchLoops& loops, const Scene& scene, const Run& run,
                       const float* taus) noexcept
    : gather_(gather), loops_(loops), scene_(scene), run_(run), item_(scene.item_of(run)),
      sight_(gather.sight(run.item)), seer_(sight_.seer), style_(*run.style), taus_(taus), levels_(0),
      per_unit_(1.0 / item_.unit), separation_(0.0F),
      limits_(loops, run, item_, sight_, taus == nullptr && item_.style.tone == Tone::light,
              style_.hatch_tone_begin - 1.0F / openness_of_tone),
      beyond_(
          std::min(style_.hatch_taper + 2.0F * shortest_filling * style_.hatch_shortest + 4.0F * style_.hatch_spacing,
                   scene.lens.diagonal)),
      stretch_(0.0F), shown_(255), most_coverage_{} {
    const marks::LayerReport& report = run.marks->report;
    if (!has_separation(*run.marks)) return;
    levels_ = std::clamp(report.levels, 0, marks::most_levels);
    separation_ = static_cast<float>(std::ldexp(report.step / item_.unit, levels_));
    stretch_ = sight_.scale * largest_stretch(scene.lens, beyond_);
    set_most_coverage();
    shown_ = most_level();
}

void HatchMarks::set_most_coverage() noexcept {
    float most = 0.0F;
    for (std::size_t i = 0; i <= steps; ++i) {
        most = std::max(most, hatch_coverage(style_, static_cast<float>(i) / static_cast<float>(steps)));
        most_coverage_[i] = most;
    }
}

// Of the lines of any place of the item inside the picture.
std::int32_t HatchMarks::most_level() const noexcept {
    const glm::vec4 row = glm::row(scene_.lens.window, 3);
    const float nearest = glm::dot(row, glm::vec4(item_.to_eye * item_.centre + item_.eye_offset, 1.0F)) -
                          glm::length(glm::vec3(row)) * sight_.scale * item_.radius;
    std::int32_t level = levels_;
    while (level > 0 && !has_room(level, nearest, 1.0F)) --level;
    return level;
}

// Whether there may be room for lines of a level, the next one to those that are drawn full, where no mark is darker
// and nearer.  Nearest: w of a place in the picture's projection.
bool HatchMarks::has_room(std::int32_t level, float nearest, float darkness) const noexcept {
    if (level <= 1 || !(nearest > 0.0F)) return true;
    const auto step = static_cast<std::size_t>(std::ceil(std::clamp(darkness, 0.0F, 1.0F) * static_cast<float>(steps)));
    const float wanted = std::max(style_.hatch_spacing, style_.hatch_pen / most_coverage_[step]);
    return !(1.001F * separation_ * stretch_ < std::ldexp(wanted, level - 1) * nearest);
}

// Whether a mark of the piece may be drawn: it is not known to be too light, to be of a level that there is no room
// for, to face away or to lie outside.
bool HatchMarks::may_draw(const marks::StrokePiece& piece) const noexcept {
    if (piece.level > shown_ || faces_away(piece, sight_)) return false;
    const ClusterView view = view_cluster(piece, sight_, scene_.lens, gather_.frustum(), beyond_ + smallest_margin);
    if (view.outside || view.nu_min > last_nu + smallest_margin) return false;
    const float darkness = most_darkness(piece) + smallest_margin;
    if (darkness < style_.hatch_tone_begin - 1.0F / openness_of_tone) return false; // all of it is an open gap
    return !(separation_ > 0.0F) || has_room(piece.level, view.nearest, darkness);
}

// What set_darkness() sets for marks of the piece is no larger.
float HatchMarks::most_darkness(const marks::StrokePiece& piece) const noexcept {
    if (taus_ != nullptr || item_.style.tone != Tone::light) return 1.0F;
    return 1.0F - light_tone(least_lit(piece, sight_), static_cast<float>(item_.style.tone_exponent));
}

// A closed stroke's last mark may lie where its first one does.
void HatchMarks::set_ends(std::int64_t stroke, HatchStroke& seen) const noexcept {
    seen.first = run_.marks->stroke_first[stroke];
    seen.count = std::int64_t{run_.marks->stroke_first[stroke + 1]} - seen.first;
    seen.closed = false;
    if (seen.count < fewest_of_closed) return;
    const glm::vec3 begin = place(seen.first);
    const glm::vec3 end = place(seen.first + seen.count - 1);
    const glm::vec3 leaves = place(seen.first + 1) - begin;
    const glm::vec3 comes = end - place(seen.first + seen.count - 2);
    const float gap = glm::distance(begin, end);
    const float step = glm::length(leaves);
    const bool same = gap <= same_place * step;
    const auto goes_on = [&](const glm::vec3& v) {
        return glm::dot(v, begin - end) >= closed_cosine * gap * glm::length(v);
    };
    seen.closed = same || (gap <= closed_gap * step && goes_on(leaves) && goes_on(comes));
    if (same) --seen.count;
}

bool HatchMarks::see(std::int64_t stroke, std::int64_t piece, HatchStroke& seen) const {
    const marks::Layer& layer = *run_.marks;
    const std::int64_t first = layer.stroke_first[stroke];
    const std::int64_t count = std::int64_t{layer.stroke_first[stroke + 1]} - first;
    if (count < 2) return false;
    if (run_.directions != 3U && (run_.directions >> layer.direction_of(layer.mark_of(first)) & 1U) == 0) return false;
    if (!find_pieces(piece, marks::pieces_of(count), seen)) return false;
    set_ends(stroke, seen);
    if (!find_marks(piece, seen)) return false;
    find_ranges(seen);
    const HatchRows rows = load(seen);
    see_rows(seen.number.span(), rows, seen.closed);
    keep(rows, seen);
    return !seen.mark.empty();
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

// Marks whose places follow each other.
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
            loops_.load(all + 3 * begin, count, factor, other, row.first, y, z);
            return;
        }
        for (std::int64_t i = 0; i < count; ++i)
            loops_.load(all + 3 * std::int64_t{numbers[i]}, 1, factor, other, row.first + i, y + i, z + i);
    };
    // Two factors, since there are units whose inverse is too large for a float.
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

HatchSight HatchMarks::sight() const noexcept {
    const glm::vec4& v = scene_.lens.viewport;
    return {&seer_, run_.has_tone_normals(), separation_, v.x, v.y, v.x + v.z, v.y + v.w, beyond_, last_nu, farthest};
}

HatchLaw HatchMarks::law() const noexcept {
    HatchLaw law{};
    law.tone_begin = style_.hatch_tone_begin;
    law.tone_span = style_.hatch_tone_end - style_.hatch_tone_begin;
    law.share = style_.share;
    law.coverage_begin = style_.hatch_coverage_begin;
    law.coverage_rise = style_.hatch_coverage_end - style_.hatch_coverage_begin;
    std::copy(hollow.begin(), hollow.end(), law.hollow);
    law.spacing = style_.hatch_spacing;
    law.pen = style_.hatch_pen;
    law.white = style_.hatch_white;
    law.levels = static_cast<float>(levels_);
    law.thinnest_fading = thinnest_fading;
    law.fading_ramp = fading_ramp;
    law.nearly_full = nearly_full;
    law.per_tone_span = 1.0F / law.tone_span;
    law.per_spacing = 1.0F / law.spacing;
    law.per_pen = 1.0F / law.pen;
    law.per_fading_ramp = 1.0F / law.fading_ramp;
    law.per_rest = 1.0F / (1.0F - law.nearly_full);
    law.widest_nu = widest_nu;
    law.widest = farthest;
    return law;
}

void HatchMarks::see_rows(std::span<const std::uint32_t> numbers, const HatchRows& rows, bool closed) const noexcept {
    const auto count = static_cast<std::int64_t>(numbers.size());
    for (const HatchRow row : {HatchRow::x, HatchRow::y, HatchRow::z}) { // beside the first and the last one
        rows[row][-1] = rows[row][closed ? count - 1 : 0];
        rows[row][count] = rows[row][closed ? 0 : count - 1];
    }
    const HatchSight how = sight();
    gather_.loops().see_rows(seer_,
                             {rows[HatchRow::x], rows[HatchRow::y], rows[HatchRow::z], rows[HatchRow::normal_x],
                              rows[HatchRow::normal_y], rows[HatchRow::normal_z], count},
                             {rows[HatchRow::left], rows[HatchRow::top], rows[HatchRow::window], rows[HatchRow::depth],
                              rows[HatchRow::pixels_per_unit], rows[HatchRow::nu], rows[HatchRow::darkness],
                              rows[HatchRow::side_x], rows[HatchRow::side_y], rows[HatchRow::distance]});
    loops_.place(how, rows, count);
    set_darkness(numbers, rows);
    if (separation_ > 0.0F)
        loops_.widen(how, law(), rows, count, closed);
    else
        set_widths_alone(numbers, rows);
    loops_.measure(rows, count, closed);
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
    if (style.depth_min > 0.0 && style.depth_max > style.depth_min)
        for (std::int64_t i = 0; i < count; ++i)
            darkness[i] *= depth_tone(static_cast<double>(rows[HatchRow::distance][i] / scene_.lens.eye_per_world),
                                      style.depth_min, style.depth_max);
    if (taus_ != nullptr) borrow_darkness(count, darkness, rows);
}

// A callback is not asked for what faces away or is far outside: there it is as beside it.
void HatchMarks::borrow_darkness(std::int64_t count, float* darkness, const HatchRows& rows) const noexcept {
    const auto asked = [&](std::int64_t i) {
        return i >= 0 && i < count && rows[HatchRow::nu][i] < 0.0F && rows[HatchRow::picture_margin][i] >= 0.0F;
    };
    for (std::int64_t i = 0; i < count; ++i) {
        if (asked(i)) continue;
        darkness[i] = asked(i - 1) ? darkness[i - 1] : asked(i + 1) ? darkness[i + 1] : 1.0F;
    }
}

// Of lines whose distance from each other is not known.
void HatchMarks::set_widths_alone(std::span<const std::uint32_t> numbers, const HatchRows& rows) const noexcept {
    for (std::int64_t i = 0; i < static_cast<std::int64_t>(numbers.size()); ++i) {
        const float dark = rows[HatchRow::darkness][i];
        float& picture = rows[HatchRow::picture_margin][i];
        float& width = rows[HatchRow::width][i];
        rows[HatchRow::tone_margin][i] = dark - style_.hatch_tone_begin;
        rows[HatchRow::level_margin][i] = 1.0F;
        width = 0.0F;
        if (picture == hatch_nowhere || !(rows[HatchRow::nu][i] < widest_nu)) continue;
        width = 2.0F * run_.front_ink(numbers[static_cast<std::size_t>(i)], rows[HatchRow::pixels_per_unit][i]) *
                hatch_coverage(style_, dark) / style_.hatch_coverage_end;
        if (!(width < farthest)) picture = hatch_nowhere;
    }
}

// One after the other, each with its leg.
void HatchMarks::put_marks(const HatchRows& rows, const std::uint32_t* numbers, std::int64_t count,
                           HatchMark* to) const noexcept {
    static_assert(sizeof(HatchMark) == PackedMark::size * sizeof(float) && std::is_trivially_copyable_v<HatchMark>);
    loops_.pack(rows, count, &to->x);
    for (std::int64_t i = 0; i < count; ++i) to[i].id = run_.first_id + numbers[i];
}

// Those that are drawn and the two on either side, if any are.
void HatchMarks::keep(const HatchRows& rows, HatchStroke& seen) const {
    const std::int64_t count = seen.number.size();
    const float* const near = rows[HatchRow::near];
    const float* const leg = rows[HatchRow::leg];
    const auto is_near = [](float margin) { return margin >= 0.0F; };
    seen.mark.clear();
    if (std::none_of(near, near + count, is_near)) return;
    const bool all = has_hand();
    base::resize_scratch(seen.mark, count + PackedMark::at_once); // room for all of them
    HatchMark* to = seen.mark.data();
    float way = 0.0F;
    float passed = 0.0F;
    float alone = 1.0F;
    const HatchStroke::Range* range = seen.range.begin();
    std::int64_t leap = range->end - range->begin; // the row at which the next range begins
    const auto next_range = [&] {
        ++range;
        leap += range == seen.range.end() ? count : range->end - range->begin;
    };
    const auto is_kept = [&](std::int64_t i) { return all || is_near(near[i]); };
    for (std::int64_t i = 0; i < count;) {
        std::int64_t first = i;
        while (i < count && !is_kept(i)) ++i;
        way += sum(leg + first, i - first);
        passed = std::max(passed, leap <= i && leap < count ? 1.0F : most_open(rows.from(first), i - first));
        if (passed < 1.0F) alone = std::min(alone, least_alone(rows.from(first), i - first));
        while (leap <= i && leap < count) next_range();
        first = i;
        while (i < count && is_kept(i)) ++i;
        if (first == i) continue;
        put_marks(rows.from(first), seen.number.data() + first, i - first, to);
        to->way += std::exchange(way, 0.0F);
        to->passed = std::exchange(passed, 0.0F);
        to->passed_alone = std::exchange(alone, 1.0F);
        while (leap < i) {
            to[leap - first].passed = 1.0F;
            next_range();
        }
        to += i - first;
    }
    if (seen.closed) {
        seen.mark[0].way += way;
        seen.mark[0].passed = std::max(seen.mark[0].passed, passed);
        seen.mark[0].passed_alone = std::min(seen.mark[0].passed_alone, alone);
        *to++ = seen.mark[0];
    }
    seen.mark.resize(to - seen.mark.data());
}

} // namespace hrbfnpr::frame
