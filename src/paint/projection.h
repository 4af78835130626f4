// SPDX-License-Identifier: MIT
// An image that is projected onto a surface along a camera.
#pragma once

#include "base/memory.h"
#include "geometry/bvh.h"
#include "paint/kind.h"
#include "paint/sample.h"

#include <cstdint>

namespace hrbfnpr::paint {

// The pixels of an image, row by row from the top: components_of(kind) numbers that are multiplied by alpha, and alpha.
struct Pixels {
    Pixels(base::Memory& memory, FieldKind kind, std::int64_t columns, std::int64_t rows_down)
        : width(columns), height(rows_down), channels(components_of(kind) + 1), number(memory) {
        number.resize_for_overwrite(width * height * channels);
    }

    std::int64_t width, height;
    int channels;
    base::Array<float> number;

    [[nodiscard]] float* at(std::int64_t column, std::int64_t row) noexcept {
        return number.data() + (row * width + column) * channels;
    }
    [[nodiscard]] const float* at(std::int64_t column, std::int64_t row) const noexcept {
        return number.data() + (row * width + column) * channels;
    }
};

// Where places of the surface are in the image, and what hides them.
struct Projector {
    glm::dmat4 to_window{1.0};                // to (x w, y w, ., w), with x and y in pixels of the viewport
    glm::dvec4 eye{0.0};                      // the eye (w = 1), or the direction of all lines of sight (w = 0)
    glm::dvec4 viewport{0.0};                 // x and y of the top-left corner, width and height
    const geometry::Bvh* occluders = nullptr; // the triangles that hide places; null: none. The caller owns them
    double offset = 0.0;                      // Rays to the eye begin at this distance above the surface.
};

// The image fills the viewport. Between the middles of pixels it is interpolated, and weights are its alpha. A place
// outside the viewport has no value, and neither has a place that faces away from the eye or is hidden.
class Projection {
public:
    Projection(Pixels&& pixels, const Projector& projector);

    [[nodiscard]] Sample at(const Place& place) const noexcept;

private:
    [[nodiscard]] bool is_seen(const Place& place) const noexcept;
    // Returns the sample at a place of the image, in pixels from its top-left corner.
    [[nodiscard]] Sample between_pixels(double x, double y) const noexcept;

    Pixels pixels_;
    Projector projector_;
};

} // namespace hrbfnpr::paint
