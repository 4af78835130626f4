// SPDX-License-Identifier: MIT
// Checks of the numbers in a file whose checksum is correct.
#pragma once

#include "geometry/vec.h"
#include "io/decoder.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace hrbfnpr::io {

template <class T>
void check_finite(const Decoder& decoder, const char* name, std::span<const T> numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (!std::isfinite(numbers[i])) decoder.damaged("%s[%lld] is not finite", name, static_cast<long long>(i));
}

// Checks packed unit vectors. The limits are loose, because other programs may have written the file.
template <class T>
void check_unit(const Decoder& decoder, const char* name, std::span<const T> packed) {
    for (std::size_t i = 0; i + 2 < packed.size(); i += 3) {
        const T square = packed[i] * packed[i] + packed[i + 1] * packed[i + 1] + packed[i + 2] * packed[i + 2];
        if (!(square > T(0.98) && square < T(1.02)))
            decoder.damaged("%s[%lld] is not of unit length", name, static_cast<long long>(i / 3));
    }
}

// Returns the longest side of a box. It is used instead of the diagonal, whose square would be 0 for tiny boxes.
[[nodiscard]] inline double longest_side(const geometry::Bounds& bounds) noexcept {
    const glm::dvec3 size = bounds.size();
    return std::max({size.x, size.y, size.z});
}

inline void check_bounds(const Decoder& decoder, const geometry::Bounds& bounds) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(std::isfinite(bounds.min[axis]) && std::isfinite(bounds.max[axis]) &&
              bounds.min[axis] <= bounds.max[axis]))
            decoder.damaged("its bounds are not a box");
}

// Checks that a sample is in the bounds, or at most a tenth of their diagonal outside. For a model of sheets, the
// bounds are those of its cells. A fit to a mesh may have samples off the surface, anywhere in the search box.
inline void check_sample(const Decoder& decoder, const geometry::Bounds& bounds, const double* sample,
                         std::int64_t index) {
    const double beyond = 0.1 * bounds.diagonal();
    for (int axis = 0; axis < 3; ++axis) {
        const double slack = beyond + 1e-15 * std::abs(sample[axis]);
        if (!(sample[axis] >= bounds.min[axis] - slack && sample[axis] <= bounds.max[axis] + slack))
            decoder.damaged("sample_position[%lld] is outside its bounds", static_cast<long long>(index));
    }
}

} // namespace hrbfnpr::io
