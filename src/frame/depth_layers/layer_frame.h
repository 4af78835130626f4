// A frame by layers: ink, dimmed by what it is seen through, in tiles.
#pragma once

#include "frame/depth_layers/depth_layers.h"
#include "frame/depth_layers/exact_visibility.h"
#include "frame/depth_layers/gather.h"
#include "frame/scene/disc.h"
#include "frame/scene/frame_info.h"
#include "frame/scene/order.h"

#include <mutex>

namespace hrbfnpr::frame {

class LayerFrame {
public:
    explicit LayerFrame(const base::Runtime& runtime) noexcept;

    // Throws Error{callback, out_of_memory}.
    void run(Scene& scene);

    // With alpha 0: not drawn.
    [[nodiscard]] std::span<const Ink> inks() const noexcept { return inks_; }
    [[nodiscard]] std::span<const Splat> splats() const noexcept { return gather_.splats(); }
    // Of the inks and of the splats, over the viewport; first_pixel is their top-left corner.
    [[nodiscard]] const TileBins& ink_bins() const noexcept { return ink_bins_; }
    [[nodiscard]] const TileBins& splat_bins() const noexcept { return layers_.bins(); }
    [[nodiscard]] bool has_layers() const noexcept { return has_layers_; }
    [[nodiscard]] glm::ivec2 first_pixel() const noexcept { return first_pixel_; }
    [[nodiscard]] std::uint32_t colors() const noexcept { return static_cast<std::uint32_t>(colors_.size()); }
    // Straight RGBA of an ink's color.
    [[nodiscard]] const glm::vec4& color(std::uint32_t number) const noexcept { return colors_[number]; }
    // All inks have the same: then their order does not matter.
    [[nodiscard]] bool one_color() const noexcept { return one_color_; }
    [[nodiscard]] const glm::vec4& ink_color() const noexcept { return ink_color_; }
    // Whether a is painted before b.
    [[nodiscard]] bool before(std::uint32_t a, std::uint32_t b) const noexcept;

    // The inks as discs, far to near; made when first asked for after run(), or by it if they were asked for after
    // the run before.  On several threads at the same time.
    [[nodiscard]] std::span<const Disc> discs() const;

    [[nodiscard]] const FrameInfo& info() const noexcept { return info_; }
    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    void take_colors(const Scene& scene);
    void bin(const Scene& scene);
    void make_discs(const base::Parallel& parallel) const;

    const base::Runtime& runtime_;
    Gather gather_;
    DepthLayers layers_;
    ExactVisibility exact_;
    TileBins ink_bins_;
    std::span<Ink> inks_;
    base::Array<glm::vec4> colors_;
    mutable std::mutex making_; // what stands here, up to has_discs_
    mutable FarToNear order_;
    mutable base::Array<std::uint64_t> keys_;
    mutable base::Array<Disc> discs_;
    mutable bool has_discs_ = false;
    FrameInfo info_;
    glm::ivec2 first_pixel_{0};
    glm::vec4 ink_color_{0.0F}; // if there is but one
    bool one_color_ = true;
    bool has_layers_ = false;
};

} // namespace hrbfnpr::frame
