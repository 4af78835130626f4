// SPDX-License-Identifier: MIT
// Frames that start from the curves of the previous frame: whether their curves are as whole as those of frames that
// start from nothing, and the same.
#pragma once

#include "line_times.h"
#include "line_truth.h"
#include "line_visibility.h"

#include <cstdint>
#include <string>
#include <vector>

namespace bench {

struct WarmFrames {
    Views views;                         // frames that start from the previous frame
    std::int64_t compared = 0, same = 0; // places on contours of frames that start from nothing; those found
    VisibilityCount visible;

    void add(const WarmFrames& other) {
        views.add(other.views);
        compared += other.compared;
        same += other.same;
        visible.add(other.visible);
    }
};

// Draws frames half a degree apart around a model.  Every eighth frame is checked by rays, and a new renderer draws it
// as well: all of its contours must be found.
[[nodiscard]] inline WarmFrames warm_frames(hrbfnpr_context* context, const LineModel& model, int frames,
                                            std::int64_t places) {
    constexpr int compared = 8;
    const LineOrbit orbit(model.model.get());
    const VisibilityCheck check(model.model.get());
    LinePainter warm(context, model.marks.get(), model.lines.get());
    LinePainter cold(context, model.marks.get(), model.lines.get());
    WarmFrames found;
    for (int frame = 0; frame < frames; ++frame) {
        const hrbfnpr_camera camera = orbit.at(0.5 * frame);
        warm.draw(camera);
        if (frame == 0) continue;
        const std::string name = model.name + ", frame " + std::to_string(frame);
        count(found.views, warm.info(), name);
        if (frame % compared != 0) continue;
        cold.begin_anew();
        cold.draw(camera);
        const std::vector<Polyline> lines = warm.polylines();
        const ImageLines drawn = image_lines(lines);
        const NearLines near(drawn);
        for (const LinePlace& place : places_of(cold.polylines(), Lens(camera), places)) {
            ++found.compared;
            if (near.distance(place.pixel) <= 0.3)
                ++found.same;
            else
                found.visible.wrong.push_back(name + ", missing at pixel (" + std::to_string(place.pixel.x) + " " +
                                              std::to_string(place.pixel.y) + ")");
        }
        VisibilityCount seen = check(camera, lines, places);
        for (std::string& wrong : seen.wrong) wrong = name + ", " + wrong;
        found.visible.add(seen);
    }
    return found;
}

} // namespace bench
