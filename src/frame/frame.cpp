// SPDX-License-Identifier: MIT
#include "frame/frame.h"

#include "frame/depth_layers/layer_frame.h"
#include "frame/lines/line_frame.h"
#include "frame/published/published_frame.h"
#include "frame/scene/scene.h"

namespace hrbfnpr::frame {

struct Frame::Impl {
    explicit Impl(const base::Runtime& host) : scene(host.memory), published(host), depth_layers(host), lines(host) {}

    Scene scene;
    PublishedFrame published;
    LayerFrame depth_layers;
    LineFrame lines;
};

Frame::Frame(const base::Runtime& runtime) : impl_(std::make_unique<Impl>(runtime)) {}
Frame::~Frame() = default;

void Frame::draw(std::span<const Item> items, const Camera& camera, drawing::Drawing& drawing) {
    Impl& own = *impl_;
    set_up(own.scene, items, camera, drawing);
    if (!items.empty() && items[0].style.visibility == Visibility::published)
        own.published.run(own.scene, drawing);
    else
        own.depth_layers.run(own.scene, own.lines.run(own.scene, items, drawing), drawing);
    drawing.counts.scratch_bytes = own.scene.bytes() + own.published.bytes() + own.depth_layers.bytes();
}

} // namespace hrbfnpr::frame
