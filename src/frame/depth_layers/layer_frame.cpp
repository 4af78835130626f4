#include "frame/depth_layers/layer_frame.h"

#include "base/clock.h"
#include "frame/scene/scratch.h"

#include <algorithm>
#include <utility>

namespace hrbfnpr::frame {
namespace {

constexpr std::int64_t disc_grain = 4096;

} // namespace

LayerFrame::LayerFrame(const base::Runtime& runtime) noexcept
    : runtime_(runtime), gather_(runtime), layers_(runtime), exact_(runtime.memory),
      ink_bins_(runtime.memory, DepthLayers::tile_size), colors_(runtime.memory), order_(runtime.memory),
      keys_(runtime.memory), discs_(runtime.memory) {}

void LayerFrame::run(Scene& scene) {
    base::Stopwatch watch;
    const bool wants_discs = std::exchange(has_discs_, false);
    take_colors(scene);
    gather_.run(scene);
    inks_ = gather_.inks();
    info_ = gather_.info();
    info_.nanoseconds_classify = watch.nanoseconds();

    watch.restart();
    bin(scene);
    info_.nanoseconds_sort = watch.nanoseconds();

    watch.restart();
    std::int64_t inks = 0;
    for (const Piece& piece : gather_.ink_pieces()) inks += piece.end - piece.begin;
    has_layers_ = std::any_of(scene.runs.begin(), scene.runs.end(), [](const Run& run) { return run.splats; });
    info_.shown = has_layers_ ? layers_.attenuate(gather_, inks_, ink_bins_, first_pixel_.x, first_pixel_.y) : inks;
    if (std::any_of(scene.items.begin(), scene.items.end(), [](const ItemView& i) { return i.model != nullptr; }))
        info_.shown -= exact_.attenuate(runtime_, scene, inks_, gather_.ink_pieces());
    info_.dropped_hidden = inks - info_.shown;
    info_.nanoseconds_visibility = watch.nanoseconds();
    if (!wants_discs) return;
    watch.restart();
    make_discs(runtime_.parallel);
    info_.nanoseconds_sort += watch.nanoseconds();
}

void LayerFrame::take_colors(const Scene& scene) {
    colors_.clear();
    one_color_ = true;
    bool first = true;
    const auto use = [&](bool used, const glm::vec4& color) {
        colors_.push_back(color);
        if (!used) return;
        if (std::exchange(first, false)) ink_color_ = color;
        one_color_ = one_color_ && color == ink_color_;
    };
    for (const Run& run : scene.runs) {
        const Style& style = scene.item_of(run).style;
        use(run.draws_front, style.group[static_cast<std::size_t>(run.group)].ink);
        use(run.draws_silhouettes, style.silhouette_ink);
    }
}

void LayerFrame::bin(const Scene& scene) {
    const glm::vec4& v = scene.lens.viewport;
    first_pixel_ = glm::ivec2(std::floor(v.x), std::floor(v.y));
    const auto left = static_cast<float>(first_pixel_.x);
    const auto top = static_cast<float>(first_pixel_.y);
    const auto width = static_cast<std::int32_t>(std::ceil(v.x + v.z - left));
    const auto height = static_cast<std::int32_t>(std::ceil(v.y + v.w - top));
    ink_bins_.build(runtime_.parallel, width, height, gather_.ink_pieces(),
                    [&](std::int64_t i, TileBins::Footprint& print) {
                        const Ink& ink = inks_[static_cast<std::size_t>(i)];
                        // One that just misses the picture belongs to the nearest tile, too.
                        print = {std::clamp(ink.x - left, 0.0F, static_cast<float>(width)),
                                 std::clamp(ink.y - top, 0.0F, static_cast<float>(height)),
                                 std::max(ink.radius, smallest_radius) + soft_rim};
                        return true;
                    });
    if (!one_color_) ink_bins_.order(runtime_.parallel, [&](std::uint32_t a, std::uint32_t b) { return before(a, b); });
}

bool LayerFrame::before(std::uint32_t a, std::uint32_t b) const noexcept {
    return inks_[a].depth != inks_[b].depth ? inks_[a].depth > inks_[b].depth : a < b;
}

// Serially: a host's job runner must not be called under the lock, as its threads may come here meanwhile.
std::span<const Disc> LayerFrame::discs() const {
    const std::scoped_lock lock(making_);
    if (!has_discs_) make_discs(base::Parallel());
    return std::as_const(discs_).span();
}

void LayerFrame::make_discs(const base::Parallel& parallel) const {
    keys_.clear();
    keys_.reserve(info_.shown);
    for (const Piece& piece : gather_.ink_pieces()) {
        for (std::int64_t i = piece.begin; i < piece.end; ++i) {
            const Ink& ink = inks_[static_cast<std::size_t>(i)];
            if (ink.alpha > 0.0F) keys_.push_back(far_first_key(ink.depth, static_cast<std::uint32_t>(i)));
        }
    }
    order_.sort(parallel, keys_);
    resize_scratch(discs_, keys_.size());
    parallel.for_chunks(keys_.size(), disc_grain, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const Ink& ink = inks_[static_cast<std::uint32_t>(keys_[i])];
            glm::vec4 color = colors_[ink.color];
            color.w *= ink.alpha;
            discs_[i] = {ink.x, ink.y, ink.radius, ink.window, color, ink.id, ink.mark_class, false};
        }
    });
    has_discs_ = true;
}

std::int64_t LayerFrame::bytes() const noexcept {
    return gather_.bytes() + layers_.bytes() + exact_.bytes() + ink_bins_.bytes() + colors_.bytes() + order_.bytes() +
           keys_.bytes() + discs_.bytes();
}

} // namespace hrbfnpr::frame
