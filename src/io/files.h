// SPDX-License-Identifier: MIT
// Model and point-set files: magic, version, endianness, length, checksum.  docs/file-format.md
#pragma once

#include "base/memory.h"
#include "implicit/hrbf.h"
#include "io/stream.h"
#include "marks/point_set.h"

namespace hrbfnpr::io {

// Numbers that a model keeps beside its coefficients, in the order of fit::FitReport;
// opaque to this room.
struct ModelFile {
    explicit ModelFile(base::Memory& memory) noexcept : data(memory), report(memory) {}
    implicit::HrbfData data;
    base::Array<double> report;
};

void save_model(const implicit::HrbfData& data, std::span<const double> report, Writer& writer);
// Throws Error{corrupt_data, version_mismatch, io, out_of_memory}; reads no byte beyond the file's end.
[[nodiscard]] ModelFile load_model(base::Memory& memory, Reader& reader);

void save_point_set(const marks::PointSet& set, Writer& writer);
[[nodiscard]] marks::PointSet load_point_set(base::Memory& memory, Reader& reader);

} // namespace hrbfnpr::io
