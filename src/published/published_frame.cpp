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
#include <utility>

namespace hrbfnpr::published {
namespace {

constexpr std::int64_t marks_a_task = 4096;

// Calls visit(run, place, task) for all marks of all runs of the scene, on all threads.
template <class Visit>
void for_marks(const base::Parallel& parallel, const Scene& scene, const Visit& visit) {
    parallel.for_chunks(scene.mark_count(), marks_a_task, [&](std::int64_t begin, std::int64_t end) {
        const Run* run = scene.runs.begin();
        for (std::int64_t place = begin; place < end; ++place) {
            while (place >= run->first + run->count) ++run;
            visit(*run, place, begin / marks_a_task);
        }
    });
}

// ---- 1. Classes

// Returns the radius of the largest disc that the mark can paint. It decides whether the mark can reach the viewport.
[[nodiscard]] float reach(const Run& run, float pixels_per_unit) noexcept {
    float radius = 0.0F;
    if (run.draws_front) radius = run.discs.front_ink(pixels_per_unit);
    if (run.draws_silhouettes) radius = std::max(radius, run.discs.silhouette_ink(pixels_per_unit));
    if (run.paints_paper || run.occludes)
        radius = std::max({radius, run.discs.front_splat(pixels_per_unit), run.discs.back_splat(pixels_per_unit)});
    return radius + 0.5F; // half a pixel more for the soft rim
}

// Returns whether a mark is inside the viewport. Comparisons with NaN are false, so a mark with NaN is outside.
[[nodiscard]] bool inside(const glm::vec4& viewport, float x, float y, float window_depth, float radius) noexcept {
    return x > viewport.x - radius && x < viewport.x + viewport.z + radius && y > viewport.y - radius &&
           y < viewport.y + viewport.w + radius && window_depth >= 0.0F && window_depth <= 1.0F;
}

// Classifies a mark, which is given by its index in the layer. Computes tau, unless the style's tone is a callback.
[[nodiscard]] Mark classify(const Run& run, const ItemView& item, const Lens& lens, std::int64_t number) noexcept {
    const Style& style = item.style;
    Mark mark{};
    const glm::vec3 eye = item.to_eye * run.place_of(number, item.unit) + item.eye_offset;
    const glm::vec4 clip = lens.window * glm::vec4(eye, 1.0F);
    if (!(clip.w > 0.0F)) return mark; // the mark is not in front of the eye
    const glm::vec3 at = glm::vec3(clip) / clip.w;
    const glm::vec3 own_normal = run.normal_of(number);
    const glm::vec3 sight = lens.sight(eye);
    mark.x = at.x;
    mark.y = at.y;
    mark.window = at.z;
    mark.depth = -eye.z;
    mark.pixels_per_unit = lens.pixels / clip.w;
    mark.nu = glm::dot(glm::normalize(item.normal_to_eye * own_normal), glm::normalize(sight));
    if (!inside(lens.viewport, at.x, at.y, at.z, reach(run, mark.pixels_per_unit)) || !(std::abs(mark.nu) <= 1.001F))
        return mark;
    mark.tau = style.tone == Tone::light ? light_at(item.lighting, run.place_of(number, item.unit), own_normal, mark.nu)
                                         : 0.0F;
    // The distance is measured from the eye or, in a parallel projection, from the eye's plane.
    mark.tau_depth = DepthTone(style, lens.eye_per_world)(lens.centre.w == 0.0F ? mark.depth : glm::length(sight));
    const auto threshold = static_cast<float>(style.silhouette_threshold);
    mark.mark_class = mark.nu < -threshold  ? MarkClass::front
                      : mark.nu > threshold ? MarkClass::back
                                            : MarkClass::silhouette;
    return mark;
}

// Returns whether a front mark may be ink. Tone, depth, zoom and visibility are not considered here.
[[nodiscard]] bool may_be_ink(const Run& run, std::int64_t mark) noexcept {
    return run.draws_front && (run.directions == 3U || run.draws_direction(run.marks->stroke[2 * mark] & 1U));
}

// Calls the tone callbacks of the styles for the tau of the front marks that need it, on the calling thread.
void ask_tones(const Scene& scene, ToneCalls& calls, base::Array<Mark>& marks) {
    for (const Run& run : scene.runs) {
        const ItemView& item = scene.item_of(run);
        if (item.style.tone != Tone::callback) continue;
        static_assert(sizeof(Mark) % sizeof(float) == 0);
        calls.begin(item, &marks[0].tau, sizeof(Mark) / sizeof(float));
        for (std::int64_t i = 0; i < run.count; ++i) {
            if (marks[run.first + i].mark_class == MarkClass::front && may_be_ink(run, i))
                calls.add(run.place_of(i, item.unit), run.normal_of(i), run.first + i);
        }
        calls.end();
    }
}

// ---- Radii and depths of the discs of a mark; depths are in eye units along the view

[[nodiscard]] float ink_radius(const Run& run, const Mark& mark, std::int64_t number) noexcept {
    return mark.mark_class == MarkClass::silhouette ? run.discs.silhouette_ink(mark.pixels_per_unit)
                                                    : run.front_ink(number, mark.pixels_per_unit);
}

[[nodiscard]] float splat_radius(const Run& run, const Mark& mark) noexcept {
    return mark.mark_class == MarkClass::back ? run.discs.back_splat(mark.pixels_per_unit)
                                              : run.discs.front_splat(mark.pixels_per_unit);
}

[[nodiscard]] float paper_depth(const Mark& mark, float radius) noexcept {
    return mark.depth + (mark.mark_class == MarkClass::back ? back_push(radius, mark.pixels_per_unit)
                                                            : front_push(radius, mark.nu, mark.pixels_per_unit));
}

// Returns the depth at which ink is drawn. It is nearer to the eye by the ink's radius, so that ink lies above the
// paper of its own layer.
[[nodiscard]] float ink_depth(const Mark& mark, float radius) noexcept {
    return mark.depth - radius / mark.pixels_per_unit;
}

// ---- 3. Roles

// Returns whether a mark is ink. If a front or silhouette mark is not, the reason is counted in `counts`. `visibility`
// is null if nothing hides marks.
[[nodiscard]] bool is_ink(const Run& run, const Mark& mark, std::int64_t number, const VisibilityMap* visibility,
                          Counts& counts) noexcept {
    const ToneRule rule = run.discs.style->tone_rule;
    const float rank = run.marks->rank[number];
    if (mark.mark_class == MarkClass::front) {
        if (!may_be_ink(run, number)) return false;
        const ToneTerms terms{mark.tau, mark.tau_depth, run.discs.scale(mark.pixels_per_unit), run.style->share};
        switch (front_verdict(rank, terms, rule)) {
        case Verdict::shown: break;
        case Verdict::tone: ++counts.dropped_tone; return false;
        case Verdict::zoom: ++counts.dropped_zoom; return false;
        case Verdict::depth: ++counts.dropped_depth; return false;
        }
    } else {
        if (mark.mark_class != MarkClass::silhouette || !run.draws_silhouettes) return false;
        if (!silhouette_shown(rank, mark.tau_depth, rule)) {
            ++counts.dropped_depth;
            return false;
        }
    }
    if (visibility == nullptr || !visibility->hides(mark.x, mark.y, ink_depth(mark, ink_radius(run, mark, number))))
        return true;
    ++counts.dropped_hidden;
    return false;
}

[[nodiscard]] bool is_paper(const Run& run, const Mark& mark) noexcept {
    if (!run.paints_paper) return false;
    if (mark.mark_class == MarkClass::front)
        return front_alpha(mark.nu, static_cast<float>(run.discs.style->attenuation_front)) > 0.0F;
    return mark.mark_class == MarkClass::back &&
           back_alpha(mark.nu, static_cast<float>(run.discs.style->attenuation_back)) > 0.0F;
}

void decide(const Run& run, std::int64_t number, const VisibilityMap* visibility, Mark& mark, Counts& counts) noexcept {
    ++counts.marks;
    switch (mark.mark_class) {
    case MarkClass::none: ++counts.outside; break;
    case MarkClass::back: ++counts.back; break;
    case MarkClass::front: ++counts.front; break;
    case MarkClass::silhouette: ++counts.silhouette; break;
    }
    mark.is_ink = is_ink(run, mark, number, visibility, counts);
    mark.is_paper = is_paper(run, mark);
    counts.shown += mark.is_ink ? 1 : 0;
    counts.splats += mark.is_paper ? 1 : 0;
}

// ---- 4. Dots

// Returns the dot of a mark. `run_number` is the index of the run in the scene.
[[nodiscard]] Dot dot_of(const Run& run, std::int64_t run_number, const Mark& mark, std::int64_t number,
                         bool is_paper) noexcept {
    Dot dot{};
    dot.x = mark.x;
    dot.y = mark.y;
    dot.depth = mark.depth;
    dot.window = mark.window;
    dot.pixels_per_unit = mark.pixels_per_unit;
    dot.id = run.first_id + static_cast<std::uint32_t>(number);
    dot.mark_class = mark.mark_class;
    dot.layer = 2U * static_cast<std::uint32_t>(run_number) + (mark.mark_class == MarkClass::silhouette ? 1U : 0U);
    dot.radius = is_paper ? splat_radius(run, mark) : ink_radius(run, mark, number);
    dot.opacity = !is_paper ? 1.0F
                  : mark.mark_class == MarkClass::back
                      ? run.discs.back_opacity(mark.nu, dot.radius, mark.pixels_per_unit)
                      : run.discs.front_opacity(mark.nu, dot.radius, mark.pixels_per_unit);
    if (is_paper) dot.flags = dot_is_paper;
    return dot;
}

} // namespace

// ---- 2. Visibility

void VisibilityMap::build(const base::Parallel& parallel, const Scene& scene, const base::Array<Mark>& marks) {
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
    base::resize_scratch(occluders_, marks.size());
    for_marks(parallel, scene, [&](const Run& run, std::int64_t place, std::int64_t) {
        const Mark& mark = marks[place];
        occluders_[place].radius = -1.0F;
        if (!run.occludes || (mark.mark_class != MarkClass::front && mark.mark_class != MarkClass::back)) return;
        const float radius = run.discs.front_splat(mark.pixels_per_unit);
        occluders_[place] = {(mark.x - left_) * texels_per_pixel_, (mark.y - top_) * texels_per_pixel_,
                             radius * texels_per_pixel_, paper_depth(mark, radius)};
    });
    const std::array all = {IndexRange{0, occluders_.size()}};
    bins_.build(parallel, width_, height_, all, [this](std::int64_t i, drawing::Tiles::Footprint& print) {
        const Occluder& disc = occluders_[i];
        print = drawing::Tiles::Footprint::of_disc(disc.x, disc.y, disc.radius);
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
            // The range contains the texels whose centres are within the disc.
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

void PublishedFrame::run(const Scene& scene, drawing::Drawing& drawing) {
    drawing.painting = drawing::Painting::published;
    const base::Parallel& parallel = runtime_.parallel;
    base::Stopwatch watch;
    base::resize_scratch(marks_, scene.mark_count());
    for_marks(parallel, scene, [&](const Run& run, std::int64_t place, std::int64_t) {
        marks_[place] = classify(run, scene.item_of(run), scene.lens, place - run.first);
    });
    ask_tones(scene, tone_calls_, marks_);
    const std::int64_t classified = watch.nanoseconds();

    watch.restart();
    const bool hiding = std::any_of(scene.runs.begin(), scene.runs.end(), [](const Run& run) { return run.occludes; });
    if (hiding) visibility_.build(parallel, scene, marks_);
    const std::int64_t seen = watch.nanoseconds();

    watch.restart();
    counts_.clear();
    counts_.resize((marks_.size() + marks_a_task - 1) / marks_a_task);
    for_marks(parallel, scene, [&](const Run& run, std::int64_t place, std::int64_t task) {
        decide(run, place - run.first, hiding ? &visibility_ : nullptr, marks_[place], counts_[task]);
    });
    Counts& all = drawing.counts;
    for (const Counts& counts : counts_) all += counts;
    all.nanoseconds_classify = classified + watch.nanoseconds();
    all.nanoseconds_visibility = seen;

    watch.restart();
    find_keys(scene);
    order_.sort(parallel, keys_);
    base::resize_scratch(drawing.dots, keys_.size());
    drawing.dot_ranges.push_back({0, keys_.size()});
    drawing.dot_count = all.shown;
    parallel.for_chunks(keys_.size(), marks_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const auto disc = static_cast<std::uint32_t>(keys_[i]);
            const std::int64_t place = disc >> 1U;
            const Run* run = std::upper_bound(scene.runs.begin(), scene.runs.end(), place,
                                              [](std::int64_t p, const Run& r) { return p < r.first; }) -
                             1;
            drawing.dots[i] =
                dot_of(*run, run - scene.runs.begin(), marks_[place], place - run->first, (disc & 1U) != 0);
        }
    });
    all.nanoseconds_sort = watch.nanoseconds();
}

// Makes a sort key for each disc, in the order of the marks. A key consists of the disc's depth, and of twice the index
// of the mark, plus 1 for paper. The counts of a task tell where its keys begin.
void PublishedFrame::find_keys(const Scene& scene) {
    next_key_.clear();
    std::int64_t total = 0;
    for (const Counts& counts : counts_)
        next_key_.push_back(std::exchange(total, total + counts.shown + counts.splats));
    base::resize_scratch(keys_, total);
    for_marks(runtime_.parallel, scene, [&](const Run& run, std::int64_t place, std::int64_t task) {
        const Mark& mark = marks_[place];
        const auto disc = static_cast<std::uint32_t>(place) << 1U;
        if (mark.is_paper)
            keys_[next_key_[task]++] = drawing::far_first_key(paper_depth(mark, splat_radius(run, mark)), disc | 1U);
        if (mark.is_ink)
            keys_[next_key_[task]++] =
                drawing::far_first_key(ink_depth(mark, ink_radius(run, mark, place - run.first)), disc);
    });
    HRBFNPR_ASSERT(next_key_.empty() || next_key_.back() == total);
}

} // namespace hrbfnpr::published
