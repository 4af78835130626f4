// SPDX-License-Identifier: MIT
// Saves and loads models and point sets in the format of docs/file-format.md.
#pragma once

#include "base/memory.h"
#include "geometry/cell_grid.h"
#include "implicit/csg_shapes.h"
#include "implicit/hrbf.h"
#include "implicit/sheet_tree.h"
#include "io/stream.h"
#include "marks/point_set.h"

#include <new>
#include <optional>

namespace hrbfnpr::io {

// Where the surface of a trimmed model ends (surface/support_domain.h).
struct TrimFile {
    explicit TrimFile(base::Memory& memory) noexcept
        : report(memory), position(memory), normal(memory), kept_cells(memory), end_cells(memory) {}
    double limit = 0.0, closest = 0.0;
    geometry::CellGrid grid;
    base::Array<double> report; // the numbers of a report, which src/io does not interpret
    base::Array<double> position, normal;
    // Cells; the three indices of each are packed into one integer.
    base::Array<std::int64_t> kept_cells, end_cells;
};

// A single fit, or a model of sheets.
struct FitFile {
    explicit FitFile(base::Memory& memory) noexcept : data(memory), report(memory) {}
    implicit::HrbfData data;
    std::optional<implicit::SheetTreeData> pieces = std::nullopt;
    base::Array<double> report; // the numbers of a fit::FitReport in order; src/io does not interpret them
};

// A growing list of FitFiles in the context's memory.
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
    TrimFile trim; // has no samples if the model is not trimmed
    // If this has nodes, the model is a CSG tree and not a fit. The caller must check that the nodes form a tree.
    implicit::CsgTree tree;
    geometry::Bounds bounds;
    FitFiles leaves;
};

// A fit or a model of sheets. Exactly one of `data` and `pieces` is not null.
struct FitToSave {
    const implicit::HrbfData* data = nullptr;
    const implicit::SheetTreeData* pieces = nullptr;
    std::span<const double> report;
};

// Writes a model file. If the model is not trimmed, `trim` is null or has no samples.
void save_model(const FitToSave& fit, const TrimFile* trim, Writer& writer);
void save_csg(const implicit::CsgTree& tree, const geometry::Bounds& bounds, std::span<const FitToSave> leaves,
              const TrimFile* trim, Writer& writer);
// Reads a model file. It reads no byte beyond the end of the model. Throws Error{corrupt_data, version_mismatch, io,
// out_of_memory}.
[[nodiscard]] ModelFile load_model(base::Memory& memory, Reader& reader);

void save_point_set(const marks::PointSet& set, Writer& writer);
[[nodiscard]] marks::PointSet load_point_set(base::Memory& memory, Reader& reader);

} // namespace hrbfnpr::io
