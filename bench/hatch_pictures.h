// SPDX-License-Identifier: MIT
// Hatching as the command line draws it: the same lines for all sizes, with lengths in pixels that scale with the
// picture.
#pragma once

#include "line_calls.h"
#include "stroke_painter.h"
#include "width_changes.h"

#include <algorithm>

namespace bench {

// Generates the layers of a style: the first `sets` sets of hatching lines, spaced as by the command line, 300 per
// square root of the area; and some stipples, which show where the surface is.
[[nodiscard]] inline scenes::PointSet hatch_set(hrbfnpr_context* context, const hrbfnpr_model* model,
                                                std::uint32_t preset, int sets = 3) {
    constexpr std::int64_t few = 2000;
    const hrbfnpr_point_set_info probe =
        info_of(generate(context, model, one_layer(HRBFNPR_LAYER_KIND_STIPPLES, few)).get());
    const double separation = probe.spacing * std::sqrt(static_cast<double>(probe.marks)) / 300.0;
    Generation desc;
    std::int64_t count = 0;
    const hrbfnpr_layer_desc* layers = hrbfnpr_preset_layers(preset, &count);
    for (std::int64_t i = 0; i < count; ++i) {
        const bool lines = layers[i].kind == HRBFNPR_LAYER_KIND_HATCH;
        if (lines && sets-- <= 0) continue;
        desc.layer.push_back(layers[i]);
        desc.layer.back().separation = lines ? separation : 0.0;
        desc.layer.back().budget = lines ? 0 : 40'000;
    }
    return generate(context, model, desc);
}

// Returns the pen scale of the command line for a picture of `size` pixels: it is constant below 600.
[[nodiscard]] inline float pen_of(double size) { return static_cast<float>(std::max(0.75, size / 800.0)); }

// Returns a style whose lengths are scaled to a picture of `size` pixels, without halos.
[[nodiscard]] inline Style hatch_style(std::uint32_t preset, double size) {
    Style style(preset);
    const float pen = pen_of(size);
    for (hrbfnpr_layer_style& layer : style.layer) {
        for (float* const pixels : {&layer.radius, &layer.hatch_spacing, &layer.hatch_pen, &layer.hatch_white,
                                    &layer.hatch_taper, &layer.hatch_shortest})
            *pixels *= pen;
    }
    style.halo_width = 0.0F;
    return style;
}

// Returns a camera of `size` x `size` pixels that the box fills.
[[nodiscard]] inline hrbfnpr_camera square_camera(const double* low, const double* high, const glm::dvec3& direction,
                                                  double size) {
    scenes::Check check;
    auto camera = scenes::made(hrbfnpr_camera_init);
    const glm::dvec3 up = std::abs(direction.y) > 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, 1.0, 0.0);
    check(hrbfnpr_camera_fit_bounds(&camera, low, high, glm::value_ptr(direction), glm::value_ptr(up), 0.5, size, size,
                                    0.02, check.error()));
    return camera;
}

// Positions, normals and places of all marks of a set, by mark number.
struct MarkTable {
    explicit MarkTable(const hrbfnpr_point_set* set) {
        const hrbfnpr_point_set_info info = info_of(set);
        std::uint32_t line = 0;
        for (std::int64_t layer = 0; layer < info.layers; ++layer) {
            std::int64_t count = 0;
            const float* p = attribute<float>(set, layer, HRBFNPR_MARK_ATTRIBUTE_POSITION, count);
            const float* n = attribute<float>(set, layer, HRBFNPR_MARK_ATTRIBUTE_NORMAL, count);
            const std::uint32_t* stroke = attribute<std::uint32_t>(set, layer, HRBFNPR_MARK_ATTRIBUTE_STROKE, count);
            for (std::int64_t i = 0; i < count; ++i) {
                position.push_back(glm::make_vec3(info.origin) + glm::dvec3(glm::make_vec3(p + 3 * i)));
                normal.emplace_back(glm::make_vec3(n + 3 * i));
                const bool goes_on = i > 0 && stroke[2 * i] == stroke[2 * i - 2];
                const auto number = static_cast<std::uint32_t>(place.size());
                place.push_back(goes_on ? place.back() : MarkPlace{++line, number, 0, false});
            }
        }
        std::vector<std::uint32_t> counts(line + 1, 0);
        for (const MarkPlace& mark : place) ++counts[mark.line];
        for (MarkPlace& mark : place) {
            mark.count = counts[mark.line];
            mark.closed = is_closed(mark);
        }
    }
    // Applies the same rule as the hatching: a line is closed if its ends meet and point the same way, but not if they
    // meet at a corner or lie side by side.
    [[nodiscard]] bool is_closed(const MarkPlace& line) const {
        if (line.count < 4) return false;
        const glm::dvec3* const first = &position[line.first];
        const glm::dvec3* const last = first + line.count - 1;
        const glm::dvec3 gap = first[0] - last[0];
        const double step = glm::distance(first[0], first[1]);
        const auto goes_on = [&](const glm::dvec3& way) {
            return glm::dot(way, gap) >= 0.8 * glm::length(gap) * glm::length(way);
        };
        return glm::length(gap) <= 0.1 * step ||
               (glm::length(gap) <= 1.5 * step && goes_on(first[1] - first[0]) && goes_on(last[0] - last[-1]));
    }

    std::vector<glm::dvec3> position, normal;
    std::vector<MarkPlace> place;
};

} // namespace bench
