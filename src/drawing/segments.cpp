// SPDX-License-Identifier: MIT
#include "drawing/segments.h"

#include <array>

namespace hrbfnpr::drawing {
namespace {

// The stroke that begins with a point; NULL: none does.
const Stroke* stroke_at(const Drawing& drawing, std::int64_t point) noexcept {
    const Stroke* const found =
        std::lower_bound(drawing.strokes.begin(), drawing.strokes.end(), point,
                         [](const Stroke& stroke, std::int64_t at) { return stroke.first < at; });
    return found != drawing.strokes.end() && found->first == point ? found : nullptr;
}

// How a segment ends.  Strokes stand one after the other.
SegmentEnds ends_at(const Drawing& drawing, std::int64_t segment) noexcept {
    SegmentEnds ends;
    if (const Stroke* const own = stroke_at(drawing, segment)) ends = ends_of(*own, segment);
    if (segment + 2 == drawing.points.size()) return {ends.begin, ends_of(*(drawing.strokes.end() - 1), segment).end};
    if (const Stroke* const next = stroke_at(drawing, segment + 2)) ends.end = ends_of(*(next - 1), segment).end;
    return ends;
}

} // namespace

// By segments: a segment's number is that of its first point.
void bin_segments(const base::Parallel& parallel, Drawing& drawing) {
    const Tiles& like = drawing.dot_tiles;
    const std::array all = {Piece{0, drawing.points.size()}};
    const glm::vec2 origin(drawing.first_pixel);
    const bool pointed = std::any_of(drawing.strokes.begin(), drawing.strokes.end(), [](const Stroke& stroke) {
        return stroke.cap_begin == Cap::pointed || stroke.cap_end == Cap::pointed;
    });
    drawing.segment_tiles.build<Tiles::BoxFootprint>(
        parallel, like.columns() * tile_size, like.rows() * tile_size, all,
        [&](std::int64_t i, Tiles::BoxFootprint& print) {
            if (i + 1 >= drawing.points.size()) return false;
            const StrokePoint& a = drawing.points[i];
            const StrokePoint& b = drawing.points[i + 1];
            if (!(b.length > 0.0F) && stroke_at(drawing, i + 1) != nullptr) return false;
            const float around = reach(pointed ? ends_at(drawing, i) : SegmentEnds{}, a, b);
            print = {std::min(a.x, b.x) - around - origin.x, std::min(a.y, b.y) - around - origin.y,
                     std::max(a.x, b.x) + around - origin.x, std::max(a.y, b.y) + around - origin.y};
            return true;
        });
}

} // namespace hrbfnpr::drawing
