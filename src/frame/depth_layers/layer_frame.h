// SPDX-License-Identifier: MIT
// A drawing by depth layers: ink, dimmed by the layers of surface before it.
//
// | step | function | makes |
// | 1 | gather | dots and splats of marks |
// | 2 | HatchPoints | dots along hatching |
// | 3 | bin_dots, HatchTiles | tiles of dots |
// | 4 | dim_by_layers, dim_by_rays | opacities |
// | 5 | HatchStrokes | strokes of hatching |
// | 6 | join_dots, put_strokes | strokes of the drawing, far to near |
#pragma once

#include "drawing/far_to_near.h"
#include "frame/depth_layers/depth_layers.h"
#include "frame/depth_layers/gather.h"
#include "frame/hatch/strokes.h"

namespace hrbfnpr::frame {

class LayerFrame {
public:
    explicit LayerFrame(const base::Runtime& runtime) noexcept;

    // Fills the drawing's dots, splats, strokes, tiles and counts. `lines` are strokes that are ready.
    // Throws Error{callback, cancelled, out_of_memory}.
    void run(const Scene& scene, const LineStrokes& lines, const base::Progress& progress, drawing::Drawing& drawing);

    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    // A stroke of a list.
    struct Ready {
        const LineStrokes* list;
        std::int64_t number;
    };

    void dim(const Scene& scene, drawing::Drawing& drawing);
    void join_dots(const Scene& scene, drawing::Drawing& drawing);
    void put_strokes(const LineStrokes& lines, std::span<const HatchStrokePart> hatching, drawing::Drawing& drawing);

    const base::Runtime& runtime_;
    Gathering gathering_;
    HatchPoints hatch_points_;
    HatchTiles hatch_tiles_;
    NearerEdges edges_;
    HatchStrokes hatch_strokes_;
    DepthLayers layers_;
    base::Array<std::int64_t> dot_of_; // the number of the dot of each mark of a run; -1: the mark is not shown
    LineStrokes joined_;
    base::Array<Ready> ready_;
    base::Array<std::uint64_t> keys_;
    drawing::FarToNear order_;
};

} // namespace hrbfnpr::frame
