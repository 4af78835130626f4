// SPDX-License-Identifier: MIT
#include "frame/depth_layers/hatch_marks.h"

#include "frame/scene/tone.h"

#include <glm/gtc/matrix_access.hpp>

#include <cmath>
#include <utility>

namespace hrbfnpr::frame {
namespace {

using marks::MarkBlock;

// Lines end where n . v is above this, just before the contour.
constexpr float last_nu = -0.03F;
// Of marks that face away by more than this, only that is asked.
constexpr float widest_nu = 0.2F;
// What is known of a whole piece holds for its marks up to rounding.
constexpr float smallest_margin = 1e-3F;
// Marks around a piece: the first one that is not drawn, and the next one, for its tangent.
constexpr std::int64_t around_piece = 2;
// Marks that are nearer to each other in the picture than so many pens are not all seen.
constexpr float widest_step = 6.0F;
constexpr std::int64_t longest_stride = 8; // a part of a piece
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
    : gather_(gather), scene_(scene), run_(run), item_(scene.item_of(run)), sight_(gather.sight(run.item)),
      seer_(sight_.seer), style_(*run.style), taus_(taus), levels_(0), per_unit_(1.0 / item_.unit), separation_(0.0F),
      beyond_(
          std::min(style_.hatch_taper + 2.0F * shortest_filling * style_.hatch_shortest + 4.0F * style_.hatch_spacing,
                   scene.lens.diagonal)),
      stretch_(0.0F), shown_(255) {
    const marks::LayerReport& report = run.marks->report;
    if (!has_separation(*run.marks)) return;
    levels_ = std::clamp(report.levels, 0, marks::most_levels);
    separation_ = static_cast<float>(std::ldexp(report.step / item_.unit, levels_));
    stretch_ = sight_.scale * largest_stretch(scene.lens, beyond_);
    shown_ = most_level();
}

// Of the lines of any place of the item inside the picture.
std::int32_t HatchMarks::most_level() const noexcept {
    const glm::vec4 row = glm::row(scene_.lens.window, 3);
    const float nearest = glm::dot(row, glm::vec4(item_.to_eye * item_.centre + item_.eye_offset, 1.0F)) -
                          glm::length(glm::vec3(row)) * sight_.scale * item_.radius;
    return most_level(nearest, 1.0F);
}

// Nearest: w of a place in the picture's projection.
std::int32_t HatchMarks::most_level(float nearest, float darkness) const noexcept {
    if (!(nearest > 0.0F)) return levels_;
    const float coverage = darkness < 1.0F
                               ? hatch_coverage(style_, darkness)
                               : style_.share * std::max(style_.hatch_coverage_begin, style_.hatch_coverage_end);
    return hatch_widths(style_, coverage, 1.001F * separation_ * stretch_ / nearest, levels_).full + 1;
}

// Whether a mark of the piece may be drawn: it is not known to be too light, to be of a level that there is no room
// for, to face away or to lie outside.  Then the stride is made as small as the piece needs.
bool HatchMarks::may_draw(const marks::StrokePiece& piece, std::int64_t& stride) const noexcept {
    if (piece.level > shown_) return false;
    const ClusterView view = view_cluster(piece, sight_, scene_.lens, gather_.frustum(), beyond_ + smallest_margin);
    if (view.outside || view.nu_min > last_nu + smallest_margin) return false;
    const float darkness = most_darkness(view) + smallest_margin;
    if (darkness < style_.hatch_tone_begin) return false;
    if (separation_ > 0.0F && piece.level > most_level(view.nearest, darkness)) return false;
    stride = std::min(stride, stride_of(piece, view.nearest));
    return true;
}

// A power of two, by which marks of the piece are hardly farther apart than the points of a line.
std::int64_t HatchMarks::stride_of(const marks::StrokePiece& piece, float nearest) const noexcept {
    const float step =
        2.0F * piece.radius * sight_.scale * scene_.lens.pixels / static_cast<float>(std::max(piece.count - 1, 1));
    const float most = widest_step * style_.hatch_pen * nearest;
    std::int64_t stride = 1;
    while (stride < longest_stride && 2.0F * static_cast<float>(stride) * step <= most) stride *= 2;
    return stride;
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

// Those of the pieces that may be drawn, and around each of them the marks that its ends and its tangents there need.
void HatchMarks::find_places(HatchStroke& seen) const {
    const std::int64_t end = seen.first + seen.count;
    const std::int64_t around = around_piece * seen.stride;
    const auto add = [&](std::int64_t from, std::int64_t to) {
        from = std::max(from, seen.place.empty() ? seen.first : seen.place.back() + seen.stride);
        for (to = std::min(to, end); from < to; from += seen.stride) seen.place.push_back(from);
    };
    seen.place.clear();
    if (seen.closed && seen.may_draw.back()) add(seen.first, seen.first + around);
    for (std::int64_t k = 0; k < seen.may_draw.size(); ++k) {
        const std::int64_t from = seen.first + k * marks::StrokePiece::most;
        if (seen.may_draw[k]) add(from - around, from + marks::StrokePiece::most + around);
    }
    const std::int64_t last = seen.first + (seen.count - 1) / seen.stride * seen.stride;
    if (seen.closed && seen.may_draw[0]) add(last - around, end);
    // An open one ends where it ends.
    if (!seen.closed && seen.place.back() == last && last + 1 < end) seen.place.push_back(end - 1);
}

bool HatchMarks::see(std::int64_t stroke, std::int64_t piece, HatchStroke& seen) const {
    const marks::Layer& layer = *run_.marks;
    const std::int64_t first = layer.stroke_first[stroke];
    const std::int64_t count = std::int64_t{layer.stroke_first[stroke + 1]} - first;
    if (count < 2) return false;
    if (run_.directions != 3U && (run_.directions >> layer.direction_of(layer.mark_of(first)) & 1U) == 0) return false;
    seen.may_draw.clear();
    seen.stride = longest_stride;
    bool any = false;
    for (std::int64_t k = 0; k < marks::pieces_of(count); ++k) {
        seen.may_draw.push_back(may_draw(run_.clusters->piece[piece + k], seen.stride));
        any = any || seen.may_draw.back();
    }
    if (!any) return false;
    // An unsteady hand goes by the numbers of the marks, and past where the tone ends.
    if (style_.hatch_wobble > 0.0F || style_.hatch_overshoot > 0.0F) {
        std::fill(seen.may_draw.begin(), seen.may_draw.end(), true);
        seen.stride = 1;
    }
    set_ends(stroke, seen);
    find_places(seen);
    see_marks(seen);
    if (seen.closed) seen.mark.push_back(seen.mark[0]);
    return true;
}

void HatchMarks::see_marks(HatchStroke& seen) const {
    const std::int64_t count = seen.place.size();
    seen.mark.clear();
    seen.mark.reserve(count + 1);
    seen.mark.resize_for_overwrite(count);
    const std::span<HatchMark> all = seen.mark.span();
    for (std::int64_t i = 0; i < count; i += Seen::most)
        see_part(seen, i,
                 all.subspan(static_cast<std::size_t>(i), static_cast<std::size_t>(std::min(Seen::most, count - i))));
    if (taus_ != nullptr) borrow_darkness(all);
    set_widths(all);
    if (!seen.closed) return;
    for (std::size_t k = 0; k < std::min<std::size_t>(around_piece, all.size()); ++k) { // beside each other
        set_width(all[k]);
        set_width(all[all.size() - 1 - k]);
    }
}

// A width takes a while, and is asked only where a mark may be drawn and next to that.
void HatchMarks::set_widths(std::span<HatchMark> marks) const noexcept {
    constexpr auto reach = static_cast<std::size_t>(around_piece);
    std::size_t end = 0; // of the marks that have theirs
    for (std::size_t i = 0; i < marks.size(); ++i) {
        HatchMark& own = marks[i];
        own.margin[static_cast<std::size_t>(HatchEnd::tone)] = own.darkness - style_.hatch_tone_begin;
        if (!own.is_drawn()) continue; // whatever its level
        const std::size_t begin = i < reach ? 0 : i - reach;
        const std::size_t after = std::min(i + 1 + reach, marks.size());
        for (std::size_t k = std::max(begin, end); k < after; ++k) set_width(marks[k]);
        end = std::max(end, after);
    }
}

// At most Seen::most of the stroke's marks that are seen, from the one of that number on.
void HatchMarks::see_part(const HatchStroke& stroke, std::int64_t begin, std::span<HatchMark> marks) const noexcept {
    std::array<MarkBlock, Seen::most / MarkBlock::size> blocks;
    const auto count = static_cast<std::int64_t>(marks.size());
    const std::int64_t* const places = stroke.place.data() + begin;
    for (std::int64_t i = 0; i < count; ++i) {
        MarkBlock& block = blocks[static_cast<std::size_t>(i / MarkBlock::size)];
        const std::int64_t slot = i % MarkBlock::size;
        const glm::vec3 p = place(places[i]);
        const glm::vec3 n = run_.normal_of(run_.marks->mark_of(places[i]));
        block.x[slot] = p.x, block.y[slot] = p.y, block.z[slot] = p.z;
        block.nx[slot] = n.x, block.ny[slot] = n.y, block.nz[slot] = n.z;
    }
    Seen seen;
    gather_.loops().see(seer_, {blocks.data(), count}, seen);
    take_places(seen, places, marks);
    set_darkness(seen, places, marks);
    if (separation_ > 0.0F) set_spacing(stroke, begin, {blocks.data(), count}, marks);
}

void HatchMarks::take_places(const Seen& seen, const std::int64_t* places, std::span<HatchMark> marks) const noexcept {
    for (std::size_t i = 0; i < marks.size(); ++i) {
        HatchMark& m = marks[i];
        m.x = seen.x[i];
        m.y = seen.y[i];
        m.window = seen.window[i];
        m.depth = seen.depth[i];
        m.pixels_per_unit = seen.pixels_per_unit[i];
        m.nu = seen.nu[i];
        m.side_x = seen.side_x[i];
        m.side_y = seen.side_y[i];
        m.width = 0.0F;
        m.id = run_.first_id + static_cast<std::uint32_t>(run_.marks->mark_of(places[i]));
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

void HatchMarks::set_darkness(const Seen& seen, const std::int64_t* places, std::span<HatchMark> marks) const noexcept {
    const Style& style = item_.style;
    const LightTone light(style);
    const bool by_depth = style.depth_min > 0.0 && style.depth_max > style.depth_min;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        float tau = 0.0F;
        if (taus_ != nullptr)
            tau = taus_[run_.marks->mark_of(places[i])];
        else if (style.tone == Tone::light)
            tau = light(run_.has_tone_normals()
                            ? lit_of(item_, seer_, run_.tone_normal_of(run_.marks->mark_of(places[i])))
                            : seen.lit[i]);
        float darkness = 1.0F - tau;
        if (by_depth)
            darkness *= depth_tone(static_cast<double>(seen.distance[i] / scene_.lens.eye_per_world), style.depth_min,
                                   style.depth_max);
        marks[i].darkness = darkness;
    }
}

// What set_darkness() sets for marks that are seen like this is no larger.
float HatchMarks::most_darkness(const ClusterView& view) const noexcept {
    if (taus_ != nullptr || item_.style.tone != Tone::light || run_.has_tone_normals()) return 1.0F;
    return 1.0F - light_tone(view.lit_min, static_cast<float>(item_.style.tone_exponent));
}

void HatchMarks::set_width(HatchMark& mark) const noexcept {
    if (!mark.valid || mark.nu >= widest_nu) return;
    const float coverage = hatch_coverage(style_, mark.darkness);
    const std::int64_t number = mark.id - run_.first_id;
    if (!(separation_ > 0.0F)) {
        mark.width = 2.0F * run_.front_ink(number, mark.pixels_per_unit) * coverage / style_.hatch_coverage_end;
    } else {
        const HatchWidths widths = hatch_widths(style_, coverage, mark.spacing, levels_);
        const std::int32_t level = run_.marks->level[number];
        mark.margin[static_cast<std::size_t>(HatchEnd::level)] = level_margin(widths, level);
        mark.width = hatch_width(widths, level);
    }
    // Not where it is no number, as of a step from a bad file.
    mark.valid = mark.width < farthest;
}

// Of the lines of level 0, pixels: a parallelogram with one side along the line and one across it, on the surface, has
// an area and a base in the picture.  With parallel lines of sight that is separation |n . v| / sqrt(1 - (t . v)^2).
void HatchMarks::set_spacing(const HatchStroke& stroke, std::int64_t begin, const MarkRange& range,
                             std::span<HatchMark> marks) const noexcept {
    const base::Array<std::int64_t>& places = stroke.place;
    const auto seen_place = [&](std::int64_t i) {
        const MarkBlock& b = range.blocks[i / MarkBlock::size];
        const std::int64_t slot = i % MarkBlock::size;
        return glm::vec3(b.x[slot], b.y[slot], b.z[slot]);
    };
    const std::int64_t end = begin + range.count;
    glm::vec3 at = seen_place(0);
    glm::vec3 before = begin > 0 ? place(places[begin - 1]) : stroke.closed ? place(places[places.size() - 1]) : at;
    for (std::int64_t i = 0; i < range.count; ++i) {
        const glm::vec3 after = i + 1 < range.count   ? seen_place(i + 1)
                                : end < places.size() ? place(places[end])
                                : stroke.closed       ? place(places[0])
                                                      : at;
        const MarkBlock& b = range.blocks[i / MarkBlock::size];
        const std::int64_t slot = i % MarkBlock::size;
        HatchMark& mark = marks[static_cast<std::size_t>(i)];
        if (mark.valid && mark.nu < widest_nu)
            mark.spacing = spacing_at(after - before, {b.nx[slot], b.ny[slot], b.nz[slot]}, mark);
        before = std::exchange(at, after);
    }
}

float HatchMarks::spacing_at(const glm::vec3& along, const glm::vec3& normal, const HatchMark& mark) const noexcept {
    const glm::vec3 across = glm::cross(normal, along);
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
