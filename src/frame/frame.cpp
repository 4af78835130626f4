// SPDX-License-Identifier: MIT
#include "frame/frame.h"

#include "frame/depth_layers/layer_frame.h"
#include "frame/lines/line_frame.h"
#include "published/published_frame.h"

namespace hrbfnpr::frame {
namespace {

// Where there are lines, they take most of the time.
constexpr double lines_end = 0.7;

class Watch {
public:
    Watch(base::Parallel& threads, const base::Progress& progress) noexcept : threads_(threads) {
        threads_.watch(progress);
    }
    ~Watch() { threads_.watch(base::Progress()); }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

private:
    base::Parallel& threads_;
};

} // namespace

struct Frame::Impl {
    explicit Impl(const base::Runtime& host)
        : runtime(host, host.parallel), scene(runtime.memory), published(runtime), depth_layers(runtime),
          lines(runtime) {}

    void draw(std::span<const Item> items, const Camera& camera, const base::Progress& progress,
              drawing::Drawing& drawing);

    base::Runtime runtime; // its threads are watched while a frame is drawn
    Scene scene;
    published::PublishedFrame published;
    LayerFrame depth_layers;
    LineFrame lines;
};

void Frame::Impl::draw(std::span<const Item> items, const Camera& camera, const base::Progress& progress,
                       drawing::Drawing& drawing) {
    set_up(scene, items, camera, drawing);
    if (!items.empty() && items[0].style.visibility == Visibility::published) {
        published.run(scene, drawing);
    } else {
        const LineStrokes& strokes = lines.run(scene, items, progress.part(0.0, lines_end), drawing);
        depth_layers.run(scene, strokes, progress.part(lines_end, 1.0), drawing);
    }
    drawing.counts.scratch_bytes = scene.bytes() + published.bytes() + depth_layers.bytes();
}

Frame::Frame(const base::Runtime& runtime) : impl_(std::make_unique<Impl>(runtime)) {}
Frame::~Frame() = default;

void Frame::draw(std::span<const Item> items, const Camera& camera, const base::Progress& progress,
                 drawing::Drawing& drawing) {
    const Watch watch(impl_->runtime.parallel, progress);
    try {
        impl_->draw(items, camera, progress, drawing);
        progress.update(1.0); // the last chance to cancel
    } catch (...) {
        impl_->lines.forget();
        throw;
    }
}

} // namespace hrbfnpr::frame
