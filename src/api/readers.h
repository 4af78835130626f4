// SPDX-License-Identifier: MIT
// Scratch of the calls that read a drawing: they take a const handle, and may run on several threads at once.
#pragma once

#include "base/scratch_pool.h"
#include "output/marks/mark_results.h"
#include "output/raster/raster.h"
#include "output/vertex/vertices.h"

namespace hrbfnpr::api {

struct Readers {
    explicit Readers(const base::Runtime& runtime) noexcept : rasters(runtime), vertices(runtime), indices(runtime) {}

    base::ScratchPool<output::Raster> rasters;
    base::ScratchPool<output::VertexScratch> vertices;
    base::ScratchPool<output::MarkIndices> indices;
};

} // namespace hrbfnpr::api
