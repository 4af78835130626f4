// SPDX-License-Identifier: MIT
// Model and point-set files: magic, version, endianness, length, checksum.  docs/file-format.md
#pragma once

#include "base/memory.h"
#include "geometry/cell_grid.h"
#include "implicit/hrbf.h"
#include "implicit/pieces.h"
#include "io/stream.h"
#include "marks/point_set.h"

#include <optional>

namespace hrbfnpr::io {

// Where the surface of a trimmed model ends (surface/trim.h).
struct TrimFile {
    explicit TrimFile(base::Memory& memory) noexcept
        : report(memory), position(memory), normal(memory), kept(memory), ends(memory) {}
    double limit = 0.0, closest = 0.0;
    geometry::CellGrid grid;
    base::Array<double> report; // opaque, as that of a model
    base::Array<double> position, normal;
    base::Array<std::int64_t> kept, ends; // cells, packed
};

struct ModelFile {
    explicit ModelFile(base::Memory& memory) noexcept : data(memory), report(memory), trim(memory) {}
    implicit::HrbfData data;                                   // of one fit
    std::optional<implicit::PiecesData> pieces = std::nullopt; // or of sheets
    base::Array<double> report; // numbers in the order of fit::FitReport, opaque to this room
    TrimFile trim;              // without samples: the model is not trimmed
};

// trim: null or without samples where the model is not trimmed.
void save_model(const implicit::HrbfData& data, std::span<const double> report, const TrimFile* trim, Writer& writer);
void save_model(const implicit::PiecesData& data, std::span<const double> report, const TrimFile* trim, Writer& writer);
// Throws Error{corrupt_data, version_mismatch, io, out_of_memory}; reads no byte beyond the file's end.
[[nodiscard]] ModelFile load_model(base::Memory& memory, Reader& reader);

void save_point_set(const marks::PointSet& set, Writer& writer);
[[nodiscard]] marks::PointSet load_point_set(base::Memory& memory, Reader& reader);

} // namespace hrbfnpr::io
