// What became of the marks of a frame, and how long it took.
#pragma once

#include <cstdint>

namespace hrbfnpr::frame {

// Same fields as hrbfnpr_frame_info.  Marks of the groups that a style draws or takes contours from:
//   marks = outside + front + back + silhouette + culled; of those,
//   front + silhouette = shown + dropped_... + those whose group or set of directions is not drawn.
// By layers, marks of a cluster whose ranks nothing shows are culled before their class is known.
// A mark is outside if no disc of it could touch the viewport, or it lies before the near or behind
// the far plane.  A dropped mark counts once, for the first of: share and light (tone), zoom, depth,
// hidden.  Marks that are not numbers count as outside.
struct FrameInfo {
    std::int64_t marks = 0, outside = 0, front = 0, back = 0, silhouette = 0, shown = 0;
    std::int64_t dropped_tone = 0, dropped_depth = 0, dropped_zoom = 0, dropped_hidden = 0, painted = 0, culled = 0;
    std::int64_t nanoseconds_classify = 0, nanoseconds_visibility = 0, nanoseconds_sort = 0, nanoseconds_draw = 0;
    std::int64_t scratch_bytes = 0;

    FrameInfo& operator+=(const FrameInfo& other) noexcept;
};

} // namespace hrbfnpr::frame
