// SPDX-License-Identifier: MIT
// Few neighbours on one sheet whose normals agree: what large clouds begin with in place of single places.
#pragma once

#include "orient/directions.h"
#include "orient/signs.h"

namespace hrbfnpr::orient {

struct Patches {
    explicit Patches(base::Memory& memory) noexcept : cluster(memory), signs(memory) {}

    base::Array<std::int32_t> cluster; // of each place the first one of its patch
    Signs signs;                       // ... relative to that
};

[[nodiscard]] Patches find_patches(const base::Runtime& runtime, const geometry::PointTree& tree, const Near& near,
                                   const geometry::VecArray& normal);

} // namespace hrbfnpr::orient
