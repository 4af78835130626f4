// SPDX-License-Identifier: MIT
#include "curves/crossed_cells.h"

#include "base/sort.h"
#include "curves/corner_map.h"
#include "geometry/cell_block.h"
#include "geometry/cell_set.h"
#include "geometry/long_vec_array.h"
#include "implicit/evaluate_all.h"

namespace hrbfnpr::curves {
namespace {

using Cell = Lattice::Cell;

constexpr std::int64_t cells_a_look = 4096;

// The corners of a cell's faces, and the ways over them.
struct Face {
    unsigned corners;
    Cell way;
};
constexpr std::array<Face, 6> faces{{{0x55, {-1, 0, 0}},
                                     {0xAA, {1, 0, 0}},
                                     {0x33, {0, -1, 0}},
                                     {0xCC, {0, 1, 0}},
                                     {0x0F, {0, 0, -1}},
                                     {0xF0, {0, 0, 1}}}};

Cell sum(const Cell& a, const Cell& b) noexcept { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

// Cells that are surely beyond the end of the surface, with some around them: asked for in blocks of cells.
class BeyondEnd {
public:
    BeyondEnd(base::Memory& memory, const MeshSettings& settings, const Lattice& lattice) noexcept
        : settings_(settings), lattice_(lattice), asked_(memory), beyond_(memory) {}

    [[nodiscard]] bool operator()(const Cell& cell) {
        if (settings_.extent == nullptr) return false;
        const Cell block{cell[0] / block_side, cell[1] / block_side, cell[2] / block_side};
        const std::uint64_t packed = geometry::CellGrid::pack(block);
        if (asked_.insert(packed) && is_beyond(block)) beyond_.insert(packed);
        return beyond_.contains(packed);
    }

private:
    static constexpr std::int64_t block_side = 8; // cells
    static constexpr double around = 2.0;         // cells

    [[nodiscard]] bool is_beyond(const Cell& block) const noexcept {
        const glm::dvec3 first(static_cast<double>(block[0]), static_cast<double>(block[1]),
                               static_cast<double>(block[2]));
        const double half = 0.5 * static_cast<double>(block_side);
        const glm::dvec3 middle = lattice_.region.min + lattice_.side * (2.0 * half * first + half);
        const double side = std::max({lattice_.side.x, lattice_.side.y, lattice_.side.z});
        return settings_.extent->is_nowhere_near(middle, (half + around) * side);
    }

    const MeshSettings& settings_;
    const Lattice& lattice_;
    geometry::CellSet asked_, beyond_; // blocks
};

class Flood {
public:
    Flood(const base::Runtime& runtime, const implicit::Implicit& implicit, const MeshSettings& settings,
          CrossedCells& cells) noexcept
        : runtime_(runtime), implicit_(implicit), limit_(settings.triangle_limit), cells_(cells),
          is_beyond_(runtime.memory, settings, cells.lattice), known_(runtime.memory), corners_(runtime.memory),
          front_(runtime.memory), next_(runtime.memory), looked_at_(runtime.memory), fresh_(runtime.memory),
          value_(runtime.memory) {}

    void start(const geometry::VecArray& seeds);
    void run(const base::Progress& progress);

private:
    void find_corners(const base::Progress& progress);
    void evaluate(const base::Progress& progress);
    void judge(const CrossedCell& cell, const Cell& place, bool seeded, const base::Progress& progress);
    void go_to(const Cell& cell);

    const base::Runtime& runtime_;
    const implicit::Implicit& implicit_;
    std::int64_t limit_;
    CrossedCells& cells_;
    BeyondEnd is_beyond_;
    geometry::CellSet known_;
    CornerMap corners_;
    base::Array<std::uint64_t> front_, next_; // packed cells to look at in this wave and in the next one
    base::Array<CrossedCell> looked_at_;      // those of this wave
    geometry::VecArray fresh_;                // their corners that no wave before had
    base::Array<double> value_;
};

void Flood::go_to(const Cell& cell) {
    if (!cells_.lattice.inside(cell) || is_beyond_(cell)) return;
    if (const std::uint64_t packed = geometry::CellGrid::pack(cell); known_.insert(packed)) next_.push_back(packed);
}

void Flood::start(const geometry::VecArray& seeds) {
    for (std::int64_t i = 0; i < seeds.size(); ++i)
        if (cells_.lattice.region.contains(seeds[i])) go_to(cells_.lattice.cell_of(seeds[i]));
}

void Flood::find_corners(const base::Progress& progress) {
    looked_at_.resize_for_overwrite(front_.size());
    fresh_.clear();
    for (std::int64_t i = 0; i < front_.size(); ++i) {
        if (i % cells_a_look == 0) progress.check();
        const Cell cell = geometry::CellGrid::unpack(front_[i]);
        looked_at_[i].code = geometry::morton_code(cell);
        for (unsigned k = 0; k < 8; ++k) {
            const Cell corner = sum(cell, {k & 1U, k >> 1U & 1U, k >> 2U});
            const std::uint64_t packed = geometry::CellGrid::pack(corner);
            const std::int32_t number = corners_.number_of(packed, progress);
            if (number == cells_.place.size()) {
                base::push_back_long(cells_.place, packed, progress);
                geometry::push_back_long(fresh_, cells_.lattice.corner(corner), progress);
            }
            looked_at_[i].corner[k] = number;
        }
    }
}

void Flood::evaluate(const base::Progress& progress) {
    value_.resize_for_overwrite(fresh_.size());
    implicit::evaluate_all(runtime_, implicit_, fresh_, {value_.data(), {}, {}}, progress.part(0.0, 0.0));
    for (std::int64_t i = 0; i < fresh_.size(); ++i) {
        if (i % cells_a_look == 0) progress.check();
        geometry::push_back_long(cells_.position, fresh_[i], progress);
        base::push_back_long(cells_.value, value_[i], progress);
    }
}

// The flood goes on over every face that the surface passes through.  A seed may be nearer to the surface than the
// corners of its own cell can tell: then the cells around it are looked at.
void Flood::judge(const CrossedCell& cell, const Cell& place, bool seeded, const base::Progress& progress) {
    const unsigned negative = cells_.negative_corners(cell);
    std::int64_t triangles = 0;
    cells_.sections_of(cell, [&](const Tetrahedron&, const Section& section) { triangles += section.size - 2; });
    if (triangles > 0) base::push_back_long(cells_.cell, cell, progress);
    cells_.triangles += triangles;
    for (const Face& face : faces)
        if ((negative & face.corners) != 0 && (~negative & face.corners) != 0) go_to(sum(place, face.way));
    if (seeded && triangles == 0)
        for (int step = 0; step < geometry::neighbour_count; ++step) go_to(geometry::neighbour(place, step));
}

void Flood::run(const base::Progress& progress) {
    for (bool seeded = true; !next_.empty(); seeded = false) {
        progress.check();
        std::swap(front_, next_);
        next_.clear();
        find_corners(progress);
        evaluate(progress);
        for (std::int64_t i = 0; i < front_.size(); ++i) {
            if (i % cells_a_look == 0) progress.check();
            judge(looked_at_[i], geometry::CellGrid::unpack(front_[i]), seeded, progress);
        }
        if (cells_.triangles > limit_)
            fail(Status::invalid_argument,
                 "the mesh would have more than %lld triangles: give its cells a larger side than %g",
                 static_cast<long long>(limit_),
                 std::max({cells_.lattice.side.x, cells_.lattice.side.y, cells_.lattice.side.z}));
    }
}

} // namespace

CrossedCells find_crossed_cells(const base::Runtime& runtime, const implicit::Implicit& implicit,
                                const geometry::VecArray& seeds, const Lattice& lattice, const MeshSettings& settings,
                                const base::Progress& progress) {
    CrossedCells cells(runtime.memory, lattice);
    Flood flood(runtime, implicit, settings, cells);
    flood.start(seeds);
    flood.run(progress);
    base::sort_long(
        cells.cell.begin(), cells.cell.end(),
        [](const CrossedCell& a, const CrossedCell& b) { return a.code < b.code; }, progress);
    return cells;
}

} // namespace hrbfnpr::curves
