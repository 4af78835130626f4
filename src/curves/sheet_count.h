// SPDX-License-Identifier: MIT
// How often the surface lies between two points: the quantitative invisibility of one seen from the other.  [Appel
// 1967]
#pragma once

#include "base/memory.h"
#include "base/operation.h"
#include "base/runtime.h"
#include "curves/surface_mesh.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"

#include <cstdint>

namespace hrbfnpr::curves {

// Made once for a mesh, which must outlive it; const afterwards, for any number of threads.
class SheetCounter {
public:
    SheetCounter(const base::Runtime& runtime, const SurfaceMesh& mesh, const base::Progress& progress);
    ~SheetCounter();
    SheetCounter(const SheetCounter&) = delete;
    SheetCounter& operator=(const SheetCounter&) = delete;

    struct Answer {
        std::int32_t sheets = 0;
        bool certain = true; // false: the segment grazes the surface, or its two counts do not agree
    };
    // The crossings of f = 0 with the open segments from[i] to to[i].  `to` may itself lie on the surface: crossings
    // nearer to it than clear[i] are not counted.  answer is resized.
    void count(const base::Runtime& runtime, const implicit::Implicit& implicit, const geometry::VecArray& from,
               const geometry::VecArray& to, const base::Array<double>& clear, base::Array<Answer>& answer,
               const base::Progress& progress) const;

    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    struct Impl;
    Impl* impl_;
};

} // namespace hrbfnpr::curves
