// SPDX-License-Identifier: MIT
// From items and a camera to a drawing.                                          [NPAR 6]
#pragma once

#include "base/runtime.h"
#include "drawing/drawing.h"
#include "frame/scene/scene.h"

#include <memory>
#include <span>

namespace hrbfnpr::frame {

// The scratch of one thread, used again for each drawing. It allocates nothing once warm, where no lines are drawn.
class Frame {
public:
    explicit Frame(const base::Runtime& runtime);
    ~Frame();

    // Fills `drawing`, whatever was in it. Throws Error{invalid_argument, callback, cancelled, out_of_memory}; then it
    // is no drawing.
    void draw(std::span<const Item> items, const Camera& camera, const base::Progress& progress,
              drawing::Drawing& drawing);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace hrbfnpr::frame
