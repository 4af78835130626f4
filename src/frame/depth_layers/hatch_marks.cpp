// SPDX-License-Identifier: MIT
#include "frame/depth_layers/hatch_marks.h"

#include "frame/scene/tone.h"

#include <glm/gtc/matrix_access.hpp>

#include <cmath>

namespace hrbfnpr::frame {
namespace {

using marks::MarkBlock;

// Lines end where n . v is above this, just before the contour.
constexpr float last_nu = -0.03F;
// Of marks that face away by more than this, only that is asked.
constexpr float widest_nu = 0.2F;
// A stroke is closed if its ends are no farther apart than this, in steps from mark to mark, and go on into each other
// with at least this cosine.  Ends that are nearer than `same_place` are one mark.
constexpr float closed_gap = 1.5F;
constexpr float closed_cosine = 0.8F;
constexpr float same_place = 0.1F;
constexpr std::int64_t fewest_of_closed = 4;
// Places farther outside of the picture have no use, pixels.
constexpr float farthest = 1e6F;

// Published strokes branch where they like.
[[nodiscard]] bool has_separation(const marks::Layer& layer) noexcept {
    const bool grown =
        layer.kind == marks::Kind::principal || layer.kind == marks::Kind::combing || layer.kind == marks::Kind::field;
    return layer.report.step > 0.0 && (layer.progressive || !grown);
}

// The root of the largest eigenvalue of a symmetric matrix.
[[nodiscard]] float largest_stretch(float xx, float xy, float yy) noexcept {
    const float half = 0.5F * (xx - yy);
    return std::sqrt(0.5F * (xx + yy) + std::sqrt(half * half + xy * xy));
}

// A callback is not asked for what faces away or is far outside: there it is as beside it.
void borrow_darkness(std::span<HatchMark> marks) noexcept {
    const auto asked = [&](std::size_t i) {
        return i < marks.size() && marks[i].valid && marks[i].nu < 0.0F && marks[i].margin[3] >= 0.0F;
    };
    for (std::size_t i = 0; i < marks.size(); ++i) {
        if (asked(i)) continue;
        marks[i].darkness = i > 0 && asked(i - 1) ? marks[i - 1].darkness : asked(i + 1) ? marks[i + 1].darkness : 1.0F;
    }
}

[[nodiscard]] float dot3(const float* row, const glm::vec3& v) noexcept {
    return row[0] * v.x + row[1] * v.y + row[2] * v.z;
}

} // namespace

HatchMarks::HatchMarks(const Gather& gather, const Scene& scene, const Run& run, const float* taus) noexcept
    : gather_(gather), scene_(scene), run_(run), item_(scene.item_of(run)), seer_(gather.sight(run.item).seer),
      style_(*run.style), taus_(taus), levels_(0), shown_(255), separation_(0.0F),
      beyond_(std::min(style_.hatch_taper + 2.0F * style_.hatch_shortest + 4.0F * style_.hatch_spacing,
                       scene.lens.diagonal)) {
    const marks::LayerReport& report = run.marks->report;
    if (!has_separation(*run.marks)) return;
    levels_ = std::clamp(report.levels, 0, marks::most_levels);
    separation_ = static_cast<float>(std::ldexp(report.step / item_.unit, levels_));
    shown_ = most_level();
}

// Of the lines of any place of the item inside the picture: in a projection, dx = (row_x - x row_w) . d / w.  The
// largest stretch of that is convex in the place, so that it is greatest in a corner.
std::int32_t HatchMarks::most_level() const noexcept {
    const Lens& lens = scene_.lens;
    const glm::vec4 row = glm::row(lens.window, 3);
    const float scale = gather_.sight(run_.item).scale;
    const float nearest = glm::dot(row, glm::vec4(item_.to_eye * item_.centre + item_.eye_offset, 1.0F)) -
                          glm::length(glm::vec3(row)) * scale * item_.radius;
    if (!(nearest > 0.0F)) return levels_;
    const glm::vec4& v = lens.viewport;
    float stretch = 0.0F;
    for (const float x : {v.x - beyond_, v.x + v.z + beyond_}) {
        for (const float y : {v.y - beyond_, v.y + v.w + beyond_}) {
            const glm::vec3 a(glm::row(lens.window, 0) - x * row);
            const glm::vec3 b(glm::row(lens.window, 1) - y * row);
            stretch = std::max(stretch, largest_stretch(glm::dot(a, a), glm::dot(a, b), glm::dot(b, b)));
        }
    }
    const float coverage = style_.share * std::max(style_.hatch_coverage_begin, style_.hatch_coverage_end);
    return hatch_widths(style_, coverage, 1.001F * separation_ * scale * stretch / nearest, levels_).full + 1;
}

// A line may change its level.
bool HatchMarks::shows(std::int64_t stroke) const noexcept {
    const marks::Layer& marks = *run_.marks;
    const std::int64_t begin = marks.stroke_first[stroke];
    const std::int64_t end = marks.stroke_first[stroke + 1];
    if (end - begin < 2) return false;
    if (run_.directions != 3U && (run_.directions >> marks.direction_of(marks.mark_of(begin)) & 1U) == 0) return false;
    for (std::int64_t place = begin; place < end; ++place)
        if (marks.level[marks.mark_of(place)] <= shown_) return true;
    return false;
}

HatchMarks::Stroke HatchMarks::stroke_of(std::int64_t stroke) const noexcept {
    const std::int64_t first = run_.marks->stroke_first[stroke];
    const std::int64_t count = std::int64_t{run_.marks->stroke_first[stroke + 1]} - first;
    if (count < fewest_of_closed) return {first, count, false};
    const glm::vec3 begin = place(first);
    const glm::vec3 end = place(first + count - 1);
    const glm::vec3 leaves = place(first + 1) - begin;
    const glm::vec3 comes = end - place(first + count - 2);
    const float gap = glm::distance(begin, end);
    const float step = glm::length(leaves);
    if (gap <= same_place * step) return {first, count - 1, true};
    const auto goes_on = [&](const glm::vec3& v) {
        return glm::dot(v, begin - end) >= closed_cosine * gap * glm::length(v);
    };
    return {first, count, gap <= closed_gap * step && goes_on(leaves) && goes_on(comes)};
}

bool HatchMarks::see(std::int64_t stroke, base::Array<HatchMark>& marks) const {
    const Stroke s = stroke_of(stroke);
    marks.clear();
    marks.reserve(s.count + 1);
    marks.resize_for_overwrite(s.count);
    const std::span<HatchMark> all = marks.span();
    for (std::int64_t i = 0; i < s.count; i += Seen::most) {
        const std::int64_t count = std::min(Seen::most, s.count - i);
        see_part(s.first + i, all.subspan(static_cast<std::size_t>(i), static_cast<std::size_t>(count)));
    }
    if (taus_ != nullptr) borrow_darkness(all);
    for (std::int64_t i = 0; i < s.count; ++i) {
        if (!marks[i].valid || marks[i].nu >= widest_nu) continue;
        set_width(s, i, marks[i]);
        // Not where it is no number, as of a step from a bad file.
        marks[i].valid = marks[i].width < farthest;
    }
    if (s.closed) marks.push_back(marks[0]);
    return s.closed;
}

// At most Seen::most of them, from a place in the order of the strokes on.
void HatchMarks::see_part(std::int64_t first, std::span<HatchMark> marks) const noexcept {
    std::array<MarkBlock, Seen::most / MarkBlock::size> blocks{};
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const std::int64_t mark = run_.marks->mark_of(first + static_cast<std::int64_t>(i));
        MarkBlock& block = blocks[i / MarkBlock::size];
        const std::size_t at = i % MarkBlock::size;
        const glm::vec3 p = run_.place_of(mark, item_.unit);
        const glm::vec3 n = run_.normal_of(mark);
        block.x[at] = p.x, block.y[at] = p.y, block.z[at] = p.z;
        block.nx[at] = n.x, block.ny[at] = n.y, block.nz[at] = n.z;
    }
    Seen seen;
    gather_.loops().see(seer_, {blocks.data(), static_cast<std::int64_t>(marks.size())}, seen);
    take_places(seen, first, marks);
    set_darkness(seen, first, marks);
}

void HatchMarks::take_places(const Seen& seen, std::int64_t first, std::span<HatchMark> marks) const noexcept {
    for (std::size_t i = 0; i < marks.size(); ++i) {
        HatchMark& m = marks[i];
        m.x = seen.x[i];
        m.y = seen.y[i];
        m.window = seen.window[i];
        m.depth = seen.depth[i];
        m.pixels_per_unit = seen.pixels_per_unit[i];
        m.nu = seen.nu[i];
        m.width = 0.0F;
        m.id = run_.first_id + static_cast<std::uint32_t>(run_.marks->mark_of(first + static_cast<std::int64_t>(i)));
        m.margin = {1.0F, 1.0F, last_nu - m.nu, picture_margin(m.x, m.y)};
        // Everything is asked so that a value that is not a number answers "outside".
        m.valid = m.pixels_per_unit > 0.0F && m.window >= 0.0F && m.window <= 1.0F && std::abs(m.nu) <= 1.001F &&
                  m.margin[3] > -farthest;
    }
}

float HatchMarks::picture_margin(float x, float y) const noexcept {
    const glm::vec4& v = scene_.lens.viewport;
    return beyond_ + std::min({x - v.x, v.x + v.z - x, y - v.y, v.y + v.w - y});
}

void HatchMarks::set_darkness(const Seen& seen, std::int64_t first, std::span<HatchMark> marks) const noexcept {
    const Style& style = item_.style;
    const LightTone light(style);
    const bool by_depth = style.depth_min > 0.0 && style.depth_max > style.depth_min;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const std::int64_t mark = run_.marks->mark_of(first + static_cast<std::int64_t>(i));
        float tau = 0.0F;
        if (taus_ != nullptr)
            tau = taus_[mark];
        else if (style.tone == Tone::light)
            tau = light(run_.has_tone_normals() ? lit_of(item_, seer_, run_.tone_normal_of(mark)) : seen.lit[i]);
        float darkness = 1.0F - tau;
        if (by_depth)
            darkness *= depth_tone(static_cast<double>(seen.distance[i] / scene_.lens.eye_per_world), style.depth_min,
                                   style.depth_max);
        marks[i].darkness = darkness;
    }
}

void HatchMarks::set_width(const Stroke& stroke, std::int64_t i, HatchMark& mark) const noexcept {
    const float coverage = hatch_coverage(style_, mark.darkness);
    mark.margin[static_cast<std::size_t>(HatchEnd::tone)] = mark.darkness - style_.hatch_tone_begin;
    float& level_margin_there = mark.margin[static_cast<std::size_t>(HatchEnd::level)];
    const std::int64_t number = run_.marks->mark_of(stroke.first + i);
    if (!(separation_ > 0.0F)) {
        level_margin_there = 1.0F;
        mark.width = 2.0F * run_.front_ink(number, mark.pixels_per_unit) * coverage / style_.hatch_coverage_end;
        return;
    }
    const HatchWidths widths = hatch_widths(style_, coverage, spacing_at(stroke, i, mark), levels_);
    const std::int32_t level = run_.marks->level[number];
    level_margin_there = level_margin(widths, level);
    mark.width = hatch_width(widths, level);
}

// Of the lines of level 0, pixels: a parallelogram with one side along the line and one across it, on the surface, has
// an area and a base in the picture.  With parallel lines of sight that is separation |n . v| / sqrt(1 - (t . v)^2).
float HatchMarks::spacing_at(const Stroke& stroke, std::int64_t i, const HatchMark& mark) const noexcept {
    const std::int64_t last = stroke.count - 1;
    const std::int64_t before = i > 0 ? i - 1 : stroke.closed ? last : 0;
    const std::int64_t after = i < last ? i + 1 : stroke.closed ? 0 : last;
    const glm::vec3 along = place(stroke.first + after) - place(stroke.first + before);
    const glm::vec3 across = glm::cross(run_.normal_of(run_.marks->mark_of(stroke.first + i)), along);
    const auto image = [&](const glm::vec3& v) {
        const float w = dot3(seer_.clip[3], v);
        return glm::vec2(dot3(seer_.clip[0], v) - mark.x * w, dot3(seer_.clip[1], v) - mark.y * w) *
               (mark.pixels_per_unit / seer_.pixels);
    };
    const glm::vec2 a = image(along);
    const glm::vec2 b = image(across);
    const float base = glm::length(a) * glm::length(across);
    return base > 0.0F ? separation_ * std::abs(a.x * b.y - a.y * b.x) / base : 0.0F;
}

} // namespace hrbfnpr::frame
