// SPDX-License-Identifier: MIT
#include "generate/settings.h"

#include "base/status.h"
#include "marks/marks.h"

#include <algorithm>

namespace hrbfnpr::generate {
namespace {

constexpr std::int32_t stipple_levels = 4;
constexpr std::int32_t stroke_levels = 3;
// Over how long a way the normals that the tone of hatching goes by are averaged, in diagonals. A line shows each turn
// of its surface by its width, whereas stipples average over many turns. Larger: calmer lines, and less of small forms.
constexpr double hatching_tone_smoothing = 0.006;

// Only strokes of the published recursion run in two directions, each of which has a part of the tones.
std::size_t directions_of(const Settings& settings, const LayerSettings& layer) noexcept {
    return layer.has_strokes() && settings.distribution == marks::Distribution::published ? 2 : 1;
}

// Those that do not say their part themselves have all tones, or share them evenly with all others in turn.
void fill_parts(Settings& settings) {
    double all = 0.0;
    for (const LayerSettings& layer : settings.layers) all += static_cast<double>(directions_of(settings, layer));
    double before = 0.0;
    for (LayerSettings& layer : settings.layers) {
        for (std::size_t direction = 0; direction < directions_of(settings, layer); ++direction) {
            marks::TonePart& part = layer.part[direction];
            if (part.begin == 0.0 && part.end == 0.0)
                part = settings.tone_ranges == ToneRanges::full ? marks::TonePart{}
                                                                : marks::TonePart{before / all, (before + 1.0) / all};
            before += 1.0;
        }
        if (directions_of(settings, layer) == 1) layer.part[1] = layer.part[0];
    }
}

double tones_of(const Settings& settings, const LayerSettings& layer) noexcept {
    double length = 0.0;
    for (std::size_t direction = 0; direction < directions_of(settings, layer); ++direction)
        length += layer.part[direction].length();
    return length;
}

// Each layer's marks in proportion to its part of the tones.
void share_budget(Settings& settings) {
    if (settings.shared_budget == 0) return;
    double all = 0.0;
    for (const LayerSettings& layer : settings.layers) all += tones_of(settings, layer);
    for (LayerSettings& layer : settings.layers)
        layer.budget = std::max<std::int64_t>(1, static_cast<std::int64_t>(static_cast<double>(settings.shared_budget) *
                                                                           tones_of(settings, layer) / all));
    settings.shared_budget = 0;
}

void check_budgets(const Settings& settings) {
    if (settings.distribution == marks::Distribution::published) return;
    for (std::size_t i = 0; i < settings.layers.size(); ++i) {
        const LayerSettings& layer = settings.layers[i];
        if (layer.budget > marks::most_even_marks)
            fail(Status::invalid_argument,
                 "generate_desc asks for %lld marks in layers[%zu]; BLUE_NOISE makes %lld at most: lower budget or "
                 "shared_budget",
                 static_cast<long long>(layer.budget), i, static_cast<long long>(marks::most_even_marks));
        if (layer.budget == 0 && !(layer.has_strokes() && layer.hatching.separation > 0.0))
            fail(Status::invalid_argument, "generate_desc.layers[%zu].budget is 0, no limit; %s", i,
                 layer.has_strokes() ? "set it, or the separation that limits the lines of BLUE_NOISE"
                                     : "stipples of BLUE_NOISE need one: say how many there may be");
    }
}

const LayerSettings* first_stipples(const Settings& settings) noexcept {
    for (const LayerSettings& layer : settings.layers)
        if (!layer.has_strokes()) return &layer;
    return nullptr;
}

void check_guides(const Settings& settings) {
    if (settings.distribution != marks::Distribution::published) return;
    for (std::size_t i = 0; i < settings.layers.size(); ++i) {
        const LayerSettings& layer = settings.layers[i];
        if (layer.has_strokes() && layer.hatching.direction.function == nullptr &&
            layer.hatching.field.guide != hatching::Guide::curvature &&
            layer.hatching.field.guide != hatching::Guide::combing)
            fail(Status::invalid_argument,
                 "generate_desc.layers[%zu].guide is %u; strokes of the PUBLISHED distribution follow CURVATURE (0), "
                 "COMBING (1) or a direction_function",
                 i, static_cast<unsigned>(layer.hatching.field.guide));
    }
}

void check_starts(const Settings& settings) {
    const LayerSettings* const stipples = first_stipples(settings);
    for (std::size_t i = 0; i < settings.layers.size(); ++i) {
        const published::Settings& given = settings.layers[i].published;
        if (!given.from_stipples) continue;
        if (settings.distribution != marks::Distribution::published)
            fail(Status::invalid_argument,
                 "generate_desc.layers[%zu].start is STIPPLES; only the PUBLISHED distribution can start strokes there",
                 i);
        if (!settings.layers[i].has_strokes())
            fail(Status::invalid_argument,
                 "generate_desc.layers[%zu].start is STIPPLES; the stipples themselves start from SEEDS", i);
        if (stipples != nullptr && given.start_level > stipples->published.levels)
            fail(Status::invalid_argument,
                 "generate_desc.layers[%zu].start_level is %d, above the %d levels of the "
                 "stipples",
                 i, static_cast<int>(given.start_level), static_cast<int>(stipples->published.levels));
    }
}

} // namespace

Settings completed(Settings settings) {
    if (settings.layers.empty()) settings.layers.emplace_back();
    for (LayerSettings& layer : settings.layers) {
        if (layer.name[0] == '\0') layer.name = marks::default_name(layer.kind);
        if (layer.published.levels < 0) layer.published.levels = layer.has_strokes() ? stroke_levels : stipple_levels;
        if (layer.tone_smoothing < 0.0)
            layer.tone_smoothing = layer.has_strokes() && settings.distribution == marks::Distribution::blue_noise
                                       ? hatching_tone_smoothing
                                       : 0.0;
    }
    fill_parts(settings);
    share_budget(settings);
    check_guides(settings);
    check_budgets(settings);
    check_starts(settings);
    return settings;
}

} // namespace hrbfnpr::generate
