// SPDX-License-Identifier: MIT
#include "published/published_frame.h"

#include "base/assert.h"
#include "base/clock.h"
#include "base/scratch.h"
#include "published/tuning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hrbfnpr::published {
namespace {

// ---- 1. Classes

// The largest disc that the mark can paint decides whether it can reach the viewport.
[[nodiscard]] float reach(const Run& run, float pixels_per_unit) noexcept {
    float radius = 0.0F;
    if (run.draws_front) radius = run.pen.front_ink(pixels_per_unit);
    if (run.draws_silhouettes) radius = std::max(radius, run.pen.silhouette_ink(pixels_per_unit));
    if (run.paints_paper || run.occludes)
        radius = std::max({radius, run.pen.front_splat(pixels_per_unit), run.pen.back_splat(pixels_per_unit)});
    return radius + 0.5F; // the soft rim
}

// Each comparison is false for NaN, so that such a mark is outside.
[[nodiscard]] bool inside(const glm::vec4& viewport, float x, float y, float window_depth, float radius) noexcept {
    return x > viewport.x - radius && x < viewport.x + viewport.z + radius && y > viewport.y - radius &&
           y < viewport.y + viewport.w + radius && window_depth >= 0.0F && window_depth <= 1.0F;
}

// Fills every array of the scene's marks but `role` at a place; tau only where the style's tone is not a callback.
void classify(const Run& run, const ItemView& item, const Lens& lens, std::int64_t place, Marks& out) noexcept {
    const Style& style = item.style;
    const std::int64_t mark = place - run.first;
    HRBFNPR_ASSERT(mark >= 0 && mark < run.count);
    out.mark_class[place] = MarkClass::none;
    const glm::vec3 eye = item.to_eye * run.place_of(mark, item.unit) + item.eye_offset;
    const glm::vec4 clip = lens.window * glm::vec4(eye, 1.0F);
    if (!(clip.w > 0.0F)) return; // the eye is before it
    const float pixels_per_unit = lens.pixels / clip.w;
    const glm::vec3 at = glm::vec3(clip) / clip.w;
    const glm::vec3 own_normal = run.normal_of(mark);
    const glm::vec3 normal = glm::normalize(item.normal_to_eye * own_normal);
    const float nu = glm::dot(normal, glm::normalize(lens.sight(eye)));
    if (!inside(lens.viewport, at.x, at.y, at.z, reach(run, pixels_per_unit)) || !(std::abs(nu) <= 1.001F)) return;
    out.x[place] = at.x;
    out.y[place] = at.y;
    out.window_depth[place] = at.z;
    out.depth[place] = -eye.z;
    out.pixels_per_unit[place] = pixels_per_unit;
    out.nu[place] = nu;
    out.tau[place] = style.tone == Tone::light ? LightTone(style)(lit(item.light, own_normal)) : 0.0F;
    // The distance is from the eye, or from its plane where there is no eye.
    out.tau_depth[place] =
        DepthTone(style, lens.eye_per_world)(lens.centre.w == 0.0F ? -eye.z : glm::length(lens.sight(eye)));
    const auto threshold = static_cast<float>(style.silhouette_threshold);
    out.mark_class[place] = nu < -threshold  ? MarkClass::front
                            : nu > threshold ? MarkClass::back
                                             : MarkClass::silhouette;
}

// Whether a front mark would be ink but for tone, depth, zoom and visibility.
[[nodiscard]] bool may_be_ink(const Run& run, std::int64_t mark) noexcept {
    return run.draws_front && (run.directions == 3U || run.draws_set(run.marks->stroke[2 * mark] & 1U));
}

// Asks the styles' tone callbacks for tau of the front marks that need one, on this thread.
void ask_tones(Scene& scene, ToneCalls& calls) {
    for (const Run& run : scene.runs) {
        const ItemView& item = scene.item_of(run);
        if (item.style.tone != Tone::callback) continue;
        calls.begin(item, scene.marks.tau);
        for (std::int64_t i = 0; i < run.count; ++i) {
            if (scene.marks.mark_class[run.first + i] == MarkClass::front && may_be_ink(run, i))
                calls.add(run.place_of(i, item.unit), run.normal_of(i), run.first + i);
        }
        calls.end();
    }
}

// ---- Radii of discs

[[nodiscard]] float ink_radius(const Scene& scene, const Run& run, std::int64_t place) noexcept {
    const float pixels_per_unit = scene.marks.pixels_per_unit[place];
    return scene.marks.mark_class[place] == MarkClass::silhouette ? run.pen.silhouette_ink(pixels_per_unit)
                                                                  : run.front_ink(place - run.first, pixels_per_unit);
}

[[nodiscard]] float splat_radius(const Scene& scene, const Run& run, std::int64_t place) noexcept {
    const float pixels_per_unit = scene.marks.pixels_per_unit[place];
    return scene.marks.mark_class[place] == MarkClass::back ? run.pen.back_splat(pixels_per_unit)
                                                            : run.pen.front_splat(pixels_per_unit);
}

// ---- 3. Roles

// Whether a mark of class front or silhouette is ink; where it is not, `counts` says why. `visibility`: null where
// nothing hides marks.
[[nodiscard]] bool is_ink(const Scene& scene, const Run& run, std::int64_t place, const VisibilityMap* visibility,
                          Counts& counts) noexcept {
    const Marks& marks = scene.marks;
    const Style& style = scene.item_of(run).style;
    const std::int64_t mark = place - run.first;
    const float pixels_per_unit = marks.pixels_per_unit[place];
    const float rank = run.marks->rank[mark];
    if (marks.mark_class[place] == MarkClass::front) {
        if (!may_be_ink(run, mark)) return false;
        const ToneTerms terms{marks.tau[place], marks.tau_depth[place], run.pen.scale(pixels_per_unit),
                              run.style->share};
        switch (front_verdict(rank, terms, style.tone_rule)) {
        case Verdict::shown: break;
        case Verdict::tone: ++counts.dropped_tone; return false;
        case Verdict::zoom: ++counts.dropped_zoom; return false;
        case Verdict::depth: ++counts.dropped_depth; return false;
        }
    } else {
        if (!run.draws_silhouettes) return false;
        if (!silhouette_shown(rank, marks.tau_depth[place], style.tone_rule)) {
            ++counts.dropped_depth;
            return false;
        }
    }
    if (visibility == nullptr) return true;
    const float depth = ink_depth(marks.depth[place], ink_radius(scene, run, place), pixels_per_unit);
    if (!visibility->hides(marks.x[place], marks.y[place], depth)) return true;
    ++counts.dropped_hidden;
    return false;
}

[[nodiscard]] bool is_paper(const Marks& marks, const Run& run, std::int64_t place) noexcept {
    if (!run.paints_paper) return false;
    const MarkClass mark_class = marks.mark_class[place];
    if (mark_class == MarkClass::front)
        return front_alpha(marks.nu[place], static_cast<float>(run.pen.style->attenuation_front)) > 0.0F;
    return mark_class == MarkClass::back &&
           back_alpha(marks.nu[place], static_cast<float>(run.pen.style->attenuation_back)) > 0.0F;
}

void decide(Scene& scene, const Run& run, std::int64_t place, const VisibilityMap* visibility,
            Counts& counts) noexcept {
    const MarkClass mark_class = scene.marks.mark_class[place];
    switch (mark_class) {
    case MarkClass::none: ++counts.outside; break;
    case MarkClass::back: ++counts.back; break;
    case MarkClass::front: ++counts.front; break;
    case MarkClass::silhouette: ++counts.silhouette; break;
    }
    std::uint8_t role = 0;
    if ((mark_class == MarkClass::front || mark_class == MarkClass::silhouette) &&
        is_ink(scene, run, place, visibility, counts)) {
        ++counts.shown;
        role = role_ink;
    }
    if (is_paper(scene.marks, run, place)) {
        ++counts.splats;
        role |= role_paper;
    }
    scene.marks.role[place] = role;
}

// Calls visit(chunk, run, number) for each chunk of the scene's marks, on all threads.
template <class Visit>
void for_chunks(const base::Parallel& parallel, const Scene& scene, Visit&& visit) {
    parallel.for_each(scene.chunks.size(), [&](std::int64_t c) {
        const Chunk& chunk = scene.chunks[c];
        const Run& run = scene.runs[chunk.run];
        HRBFNPR_ASSERT(chunk.begin >= run.first && chunk.end <= run.first + run.count);
        visit(chunk, run, c);
    });
}

// ---- 4. Discs

[[nodiscard]] Dot dot_of(const Scene& scene, std::int64_t number, std::int64_t place, bool is_paper) noexcept {
    const Marks& m = scene.marks;
    const Run& run = scene.runs[number];
    Dot dot{};
    dot.x = m.x[place];
    dot.y = m.y[place];
    dot.depth = m.depth[place];
    dot.window = m.window_depth[place];
    dot.pixels_per_unit = m.pixels_per_unit[place];
    dot.id = run.first_id + static_cast<std::uint32_t>(place - run.first);
    dot.mark_class = m.mark_class[place];
    dot.layer = 2U * static_cast<std::uint32_t>(number) + (dot.mark_class == MarkClass::silhouette ? 1U : 0U);
    if (!is_paper) {
        dot.radius = ink_radius(scene, run, place);
        dot.opacity = 1.0F;
        return dot;
    }
    dot.flags = dot_is_paper;
    dot.radius = splat_radius(scene, run, place);
    dot.opacity = dot.mark_class == MarkClass::back
                      ? run.pen.back_opacity(m.nu[place], dot.radius, m.pixels_per_unit[place])
                      : run.pen.front_opacity(m.nu[place], dot.radius, m.pixels_per_unit[place]);
    return dot;
}

} // namespace

// ---- 2. Visibility

void VisibilityMap::build(const base::Parallel& parallel, const Scene& scene) {
    const glm::vec4& viewport = scene.lens.viewport;
    left_ = viewport.x;
    top_ = viewport.y;
    double scale = 1.0;
    while (std::ceil(static_cast<double>(viewport.z) * scale) * std::ceil(static_cast<double>(viewport.w) * scale) >
           published_tuning.most_texels)
        scale *= 0.5;
    texels_per_pixel_ = static_cast<float>(scale);
    width_ = static_cast<std::int32_t>(std::ceil(viewport.z * texels_per_pixel_));
    height_ = static_cast<std::int32_t>(std::ceil(viewport.w * texels_per_pixel_));
    base::resize_scratch(occluders_, scene.marks.x.size());
    for_chunks(parallel, scene, [&](const Chunk& chunk, const Run& run, std::int64_t) {
        for (std::int64_t i = chunk.begin; i < chunk.end; ++i) {
            const MarkClass mark_class = scene.marks.mark_class[i];
            occluders_[i].radius = -1.0F;
            if (!run.occludes || (mark_class != MarkClass::front && mark_class != MarkClass::back)) continue;
            const float radius = run.pen.front_splat(scene.marks.pixels_per_unit[i]);
            occluders_[i] = {(scene.marks.x[i] - left_) * texels_per_pixel_,
                             (scene.marks.y[i] - top_) * texels_per_pixel_, radius * texels_per_pixel_,
                             paper_depth(scene.marks, i, radius)};
        }
    });
    const std::array all = {Piece{0, occluders_.size()}};
    bins_.build(parallel, width_, height_, all, [this](std::int64_t i, drawing::Tiles::Footprint& print) {
        const Occluder& disc = occluders_[i];
        print = {disc.x, disc.y, disc.radius};
        return disc.radius >= 0.0F;
    });
    base::resize_scratch(depth_, std::int64_t{width_} * height_);
    parallel.for_each(bins_.tiles(), [this](std::int64_t tile) { fill_tile(tile); });
}

void VisibilityMap::fill_tile(std::int64_t tile) noexcept {
    HRBFNPR_ASSERT(tile >= 0 && tile < bins_.tiles());
    const auto left = static_cast<std::int32_t>(tile % bins_.columns()) * tile_size;
    const auto top = static_cast<std::int32_t>(tile / bins_.columns()) * tile_size;
    const std::int32_t right = std::min(left + tile_size, width_);
    const std::int32_t bottom = std::min(top + tile_size, height_);
    const auto row = [&](std::int32_t y) { return depth_.data() + std::int64_t{y} * width_; };
    for (std::int32_t y = top; y < bottom; ++y)
        std::fill(row(y) + left, row(y) + right, std::numeric_limits<float>::infinity());
    bins_.for_tile(tile, [&](std::uint32_t i) {
        const Occluder& disc = occluders_[i];
        for (std::int32_t y = top; y < bottom; ++y) {
            const float dy = static_cast<float>(y) + 0.5F - disc.y;
            const float half_squared = disc.radius * disc.radius - dy * dy;
            if (!(half_squared >= 0.0F)) continue;
            const float half = std::sqrt(half_squared);
            // Texels whose centres lie within.
            const float first = std::max(std::ceil(disc.x - half - 0.5F), static_cast<float>(left));
            const float last = std::min(std::floor(disc.x + half - 0.5F), static_cast<float>(right - 1));
            if (!(first <= last)) continue;
            for (auto x = static_cast<std::int32_t>(first); x <= static_cast<std::int32_t>(last); ++x)
                row(y)[x] = std::min(row(y)[x], disc.depth);
        }
    });
}

bool VisibilityMap::hides(float x, float y, float depth) const noexcept {
    const float u = std::floor((x - left_) * texels_per_pixel_);
    const float v = std::floor((y - top_) * texels_per_pixel_);
    if (!(u >= 0.0F && v >= 0.0F && u < static_cast<float>(width_) && v < static_cast<float>(height_))) return false;
    return depth > depth_[static_cast<std::int64_t>(v) * width_ + static_cast<std::int64_t>(u)];
}

void PublishedFrame::run(Scene& scene, drawing::Drawing& drawing) {
    drawing.painting = drawing::Painting::published;
    const base::Parallel& parallel = runtime_.parallel;
    base::Stopwatch watch;
    add_chunks(scene);
    for_chunks(parallel, scene, [&](const Chunk& chunk, const Run& run, std::int64_t) {
        const ItemView& item = scene.item_of(run);
        for (std::int64_t i = chunk.begin; i < chunk.end; ++i) classify(run, item, scene.lens, i, scene.marks);
    });
    ask_tones(scene, tone_calls_);
    const std::int64_t classified = watch.nanoseconds();

    watch.restart();
    const bool hiding = std::any_of(scene.runs.begin(), scene.runs.end(), [](const Run& run) { return run.occludes; });
    if (hiding) visibility_.build(parallel, scene);
    const std::int64_t seen = watch.nanoseconds();

    watch.restart();
    counts_.resize(scene.chunks.size());
    for_chunks(parallel, scene, [&](const Chunk& chunk, const Run& run, std::int64_t c) {
        Counts counts;
        counts.marks = chunk.end - chunk.begin;
        for (std::int64_t i = chunk.begin; i < chunk.end; ++i)
            decide(scene, run, i, hiding ? &visibility_ : nullptr, counts);
        counts_[c] = counts;
    });
    Counts& all = drawing.counts;
    for (const Counts& chunk : counts_) all += chunk;
    all.nanoseconds_classify = classified + watch.nanoseconds();
    all.nanoseconds_visibility = seen;

    watch.restart();
    find_keys(scene);
    order_.sort(parallel, keys_);
    base::resize_scratch(drawing.dots, keys_.size());
    drawing.dot_pieces.push_back({0, keys_.size()});
    drawing.dot_count = all.shown;
    constexpr std::int64_t dots_a_task = 4096;
    parallel.for_chunks(keys_.size(), dots_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const auto disc = static_cast<std::uint32_t>(keys_[i]);
            const std::int64_t place = disc >> 1U;
            const Run* run = std::upper_bound(scene.runs.begin(), scene.runs.end(), place,
                                              [](std::int64_t p, const Run& r) { return p < r.first; }) -
                             1;
            drawing.dots[i] = dot_of(scene, run - scene.runs.begin(), place, (disc & 1U) != 0);
        }
    });
    all.nanoseconds_sort = watch.nanoseconds();
}

// A key for each disc, in the order of the marks: its depth, and twice the mark's place, with 1 added for paper.
void PublishedFrame::find_keys(const Scene& scene) {
    base::resize_scratch(first_key_, counts_.size());
    std::int64_t total = 0;
    for (std::int64_t c = 0; c < counts_.size(); ++c) {
        first_key_[c] = total;
        total += counts_[c].shown + counts_[c].splats;
    }
    base::resize_scratch(keys_, total);
    for_chunks(runtime_.parallel, scene, [&](const Chunk& chunk, const Run& run, std::int64_t c) {
        const Marks& m = scene.marks;
        std::int64_t next = first_key_[c];
        for (std::int64_t place = chunk.begin; place < chunk.end; ++place) {
            const unsigned role = m.role[place];
            const auto disc = static_cast<std::uint32_t>(place) << 1U;
            if ((role & role_paper) != 0)
                keys_[next++] =
                    drawing::far_first_key(paper_depth(m, place, splat_radius(scene, run, place)), disc | 1U);
            if ((role & role_ink) != 0)
                keys_[next++] = drawing::far_first_key(
                    ink_depth(m.depth[place], ink_radius(scene, run, place), m.pixels_per_unit[place]), disc);
        }
        HRBFNPR_ASSERT(next == first_key_[c] + counts_[c].shown + counts_[c].splats);
    });
}

} // namespace hrbfnpr::published
