// SPDX-License-Identifier: MIT
// What hides a mark, asked of the surface itself: a ray from it to the eye.
#pragma once

#include "base/runtime.h"
#include "drawing/drawing.h"
#include "drawing/tiles.h"
#include "frame/scene/scene.h"
#include "surface/cast_rays.h"

namespace hrbfnpr::frame {

class ExactVisibility {
public:
    explicit ExactVisibility(base::Memory& memory) noexcept : rays_(memory), hits_(memory), asked_(memory) {}

    // Multiplies the alpha of the inks of items that have a model.  Returns how many are no longer seen.
    // Throws Error{callback, out_of_memory}.
    std::int64_t attenuate(const base::Runtime& runtime, const Scene& scene, std::span<Dot> inks,
                           std::span<const Piece> pieces);

    [[nodiscard]] std::int64_t bytes() const noexcept {
        return rays_.origin.bytes() + rays_.direction.bytes() + hits_.t.bytes() + hits_.position.bytes() +
               hits_.normal.bytes() + asked_.bytes();
    }

private:
    void ask(const base::Runtime& runtime, const Scene& scene, std::int32_t item, std::span<Dot> inks);
    void add_ray(const Scene& scene, const Run& run, const Dot& ink);

    surface::Rays rays_;
    surface::RayHits hits_;
    base::Array<std::uint32_t> asked_; // inks
};

} // namespace hrbfnpr::frame
