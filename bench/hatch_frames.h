// SPDX-License-Identifier: MIT
// Pictures of hatching on several models from several sides: how evenly lines lie on the screen, how often they end,
// and whether pictures of other sizes have the same lines.
#pragma once

#include "hatch_pictures.h"
#include "line_models.h"
#include "line_views.h"
#include "same_strokes.h"
#include "stroke_ends.h"
#include "stroke_gaps.h"

#include <cstdio>
#include <map>
#include <string>

namespace bench {

inline constexpr double frame_size = 800.0;

[[nodiscard]] inline std::vector<glm::dvec3> frame_directions() {
    return {glm::normalize(glm::dvec3(-0.3, -0.2, -1.0)), glm::normalize(glm::dvec3(1.0, -0.4, -0.3)),
            glm::normalize(glm::dvec3(0.2, -0.9, 0.5))};
}

// Returns the same medium tone everywhere.
inline std::int32_t even_tone(void*, std::int64_t count, const float*, const float*, float* tau) {
    std::fill_n(tau, count, 0.5F);
    return 0;
}

// ---- How evenly lines lie on the screen ----------------------------------------------------

struct ScreenSpacing {
    std::vector<double> gaps;                                 // pixels
    std::map<std::pair<int, int>, std::vector<double>> parts; // the gaps in each square of the picture
    double alone = 0.0;                                       // the number of sides without a line near

    // Returns the root mean square over all squares of the variation of gaps within a square. Lines of nested levels
    // may be up to twice as far apart in one place as in another, but not beside each other.
    [[nodiscard]] double variation_of_parts() const {
        constexpr std::size_t fewest = 20;
        double squares = 0.0;
        double number = 0.0;
        for (const auto& [square, values] : parts) {
            if (values.size() < fewest) continue;
            const auto count = static_cast<double>(values.size());
            squares += count * std::pow(spread_of(values).variation, 2.0);
            number += count;
        }
        return number > 0.0 ? std::sqrt(squares / number) : 0.0;
    }

    [[nodiscard]] double alone_share() const { return alone / (alone + static_cast<double>(gaps.size())); }
};

// Only gaps away from the contours count: both lines face the eye by at least this, and lie on the same piece of the
// surface.
inline constexpr double away_from_contours = 0.4;
inline constexpr float part_side = 40.0F; // pixels

inline void add_gaps(const std::vector<DrawnStroke>& strokes, const MarkTable& marks, const hrbfnpr_camera& camera,
                     ScreenSpacing& spacing) {
    const Lens lens(camera);
    const auto facing = [&](std::uint32_t id) { return -lens.facing(marks.position[id - 1], marks.normal[id - 1]); };
    const double rows = lens.viewport.w * 0.5 * camera.projection[5]; // pixels per unit at the distance 1
    for_each_gap(strokes, {}, [&](const StrokePoint& from, const std::optional<Gap>& gap) {
        const glm::dvec3 here = marks.position[from.id - 1];
        if (facing(from.id) < away_from_contours || !lens.holds({from.x, from.y}, 20.0)) return;
        if (!gap) {
            spacing.alone += 1.0;
            return;
        }
        const glm::dvec3 between = marks.position[gap->beside - 1] - here;
        const double pixels = glm::length(between) * rows / glm::distance(here, lens.eye);
        const bool same_piece = glm::dot(marks.normal[from.id - 1], marks.normal[gap->beside - 1]) > 0.5 &&
                                pixels < 4.0 + 1.5 * gap->size / away_from_contours;
        if (!same_piece || facing(gap->beside) < away_from_contours) return;
        spacing.gaps.push_back(gap->size);
        spacing.parts[{static_cast<int>(from.x / part_side), static_cast<int>(from.y / part_side)}].push_back(
            gap->size);
    });
}

[[nodiscard]] inline ScreenSpacing screen_spacing(hrbfnpr_context* context, const hrbfnpr_model* model,
                                                  const glm::dvec3& direction, const hrbfnpr_point_set* set,
                                                  const MarkTable& marks) {
    Style style = hatch_style(HRBFNPR_PRESET_ENGRAVING, frame_size);
    style.line_count = 0;
    style.tone = HRBFNPR_TONE_CALLBACK;
    style.tone_function = even_tone;
    StrokePainter painter(context, set, style);
    const hrbfnpr_model_info info = info_of(model);
    const hrbfnpr_camera camera = square_camera(info.bounds_min, info.bounds_max, direction, frame_size);
    painter.draw(camera);
    ScreenSpacing spacing;
    add_gaps(painter.strokes(), marks, camera, spacing);
    return spacing;
}

// ---- How often lines end -------------------------------------------------------------------

[[nodiscard]] inline StrokeEnds ends_of(StrokePainter& painter, const hrbfnpr_model* model) {
    const hrbfnpr_model_info info = info_of(model);
    StrokeEnds ends;
    for (const glm::dvec3& direction : frame_directions()) {
        painter.draw(square_camera(info.bounds_min, info.bounds_max, direction, frame_size));
        for (const DrawnStroke& stroke : painter.strokes()) add_ends(ends, stroke, frame_size, frame_size);
    }
    return ends;
}

// Returns the ends of lines that are thinned out by their distance, or of all lines, drawn as hairlines. The latter end
// only where the surface is light, turns away or is hidden, which no choice of lines along these directions can avoid.
[[nodiscard]] inline StrokeEnds ends_of_hatching(hrbfnpr_context* context, const hrbfnpr_model* model,
                                                 std::uint32_t preset, bool every_line) {
    const scenes::PointSet set = hatch_set(context, model, preset);
    Style style = hatch_style(preset, frame_size);
    style.line_count = 0;
    if (every_line) {
        for (hrbfnpr_layer_style& layer : style.layer) {
            layer.hatch_white = 0.0F;
            layer.hatch_pen = 0.02F;
            layer.hatch_spacing = 0.05F;
        }
    }
    StrokePainter painter(context, set.get(), style);
    return ends_of(painter, model);
}

// ---- The same at every size ----------------------------------------------------------------

inline constexpr std::array<double, 4> frame_sizes{640.0, 1000.0, 1600.0, 3200.0};

struct SizedStrokes {
    double size;
    std::vector<DrawnStroke> strokes;
};

// The least share of the length of a size's strokes that another size also has, within half a pixel of the smallest.
struct SameAtSizes {
    double kept = 1.0;  // from a size to a larger one
    double added = 1.0; // from a size to a smaller one, where the rest was thinned out
};

// Returns the lines of a style, scaled to a picture of `size` pixels.
[[nodiscard]] inline std::vector<hrbfnpr_line_style> picture_lines(const Style& style, double size) {
    std::vector<hrbfnpr_line_style> lines(style.lines, style.lines + style.line_count);
    for (hrbfnpr_line_style& line : lines)
        for (float* const pixels : {&line.width, &line.hidden_width, &line.taper, &line.shortest})
            *pixels *= pen_of(size);
    return lines;
}

// Returns the hatching strokes of a picture with its contours and halos.
[[nodiscard]] inline std::vector<DrawnStroke> picture_strokes(hrbfnpr_context* context, const hrbfnpr_model* model,
                                                              const hrbfnpr_point_set* set,
                                                              const hrbfnpr_line_set* line_set, std::uint32_t preset,
                                                              double size) {
    Style style = hatch_style(preset, size);
    style.halo_width = Style(preset).halo_width * pen_of(size);
    const std::vector<hrbfnpr_line_style> lines = picture_lines(style, size);
    style.lines = lines.data();
    const hrbfnpr_model_info info = info_of(model);
    StrokePainter painter(context, set, style, line_set);
    painter.draw(square_camera(info.bounds_min, info.bounds_max, frame_directions()[0], size));
    std::vector<DrawnStroke> strokes = painter.strokes();
    std::erase_if(strokes, [](const DrawnStroke& stroke) { return stroke.empty() || stroke.front().id == 0; });
    return strokes;
}

[[nodiscard]] inline SameAtSizes same_at_sizes(hrbfnpr_context* context, const hrbfnpr_model* model,
                                               std::uint32_t preset) {
    const scenes::PointSet set = hatch_set(context, model, preset);
    const LineSet line_set = make_line_set(context, model);
    const MarkTable marks(set.get());
    const auto line = [&](std::uint32_t id) { return marks.place[id - 1].line; };
    std::vector<SizedStrokes> pictures;
    for (const double size : frame_sizes)
        pictures.push_back({size, picture_strokes(context, model, set.get(), line_set.get(), preset, size)});
    SameAtSizes same;
    for (const SizedStrokes& one : pictures)
        for (const SizedStrokes& other : pictures) {
            if (one.size == other.size) continue;
            const double reach = 0.5 * one.size / frame_sizes[0];
            const float seen = 0.025F * pen_of(one.size);
            const double share =
                shared_length(one.strokes, other.strokes, one.size / other.size, reach, line, seen).share();
            double& least = one.size < other.size ? same.kept : same.added;
            std::printf("  %5.0f in %5.0f: %.4f\n", one.size, other.size, share);
            least = std::min(least, share);
        }
    return same;
}

} // namespace bench
