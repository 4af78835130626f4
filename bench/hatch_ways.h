// SPDX-License-Identifier: MIT
// Hatching along a camera path, by the same measure as for stipples: whether the ink at each place of the surface pops
// or vanishes from one frame to the next.
#pragma once

#include "changes.h"
#include "hatch_pictures.h"
#include "line_times.h"

#include <limits>

namespace bench {

// Light fixed to the world and hidden lines shown, so that nothing is occluded and the tone of a place stays the same.
[[nodiscard]] inline Style way_style(std::uint32_t preset, double size) {
    Style style = hatch_style(preset, size);
    style.line_count = 0;
    style.hidden_lines = HRBFNPR_HIDDEN_LINES_SHOW;
    style.light_space = HRBFNPR_LIGHT_WORLD;
    return style;
}

// Returns the thinnest pen of the hatching layers.
[[nodiscard]] inline float thinnest_pen(const Style& style) {
    float pen = std::numeric_limits<float>::infinity();
    for (const hrbfnpr_layer_style& layer : style.layer)
        if (layer.shape == HRBFNPR_SHAPE_HATCH) pen = std::min(pen, layer.hatch_pen);
    return pen;
}

// Follows the marks of one set from frame to frame.
class HatchFollower {
public:
    explicit HatchFollower(const hrbfnpr_point_set* set) : table_(set) {}

    void look(const hrbfnpr_camera& camera, const std::vector<DrawnStroke>& strokes) {
        constexpr double away = 0.25; // as for stipples: marks that face the eye by less may be near a contour
        const Lens lens(camera);
        std::vector<MarkInk>& inks = frames_.emplace_back(table_.place.size());
        std::vector<glm::vec2> images(inks.size());
        for (std::size_t i = 0; i < inks.size(); ++i) {
            const glm::dvec2 image = lens.image_of(table_.position[i]);
            images[i] = image;
            inks[i].counts = lens.facing(table_.position[i], table_.normal[i]) < -away && lens.holds(image, 2.0);
        }
        for (const DrawnStroke& stroke : strokes) add_widths(stroke, table_.place, images, inks);
    }
    [[nodiscard]] WidthChanges changes(float pen) const { return width_changes(frames_, pen); }
    [[nodiscard]] const MarkTable& table() const { return table_; }
    [[nodiscard]] const std::vector<std::vector<MarkInk>>& frames() const { return frames_; }

private:
    MarkTable table_;
    std::vector<std::vector<MarkInk>> frames_;
};

[[nodiscard]] inline WidthChanges follow_hatching(hrbfnpr_context* context, const hrbfnpr_point_set* set,
                                                  std::uint32_t preset, const Way& way) {
    constexpr int size = 800;
    const Orbit orbit(set, size, size);
    const Style style = way_style(preset, size);
    StrokePainter painter(context, set, style);
    HatchFollower follower(set);
    for (int step = 0; step <= way.steps; ++step) {
        const hrbfnpr_camera camera = orbit.at(step * way.degrees, std::pow(way.zoom, step));
        painter.draw(camera);
        follower.look(camera, painter.strokes());
    }
    return follower.changes(thinnest_pen(style));
}

} // namespace bench
