// SPDX-License-Identifier: MIT
#include "published/published_frame.h"

#include "base/clock.h"
#include "base/scratch.h"

#include <algorithm>

namespace hrbfnpr::published {
namespace {

constexpr std::int64_t dot_grain = 4096;

} // namespace

PublishedFrame::PublishedFrame(const base::Runtime& runtime) noexcept
    : runtime_(runtime), tone_calls_(runtime.memory), visibility_(runtime.memory), order_(runtime.memory),
      counts_(runtime.memory), first_key_(runtime.memory), keys_(runtime.memory) {}

void PublishedFrame::run(Scene& scene, drawing::Drawing& drawing) {
    drawing.painting = drawing::Painting::published;
    const base::Parallel& parallel = runtime_.parallel;
    base::Stopwatch watch;
    add_chunks(scene);
    classify(parallel, scene);
    ask_tones(scene, tone_calls_);
    const std::int64_t classified = watch.nanoseconds();

    watch.restart();
    const bool hiding = hides(scene);
    if (hiding) visibility_.build(parallel, scene);
    const std::int64_t seen = watch.nanoseconds();

    watch.restart();
    decide(parallel, scene, hiding ? &visibility_ : nullptr, counts_);
    Counts& info = drawing.counts;
    for (const Counts& chunk : counts_) info += chunk;
    info.nanoseconds_classify = classified + watch.nanoseconds();
    info.nanoseconds_visibility = seen;

    watch.restart();
    emit_keys(scene);
    order_.sort(parallel, keys_);
    put_dots(scene, drawing);
    info.nanoseconds_sort = watch.nanoseconds();
}

bool PublishedFrame::hides(const Scene& scene) noexcept {
    return std::any_of(scene.runs.begin(), scene.runs.end(), [](const Run& run) { return run.occludes; });
}

float PublishedFrame::ink_radius(const Scene& scene, const Run& run, std::int64_t place) noexcept {
    const float pixels_per_unit = scene.marks.pixels_per_unit[place];
    return scene.marks.mark_class[place] == MarkClass::silhouette ? run.pen.silhouette_ink(pixels_per_unit)
                                                                  : run.front_ink(place - run.first, pixels_per_unit);
}

float PublishedFrame::splat_radius(const Scene& scene, const Run& run, std::int64_t place) noexcept {
    const float pixels_per_unit = scene.marks.pixels_per_unit[place];
    return scene.marks.mark_class[place] == MarkClass::back ? run.pen.back_splat(pixels_per_unit)
                                                            : run.pen.front_splat(pixels_per_unit);
}

std::uint64_t PublishedFrame::ink_key(const Scene& scene, const Run& run, std::int64_t place) noexcept {
    const Marks& m = scene.marks;
    const float depth = ink_depth(m.depth[place], ink_radius(scene, run, place), m.pixels_per_unit[place]);
    return drawing::far_first_key(depth, static_cast<std::uint32_t>(place) << 1U);
}

std::uint64_t PublishedFrame::paper_key(const Scene& scene, const Run& run, std::int64_t place) noexcept {
    const Marks& m = scene.marks;
    return drawing::far_first_key(paper_depth(m, place, splat_radius(scene, run, place)),
                                  static_cast<std::uint32_t>(place) << 1U | 1U);
}

// A key for each disc, in the order of the marks.
void PublishedFrame::emit_keys(const Scene& scene) {
    base::resize_scratch(first_key_, counts_.size());
    std::int64_t total = 0;
    for (std::int64_t c = 0; c < counts_.size(); ++c) {
        first_key_[c] = total;
        total += counts_[c].shown + counts_[c].splats;
    }
    base::resize_scratch(keys_, total);
    runtime_.parallel.for_each(scene.chunks.size(), [&](std::int64_t c) {
        const Chunk& chunk = scene.chunks[c];
        const Run& run = scene.runs[chunk.run];
        std::int64_t next = first_key_[c];
        for (std::int64_t place = chunk.begin; place < chunk.end; ++place) {
            const unsigned role = scene.marks.role[place];
            if ((role & role_paper) != 0) keys_[next++] = paper_key(scene, run, place);
            if ((role & role_ink) != 0) keys_[next++] = ink_key(scene, run, place);
        }
    });
}

void PublishedFrame::put_dots(const Scene& scene, drawing::Drawing& drawing) const {
    base::resize_scratch(drawing.dots, keys_.size());
    drawing.dot_pieces.push_back({0, keys_.size()});
    drawing.dot_count = drawing.counts.shown;
    runtime_.parallel.for_chunks(keys_.size(), dot_grain, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const auto what = static_cast<std::uint32_t>(keys_[i]);
            const std::int64_t place = what >> 1U;
            const Run* run = std::upper_bound(scene.runs.begin(), scene.runs.end(), place,
                                              [](std::int64_t p, const Run& r) { return p < r.first; }) -
                             1;
            drawing.dots[i] = dot_of(scene, run - scene.runs.begin(), place, (what & 1U) != 0);
        }
    });
}

Dot PublishedFrame::dot_of(const Scene& scene, std::int64_t number, std::int64_t place, bool is_paper) noexcept {
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

std::int64_t PublishedFrame::bytes() const noexcept {
    return tone_calls_.bytes() + visibility_.bytes() + order_.bytes() + counts_.bytes() + first_key_.bytes() +
           keys_.bytes();
}

} // namespace hrbfnpr::published
