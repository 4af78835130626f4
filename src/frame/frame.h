// SPDX-License-Identifier: MIT
// From items and a camera to a drawing [NPAR 6].
#pragma once

#include "frame/depth_layers/layer_frame.h"
#include "frame/lines/line_frame.h"
#include "published/published_frame.h"

namespace hrbfnpr::frame {

// The scratch of one thread, used again for each drawing. It allocates nothing once warm, where no lines are drawn.
class Frame {
public:
    explicit Frame(const base::Runtime& runtime);
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;

    // Fills `drawing`, whatever was in it. Throws Error{invalid_argument, callback, cancelled, out_of_memory}; then it
    // is no drawing.
    void draw(std::span<const Item> items, const Camera& camera, const base::Progress& progress,
              drawing::Drawing& drawing);

private:
    base::Runtime runtime_; // its threads are watched while a frame is drawn
    Scene scene_;
    published::PublishedFrame published_;
    LayerFrame depth_layers_;
    LineFrame lines_;
};

} // namespace hrbfnpr::frame
