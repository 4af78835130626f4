// SPDX-License-Identifier: MIT
// Smoothing of depth camera images: removes the sensor's noise from the points, and finds their normals.
//
// A plane n . p = c that is seen in the direction (u, v, 1) has 1 / z = n . (u, v, 1) / c, so the inverse depth is
// linear in the image. Its errors have the same size everywhere, because cameras that triangulate measure the shift of
// a pattern, which is proportional to 1 / z.
#pragma once

#include "base/operation.h"
#include "base/view.h"
#include "base/work.h"
#include "geometry/vec_array.h"

#include <array>
#include <optional>
#include <span>

namespace hrbfnpr::orient {

// The fields are those of hrbfnpr_depth_image_desc. The view has 3 components and columns x rows elements; the boundary
// checks this.
struct DepthImageInput {
    base::InView points;
    std::int32_t columns = 0;
    std::int32_t rows = 0;
    bool keep_points = false;
    double noise = 0.0; // If 0, the noise is measured.
    double smoothing = 1.0;
};

struct DepthImageReport {
    std::int64_t seen = 0;
    std::int64_t left_out = 0;
    double noise = 0.0;        // standard deviation of 1 / z
    double focal_length = 0.0; // pixels
    double depth = 0.0;        // median of |z|
    double radius = 0.0;       // median radius of the discs, in pixels
    double seconds = 0.0;
};

// One point and one normal for each pixel. Where the sensor saw nothing, or where the point is left out, the point is
// NaN and the normal is 0.
struct DepthImage {
    explicit DepthImage(base::Memory& memory) noexcept : point(memory), normal(memory) {}

    geometry::VecArray point;
    geometry::VecArray normal;
    DepthImageReport report;
};

// Throws Error{invalid_argument, out_of_memory, cancelled}.
[[nodiscard]] DepthImage smooth_depth_image(const base::Work& work, const DepthImageInput& input);

// ---- Its parts, for tests

// Values of 1 / z, row by row; NaN where nothing was seen.
struct InverseDepth {
    explicit InverseDepth(base::Memory& memory) noexcept : value(memory) {}

    [[nodiscard]] std::int64_t size() const noexcept { return std::int64_t{columns} * rows; }
    [[nodiscard]] double at(std::int32_t column, std::int32_t row) const noexcept {
        return value[std::int64_t{row} * columns + column];
    }

    base::Array<double> value;
    std::int32_t columns = 0;
    std::int32_t rows = 0;
};

// The inverse depth is value + across * (pixels to the right) + down * (pixels down).
struct DepthPlane {
    double value = 0.0;
    double across = 0.0;
    double down = 0.0;
};

struct SmallPlane {
    DepthPlane plane;
    double error = 0.0; // standard deviation of the pixels' 1 / z from the plane
};

// Fits a plane to the 5 x 5 pixels around a pixel. Returns nullopt unless the sensor saw all of them.
[[nodiscard]] std::optional<SmallPlane> small_plane(const InverseDepth& depth, std::int32_t column,
                                                    std::int32_t row) noexcept;

// A pixel of a disc, relative to the middle of the disc, with its weight.
struct Tap {
    std::int32_t across = 0;
    std::int32_t down = 0;
    double weight = 0.0;
};

// The discs of all radii from `least` to `most` pixels.
class Discs {
public:
    static constexpr std::int32_t least = 2;
    static constexpr std::int32_t most = 48;

    explicit Discs(base::Memory& memory);

    [[nodiscard]] std::span<const Tap> of(std::int32_t radius) const noexcept {
        const auto k = static_cast<std::size_t>(radius - least);
        return {taps_.data() + start_[k], static_cast<std::size_t>(start_[k + 1] - start_[k])};
    }

private:
    base::Array<Tap> taps_; // the pixels of all discs
    std::array<std::int64_t, most - least + 2> start_{};
};

// Fits a plane to the pixels of a disc. Starts with `first`, and leaves out pixels beyond an edge. Returns nullopt if
// too few pixels are left.
[[nodiscard]] std::optional<DepthPlane> plane_around(const InverseDepth& depth, std::int32_t column, std::int32_t row,
                                                     std::span<const Tap> disc, const SmallPlane& first) noexcept;

} // namespace hrbfnpr::orient
