// SPDX-License-Identifier: MIT
// Makes a drawing from items and a camera. [NPAR 6]
#pragma once

#include "frame/depth_layers/layer_frame.h"
#include "frame/lines/line_frame.h"
#include "published/published_frame.h"

namespace hrbfnpr::frame {

// Makes drawings. One thread at a time may use it, and its scratch is reused. Once warm it allocates nothing, unless
// lines are drawn.
class Frame {
public:
    explicit Frame(const base::Runtime& runtime);
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;

    // Fills `drawing` and overwrites its old content. Throws Error{invalid_argument, callback, cancelled,
    // out_of_memory}; then `drawing` is not valid.
    void draw(std::span<const Item> items, const Camera& camera, const base::Progress& progress,
              drawing::Drawing& drawing);

private:
    base::Runtime runtime_; // its threads check for cancellation while a frame is drawn
    Scene scene_;
    published::PublishedFrame published_;
    LayerFrame depth_layers_;
    LineFrame lines_;
};

} // namespace hrbfnpr::frame
