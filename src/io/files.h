// SPDX-License-Identifier: MIT
// Model and point-set files: magic, version, endianness, length, checksum.  docs/file-format.md
#pragma once

#include "base/memory.h"
#include "geometry/cell_grid.h"
#include "implicit/csg_shapes.h"
#include "implicit/hrbf.h"
#include "implicit/pieces.h"
#include "io/stream.h"
#include "marks/point_set.h"

#include <new>
#include <optional>

namespace hrbfnpr::io {

// Where the surface of a trimmed model ends (surface/support_domain.h).
struct TrimFile {
    explicit TrimFile(base::Memory& memory) noexcept
        : report(memory), position(memory), normal(memory), kept(memory), ends(memory) {}
    double limit = 0.0, closest = 0.0;
    geometry::CellGrid grid;
    base::Array<double> report; // opaque, as that of a model
    base::Array<double> position, normal;
    base::Array<std::int64_t> kept, ends; // cells, packed
};

// Of one fit, or of sheets.
struct FitFile {
    explicit FitFile(base::Memory& memory) noexcept : data(memory), report(memory) {}
    implicit::HrbfData data;
    std::optional<implicit::PiecesData> pieces = std::nullopt;
    base::Array<double> report; // numbers in the order of fit::FitReport, opaque to this room
};

// Any number of them, in the context's memory.
class FitFiles {
public:
    explicit FitFiles(base::Memory& memory) noexcept : files_(memory) {}
    FitFiles(FitFiles&&) noexcept = default;
    FitFiles& operator=(FitFiles&&) = delete;
    ~FitFiles() {
        for (FitFile* const file : files_) {
            if (file == nullptr) continue;
            file->~FitFile();
            files_.memory().deallocate(file, sizeof(FitFile));
        }
    }

    [[nodiscard]] FitFile& add() {
        files_.push_back(nullptr);
        return *(files_.back() = new (files_.memory().allocate(sizeof(FitFile))) FitFile(files_.memory()));
    }
    [[nodiscard]] std::int64_t size() const noexcept { return files_.size(); }
    [[nodiscard]] FitFile& operator[](std::int64_t i) const noexcept { return *files_[i]; }

private:
    base::Array<FitFile*> files_;
};

struct ModelFile : FitFile {
    explicit ModelFile(base::Memory& memory) noexcept : FitFile(memory), trim(memory), tree(memory), leaves(memory) {}
    TrimFile trim; // without samples: the model is not trimmed
    // With nodes: the model is a tree, and no fit.  That its nodes make one is for others to check.
    implicit::CsgTree tree;
    geometry::Bounds bounds;
    FitFiles leaves;
};

// One of the two.
struct FitToSave {
    const implicit::HrbfData* data = nullptr;
    const implicit::PiecesData* pieces = nullptr;
    std::span<const double> report;
};

// trim: null or without samples where the model is not trimmed.
void save_model(const FitToSave& fit, const TrimFile* trim, Writer& writer);
void save_csg(const implicit::CsgTree& tree, const geometry::Bounds& bounds, std::span<const FitToSave> leaves,
              const TrimFile* trim, Writer& writer);
// Throws Error{corrupt_data, version_mismatch, io, out_of_memory}; reads no byte beyond the file's end.
[[nodiscard]] ModelFile load_model(base::Memory& memory, Reader& reader);

void save_point_set(const marks::PointSet& set, Writer& writer);
[[nodiscard]] marks::PointSet load_point_set(base::Memory& memory, Reader& reader);

} // namespace hrbfnpr::io
