// SPDX-License-Identifier: MIT
// From dots that follow each other along a stroke to lines.
#pragma once

#include "base/runtime.h"
#include "drawing/far_to_near.h"
#include "frame/hatch/strokes.h"
#include "frame/scene/scene.h"

namespace hrbfnpr::frame {

// Of layers whose style draws them as strokes: marks that follow each other and are shown as ink of the front become
// one line; their dots are not drawn any more.  A single one stays a dot.
class StrokeJoiner {
public:
    explicit StrokeJoiner(const base::Runtime& runtime) noexcept
        : runtime_(runtime), dot_of_(runtime.memory), found_(runtime.memory), keys_(runtime.memory),
          order_(runtime.memory) {}

    // Strokes that are ready.
    struct Ready {
        const LineStrokes& lines;
        std::span<const HatchStrokePart> hatching;
    };

    // And those that are ready, into the same order.
    void run(const Scene& scene, const Ready& ready, drawing::Drawing& drawing);

    [[nodiscard]] std::int64_t bytes() const noexcept {
        return dot_of_.bytes() + found_.bytes() + keys_.bytes() + order_.bytes();
    }

private:
    static constexpr std::int32_t of_lines = -1;
    static constexpr std::int32_t of_hatching = -2;
    // A line before it is sorted: places in the order of its layer's marks along strokes.
    struct Found {
        std::int32_t run; // of_lines or of_hatching: `begin` is the stroke's number, and `end` that of its part
        float depth;
        std::int64_t begin, end;
    };

    void note_dots(const Run& run, std::uint32_t layer, const drawing::Drawing& drawing);
    void find_lines(const Run& run, std::int32_t number, const drawing::Drawing& drawing);
    void put(const Scene& scene, const Found& line, drawing::Drawing& drawing);
    void make_room(const Ready& ready, drawing::Drawing& drawing) const;
    [[nodiscard]] static const LineStrokes& list_of(const Ready& ready, const Found& found) noexcept;
    static void put_stroke(drawing::Stroke stroke, drawing::Drawing& drawing);
    void put_points(const Ready& ready, drawing::Drawing& drawing) const;
    void find_ready(const LineStrokes& strokes, std::int32_t run, std::int64_t part);
    void find_joined(const Scene& scene, const drawing::Drawing& drawing);

    const base::Runtime& runtime_;
    base::Array<std::int64_t> dot_of_; // of each mark of the runs that are drawn as strokes; -1: not shown
    base::Array<Found> found_;
    base::Array<std::uint64_t> keys_;
    drawing::FarToNear order_;
};

} // namespace hrbfnpr::frame
