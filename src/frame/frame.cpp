// SPDX-License-Identifier: MIT
#include "frame/frame.h"

namespace hrbfnpr::frame {
namespace {

// The share of the time that lines take, if there are any.
constexpr double lines_end = 0.7;

// While this object lives, threads check for cancellation.
struct Watch {
    ~Watch() { threads.watch(base::Progress()); }
    base::Parallel& threads;
};

} // namespace

Frame::Frame(const base::Runtime& runtime)
    : runtime_(runtime, runtime.parallel), scene_(runtime.memory), published_(runtime_), depth_layers_(runtime_),
      lines_(runtime_) {}

void Frame::draw(std::span<const Item> items, const Camera& camera, const base::Progress& progress,
                 drawing::Drawing& drawing) {
    runtime_.parallel.watch(progress); // Threads check for cancellation before each task.
    const Watch watch{runtime_.parallel};
    try {
        set_up(scene_, items, camera, drawing);
        if (!items.empty() && items[0].style.visibility == Visibility::published) {
            published_.run(scene_, drawing);
        } else {
            const LineStrokes& strokes = lines_.run(scene_, items, progress.part(0.0, lines_end), drawing);
            depth_layers_.run(scene_, strokes, progress.part(lines_end, 1.0), drawing);
        }
        drawing.counts.scratch_bytes = scene_.bytes() + published_.bytes() + depth_layers_.bytes();
        progress.update(1.0); // This is the last check for cancellation.
    } catch (...) {
        lines_.forget();
        throw;
    }
}

} // namespace hrbfnpr::frame
