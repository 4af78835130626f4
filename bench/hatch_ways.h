// SPDX-License-Identifier: MIT
// Lines of hatching along a way of the camera, by the measure that stipples have: of each place of the surface, whether
// its ink pops or vanishes from one frame to the next.
#pragma once

#include "changes.h"
#include "hatch_pictures.h"
#include "line_times.h"

namespace bench {

// Light of the world and hidden lines shown: nothing passes behind anything, and the tone of a place stays.
[[nodiscard]] inline Style way_style(std::uint32_t preset, double size) {
    Style style = hatch_style(preset, size);
    style.line_count = 0;
    style.hidden_lines = HRBFNPR_HIDDEN_LINES_SHOW;
    style.light_space = HRBFNPR_LIGHT_WORLD;
    return style;
}

// The marks of one set, frame after frame.
class HatchFollower {
public:
    explicit HatchFollower(const hrbfnpr_point_set* set) : table_(set) {}

    void look(const hrbfnpr_camera& camera, const std::vector<DrawnStroke>& strokes) {
        constexpr double away = 0.25; // as for stipples: what faces the eye by less may be a contour's
        const Lens lens(camera);
        std::vector<MarkInk>& inks = frames_.emplace_back(table_.place.size());
        for (std::size_t i = 0; i < inks.size(); ++i)
            inks[i].counts = lens.facing(table_.position[i], table_.normal[i]) < -away &&
                             lens.holds(lens.image_of(table_.position[i]), 2.0);
        for (const DrawnStroke& stroke : strokes) add_widths(stroke, table_.place, inks);
    }
    [[nodiscard]] WidthChanges changes() const { return width_changes(frames_); }
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
    StrokePainter painter(context, set, way_style(preset, size));
    HatchFollower follower(set);
    for (int step = 0; step <= way.steps; ++step) {
        const hrbfnpr_camera camera = orbit.at(step * way.degrees, std::pow(way.zoom, step));
        painter.draw(camera);
        follower.look(camera, painter.strokes());
    }
    return follower.changes();
}

} // namespace bench
