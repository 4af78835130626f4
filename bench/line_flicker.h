// SPDX-License-Identifier: MIT
// Visible contours that vanish for a frame or two and return, on a camera path around a surface.
#pragma once

#include "line_times.h"
#include "line_truth.h"
#include "line_visibility.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

namespace bench {

// The visible contours of one frame.
struct SeenFrame {
    SeenFrame(const hrbfnpr_camera& camera, std::vector<Polyline> polylines) : lens(camera) {
        for (Polyline& line : polylines)
            if (line.layers == 0) seen.push_back(std::move(line));
        lines = image_lines(seen);
        near = std::make_unique<NearLines>(lines);
    }
    // From one frame to the next, a place of the surface moves by a fraction of a pixel relative to its contour.
    [[nodiscard]] bool shows(const glm::dvec3& place) const { return near->distance(lens.image_of(place)) <= 1.0; }

    Lens lens;
    std::vector<Polyline> seen;
    ImageLines lines;
    std::unique_ptr<NearLines> near;
};

struct Flicker {
    std::int64_t places = 0; // places two pixels apart
    std::int64_t gone = 0;   // places that vanish for a frame or two
};

// Counts the places of the first of four consecutive frames.
inline void count_flicker(const std::deque<SeenFrame>& frames, Flicker& flicker) {
    double length = 0.0;
    for (const auto& [a, b] : frames[0].lines.segment)
        length += glm::distance(frames[0].lines.node[a], frames[0].lines.node[b]);
    const auto count = static_cast<std::int64_t>(length / 2.0);
    if (count == 0) return;
    for (const LinePlace& p : places_of(frames[0].seen, frames[0].lens, count)) {
        ++flicker.places;
        if (frames[1].shows(p.world)) continue;
        if (frames[2].shows(p.world) || frames[3].shows(p.world)) ++flicker.gone;
    }
}

[[nodiscard]] inline Flicker flicker_of(LinePainter& painter, const LineOrbit& orbit, int frames, double step) {
    std::deque<SeenFrame> last;
    Flicker flicker;
    for (int frame = 0; frame < frames; ++frame) {
        const hrbfnpr_camera camera = orbit.at(step * frame);
        painter.draw(camera);
        last.emplace_back(camera, painter.polylines());
        if (last.size() < 4) continue;
        count_flicker(last, flicker);
        last.pop_front();
    }
    return flicker;
}

} // namespace bench
