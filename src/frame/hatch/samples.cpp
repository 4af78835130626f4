// SPDX-License-Identifier: MIT
// sample_strokes, stroke by stroke:
//
// 1. see_stroke finds the pieces and marks that may be drawn, loads them and the marks around them into rows of
//    numbers, finds where they are and how wide their line is, and fills HatchStroke with the marks near drawn places.
// 2. sample_stroke makes even samples along smooth curves through chains of marks.
#include "frame/hatch/points.h"

#include "base/assert.h"
#include "base/prefetch.h"
#include "base/scratch.h"
#include "features/line_set.h"
#include "frame/hatch/hand.h"
#include "frame/hatch/tuning.h"

#include <glm/gtc/matrix_access.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <utility>

namespace hrbfnpr::frame {
namespace {

// The allowed rounding error of the bounds of a piece.
constexpr float rounding_of_margins = 1e-3F;
constexpr float rounding_of_darkness = 1e-4F;
constexpr float most_length = 1.01F; // The largest length of a unit normal, with rounding.

// Returns the largest length in pixels that a length of 1 can have in the picture, where w is 1, within `beyond` pixels
// around the picture. In a projection dx = (row_x - x row_w) . d / w. The largest stretch is a convex function of the
// position, so it occurs at a corner.
[[nodiscard]] float largest_stretch(const Lens& lens, float beyond) noexcept {
    const glm::vec4 row = glm::row(lens.window, 3);
    const glm::vec4& v = lens.viewport;
    float stretch = 0.0F;
    for (const float x : {v.x - beyond, v.x + v.z + beyond}) {
        for (const float y : {v.y - beyond, v.y + v.w + beyond}) {
            const glm::vec3 a(glm::row(lens.window, 0) - x * row);
            const glm::vec3 b(glm::row(lens.window, 1) - y * row);
            // This is the largest singular value of the matrix with rows a and b.
            const float half = 0.5F * (glm::dot(a, a) - glm::dot(b, b));
            const float mean = 0.5F * (glm::dot(a, a) + glm::dot(b, b));
            stretch = std::max(stretch, std::sqrt(mean + std::sqrt(half * half + glm::dot(a, b) * glm::dot(a, b))));
        }
    }
    return stretch;
}

// The data for finding how the strokes of one run look.
struct RunSight {
    const HatchView& view;
    const Run& run;
    const ItemView& item;
    const ItemSight& sight;
    const LayerStyle& style;
    const float* taus;
    std::int32_t levels;      // the index of the finest level
    double per_unit;          // 1 / the item's unit, a power of two
    const float* tone_normal; // The normals that bound the light: the normals of the marks, or their normals for tone.
    bool has_bounds;          // true if marks can be skipped by their normals
    // True if the hand is unsteady. Then all marks are loaded: a wobble needs their indices along the stroke, and an
    // overshoot continues beyond the end of the tone.
    bool is_unsteady;
    float beyond; // the width of the strip around the picture in which lines may end unseen, in pixels
    HatchLights lights;
    HatchWidthLaw law{};
    // Marks whose n . l is larger than this are too light to be drawn.
    float lightest = std::numeric_limits<float>::infinity();
    float separation = 0.0F;  // the separation of the lines of level 0, in the item's unit; 0 if not known
    float stretch = 0.0F;     // the largest length in the picture, in pixels, of a unit length at the distance 1
    std::int32_t shown = 255; // the finest level that may be visible in this view
    static constexpr std::size_t steps = 16;
    std::array<float, steps + 1> most_coverage{}; // for each k: the largest coverage for darknesses up to k / steps
};

// Returns whether there may be space for lines of a level. No mark is darker than `darkness`, and none has a smaller
// clip coordinate w than `nearest`.
bool has_room(const RunSight& v, std::int32_t level, float nearest, float darkness) noexcept {
    if (level <= 1 || !(nearest > 0.0F)) return true;
    const auto step =
        static_cast<std::size_t>(std::ceil(std::clamp(darkness, 0.0F, 1.0F) * static_cast<float>(RunSight::steps)));
    const float wanted = std::max(v.style.hatch_spacing, v.style.hatch_pen / v.most_coverage[step]);
    return !(1.001F * v.separation * v.stretch < std::ldexp(wanted, level - 1) * nearest);
}

RunSight sight_of_run(const HatchView& view, const Run& run, const ItemSight& sight, const float* taus) noexcept {
    const ItemView& item = view.scene.item_of(run);
    const LayerStyle& style = *run.style;
    // A layer's report gives the separation of its lines as the step. Published strokes are an exception: their
    // distances vary.
    const bool nested =
        run.marks->report.step > 0.0 && (run.marks->progressive || run.marks->kind != marks::Kind::hatch);
    RunSight v{view,
               run,
               item,
               sight,
               style,
               taus,
               nested ? std::clamp(run.marks->report.levels, 0, marks::most_levels) : 0,
               1.0 / item.unit,
               run.normal,
               sight.view_transform.rigid && run.marks->stroke_order.empty(),
               style.hatch_wobble > 0.0F || style.hatch_overshoot > 0.0F,
               std::min(style.hatch_taper + 6.0F * style.hatch_shortest + 4.0F * style.hatch_spacing,
                        view.scene.lens.diagonal),
               HatchLights(style)};
    v.law = {&style,
             static_cast<float>(v.levels),
             1.0F / (style.hatch_tone_end - style.hatch_tone_begin),
             style.hatch_lights() > 0.0F ? 1.0F / style.hatch_lights() : 0.0F,
             1.0F / style.hatch_spacing,
             1.0F / style.hatch_pen};
    const bool posed = run.normal != run.marks->normal.data();
    const bool is_shaded = run.shading_of(item) != nullptr;
    const bool is_lit = taus == nullptr && item.style.tone == Tone::light && run.fields.tone == nullptr;
    if (is_lit && !is_shaded && !(posed && run.has_tone_normals())) {
        if (run.has_tone_normals()) v.tone_normal = run.marks->tone_normal.data();
        v.lightest = lightest_facing(sight.lighting, 1.0F - style.hatch_least(), rounding_of_darkness);
    }
    if (!nested) return v;
    v.separation = static_cast<float>(std::ldexp(run.marks->report.step / item.unit, v.levels));
    v.stretch = sight.scale * largest_stretch(view.scene.lens, v.beyond);
    std::array<float, RunSight::steps + 1 + HatchRows::slack> darkness{};
    std::array<float, RunSight::steps + 1 + HatchRows::slack> coverage{};
    for (std::size_t i = 0; i <= RunSight::steps; ++i)
        darkness[i] = static_cast<float>(i) / static_cast<float>(RunSight::steps);
    view.loops.coverage(v.law, darkness.data(), RunSight::steps + 1, coverage.data());
    for (std::size_t i = 0; i <= RunSight::steps; ++i)
        v.most_coverage[i] = std::max(coverage[i], i > 0 ? v.most_coverage[i - 1] : 0.0F);
    // The finest level for which there may be space anywhere on the item, in the picture.
    const glm::vec4 row = glm::row(view.scene.lens.window, 3);
    const float nearest = glm::dot(row, glm::vec4(item.to_eye * item.centre + item.eye_offset, 1.0F)) -
                          glm::length(glm::vec3(row)) * sight.scale * item.radius;
    v.shown = v.levels;
    while (v.shown > 0 && !has_room(v, v.shown, nearest, 1.0F)) --v.shown;
    return v;
}

// Returns whether a mark of the piece may be drawn. If not, all of its marks are too light, face away, are outside, or
// have a level without space.
bool may_draw_piece(const RunSight& v, const marks::StrokePiece& piece) noexcept {
    if (piece.level > v.shown || faces_away(piece, v.sight)) return false;
    const ClusterView view = view_cluster(piece, v.sight, v.view.scene.lens, v.view.frustum);
    if (view.beyond > v.beyond + rounding_of_margins || view.nu_min > hatch_tuning.last_nu + rounding_of_margins)
        return false;
    // Computes an upper bound for the darkness of the marks, from a lower bound for their tone.
    const bool is_lit = v.taus == nullptr && v.item.style.tone == Tone::light;
    const Shading* const shading = v.run.shading_of(v.item);
    const std::int64_t number = &piece - v.run.clusters->piece.data();
    const SeenShares seen = shading != nullptr ? shading->layers[v.run.layer].of_piece[number] : SeenShares();
    const float tau = is_lit ? least_tau_of_piece(piece, v.sight, seen) : 0.0F;
    const FieldBounds fields = v.run.field_bounds_of(piece);
    const float darkness = (1.0F - fields.least_tone(tau)) * fields.most_density + rounding_of_margins;
    if (darkness < v.style.hatch_least()) return false;
    return !(v.separation > 0.0F) || has_room(v, piece.level, view.nearest, v.lights.darkest(darkness));
}

// Returns a bit for each mark that may be drawn. For a place p of the ball around c, and the eye e, n . (p - e) >= n .
// (c - e) - |n| r. If the right side is positive, the mark faces away.
std::uint32_t marks_that_may(const RunSight& v, const marks::StrokePiece& piece) noexcept {
    HatchBounds bounds{};
    const ViewTransform& view_transform = v.sight.view_transform;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto i = static_cast<int>(k);
        bounds.sight[k] = view_transform.parallel ? v.sight.eye[i] : piece.centre[k] - v.sight.eye[i];
        bounds.light[k] = v.sight.lighting.lamps[0].place[k];
    }
    bounds.away = view_transform.parallel ? 0.0F : most_length * piece.radius;
    bounds.lightest = v.lightest;
    const std::int64_t first = 3 * std::int64_t{piece.first};
    return v.view.loops.may_draw(bounds, v.run.normal + first, v.tone_normal + first, piece.count);
}

// Finds the range of a stroke's positions, and whether the stroke is closed. If the last mark of a closed stroke
// coincides with the first, it is left out.
void find_extent(const RunSight& v, std::int64_t stroke, HatchStroke& seen) noexcept {
    seen.first = v.run.marks->stroke_first[stroke];
    seen.count = std::int64_t{v.run.marks->stroke_first[stroke + 1]} - seen.first;
    seen.closed = false;
    const auto place = [&](std::int64_t at) {
        return glm::vec3(glm::dvec3(v.run.position_of(v.run.marks->mark_of(at))) * v.per_unit);
    };
    const glm::vec3 begin = place(seen.first);
    const glm::vec3 leaves = place(seen.first + 1) - begin;
    seen.step = glm::length(leaves);
    if (seen.count < hatch_tuning.fewest_of_closed) return;
    const glm::vec3 end = place(seen.first + seen.count - 1);
    const glm::vec3 comes = end - place(seen.first + seen.count - 2);
    const float gap = glm::distance(begin, end);
    const bool same = gap <= hatch_tuning.same_mark * seen.step;
    const auto goes_on = [&](const glm::vec3& way) {
        return glm::dot(way, begin - end) >= hatch_tuning.closed_cosine * gap * glm::length(way);
    };
    seen.closed = same || (gap <= hatch_tuning.closed_gap * seen.step && goes_on(leaves) && goes_on(comes));
    if (same) --seen.count;
}

// Finds the pieces that may be drawn. Returns whether it finds any.
bool find_drawn_pieces(const RunSight& v, std::int64_t piece, std::int64_t count, HatchStroke& seen) {
    constexpr std::uint32_t all = ~std::uint32_t{0} >> (32 - marks::StrokePiece::most);
    seen.may_draw.clear();
    bool any = false;
    for (std::int64_t k = 0; k < count; ++k) {
        const marks::StrokePiece& own = v.run.clusters->piece[piece + k];
        seen.may_draw.push_back(may_draw_piece(v, own) ? all >> (marks::StrokePiece::most - own.count) : 0U);
        if (seen.may_draw.back() == 0) continue;
        any = true;
        if (!v.run.marks->stroke_order.empty()) continue;
        // find_marks() will soon read these normals.
        base::prefetch_many(v.run.normal + 3 * std::int64_t{own.first}, 3 * std::int64_t{own.count});
        if (v.run.has_tone_normals() && v.run.normal == v.run.marks->normal.data())
            base::prefetch_many(v.run.marks->tone_normal.data() + 3 * std::int64_t{own.first},
                                3 * std::int64_t{own.count});
    }
    // A wobble needs the indices of all marks along the stroke, and an overshoot needs marks beyond the end of the
    // tone, so all marks are loaded.
    if (any && v.is_unsteady) std::fill(seen.may_draw.begin(), seen.may_draw.end(), all);
    return any;
}

// Finds the marks that may be drawn. Returns whether it finds any.
bool find_marks(const RunSight& v, std::int64_t piece, HatchStroke& seen) noexcept {
    const bool bounded = v.has_bounds && !v.is_unsteady;
    std::uint32_t any = 0;
    for (std::int64_t k = 0; k < seen.may_draw.size(); ++k) {
        std::uint32_t& bits = seen.may_draw[k];
        const marks::StrokePiece& own = v.run.clusters->piece[piece + k];
        if (bits != 0 && bounded) bits = marks_that_may(v, own);
        any |= bits;
        if (bits == 0 || !v.run.marks->stroke_order.empty()) continue;
        base::prefetch_many(v.run.position + 3 * std::int64_t{own.first}, 3 * std::int64_t{own.count});
        base::prefetch_many(v.run.marks->level.data() + own.first, own.count);
        const base::Array<float>& gap = v.run.marks->clusters.gap;
        if (!gap.empty()) base::prefetch_many(gap.data() + own.first, own.count);
    }
    return any != 0;
}

// Finds the ranges of marks to load: the marks that may be drawn, with the neighbours that ends, tangents and spacing
// need. If only a few marks are between two ranges, these are loaded, too.
void find_ranges(HatchStroke& seen) {
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

// Loads the marks of a range of positions.
void load_range(const RunSight& v, std::int64_t begin, std::int64_t count, std::uint32_t* numbers,
                const HatchRows& rows) noexcept {
    const marks::Layer& layer = *v.run.marks;
    const bool ordered = layer.stroke_order.empty();
    for (std::int64_t i = 0; i < count; ++i)
        numbers[i] = ordered ? static_cast<std::uint32_t>(begin + i) : layer.stroke_order[begin + i];
    const auto mark = [&](std::int64_t i) { return ordered ? begin + i : std::int64_t{numbers[i]}; };
    const float* const gap = layer.clusters.gap.data(); // null if the gaps are not known
    const std::uint8_t* const level = layer.level.data();
    float* const levels = rows[HatchRow::level];
    float* const gaps = rows[HatchRow::gap];
    for (std::int64_t i = 0; i < count; ++i) levels[i] = static_cast<float>(level[mark(i)]);
    for (std::int64_t i = 0; i < count; ++i) gaps[i] = gap != nullptr ? gap[mark(i)] : 1.0F;
    const auto put = [&](HatchRow first, const float* all, float factor, float other) {
        float* const x = rows[first];
        float* const y = x + rows.stride;
        float* const z = y + rows.stride;
        for (std::int64_t i = 0; i < count; ++i) {
            const float* const from = all + 3 * mark(i);
            x[i] = from[0] * factor * other;
            y[i] = from[1] * factor * other;
            z[i] = from[2] * factor * other;
        }
    };
    // For some units the reciprocal is too large for a float, so it is split into two factors.
    const int exponent = std::ilogb(v.per_unit);
    put(HatchRow::x, v.run.position, std::ldexp(1.0F, exponent / 2), std::ldexp(1.0F, exponent - exponent / 2));
    put(HatchRow::normal_x, v.run.normal, 1.0F, 1.0F);
    if (!v.run.has_tone_normals()) return;
    if (v.run.normal == layer.normal.data()) {
        put(HatchRow::tone_x, layer.tone_normal.data(), 1.0F, 1.0F);
        return;
    }
    for (std::int64_t i = 0; i < count; ++i) {
        const glm::vec3 normal = v.run.tone_normal_of(numbers[i]);
        rows[HatchRow::tone_x][i] = normal.x;
        rows[HatchRow::tone_y][i] = normal.y;
        rows[HatchRow::tone_z][i] = normal.z;
    }
}

void set_darkness(const RunSight& v, std::span<const std::uint32_t> numbers, const HatchRows& rows) noexcept {
    const auto count = static_cast<std::int64_t>(numbers.size());
    const Style& style = v.item.style;
    float* const darkness = rows[HatchRow::darkness];
    if (v.taus != nullptr) {
        for (std::int64_t i = 0; i < count; ++i) darkness[i] = 1.0F - v.taus[numbers[static_cast<std::size_t>(i)]];
    } else if (style.tone != Tone::light) {
        std::fill_n(darkness, count, 1.0F);
    } else {
        const float* const tone = rows[v.run.has_tone_normals() ? HatchRow::tone_x : HatchRow::normal_x];
        light_marks(v.view.see, v.sight.lighting, {v.run.shading_of(v.item), v.run.layer, numbers},
                    {rows[HatchRow::x], rows[HatchRow::y], rows[HatchRow::z], tone, tone + rows.stride,
                     tone + 2 * rows.stride, count},
                    rows[HatchRow::nu], darkness);
        for (std::int64_t i = 0; i < count; ++i) darkness[i] = 1.0F - darkness[i];
    }
    for (std::int64_t i = 0; v.run.fields.any() && i < count; ++i) {
        const FieldEffect effect = v.run.fields.effect_on(numbers[static_cast<std::size_t>(i)]);
        darkness[i] = (1.0F - effect.tone(1.0F - darkness[i])) * effect.density;
    }
    const DepthTone depth_tone(style, v.view.scene.lens.eye_per_world);
    for (std::int64_t i = 0; depth_tone.is_on && i < count; ++i) darkness[i] *= depth_tone(rows[HatchRow::distance][i]);
    if (v.taus == nullptr) return;
    // The callback is not asked about a mark that faces away or is far outside. The mark then has the darkness of a
    // neighbour.
    const auto asked = [&](std::int64_t i) {
        return i >= 0 && i < count && rows[HatchRow::nu][i] < 0.0F && rows[HatchRow::picture_margin][i] >= 0.0F;
    };
    for (std::int64_t i = 0; i < count; ++i)
        if (!asked(i)) darkness[i] = asked(i - 1) ? darkness[i - 1] : asked(i + 1) ? darkness[i + 1] : 1.0F;
}

// Sets widths by the style's radius. This is for lines whose distance from each other is not known.
void set_widths_alone(const RunSight& v, std::span<const std::uint32_t> numbers, const HatchRows& rows) noexcept {
    const auto count = static_cast<std::int64_t>(numbers.size());
    const float* const darkness = rows[HatchRow::darkness];
    float* const coverage = rows[HatchRow::least_margin]; // This row is not used yet.
    v.view.loops.coverage(v.law, darkness, count, coverage);
    for (std::int64_t i = 0; i < count; ++i) {
        float& picture = rows[HatchRow::picture_margin][i];
        float& width = rows[HatchRow::width][i];
        rows[HatchRow::tone_margin][i] = darkness[i] - v.style.hatch_least();
        rows[HatchRow::level_margin][i] =
            std::clamp(1.0F + 2.0F * (darkness[i] - v.style.hatch_tone_begin) * v.law.per_fade, -1.0F, 1.0F);
        width = 0.0F;
        if (picture == hatch_nowhere || !(rows[HatchRow::nu][i] < hatch_tuning.widest_nu)) continue;
        width = 2.0F * v.run.front_ink(numbers[static_cast<std::size_t>(i)], rows[HatchRow::pixels_per_unit][i]) *
                coverage[i] / v.style.hatch_coverage_end;
        if (!(width < hatch_farthest)) picture = hatch_nowhere;
    }
}

// Lines of unknown distance from each other count as if their marks were one distance apart.
void vary_lights_of(const RunSight& v, std::int64_t stroke, const HatchStroke& seen, const HatchRows& rows) noexcept {
    const float distance = v.separation > 0.0F ? v.separation : seen.step;
    const auto coarsest = static_cast<int>(std::lround(noise_level(hatch_tuning.break_swing * distance, seen.step)));
    StrokeNoise noise(v.style.hatch_seed, stroke, seen.closed ? seen.count : 0);
    std::int64_t at = 0;
    for (const HatchStroke::Range& range : seen.range) {
        const std::int64_t count = range.end - range.begin;
        const auto size = static_cast<std::size_t>(count);
        vary_lights(v.lights, noise, range.begin - seen.first, coarsest, {rows[HatchRow::level] + at, size},
                    {rows[HatchRow::darkness] + at, size});
        at += count;
    }
}

void see_marks(const RunSight& v, std::int64_t stroke, const HatchStroke& seen, const HatchRows& rows) noexcept {
    const std::span<const std::uint32_t> numbers = seen.number.span();
    const auto count = static_cast<std::int64_t>(numbers.size());
    const bool closed = seen.closed;
    // Sets the positions before the first mark and after the last one, which the computation of widths reads.
    for (const HatchRow row : {HatchRow::x, HatchRow::y, HatchRow::z}) {
        rows[row][-1] = rows[row][closed ? count - 1 : 0];
        rows[row][count] = rows[row][closed ? 0 : count - 1];
    }
    const glm::vec4& port = v.view.scene.lens.viewport;
    const HatchSight how{&v.sight.view_transform, v.separation,    port.x,  port.y,
                         port.x + port.z,         port.y + port.w, v.beyond};
    v.view.see.project_rows(v.sight.view_transform,
                            {rows[HatchRow::x], rows[HatchRow::y], rows[HatchRow::z], rows[HatchRow::normal_x],
                             rows[HatchRow::normal_y], rows[HatchRow::normal_z], count},
                            {rows[HatchRow::left], rows[HatchRow::top], rows[HatchRow::window], rows[HatchRow::depth],
                             rows[HatchRow::pixels_per_unit], rows[HatchRow::nu], rows[HatchRow::side_x],
                             rows[HatchRow::side_y], rows[HatchRow::distance], nullptr});
    v.view.loops.project(how, rows, count);
    set_darkness(v, numbers, rows);
    if (v.style.hatch_lights() > 0.0F) vary_lights_of(v, stroke, seen, rows);
    if (v.separation > 0.0F)
        v.view.loops.set_widths(how, v.law, rows, count, closed);
    else
        set_widths_alone(v, numbers, rows);
    for (std::int64_t i = 0; v.run.fields.width != nullptr && i < count; ++i)
        rows[HatchRow::width][i] *= v.run.fields.effect_on(numbers[static_cast<std::size_t>(i)]).width;
    v.view.loops.measure_distances(rows, count, closed);
}

// Returns whether the stroke is closed, and both its first and last marks are loaded. These two are neighbours.
bool has_seam(const HatchStroke& seen) noexcept {
    return seen.closed && seen.range.span().front().begin == seen.first &&
           seen.range.span().back().end == seen.first + seen.count;
}

// Marks in a gap count as near, too, if the gap is short enough in the picture for the line to continue across it.
// Where marks were left out, the straight distance is used. In a closed stroke, the marks before the first near mark
// and after the last one form one gap.
void keep_short_gaps(const HatchRows& rows, const HatchStroke& seen) noexcept {
    const std::int64_t count = seen.number.size();
    float* const near = rows[HatchRow::greatest_nearby];
    const float* const leg = rows[HatchRow::distance_before];
    const float* const width = rows[HatchRow::width];
    const auto is_near = [&](std::int64_t i) { return near[i] >= 0.0F; };
    const auto is_short = [&](float way, float widest) {
        return way < 2.0F * (hatch_tuning.least_gap * widest + hatch_tuning.least_gap_pixels + hatch_tuning.step);
    };
    std::int64_t begin = 0; // the first near mark
    while (!is_near(begin)) ++begin;
    std::int64_t end = count; // the position after the last near mark
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

// The rows for the members of HatchMark up to `pixels_per_unit`.
constexpr HatchRow rows_of_mark[] = {
    HatchRow::left,           HatchRow::top,          HatchRow::window,     HatchRow::depth,
    HatchRow::side_x,         HatchRow::side_y,       HatchRow::width,      HatchRow::distance_before,
    HatchRow::tone_margin,    HatchRow::level_margin, HatchRow::rim_margin, HatchRow::picture_margin,
    HatchRow::pixels_per_unit};
static_assert(offsetof(HatchMark, begins_chain) == sizeof(float) * std::size(rows_of_mark));

// Keeps the near marks. After each gap, a new chain begins.
void keep_near(const RunSight& v, const HatchRows& rows, HatchStroke& seen) {
    const std::int64_t count = seen.number.size();
    float* const near = rows[HatchRow::greatest_nearby];
    const auto is_near = [](float margin) { return margin >= 0.0F; };
    seen.mark.clear();
    seen.ring = false;
    if (std::none_of(near, near + count, is_near)) return;
    if (v.is_unsteady)
        std::fill(near, near + count, 0.0F);
    else
        keep_short_gaps(rows, seen);
    base::resize_scratch(seen.mark, count + 1);
    HatchMark* to = seen.mark.data();
    for (std::int64_t i = 0; i < count;) {
        const std::int64_t first = std::find_if(near + i, near + count, is_near) - near;
        i = std::find_if_not(near + first, near + count, is_near) - near;
        if (to == seen.mark.data()) seen.first_kept = first;
        const bool begins_chain = to != seen.mark.data();
        for (std::int64_t k = first; k < i; ++k, ++to) {
            float* number = &to->x;
            for (const HatchRow row : rows_of_mark) *number++ = rows[row][k];
            to->begins_chain = begins_chain && k == first ? 1.0F : 0.0F;
            to->id = v.run.first_id + seen.number[k];
        }
    }
    const std::int64_t kept = to - seen.mark.data();
    if (has_seam(seen) && is_near(near[0]) && is_near(near[count - 1])) {
        // In a closed stroke, the line continues from the last mark to the first. It begins after the first gap, or is
        // a ring if there is no gap.
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

// Sets the kinds of the line's two ends: open, or at a crease.
void set_ends(const RunSight& v, HatchStroke& seen) noexcept {
    HRBFNPR_ASSERT(!seen.mark.empty());
    const auto id_at = [&](std::int64_t at) {
        return v.run.first_id + static_cast<std::uint32_t>(v.run.marks->mark_of(at));
    };
    const std::int64_t last = seen.first + seen.count - 1;
    seen.begins = seen.ends = StrokeEnd::open;
    seen.has_begin = !seen.closed && seen.mark[0].id == id_at(seen.first);
    seen.has_end = !seen.closed && seen.mark.back().id == id_at(last);
    // Marks in a pose are no longer at the creases.
    if (v.item.lines == nullptr || v.run.is_posed()) return;
    const auto end_at = [&](std::int64_t place, std::int64_t before) {
        const glm::dvec3 end(v.run.position_of(v.run.marks->mark_of(place)));
        const glm::dvec3 inner(v.run.position_of(v.run.marks->mark_of(before)));
        return v.item.lines->has_crease_near(v.item.origin + end, glm::distance(end, inner)) ? StrokeEnd::crease
                                                                                             : StrokeEnd::open;
    };
    if (seen.has_begin) seen.begins = end_at(seen.first, seen.first + 1);
    if (seen.has_end) seen.ends = end_at(last, last - 1);
}

// Fills `seen` with the marks of a stroke. `piece` is the index of the stroke's first piece. Returns whether any part
// of the stroke may be drawn.
bool see_stroke(const RunSight& v, std::int64_t stroke, std::int64_t piece, HatchStroke& seen) {
    const marks::Layer& layer = *v.run.marks;
    const std::int64_t first = layer.stroke_first[stroke];
    const std::int64_t count = std::int64_t{layer.stroke_first[stroke + 1]} - first;
    if (count < 2) return false;
    if (!v.run.draws_direction(layer.direction_of(layer.mark_of(first)))) return false;
    if (!find_drawn_pieces(v, piece, marks::pieces_of(count), seen)) return false;
    find_extent(v, stroke, seen);
    if (!find_marks(v, piece, seen)) return false;
    find_ranges(seen);
    std::int64_t marks = 0;
    for (const HatchStroke::Range& range : seen.range) marks += range.end - range.begin;
    base::resize_scratch(seen.number, marks);
    const std::int64_t stride = marks + 2 * HatchRows::slack;
    const std::int64_t numbers = static_cast<std::int64_t>(HatchRow::rows) * stride;
    if (seen.row.size() < numbers) base::resize_scratch(seen.row, numbers);
    const HatchRows rows{seen.row.data() + HatchRows::slack, stride};
    std::int64_t at = 0;
    for (const HatchStroke::Range& range : seen.range) {
        load_range(v, range.begin, range.end - range.begin, seen.number.data() + at, rows.from(at));
        at += range.end - range.begin;
    }
    see_marks(v, stroke, seen, rows);
    keep_near(v, rows, seen);
    if (seen.mark.empty()) return false;
    set_ends(v, seen);
    return true;
}

// ---- Samples

// Lengths are rounded to multiples of 1 / this, in pixels. Sums are then exact, and the samples of a chain do not
// depend on other chains.
constexpr float length_steps = 1024.0F;

[[nodiscard]] glm::vec2 place_of(const HatchMark& mark) noexcept { return {mark.x, mark.y}; }

// A chain of marks. The length and area of each mark are measured from the first mark.
struct Marks {
    std::span<const HatchMark> mark;
    const float* length;
    const float* area;
    const glm::vec2* tangent; // Tangents; they have unit length if marks are evenly spaced.

    [[nodiscard]] std::int64_t size() const noexcept { return static_cast<std::int64_t>(mark.size()); }
    [[nodiscard]] const HatchMark& operator[](std::int64_t i) const noexcept {
        HRBFNPR_ASSERT(i >= 0 && i < size());
        return mark[static_cast<std::size_t>(i)];
    }
};

// A position between the mark with the index `mark` and the next mark.
struct MarkPlace {
    std::int64_t mark;
    float share; // the share of the way to the next mark
};

// Returns a point of the cubic Hermite curve between two marks.
[[nodiscard]] glm::vec2 point_at(const Marks& m, const MarkPlace& place) noexcept {
    const std::int64_t i = place.mark;
    const float t = place.share;
    const glm::vec2 a = place_of(m[i]);
    if (t == 0.0F || i + 1 == m.size()) return a;
    const glm::vec2 b = place_of(m[i + 1]);
    const float way = m.length[i + 1] - m.length[i];
    const float u = 1.0F - t;
    if (way < hatch_tuning.shortest_curve) return u * a + t * b;
    return u * u * (1.0F + 2.0F * t) * a + t * t * (3.0F - 2.0F * t) * b +
           t * u * way * (u * m.tangent[i] - t * m.tangent[i + 1]);
}

// Returns the area of the line from the first mark to a position. Between marks, widths change linearly.
[[nodiscard]] float area_to(const Marks& m, const MarkPlace& place) noexcept {
    const std::int64_t i = place.mark;
    if (place.share == 0.0F) return m.area[i];
    const float way = m.length[i + 1] - m.length[i];
    return m.area[i] + place.share * way * (m[i].width + 0.5F * place.share * (m[i + 1].width - m[i].width));
}

// Moves a position to the length `length` along the line. The search goes from mark to mark, because the new position
// is near.
void seek(const Marks& m, MarkPlace& place, float length) noexcept {
    while (place.mark > 0 && m.length[place.mark] > length) --place.mark;
    while (place.mark < m.size() - 2 && m.length[place.mark + 1] < length) ++place.mark;
    const float way = m.length[place.mark + 1] - m.length[place.mark];
    place.share = way > 0.0F ? std::clamp((length - m.length[place.mark]) / way, 0.0F, 1.0F) : 0.0F;
}

// Interpolates all members of a sample between the two neighbouring marks, except its width.
void see_sample(const Marks& m, const MarkPlace& place, HatchSample& sample) noexcept {
    constexpr std::size_t numbers = offsetof(HatchSample, unused) / sizeof(float);
    const std::int64_t i = place.mark;
    const HatchMark& a = m[i];
    const HatchMark& b = m[std::min(i + 1, m.size() - 1)];
    const float t = place.share;
    std::array<float, numbers> from, to;
    std::memcpy(from.data(), &a, sizeof(from));
    std::memcpy(to.data(), &b, sizeof(to));
    for (std::size_t k = 0; k < numbers; ++k) from[k] += t * (to[k] - from[k]);
    std::memcpy(&sample, from.data(), sizeof(from));
    const glm::vec2 at = point_at(m, place);
    sample.x = at.x;
    sample.y = at.y;
    sample.overshoot = 0.0F;
    sample.id = t < 0.5F ? a.id : b.id;
    if (a.is_valid() && b.is_valid()) return;
    if (t == 0.0F || t == 1.0F)
        sample.margin = t == 0.0F ? a.margin : b.margin;
    else
        sample.margin.fill(hatch_nowhere);
}

// Moves a sample to the side, as the unsteady hand draws it.
void add_wobble(const Marks& m, const HatchHand& hand, StrokeNoise& noise, const MarkPlace& place, double mark,
                HatchSample& sample) noexcept {
    if (!(hand.wobble > 0.0F)) return;
    const glm::vec2 along =
        glm::mix(m.tangent[place.mark], m.tangent[std::min(place.mark + 1, m.size() - 1)], place.share);
    const float length = glm::length(along);
    if (!(length > 0.0F)) return;
    const float aside =
        hand.wobble * static_cast<float>(noise.at(mark, hand.wobble_level, StrokeNoise::For::wobble)) / length;
    sample.x -= aside * along.y;
    sample.y += aside * along.x;
}

// Computes lengths, areas and tangents of a chain of marks. The tangents are those of a Catmull-Rom curve.
void measure(std::span<const HatchMark> marks, bool ring, HatchSamples& to) {
    const auto count = static_cast<std::int64_t>(marks.size());
    HRBFNPR_ASSERT(count >= 2);
    base::resize_scratch(to.length, count);
    base::resize_scratch(to.area, count);
    base::resize_scratch(to.tangent, count);
    const auto mark = [&](std::int64_t i) -> const HatchMark& { return marks[static_cast<std::size_t>(i)]; };
    to.length[0] = to.area[0] = 0.0F;
    for (std::int64_t i = 1; i < count; ++i) {
        const float way = std::trunc(mark(i).distance_before * length_steps + 0.5F) / length_steps;
        to.length[i] = to.length[i - 1] + way;
        to.area[i] = to.area[i - 1] + 0.5F * way * (mark(i - 1).width + mark(i).width);
    }
    for (std::int64_t i = 0; i < count; ++i) {
        std::int64_t before = i > 0 ? i - 1 : ring ? count - 2 : 0;
        std::int64_t after = i + 1 < count ? i + 1 : ring ? 1 : i;
        if (!mark(before).is_valid()) before = i;
        if (!mark(after).is_valid()) after = i;
        const float way =
            (before != i ? mark(i).distance_before : 0.0F) + (after != i ? mark(after).distance_before : 0.0F);
        to.tangent[i] = way > 0.0F ? (place_of(mark(after)) - place_of(mark(before))) / way : glm::vec2(0.0F);
    }
}

// Below these margins a line fades (presence.h). It does not fade at the border of the picture.
constexpr std::array<float, hatch_margins> ramps = {hatch_tuning.tone_ramp, hatch_tuning.level_ramp,
                                                    hatch_tuning.rim_ramp, 0.0F};
static_assert(margin_tone == 0 && margin_level == 1 && margin_rim == 2);

// Bits of a mark's state. The lower bits tell which margins are below 0, and the bits from `below_ramp` on tell which
// are below their ramps. If two neighbours have the same bits, as most do, no margin passes 0 or its ramp between them.
constexpr unsigned below_ramp = hatch_margins;

[[nodiscard]] std::uint8_t state_of(const HatchMark& mark) noexcept {
    unsigned state = 0;
    for (std::size_t k = 0; k < hatch_margins; ++k) {
        state |= static_cast<unsigned>(mark.margin[k] < 0.0F) << k;
        state |= static_cast<unsigned>(mark.margin[k] < ramps[k]) << (below_ramp + k);
    }
    return static_cast<std::uint8_t>(state);
}

// Returns whether a line is present at a mark, but fades there more than at both neighbours.
[[nodiscard]] bool is_weakest(const Marks& m, std::int64_t i, std::uint8_t state) noexcept {
    if ((unsigned{state} >> below_ramp & ~unsigned{state} & ((1U << hatch_margins) - 1U)) == 0) return false;
    for (std::size_t k = 0; k < hatch_margins; ++k) {
        const float own = m[i].margin[k];
        if (own > 0.0F && own < ramps[k] && own <= m[i - 1].margin[k] && own <= m[i + 1].margin[k]) return true;
    }
    return false;
}

// Positions between two marks, in rising order. A bit tells which margin is 0 there.
struct MarginCrossings {
    struct MarginCrossing {
        float at;
        std::uint8_t ends;
    };
    std::array<MarginCrossing, 2 * hatch_margins> turn;
    std::size_t count = 0;

    void add(float at, std::uint8_t ends) noexcept {
        std::size_t place = count++;
        for (; place > 0 && turn[place - 1].at > at; --place) turn[place] = turn[place - 1];
        turn[place] = {at, ends};
    }
};

// Finds the positions between mark i and the next mark at which a margin passes 0 or its ramp. The line begins or ends
// there, or begins to fade.
[[nodiscard]] MarginCrossings crossings_after(const Marks& m, std::int64_t i) noexcept {
    MarginCrossings turns;
    if (!m[i].is_valid() || !m[i + 1].is_valid()) return turns;
    for (std::size_t k = 0; k < hatch_margins; ++k) {
        const float from = m[i].margin[k];
        const float to = m[i + 1].margin[k];
        for (const float level : {0.0F, ramps[k]}) {
            if ((from < level) == (to < level) || from == level || to == level) continue;
            const float at = std::lerp(m.length[i], m.length[i + 1], (from - level) / (from - to));
            turns.add(at, level == 0.0F ? static_cast<std::uint8_t>(1U << k) : std::uint8_t{0});
            if (ramps[k] == 0.0F) break;
        }
    }
    return turns;
}

// Finds the positions at which the line is sampled, as lengths from the chain's first mark. They are at even steps,
// where a margin passes 0 or its ramp, and where the line is weakest.
void place_samples(const Marks& m, std::int64_t steps, HatchSamples& to) {
    const float whole = m.length[m.size() - 1];
    to.at.clear();
    to.ends.clear();
    std::int64_t next = 0; // the next even step
    const auto step_at = [&](std::int64_t k) {
        return k < steps ? whole * (static_cast<float>(k) / static_cast<float>(steps)) : whole;
    };
    const auto put = [&](float length, std::uint8_t ends) {
        if (to.at.empty() || length - to.at.back() > hatch_tuning.least_step) {
            to.at.push_back(length);
            to.ends.push_back(ends);
        } else if (ends != 0) {
            to.at.back() = length; // An end of the line replaces the last sample, which is too close to it, so that a
                                   // sample lies exactly at the end.
            to.ends.back() |= ends;
        }
    };
    std::uint8_t state = state_of(m[0]);
    float next_at = step_at(next);
    const auto put_next = [&] {
        put(next_at, 0);
        next_at = step_at(++next);
    };
    for (std::int64_t i = 0; i + 1 < m.size(); ++i) {
        const std::uint8_t before = std::exchange(state, state_of(m[i + 1]));
        if (before != state) {
            const MarginCrossings turns = crossings_after(m, i);
            for (std::size_t k = 0; k < turns.count; ++k) {
                while (next <= steps && next_at < turns.turn[k].at - hatch_tuning.least_step) put_next();
                put(turns.turn[k].at, turns.turn[k].ends);
            }
        }
        while (next <= steps && next_at <= m.length[i + 1]) put_next();
        if (i + 2 < m.size() && is_weakest(m, i + 1, state)) put(m.length[i + 1], 0);
    }
    if (to.at.size() > 1 && whole - to.at.back() <= hatch_tuning.least_step) {
        to.at.back() = whole;
    } else if (to.at.back() < whole) {
        put(whole, 0);
    }
    if (to.at.size() < 2) { // The line has no length.
        to.at.push_back(whole);
        to.ends.push_back(0);
    }
}

// Adds the samples of a chain. `first_mark` is the index along the stroke of the chain's first mark.
void sample_chain(const Marks& m, const HatchHand& hand, StrokeNoise& noise, std::int64_t first_mark,
                  HatchSamples& to) {
    const float whole = m.length[m.size() - 1];
    const auto steps = std::max<std::int64_t>(static_cast<std::int64_t>(std::ceil(whole / hatch_tuning.step)), 1);
    place_samples(m, steps, to);
    const base::Array<float>& at = to.at;
    const std::int64_t count = at.size();
    const std::int64_t first = to.sample.size();
    to.sample.resize_for_overwrite(first + count);
    MarkPlace place{0, 0.0F};
    MarkPlace edge{0, 0.0F}; // the end of the interval over which a sample's width is averaged
    const float half_step = 0.5F * whole / static_cast<float>(steps);
    float last = 0.0F; // the length and the area up to the last edge
    float last_area = 0.0F;
    const auto area_at = [&](float length) {
        if (std::abs(length - last) < hatch_tuning.least_step) return last_area;
        seek(m, edge, length);
        last = length;
        return last_area = area_to(m, edge);
    };
    for (std::int64_t i = 0; i < count; ++i) {
        seek(m, place, at[i]);
        HatchSample& sample = to.sample[first + i];
        see_sample(m, place, sample);
        if (to.ends[i] != 0)
            for (std::size_t k = 0; k < hatch_margins; ++k)
                if ((static_cast<unsigned>(to.ends[i]) >> k & 1U) != 0) sample.margin[k] = 0.0F;
        const double mark = static_cast<double>(place.mark + first_mark) + static_cast<double>(place.share);
        add_wobble(m, hand, noise, place, mark, sample);
        if (hand.overshoot > 0.0F)
            sample.overshoot =
                hand.overshoot * static_cast<float>(std::clamp(
                                     0.5 + noise.at(mark, hand.end_level, StrokeNoise::For::overshoot), 0.0, 1.0));
        // The width of a sample is the mean over a step around it. Otherwise widths would flicker between frames,
        // because widths vary from mark to mark and samples move.
        const float reach = std::min({half_step, at[i], whole - at[i]});
        if (!(reach > 0.0F)) continue; // At the ends, the width is that of the mark there.
        const float area = area_at(at[i] - reach);
        sample.width = 0.5F * (area_at(at[i] + reach) - area) / reach;
    }
}

// Appends the chains of a stroke. `number` is the index of the stroke.
void sample_stroke(const LayerStyle& style, std::int64_t number, const HatchStroke& stroke, HatchSamples& to) {
    const std::span<const HatchMark> marks = stroke.mark.span();
    std::size_t end = 0;
    for (std::size_t begin = 0; begin < marks.size(); begin = end) {
        end = begin + 1;
        while (end < marks.size() && !(marks[end].begins_chain > 0.0F)) ++end;
        if (end - begin < 2) continue; // A single mark is no line.
        const std::span<const HatchMark> own = marks.subspan(begin, end - begin);
        measure(own, stroke.ring, to);
        HatchChain chain;
        chain.first = to.sample.size();
        chain.ring = stroke.ring;
        chain.has_begin = begin == 0 && stroke.has_begin;
        chain.has_end = end == marks.size() && stroke.has_end;
        chain.begins = stroke.begins;
        chain.ends = stroke.ends;
        const float steps = static_cast<float>(own.size() - 1);
        const HatchHand hand(style, to.length[to.length.size() - 1] / steps);
        StrokeNoise noise(style.hatch_seed, number, stroke.closed ? stroke.count : 0);
        sample_chain({own, to.length.data(), to.area.data(), to.tangent.data()}, hand, noise, stroke.first_kept, to);
        chain.count = to.sample.size() - chain.first;
        to.chain.push_back(chain);
    }
}

} // namespace

void sample_strokes(const HatchView& view, const Run& run, const ItemSight& sight, const float* taus,
                    const HatchRange& range, HatchStroke& scratch, HatchSamples& to) {
    const RunSight v = sight_of_run(view, run, sight, taus);
    std::int64_t piece = range.piece;
    for (std::int64_t s = range.begin; s < range.end; ++s) {
        if (see_stroke(v, s, piece, scratch)) sample_stroke(v.style, s, scratch, to);
        piece += marks::pieces_of(std::int64_t{run.marks->stroke_first[s + 1]} - run.marks->stroke_first[s]);
    }
}

} // namespace hrbfnpr::frame
