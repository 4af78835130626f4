// SPDX-License-Identifier: MIT
// A drawing by depth layers: ink, dimmed by what it is seen through.
#pragma once

#include "frame/depth_layers/depth_layers.h"
#include "frame/depth_layers/exact_visibility.h"
#include "frame/depth_layers/gather.h"
#include "frame/depth_layers/join_strokes.h"
#include "frame/hatch/strokes.h"

namespace hrbfnpr::frame {

class LayerFrame {
public:
    explicit LayerFrame(const base::Runtime& runtime) noexcept;

    // Fills what the scene does not.  Throws Error{callback, cancelled, out_of_memory}.
    void run(Scene& scene, const LineStrokes& lines, const base::Progress& progress, drawing::Drawing& drawing);

    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    // All but those of hatching.
    void bin_dots(const Scene& scene, std::span<const Piece> pieces, drawing::Drawing& drawing) const;
    void dim(const Scene& scene, drawing::Drawing& drawing);

    const base::Runtime& runtime_;
    Gather gather_;
    HatchPoints hatch_points_;
    HatchTiles hatch_tiles_;
    NearerEdges edges_;
    HatchStrokes hatch_strokes_;
    DepthLayers layers_;
    ExactVisibility exact_;
    StrokeJoiner joiner_;
};

} // namespace hrbfnpr::frame
