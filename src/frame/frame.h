// SPDX-License-Identifier: MIT
// Makes a drawing from items and a camera. [NPAR 6]
#pragma once

#include "frame/depth_layers/layer_frame.h"
#include "frame/lines/line_frame.h"
#include "published/published_frame.h"

namespace hrbfnpr::frame {

// Makes drawings. Only one thread at a time may use it. Its working memory is reused: after some frames it allocates
// nothing, unless lines are drawn.
class Frame {
public:
    explicit Frame(const base::Runtime& runtime);
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;

    // Makes the new content of `drawing`. Throws Error{invalid_argument, callback, cancelled, out_of_memory}; the
    // drawing is then not valid.
    void draw(std::span<const Item> items, const Camera& camera, const base::Progress& progress,
              drawing::Drawing& drawing);

private:
    base::Runtime runtime_; // While a frame is drawn, its threads check for cancellation.
    Scene scene_;
    published::PublishedFrame published_;
    LayerFrame depth_layers_;
    LineFrame lines_;
};

} // namespace hrbfnpr::frame
