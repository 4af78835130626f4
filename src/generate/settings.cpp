// SPDX-License-Identifier: MIT
#include "generate/settings.h"

#include "base/assert.h"
#include "base/status.h"
#include "generate/tuning.h"
#include "marks/site.h"

#include <algorithm>

namespace hrbfnpr::generate {
namespace {

// Returns the number of directions of a layer. Only strokes of the published recursion run in two directions, and each
// direction has a separate tone range.
std::size_t directions_of(const Settings& settings, const LayerSettings& layer) noexcept {
    return layer.has_strokes() && settings.distribution == marks::Distribution::published ? 2 : 1;
}

// Sets the tone ranges that are missing: to all tones or, with ToneRanges::in_turn, to parts of equal length for all
// directions of all layers.
void fill_parts(Settings& settings) {
    HRBFNPR_ASSERT(!settings.layers.empty());
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

// Divides the budget among the layers in proportion to the lengths of their tone ranges.
void share_budget(Settings& settings) {
    if (settings.shared_budget == 0) return;
    double all = 0.0;
    for (const LayerSettings& layer : settings.layers) all += tones_of(settings, layer);
    for (LayerSettings& layer : settings.layers)
        layer.budget = std::max<std::int64_t>(1, static_cast<std::int64_t>(static_cast<double>(settings.shared_budget) *
                                                                           tones_of(settings, layer) / all));
    settings.shared_budget = 0;
}

void check_layers(const Settings& settings) {
    const bool published = settings.distribution == marks::Distribution::published;
    const auto stipples = std::find_if(settings.layers.begin(), settings.layers.end(),
                                       [](const LayerSettings& layer) { return !layer.has_strokes(); });
    for (std::size_t i = 0; i < settings.layers.size(); ++i) {
        const LayerSettings& layer = settings.layers[i];
        const hatching::Guide guide = layer.hatching.field.guide;
        if (published && layer.has_strokes() && layer.hatching.direction.function == nullptr &&
            guide != hatching::Guide::curvature && guide != hatching::Guide::combing)
            fail(Status::invalid_argument,
                 "generate_desc.layers[%zu].guide is %u; PUBLISHED strokes follow CURVATURE (0), COMBING (1) or a "
                 "direction_function",
                 i, static_cast<unsigned>(guide));
        if (!published && layer.budget > marks::most_even_marks)
            fail(Status::invalid_argument,
                 "generate_desc asks for %lld marks in layers[%zu], but BLUE_NOISE makes at most %lld; lower budget or "
                 "shared_budget",
                 static_cast<long long>(layer.budget), i, static_cast<long long>(marks::most_even_marks));
        if (!published && layer.budget == 0 && !(layer.has_strokes() && layer.hatching.separation > 0.0))
            fail(Status::invalid_argument, "generate_desc.layers[%zu].budget is 0; %s", i,
                 layer.has_strokes() ? "with BLUE_NOISE, strokes need a budget or a separation above 0"
                                     : "with BLUE_NOISE, stipples need a budget above 0");
        if (!layer.published.from_stipples) continue;
        if (!published)
            fail(Status::invalid_argument,
                 "generate_desc.layers[%zu].start is STIPPLES; only PUBLISHED strokes can start from stipples", i);
        if (!layer.has_strokes())
            fail(Status::invalid_argument,
                 "generate_desc.layers[%zu].start is STIPPLES, but the layer is one of stipples; use SEEDS", i);
        if (stipples != settings.layers.end() && layer.published.start_level > stipples->published.levels)
            fail(Status::invalid_argument,
                 "generate_desc.layers[%zu].start_level is %d; it must be at most %d, the levels of the stipples", i,
                 static_cast<int>(layer.published.start_level), static_cast<int>(stipples->published.levels));
    }
}

} // namespace

Settings completed(Settings settings) {
    if (settings.layers.empty()) settings.layers.emplace_back();
    for (LayerSettings& layer : settings.layers) {
        if (layer.name[0] == '\0') layer.name = marks::default_name(layer.kind);
        if (layer.published.levels < 0)
            layer.published.levels =
                layer.has_strokes() ? generate_tuning.stroke_levels : generate_tuning.stipple_levels;
        if (layer.tone_smoothing < 0.0)
            layer.tone_smoothing = layer.has_strokes() && settings.distribution == marks::Distribution::blue_noise
                                       ? generate_tuning.hatching_tone_smoothing
                                       : 0.0;
    }
    fill_parts(settings);
    share_budget(settings);
    check_layers(settings);
    return settings;
}

} // namespace hrbfnpr::generate
