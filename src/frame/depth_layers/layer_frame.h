// SPDX-License-Identifier: MIT
// A drawing by depth layers: ink is dimmed by the layers of surface in front of it.
//
// | step | function | makes |
// | 1 | gather, EvenOrder | dots and splats of marks |
// | 2 | HatchPoints | dots along hatching |
// | 3 | bin_dots, HatchTiles | tiles of dots |
// | 4 | dim_by_layers, dim_by_rays | opacities |
// | 5 | make_strokes | strokes of hatching |
// | 6 | join_dots, add_strokes | strokes of the drawing, far to near |
#pragma once

#include "drawing/drawing.h"
#include "frame/depth_layers/gather.h"
#include "frame/hatch/strokes.h"
#include "surface/cast_rays.h"

namespace hrbfnpr::frame {

// The arrays of a drawing by depth layers. They are kept from frame to frame.
struct DepthLayers {
    explicit DepthLayers(base::Memory& memory) noexcept
        : largest(memory), planes(memory), seen(memory), rays(memory), hits(memory), ray_dots(memory) {}

    // The radius of the largest splat in each tile of the drawing's dots, in pixels. At the border of a surface, splats
    // may extend beyond the surface by up to this radius, and hide ink there.
    base::Array<float> largest;

    // Working memory.
    base::Array<float> planes;      // the pixel planes of all workers, worker by worker
    base::Array<std::int64_t> seen; // for each tile: the number of dots that are drawn
    surface::Rays rays;
    surface::RayHits hits;
    base::Array<std::uint32_t> ray_dots; // the dots from which rays are cast

    [[nodiscard]] std::int64_t bytes() const noexcept {
        return largest.bytes() + planes.bytes() + seen.bytes() + rays.origin.bytes() + rays.direction.bytes() +
               hits.t.bytes() + hits.position.bytes() + hits.normal.bytes() + ray_dots.bytes();
    }
};

class LayerFrame {
public:
    explicit LayerFrame(const base::Runtime& runtime) noexcept;

    // Makes the drawing's dots, splats, strokes, tiles and counts. `lines` are finished strokes. Throws Error{callback,
    // cancelled, out_of_memory}.
    void run(const Scene& scene, const LineStrokes& lines, const base::Progress& progress, drawing::Drawing& drawing);

    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    // A finished stroke, given by its index in a list.
    struct ReadyStroke {
        const LineStrokes* list;
        std::int64_t number;
    };

    void dim(const Scene& scene, drawing::Drawing& drawing);
    void join_dots(const Scene& scene, drawing::Drawing& drawing);
    template <class DotAt>
    void join(const Run& run, std::int64_t count, const DotAt& dot_at);
    void add_strokes(const LineStrokes& lines, drawing::Drawing& drawing);

    const base::Runtime& runtime_;
    Gathering gathering_;
    EvenOrder even_order_;
    HatchPoints hatch_points_;
    HatchTiles hatch_tiles_;
    NearerEdges edges_;
    DepthLayers layers_;
    base::Array<std::int64_t> dot_of_; // for each mark of a run: the index of its dot, or -1 if the mark is not shown
    LineStrokes joined_;
    base::Array<drawing::StrokePoint> line_; // the line of one stroke
    base::Array<std::uint8_t> line_inks_;    // the inks of its points
    base::Array<ReadyStroke> ready_;
    base::Array<std::uint64_t> keys_;
    drawing::DepthSort order_;
};

} // namespace hrbfnpr::frame
