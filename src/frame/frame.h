// One frame: from point sets, camera and styles to what is to be drawn.  [NPAR 6]
#pragma once

#include "base/memory.h"
#include "base/runtime.h"
#include "frame/camera.h"
#include "frame/mark_class.h"
#include "frame/style.h"
#include "implicit/implicit.h"
#include "sampling/point_set.h"

#include <memory>
#include <span>

namespace hrbfnpr::frame {

class SheetFrame;

struct Item {
    const sampling::PointSet* set = nullptr;
    const implicit::Implicit* model = nullptr; // if not, visibility is exact
    Style style;
    glm::dmat4 transform{1.0};
};

// One disc of ink or of paper, in image space.
struct Disc {
    float x = 0.0F; // pixels, from the image's top-left corner
    float y = 0.0F;
    float radius = 0.0F;   // pixels
    float depth = 0.0F;    // window depth, in the camera's convention
    glm::vec4 color{0.0F}; // straight RGBA; a disc of paper: the paper's RGB, and its opacity alpha
    std::uint32_t id = 0;  // 1 + running number of the mark
    MarkClass mark_class = MarkClass::none;
    bool is_paper = false;
};

// Same fields as hrbfnpr_frame_info.  Marks of the groups that a style draws or takes contours from:
//   marks = outside + front + back + silhouette + culled; of those,
//   front + silhouette = shown + dropped_... + those whose group or set of directions is not drawn.
// By sheets, marks of a cluster whose ranks nothing shows are culled before their class is known.
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

// Reused from frame to frame: allocates nothing once warm.
class Frame {
public:
    explicit Frame(const base::Runtime& runtime);
    ~Frame();

    // Throws Error{invalid_argument, callback, out_of_memory}; on failure no frame is prepared.
    void prepare(std::span<const Item> items, const Camera& camera);

    [[nodiscard]] bool prepared() const noexcept;
    [[nodiscard]] const Camera& camera() const noexcept;
    [[nodiscard]] const glm::vec4& paper() const noexcept;
    // Far to near: the order of painting.
    [[nodiscard]] std::span<const Disc> discs() const;
    // NULL: painted as published.
    [[nodiscard]] const SheetFrame* sheet_frame() const noexcept;
    [[nodiscard]] const FrameInfo& info() const noexcept;

    // The mark behind a disc, for outputs that want more of it than a disc holds.
    struct MarkSource {
        glm::vec3 position; // world
        glm::vec3 normal;
        glm::vec3 direction;
    };
    [[nodiscard]] MarkSource source(const Disc& disc) const noexcept;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace hrbfnpr::frame
