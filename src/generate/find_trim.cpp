// SPDX-License-Identifier: MIT
#include "generate/find_trim.h"

#include "geometry/cell_block.h"
#include "implicit/trimmed.h"
#include "stipples/surface_cells.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hrbfnpr::generate {
namespace {

using geometry::CellGrid;

// Cells in the diagonal, at most.
constexpr double finest_cells = 256.0;
constexpr double coarsest_cells = 32.0; // some in the margin
constexpr double cells_a_spacing = 2.0;
// A first look at few of them, which is wary instead: less than all of what is asked for is enough.
constexpr double cells_of_first_look = 1.0;
constexpr double wary = 0.7;
// Spacings that samples are off the surface at most, for it to be known between those that are surrounded.
constexpr double on_surface = 0.25;
// Marks lie in a box around the samples' bounds that is wider by up to so many diagonals.
constexpr double margin = 0.1;
// s where there can be no doubt: some 0.8 times as far beyond a border as sixth neighbours are, 1.7 times in the middle
// of a hole.
constexpr double doubtless = 6.0;
constexpr std::int64_t grain = 256;

// All of the surface, and as far as a first look at so many samples goes; guesses.
constexpr double evaluations = 2e5;
constexpr double evaluations_a_sample = 30.0;

// Where the first look goes on.
class Doubtful final : public implicit::Extent {
public:
    Doubtful(const surface::Support& support, double limit) noexcept : support_(support), limit_(limit) {}

    [[nodiscard]] bool holds(const glm::dvec3& place, const glm::dvec3& gradient) const noexcept override {
        return !support_.nearest_sample(place).surrounded || !(support_.value(place, gradient) <= limit_);
    }
    [[nodiscard]] bool may_end_near(const glm::dvec3& /*place*/, double /*half*/) const noexcept override {
        return true;
    }

private:
    const surface::Support& support_;
    double limit_;
};

class Search {
public:
    Search(const base::Runtime& runtime, const implicit::Implicit& implicit, const surface::Support& support,
           const TrimSettings& settings, bool wary_look)
        : runtime_(runtime), support_(support), settings_(settings), wary_(wary_look),
          curves_(!wary_look && settings.closest == 0.0 && support.along_curves()),
          diagonal_(implicit.diagonal()), site_{runtime, implicit, 1e-7, 1}, cells_(runtime.memory),
          value_(runtime.memory), part_(runtime.memory), numbers_(runtime.memory), found_(runtime.memory) {}

    // Counts what is left out.
    void run(const geometry::VecArray& samples, const base::Progress& progress, TrimReport& report);
    // Those that are left out, and the cells around them.
    [[nodiscard]] geometry::CellSet cells_left_out() const;
    // All others that the surface passes.
    [[nodiscard]] geometry::CellSet cells_kept(const geometry::CellSet& left_out) const;
    [[nodiscard]] const CellGrid& grid() const noexcept { return cells_.grid; }
    [[nodiscard]] bool all_is_left_out() const noexcept { return left_out_ > 0 && left_out_ == cells_.cell.size(); }

private:
    // Cells beside each other in which s exceeds the limit.
    struct Part {
        double highest = 0.0; // s
        double farthest = 0.0;
        bool to_end = false;
        bool left_out = false;
        std::int64_t cells = 0;
    };
    static constexpr std::int32_t borne_out = -1;
    static constexpr std::int32_t unknown = -2; // in no part yet

    void cover(const geometry::VecArray& samples, const base::Progress& progress);
    void ask(const base::Progress& progress);
    void collect(std::int64_t from, base::Array<std::int64_t>& front, const base::Progress& progress);
    void look_at(std::int64_t cell, Part& part) const noexcept;
    void judge(Part& part) const noexcept;
    [[nodiscard]] glm::dvec3 place(std::int64_t cell) const noexcept;
    [[nodiscard]] bool at_end(std::int64_t cell) const noexcept;
    template <class Visit>
    void for_neighbours(std::int64_t cell, Visit&& visit) const {
        const CellGrid::Cell at = geometry::morton_cell(cells_.cell[cell].code);
        for (int step = 0; step < geometry::neighbour_count; ++step) {
            const CellGrid::Cell there = geometry::neighbour(at, step);
            if (CellGrid::inside(there)) visit(there, numbers_.find(geometry::morton_code(there)));
        }
    }

    const base::Runtime& runtime_;
    const surface::Support& support_;
    const TrimSettings& settings_;
    bool wary_;
    bool curves_; // samples along them
    double diagonal_;
    marks::Site site_;
    stipples::SurfaceCells cells_;
    base::Array<double> value_;      // s where the surface is nearest to a cell's centre
    base::Array<std::int32_t> part_; // of each cell
    stipples::CellMap numbers_;
    base::Array<Part> found_;
    std::int64_t left_out_ = 0; // cells
};

// Of the surface, next to a cell's centre.
glm::dvec3 Search::place(std::int64_t cell) const noexcept {
    const stipples::SurfaceCell& c = cells_.cell[cell];
    return cells_.grid.centre(geometry::morton_cell(c.code)) - c.distance * c.normal;
}

bool Search::at_end(std::int64_t cell) const noexcept {
    const glm::dvec3 centre = cells_.grid.centre(geometry::morton_cell(cells_.cell[cell].code));
    return !cells_.region.grown(-cells_.grid.side).contains(centre);
}

void Search::cover(const geometry::VecArray& samples, const base::Progress& progress) {
    const geometry::Bounds region = site_.implicit.bounds().grown(margin * diagonal_);
    const double cells = wary_ ? cells_of_first_look : cells_a_spacing;
    const double side = std::clamp(support_.median_spacing() / cells, region.diagonal() / finest_cells,
                                   region.diagonal() / coarsest_cells);
    cells_ = stipples::find_surface_cells(site_, samples, region, side, progress);

    numbers_ = stipples::CellMap(cells_);
}

void Search::ask(const base::Progress& progress) {
    value_.resize(cells_.cell.size());
    part_.resize(cells_.cell.size());
    runtime_.parallel.for_chunks(cells_.cell.size(), grain, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t i = begin; i < end; ++i) {
            const stipples::SurfaceCell& cell = cells_.cell[i];
            value_[i] = std::isnan(cell.distance) ? 0.0 : support_.value(place(i), cell.normal);
            part_[i] = value_[i] > settings_.limit ? unknown : borne_out;
        }
    });
}

void Search::look_at(std::int64_t cell, Part& part) const noexcept {
    part.highest = std::max(part.highest, value_[cell]);
    part.farthest = std::max(part.farthest, support_.nearest_sample(place(cell)).distance);
    part.to_end = part.to_end || at_end(cell);
    ++part.cells;
}

// Between samples that are denser than the surface is accurate there are no holes, and between curves what they bound
// is meant, however far from them.
void Search::judge(Part& part) const noexcept {
    const double share = wary_ ? wary : 1.0;
    const bool sure = settings_.closest > 0.0 || part.highest >= share * doubtless;
    const bool hole = !curves_ && sure && part.farthest > share * settings_.hole * diagonal_;
    part.left_out = part.to_end || hole;
}

void Search::collect(std::int64_t from, base::Array<std::int64_t>& front, const base::Progress& progress) {
    const auto number = static_cast<std::int32_t>(found_.size());
    Part part;
    front.clear();
    const auto take = [&](std::int64_t cell) {
        part_[cell] = number;
        front.push_back(cell);
        look_at(cell, part);
    };
    take(from);
    for (std::int64_t next = 0; next < front.size(); ++next) {
        if (next % 256 == 0) progress.check();
        for_neighbours(front[next], [&](const CellGrid::Cell&, std::int32_t there) {
            if (there >= 0 && part_[there] == unknown) take(there);
        });
    }
    judge(part);
    found_.push_back(part);
}

void Search::run(const geometry::VecArray& samples, const base::Progress& progress, TrimReport& report) {
    cover(samples, progress.part(0.0, 0.6));
    ask(progress);
    base::Array<std::int64_t> front(runtime_.memory);
    for (std::int64_t i = 0; i < cells_.cell.size(); ++i)
        if (part_[i] == unknown) collect(i, front, progress);
    for (const Part& part : found_) {
        if (!part.left_out) continue;
        ++report.parts;
        report.parts_to_end += part.to_end ? 1 : 0;
        report.farthest = std::max(report.farthest, part.farthest);
        left_out_ += part.cells;
    }
    if (left_out_ > 0) report.share = static_cast<double>(left_out_) / static_cast<double>(cells_.cell.size());
}

// The surface ends between a cell that is left out and one that is not.  Of holes that stay closed nothing is taken.
geometry::CellSet Search::cells_left_out() const {
    geometry::CellSet cells(runtime_.memory);
    for (std::int64_t i = 0; i < cells_.cell.size(); ++i) {
        if (part_[i] < 0 || !found_[part_[i]].left_out) continue;
        for_neighbours(i, [&](const CellGrid::Cell& there, std::int32_t number) {
            if (number < 0 || part_[number] < 0 || found_[part_[number]].left_out) cells.insert(CellGrid::pack(there));
        });
    }
    return cells;
}

geometry::CellSet Search::cells_kept(const geometry::CellSet& left_out) const {
    geometry::CellSet cells(runtime_.memory);
    for (const stipples::SurfaceCell& cell : cells_.cell)
        if (const std::uint64_t packed = CellGrid::pack(geometry::morton_cell(cell.code)); !left_out.contains(packed))
            cells.insert(packed);
    return cells;
}

// Whether there may be something to leave out: if there is, a part of it begins where samples are not surrounded.
bool may_end(const base::Runtime& runtime, const ImplicitFor& implicit_for, const surface::Support& support,
             const TrimSettings& settings, const base::Progress& progress) {
    if (!(settings.off <= on_surface * support.median_spacing())) return true;
    const geometry::VecArray from = support.not_surrounded();
    if (from.size() == 0) return false;
    if (2 * from.size() > support.samples()) return true;
    const implicit::Implicit& implicit =
        implicit_for(evaluations_a_sample * static_cast<double>(from.size()), progress.part(0.0, 0.0));
    const Doubtful doubtful(support, settings.limit);
    const implicit::Trimmed some(implicit, doubtful);
    for (const bool wary_look : {true, false}) {
        TrimReport report;
        Search(runtime, some, support, settings, wary_look).run(from, progress, report);
        if (report.parts == 0) return false;
    }
    return true;
}

} // namespace

FoundTrim find_trim(const base::Runtime& runtime, const ImplicitFor& implicit_for, const geometry::VecArray& position,
                    const geometry::VecArray& normal, const TrimSettings& settings, const base::Progress& progress) {
    const double closest = settings.closest * implicit_for(0.0, {}).diagonal();
    surface::Support support(runtime, position, normal, closest, progress.part(0.0, 0.2));
    FoundTrim found;
    found.report.samples = position.size();
    found.report.spacing = support.median_spacing();
    if (!may_end(runtime, implicit_for, support, settings, progress.part(0.2, 0.3))) return found;
    const implicit::Implicit& implicit = implicit_for(evaluations, progress.part(0.3, 0.5));
    Search search(runtime, implicit, support, settings, false);
    search.run(position, progress.part(0.5, 1.0), found.report);
    if (search.all_is_left_out())
        fail(Status::not_converged, "no part of the surface is near its samples: give more of them, or a larger limit");
    if (found.report.parts == 0) return found;
    geometry::CellSet left_out = search.cells_left_out();
    geometry::CellSet kept = search.cells_kept(left_out);
    support.keep(search.grid(), std::move(kept), std::move(left_out), settings.limit);
    found.trim = std::make_unique<surface::Trim>(std::move(support), settings.limit, closest);
    progress.update(1.0);
    return found;
}

} // namespace hrbfnpr::generate
