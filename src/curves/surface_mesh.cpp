// SPDX-License-Identifier: MIT
// Marching tetrahedra [Doi & Koide 1991] over the cells that a flood from seeds reaches:
//
//   seeds_on_surface     projects seeds onto f = 0
//   find_crossed_cells   floods from their cells over all faces that the surface crosses, by the signs of f at corners
//   clear_corners        moves corners that are very near the surface away from it
//   number_edges         makes a vertex of each tetrahedron edge that the surface crosses
//   find_vertices        finds the root of f on each of these edges
//   add_triangles        adds one or two triangles in each tetrahedron
//   count_missed         counts seeds without a part of the mesh near them
//
// Vertices lie on edges of the tetrahedra, so triangles meet only in their edges and corners.
#include "curves/surface_mesh.h"

#include "base/long_array.h"
#include "base/sort.h"
#include "curves/mesh_edges.h"
#include "curves/tuning.h"
#include "geometry/cell_block.h"
#include "geometry/cell_set.h"
#include "geometry/long_vec_array.h"
#include "geometry/point_grid.h"
#include "implicit/evaluate_all.h"
#include "surface/project.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

using Cell = geometry::CellGrid::Cell;

// The limit keeps the indices of corners within 32 bits.
constexpr std::int64_t most_surface_triangles = std::int64_t{1} << 28;

// ---- The lattice

// A region divided into equal cells that fill it exactly, so that f is not evaluated outside of it.
struct Lattice {
    geometry::Bounds region;
    glm::dvec3 side{0.0};
    Cell cells{}; // the number of cells along each axis

    [[nodiscard]] double longest() const noexcept { return std::max({side.x, side.y, side.z}); }
    [[nodiscard]] bool inside(const Cell& cell) const noexcept {
        return cell[0] >= 0 && cell[0] < cells[0] && cell[1] >= 0 && cell[1] < cells[1] && cell[2] >= 0 &&
               cell[2] < cells[2];
    }
    [[nodiscard]] Cell cell_of(const glm::dvec3& p) const noexcept {
        const glm::dvec3 at = (p - region.min) / side;
        return {geometry::truncate_to(at.x, cells[0] - 1), geometry::truncate_to(at.y, cells[1] - 1),
                geometry::truncate_to(at.z, cells[2] - 1)};
    }
    [[nodiscard]] glm::dvec3 corner(const Cell& at) const noexcept {
        const glm::dvec3 p = region.min + side * glm::dvec3(static_cast<double>(at[0]), static_cast<double>(at[1]),
                                                            static_cast<double>(at[2]));
        return glm::min(p, region.max);
    }
};

Lattice lattice_of(const MeshSettings& settings) {
    using Grid = geometry::CellGrid;
    const glm::dvec3 size = settings.region.size();
    Lattice lattice{settings.region, glm::dvec3(0.0), {}};
    bool valid = true;
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t count =
            std::max<std::int64_t>(1, geometry::truncate_to(std::ceil(size[axis] / settings.side), Grid::most));
        lattice.cells[static_cast<std::size_t>(axis)] = count;
        lattice.side[axis] = size[axis] / static_cast<double>(count);
        valid = valid && lattice.side[axis] > 0.0 && count < Grid::most - 1;
    }
    if (!valid)
        fail(Status::invalid_argument,
             "a region of %g x %g x %g cannot be cut into cells of side %g; use a larger cell_size", size.x, size.y,
             size.z, settings.side);
    return lattice;
}

// ---- Tetrahedra

// A cube is cut into six tetrahedra around its diagonal (Kuhn 1960). All cubes are cut in the same way, so that
// tetrahedra of adjacent cubes share their faces. The index of a corner of the cube has three bits, one for each of x,
// y and z. A tetrahedron has the four corners of a path from corner 0 to corner 7, on which each step sets one more
// bit. So the bits of an edge's lower corner are a subset of the bits of its upper corner.
struct Tetrahedron {
    std::array<std::uint8_t, 4> corner;
    std::uint8_t corners; // the corners as a set of bits
    bool even;            // true if the tetrahedron is positively oriented
};

constexpr std::array<Tetrahedron, 6> tetrahedra{{
    {{0, 1, 3, 7}, 0x8B, true},
    {{0, 2, 6, 7}, 0xC5, true},
    {{0, 4, 5, 7}, 0xB1, true},
    {{0, 1, 5, 7}, 0xA3, false},
    {{0, 2, 3, 7}, 0x8D, false},
    {{0, 4, 6, 7}, 0xD1, false},
}};

// The intersection of the surface with a tetrahedron: a polygon with a corner on each edge in `edge`. As seen from the
// positive corners, it is counter-clockwise if the tetrahedron is even, else clockwise.
struct Section {
    std::uint8_t size = 0; // the number of corners: 0, 3 or 4
    // The two ends of each edge as corners of the tetrahedron, the lower one first.
    std::array<std::array<std::uint8_t, 2>, 4> edge{};
};

// The section for each set of negative corners. It is a triangle around a single corner, or a quadrilateral that
// separates two corners from the other two.
constexpr std::array<Section, 16> sections{{
    {},
    {3, {{{0, 3}, {0, 1}, {0, 2}}}},
    {3, {{{1, 2}, {0, 1}, {1, 3}}}},
    {4, {{{0, 2}, {0, 3}, {1, 3}, {1, 2}}}},
    {3, {{{1, 2}, {2, 3}, {0, 2}}}},
    {4, {{{0, 3}, {0, 1}, {1, 2}, {2, 3}}}},
    {4, {{{1, 3}, {2, 3}, {0, 2}, {0, 1}}}},
    {3, {{{0, 3}, {1, 3}, {2, 3}}}},
    {3, {{{0, 3}, {2, 3}, {1, 3}}}},
    {4, {{{0, 1}, {0, 2}, {2, 3}, {1, 3}}}},
    {4, {{{2, 3}, {1, 2}, {0, 1}, {0, 3}}}},
    {3, {{{1, 2}, {0, 2}, {2, 3}}}},
    {4, {{{1, 2}, {1, 3}, {0, 3}, {0, 2}}}},
    {3, {{{1, 2}, {1, 3}, {0, 1}}}},
    {3, {{{0, 3}, {0, 2}, {0, 1}}}},
    {},
}};

// ---- Cells

struct CrossedCell {
    std::uint64_t code; // the Morton code (geometry/morton.h)
    std::array<std::int32_t, 8> corner;
};

struct CrossedCells {
    CrossedCells(base::Memory& memory, const Lattice& cut) noexcept
        : lattice(cut), cell(memory), place(memory), position(memory), value(memory) {}

    Lattice lattice;
    base::Array<CrossedCell> cell;    // the crossed cells, in the order of a space-filling curve
    base::Array<std::uint64_t> place; // for each corner: its packed coordinates in the lattice
    geometry::VecArray position;      // for each corner: its position
    base::Array<double> value;        // for each corner: f
    std::int64_t triangles = 0;

    [[nodiscard]] unsigned negative_corners(const CrossedCell& of) const noexcept {
        unsigned set = 0;
        for (unsigned k = 0; k < 8; ++k) set |= (value[of.corner[k]] < 0.0 ? 1U : 0U) << k;
        return set;
    }
    // Calls visit(tetrahedron, section) for each tetrahedron that the surface crosses, if f is finite at its corners.
    template <class Visit>
    void sections_of(const CrossedCell& of, Visit&& visit) const {
        const unsigned negative = negative_corners(of);
        unsigned known = 0;
        for (unsigned k = 0; k < 8; ++k) known |= (std::isfinite(value[of.corner[k]]) ? 1U : 0U) << k;
        for (const Tetrahedron& tetrahedron : tetrahedra) {
            unsigned set = 0;
            for (unsigned i = 0; i < 4; ++i) set |= (negative >> tetrahedron.corner[i] & 1U) << i;
            if (sections[set].size > 0 && (tetrahedron.corners & ~known) == 0) visit(tetrahedron, sections[set]);
        }
    }
};

// Assigns indices to corners, in the order in which number_of() is first called for them.
class CornerMap {
public:
    explicit CornerMap(base::Memory& memory) noexcept : table_(memory) {}

    // Returns the index of a corner. A new corner gets the next free index.
    std::int32_t number_of(std::uint64_t packed, const base::Progress& progress) {
        if (2 * (count_ + 1) > table_.size()) grow(progress);
        Entry& entry = place(table_, packed + 1);
        if (entry.name == 0) entry = {packed + 1, static_cast<std::int32_t>(count_++)};
        return entry.number;
    }

private:
    struct Entry {
        std::uint64_t name; // the packed corner plus 1, or 0 if the entry is free
        std::int32_t number;
    };

    [[nodiscard]] static Entry& place(base::Array<Entry>& table, std::uint64_t name) noexcept {
        const auto mask = static_cast<std::uint64_t>(table.size() - 1);
        for (std::uint64_t at = geometry::hash_bits(name) & mask;; at = (at + 1) & mask) {
            Entry& entry = table[static_cast<std::int64_t>(at)];
            if (entry.name == name || entry.name == 0) return entry;
        }
    }
    void grow(const base::Progress& progress) {
        base::Array<Entry> larger(table_.memory());
        base::resize_long(larger, std::max<std::int64_t>(1024, 2 * table_.size()), progress);
        for (const std::int64_t i : progress.over(table_.size())) {
            if (table_[i].name != 0) place(larger, table_[i].name) = table_[i];
        }
        table_ = std::move(larger);
    }

    // A hash table with open addressing. Its size is a power of two, and at most half of it is used.
    base::Array<Entry> table_;
    std::int64_t count_ = 0;
};

// Projects seeds onto the surface. Drops seeds that do not converge or that move too far.
surface::Projection seeds_on_surface(const base::Work& work, const implicit::Implicit& implicit,
                                     const geometry::VecArray& seeds, const MeshSettings& settings) {
    surface::Projection on(work.memory);
    geometry::VecArray before(work.memory);
    for (std::int64_t i = 0; i < seeds.size(); ++i) {
        if (!settings.region.contains(seeds[i])) continue;
        on.position.push_back(seeds[i]);
        before.push_back(seeds[i]);
    }
    surface::ProjectionSettings steps;
    steps.evaluation_limit = curve_tuning.newton_steps;
    steps.tolerance = std::max(settings.tolerance, curve_tuning.close * settings.side / implicit.diagonal());
    surface::project(work, implicit, steps, on);
    std::int64_t kept = 0;
    for (std::int64_t i = 0; i < before.size(); ++i) {
        const glm::dvec3 place = on.position[i];
        if (on.status[i] != surface::ProjectionStatus::converged || !settings.region.contains(place) ||
            glm::distance(place, before[i]) > settings.side)
            continue;
        on.position.set(kept, place);
        on.gradient.set(kept++, on.gradient[i]);
    }
    on.position.resize(kept);
    on.gradient.resize(kept);
    return on;
}

// Finds the crossed cells in waves. The cells of a wave get their corners, the new corners get their values, and the
// next wave continues across each face that the surface crosses. Blocks of cells that are certainly beyond the end of
// the surface are skipped.
CrossedCells find_crossed_cells(const base::Work& work, const implicit::Implicit& implicit,
                                const geometry::VecArray& seeds, const Lattice& lattice, const MeshSettings& settings) {
    // The corners of each face of a cell, and the step to the cell across the face.
    struct Face {
        unsigned corners;
        Cell way;
    };
    static constexpr std::array<Face, 6> faces{{{0x55, {-1, 0, 0}},
                                                {0xAA, {1, 0, 0}},
                                                {0x33, {0, -1, 0}},
                                                {0xCC, {0, 1, 0}},
                                                {0x0F, {0, 0, -1}},
                                                {0xF0, {0, 0, 1}}}};
    HRBFNPR_ASSERT(settings.block_side > 0);
    const std::int64_t block_side = settings.block_side;
    const auto sum = [](const Cell& a, const Cell& b) { return Cell{a[0] + b[0], a[1] + b[1], a[2] + b[2]}; };
    const std::int64_t limit = std::min(settings.triangle_limit, most_surface_triangles);

    CrossedCells cells(work.memory, lattice);
    // The blocks that were tested, and those beyond the end of the surface.
    geometry::CellSet asked(work.memory), beyond(work.memory);
    const auto is_beyond = [&](const Cell& cell) {
        if (settings.domain == nullptr) return false;
        const Cell block{cell[0] / block_side, cell[1] / block_side, cell[2] / block_side};
        const std::uint64_t packed = geometry::CellGrid::pack(block);
        if (asked.insert(packed)) {
            const double half = 0.5 * static_cast<double>(block_side);
            const glm::dvec3 first(static_cast<double>(block[0]), static_cast<double>(block[1]),
                                   static_cast<double>(block[2]));
            const glm::dvec3 middle = lattice.region.min + lattice.side * (2.0 * half * first + half);
            if (settings.domain->has_no_surface_in(middle, (half + curve_tuning.beyond_end) * lattice.longest()))
                beyond.insert(packed);
        }
        return beyond.contains(packed);
    };
    geometry::CellSet known(work.memory);
    // The packed cells of this wave and of the next one.
    base::Array<std::uint64_t> front(work.memory), next(work.memory);
    const auto go_to = [&](const Cell& cell) {
        if (!lattice.inside(cell) || is_beyond(cell)) return;
        if (const std::uint64_t packed = geometry::CellGrid::pack(cell); known.insert(packed)) next.push_back(packed);
    };
    for (std::int64_t i = 0; i < seeds.size(); ++i)
        if (lattice.region.contains(seeds[i])) go_to(lattice.cell_of(seeds[i]));

    CornerMap corners(work.memory);
    base::Array<CrossedCell> wave(work.memory);
    geometry::VecArray fresh(work.memory); // the positions of the corners that are new in this wave
    base::Array<double> value(work.memory);
    for (bool seeded = true; !next.empty(); seeded = false) {
        work.check();
        std::swap(front, next);
        next.clear();
        wave.resize_for_overwrite(front.size());
        fresh.clear();
        for (const std::int64_t i : work.over(front.size())) {
            const Cell cell = geometry::CellGrid::unpack(front[i]);
            wave[i].code = geometry::morton_code(cell);
            for (unsigned k = 0; k < 8; ++k) {
                const Cell corner = sum(cell, {k & 1U, k >> 1U & 1U, k >> 2U});
                const std::uint64_t packed = geometry::CellGrid::pack(corner);
                wave[i].corner[k] = corners.number_of(packed, work);
                if (wave[i].corner[k] != cells.place.size()) continue;
                base::push_back_long(cells.place, packed, work);
                geometry::push_back_long(fresh, lattice.corner(corner), work);
            }
        }
        value.resize_for_overwrite(fresh.size());
        implicit::evaluate_all(work.without_progress(), implicit, fresh, {value.data(), {}, {}});
        for (const std::int64_t i : work.over(fresh.size())) {
            geometry::push_back_long(cells.position, fresh[i], work);
            base::push_back_long(cells.value, value[i], work);
        }
        HRBFNPR_ASSERT(cells.value.size() == cells.place.size());
        for (const std::int64_t i : work.over(front.size())) {
            const Cell place = geometry::CellGrid::unpack(front[i]);
            const unsigned negative = cells.negative_corners(wave[i]);
            std::int64_t triangles = 0;
            cells.sections_of(wave[i], [&](const Tetrahedron&, const Section& s) { triangles += s.size - 2; });
            if (triangles > 0) base::push_back_long(cells.cell, wave[i], work);
            cells.triangles += triangles;
            for (const Face& face : faces)
                if ((negative & face.corners) != 0 && (~negative & face.corners) != 0) go_to(sum(place, face.way));
            // The surface may pass through a seed's cell although f has the same sign at all corners of the cell. The
            // flood then also starts in the adjacent cells.
            if (seeded && triangles == 0)
                for (int step = 0; step < geometry::neighbour_count; ++step) go_to(geometry::neighbour(place, step));
        }
        if (cells.triangles > limit)
            fail(Status::invalid_argument,
                 "the mesh would have more than %lld triangles; use a cell_size larger than %g",
                 static_cast<long long>(limit), lattice.longest());
    }
    base::sort_long(
        cells.cell.begin(), cells.cell.end(),
        [](const CrossedCell& a, const CrossedCell& b) { return a.code < b.code; }, work);
    return cells;
}

// If the surface passes very near a corner, it cuts all edges there in nearly the same point, and triangles degenerate.
// So corners very near the surface are moved away from it. Corners on the region's faces stay on these faces. The signs
// of f do not change, so the triangles keep their connections.
void clear_corners(const base::Work& work, const implicit::Implicit& implicit, CrossedCells& cells) {
    const double clearance = curve_tuning.corner_clearance;
    const Lattice& lattice = cells.lattice;
    const double distance = clearance * std::min({lattice.side.x, lattice.side.y, lattice.side.z});
    base::Array<std::uint8_t> near(work.memory, cells.value.size());
    for (const std::int64_t i : work.over(cells.cell.size())) {
        const CrossedCell& cell = cells.cell[i];
        cells.sections_of(cell, [&](const Tetrahedron& tetrahedron, const Section& section) {
            for (std::size_t k = 0; k < section.size; ++k) {
                const std::int32_t a = cell.corner[tetrahedron.corner[section.edge[k][0]]];
                const std::int32_t b = cell.corner[tetrahedron.corner[section.edge[k][1]]];
                const double at = cells.value[a] / (cells.value[a] - cells.value[b]);
                if (at < clearance) near[a] = 1;
                if (at > 1.0 - clearance) near[b] = 1;
            }
        });
    }
    base::Array<std::int32_t> which(work.memory);
    geometry::VecArray place(work.memory), gradient(work.memory);
    for (const std::int64_t i : work.over(near.size())) {
        if (near[i] == 0) continue;
        which.push_back(static_cast<std::int32_t>(i));
        push_back_long(place, cells.position[i], work);
    }
    resize_long(gradient, place.size(), work);
    implicit::evaluate_all(work, implicit, place,
                           {nullptr, {gradient.x.data(), gradient.y.data(), gradient.z.data()}, {}});
    for (const std::int64_t i : work.over(which.size())) {
        const double slope = glm::length(gradient[i]);
        const double value = cells.value[which[i]];
        const double missing = distance - std::abs(value) / slope;
        if (!surface::is_usable_slope(slope) || !(missing > 0.0)) continue;
        glm::dvec3 way = gradient[i] * ((value < 0.0 ? -missing : missing) / slope);
        const Cell at = geometry::CellGrid::unpack(cells.place[which[i]]);
        for (int axis = 0; axis < 3; ++axis) {
            const auto k = static_cast<std::size_t>(axis);
            if (at[k] == 0 || at[k] == lattice.cells[k]) way[axis] = 0.0;
        }
        place.set(i, place[i] + way);
    }
    base::Array<double> value(work.memory, which.size());
    implicit::evaluate_all(work, implicit, place, {value.data(), {}, {}});
    for (std::int64_t i = 0; i < which.size(); ++i) {
        double& known = cells.value[which[i]];
        if (!std::isfinite(value[i]) || (value[i] < 0.0) != (known < 0.0)) continue;
        cells.position.set(which[i], place[i]);
        known = value[i];
    }
}

// ---- Vertices

// An edge between two corners at which f has different signs.
struct CrossedEdge {
    std::int32_t from, to;
};

// Returns the index of an edge, computed from the index of its lower corner and its direction. There are 7 directions.
std::int64_t edge_number(const CrossedCell& cell, const Tetrahedron& tetrahedron,
                         const std::array<std::uint8_t, 2>& between) noexcept {
    const std::uint8_t from = tetrahedron.corner[between[0]];
    const int way = from ^ tetrahedron.corner[between[1]];
    HRBFNPR_ASSERT(way > 0);
    return std::int64_t{7} * cell.corner[from] + way - 1;
}

// Lists the edges that the surface crosses, each edge once. Returns for each edge number 1 + the index in the list, or
// 0.
base::Array<std::int32_t> number_edges(const CrossedCells& cells, base::Array<CrossedEdge>& edges,
                                       const base::Progress& progress) {
    base::Array<std::int32_t> numbers(edges.memory());
    base::resize_long(numbers, std::int64_t{7} * cells.value.size(), progress);
    for (const std::int64_t i : progress.over(cells.cell.size())) {
        const CrossedCell& cell = cells.cell[i];
        cells.sections_of(cell, [&](const Tetrahedron& tetrahedron, const Section& section) {
            for (std::size_t k = 0; k < section.size; ++k) {
                std::int32_t& number = numbers[edge_number(cell, tetrahedron, section.edge[k])];
                if (number != 0) continue;
                edges.push_back({cell.corner[tetrahedron.corner[section.edge[k][0]]],
                                 cell.corner[tetrahedron.corner[section.edge[k][1]]]});
                number = static_cast<std::int32_t>(edges.size());
            }
        });
    }
    return numbers;
}

// A search on an edge, with positions from 0 to 1, and the bracket of the root.
struct RootSearch {
    glm::dvec3 from{0.0}, along{0.0};
    double low = 0.0, high = 1.0;
    double low_value = 0.0, high_value = 0.0;
    double at = 0.0;
    std::int64_t index = 0;
    int evaluations = 0;
};

// Finds a root of a cubic by Newton's method. The cubic has the values of f at the ends of the bracket, and the value
// and slope of f at the place that was evaluated last.
double root_of_cubic(const RootSearch& search, double value, double slope) noexcept {
    const double x = search.low - search.at;
    const double y = search.high - search.at;
    const double at_x = (search.low_value - value - slope * x) / (x * x);
    const double at_y = (search.high_value - value - slope * y) / (y * y);
    const double third = (at_y - at_x) / (y - x);
    const double second = at_x - third * x;
    double t = -value / slope;
    for (int step = 0; step < 3; ++step) {
        const double p = value + t * (slope + t * (second + t * third));
        const double dp = slope + t * (2.0 * second + t * 3.0 * third);
        t -= p / dp;
    }
    return search.at + t;
}

// A batch of searches, with the values of f at their places.
struct RootLanes {
    static constexpr auto size = static_cast<std::size_t>(implicit::batch_size);
    RootLanes() noexcept {} // NOLINT(modernize-use-equals-default): the columns stay as they are

    std::array<RootSearch, size> search;
    std::array<double, size> x, y, z, f, gx, gy, gz;
};

// Sets the vertices of the edges order[begin] to order[end - 1]. If `order` is null, these are the edges begin to end -
// 1. Returns the number of edges whose root was not found. The vertex of such an edge is the last place that the search
// tried.
std::int64_t find_some_vertices(const implicit::Implicit& implicit, const CrossedCells& cells,
                                const base::Array<CrossedEdge>& edges, const std::int32_t* order, std::int64_t begin,
                                std::int64_t end, double tolerance, RootLanes& lanes, SurfaceMesh& mesh,
                                const base::Progress& progress) {
    HRBFNPR_ASSERT(0 <= begin && begin <= end && end <= edges.size() && end - begin <= implicit::batch_size);
    auto count = static_cast<std::size_t>(end - begin);
    for (std::size_t i = 0; i < count; ++i) {
        const std::int64_t at = begin + static_cast<std::int64_t>(i);
        const std::int64_t index = order != nullptr ? order[at] : at;
        const CrossedEdge edge = edges[index];
        const glm::dvec3 from = cells.position[edge.from];
        const double low = cells.value[edge.from];
        const double high = cells.value[edge.to];
        const double share = low / (low - high);
        lanes.search[i] = {from, cells.position[edge.to] - from,           0.0,   1.0, low,
                           high, share > 0.0 && share < 1.0 ? share : 0.5, index, 0};
    }
    std::int64_t unresolved = 0;
    // Continues a search with f at its place. Returns false at the end of the search, when the vertex is set.
    const auto goes_on = [&](RootSearch& search, double value, const glm::dvec3& gradient) {
        const double slope = glm::length(gradient);
        const bool usable = std::isfinite(value) && std::isfinite(slope);
        const bool there = usable && surface::is_usable_slope(slope) && std::abs(value) <= tolerance * slope;
        if (there || !usable || ++search.evaluations == curve_tuning.most_steps) {
            if (!there) ++unresolved;
            mesh.position.set(search.index, search.from + search.at * search.along);
            mesh.gradient.set(search.index, surface::is_usable_slope(slope) ? gradient : glm::dvec3(0.0));
            return false;
        }
        const double next = root_of_cubic(search, value, glm::dot(gradient, search.along));
        const bool low_side = (value < 0.0) == (search.low_value < 0.0);
        (low_side ? search.low : search.high) = search.at;
        (low_side ? search.low_value : search.high_value) = value;
        const bool halve = search.evaluations > curve_tuning.trusted_steps && search.evaluations % 2 == 0;
        const bool within = next > search.low && next < search.high;
        search.at = within && !halve ? next : 0.5 * (search.low + search.high);
        return true;
    };
    while (count > 0) {
        progress.check();
        for (std::size_t i = 0; i < count; ++i) {
            const glm::dvec3 p = lanes.search[i].from + lanes.search[i].at * lanes.search[i].along;
            lanes.x[i] = p.x;
            lanes.y[i] = p.y;
            lanes.z[i] = p.z;
        }
        implicit.evaluate({lanes.x.data(), lanes.y.data(), lanes.z.data(), static_cast<std::int64_t>(count)},
                          {lanes.f.data(), {lanes.gx.data(), lanes.gy.data(), lanes.gz.data()}, {}});
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count; ++i)
            if (goes_on(lanes.search[i], lanes.f[i], {lanes.gx[i], lanes.gy[i], lanes.gz[i]}))
                lanes.search[kept++] = lanes.search[i];
        count = kept;
    }
    return unresolved;
}

// Sets `position`, `gradient` and `unresolved` of the mesh. Each crossed edge has one vertex.
void find_vertices(const base::Work& work, const implicit::Implicit& implicit, const CrossedCells& cells,
                   const base::Array<CrossedEdge>& edges, double tolerance, SurfaceMesh& mesh) {
    const std::int64_t count = edges.size();
    resize_long(mesh.position, count, work);
    resize_long(mesh.gradient, count, work);
    for (const std::int64_t i : work.over(count)) {
        mesh.position.set(i, 0.5 * (cells.position[edges[i].from] + cells.position[edges[i].to]));
    }
    const base::Array<std::int32_t> order = implicit::order_by_cell(work, implicit, mesh.position);
    std::atomic<std::int64_t> unresolved{0}, done{0};
    implicit.threads(work).for_chunks(count, implicit::batch_size, [&](std::int64_t begin, std::int64_t end) {
        base::OwnedObject<RootLanes> lanes(work.memory);
        unresolved +=
            find_some_vertices(implicit, cells, edges, order.data(), begin, end, tolerance, *lanes, mesh, work);
        work.update(static_cast<double>(done += end - begin) / static_cast<double>(count));
    });
    mesh.unresolved = unresolved;
}

// ---- Triangles

// Adds the triangles of all cells. Quadrilaterals are divided along the shorter diagonal.
void add_triangles(const CrossedCells& cells, const base::Array<std::int32_t>& numbers, SurfaceMesh& mesh,
                   const base::Progress& progress) {
    mesh.corner.reserve(3 * cells.triangles);
    for (const std::int64_t i : progress.over(cells.cell.size())) {
        const CrossedCell& cell = cells.cell[i];
        cells.sections_of(cell, [&](const Tetrahedron& tetrahedron, const Section& section) {
            std::array<std::int32_t, 4> v{};
            for (std::size_t k = 0; k < section.size; ++k)
                v[k] = numbers[edge_number(cell, tetrahedron, section.edge[k])] - 1;
            const auto add = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
                mesh.corner.push_back(a);
                mesh.corner.push_back(tetrahedron.even ? b : c);
                mesh.corner.push_back(tetrahedron.even ? c : b);
            };
            const auto length = [&](std::int32_t a, std::int32_t b) {
                return glm::distance(mesh.position[a], mesh.position[b]);
            };
            if (section.size == 3) return add(v[0], v[1], v[2]);
            const std::size_t first = length(v[0], v[2]) <= length(v[1], v[3]) ? 0 : 1;
            add(v[first], v[first + 1], v[first + 2]);
            add(v[first], v[first + 2], v[(first + 3) % 4]);
        });
    }
    HRBFNPR_ASSERT(mesh.triangles() == cells.triangles);
}

// Returns the number of i in [0, total) for which holds(i) is true.
template <class Holds>
std::int64_t count_all(const base::Work& work, std::int64_t total, Holds&& holds) {
    std::atomic<std::int64_t> sum{0};
    work.for_chunks(total, 1024, [&](std::int64_t begin, std::int64_t end) {
        std::int64_t here = 0;
        for (std::int64_t i = begin; i < end; ++i) here += holds(i) ? 1 : 0;
        sum += here;
    });
    return sum;
}

std::int64_t count_missed(const base::Work& work, const surface::Projection& seeds, const SurfaceMesh& mesh) {
    const double reach = curve_tuning.vertex_reach * mesh.side;
    const geometry::PointGrid grid(mesh.position, reach, work);
    return count_all(work, seeds.position.size(), [&](std::int64_t i) {
        bool found = false;
        grid.around(seeds.position[i], [&](std::int64_t at) {
            const std::int64_t v = grid.index(at);
            found = found || (glm::dot(mesh.gradient[v], seeds.gradient[i]) > 0.0 &&
                              glm::distance(mesh.position[v], seeds.position[i]) <= reach);
        });
        return !found;
    });
}

} // namespace

std::int64_t SurfaceMesh::bytes() const noexcept {
    return position.bytes() + gradient.bytes() + corner.bytes() + neighbour.bytes();
}

bool is_turned(const SurfaceMesh& mesh, std::int64_t triangle) noexcept {
    const std::array<glm::dvec3, 3> p = corners_of(mesh, triangle);
    const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    for (std::int64_t k = 0; k < 3; ++k)
        if (glm::dot(mesh.gradient[mesh.corner[3 * triangle + k]], normal) < 0.0) return true;
    return false;
}

SurfaceMesh triangulate(const base::Work& work, const implicit::Implicit& implicit, const geometry::VecArray& seeds,
                        const MeshSettings& settings) {
    const Lattice lattice = lattice_of(settings);
    SurfaceMesh mesh(work.memory);
    mesh.region = settings.region;
    mesh.side = lattice.longest();
    const surface::Projection on = seeds_on_surface(work.part(0.0, 0.05), implicit, seeds, settings);
    CrossedCells cells = find_crossed_cells(work.part(0.05, 0.3), implicit, on.position, lattice, settings);
    clear_corners(work.part(0.3, 0.4), implicit, cells);
    base::Array<CrossedEdge> edges(work.memory);
    const base::Array<std::int32_t> numbers = number_edges(cells, edges, work);
    find_vertices(work.part(0.4, 0.9), implicit, cells, edges, settings.tolerance * implicit.diagonal(), mesh);
    add_triangles(cells, numbers, mesh, work);
    mesh.neighbour = find_neighbours(work, mesh.corner, mesh.vertices());
    mesh.missed_seeds = count_missed(work, on, mesh);
    mesh.turned = count_all(work, mesh.triangles(), [&](std::int64_t t) { return is_turned(mesh, t); });
    work.update(1.0);
    return mesh;
}

SurfaceMesh triangulate_of_any_size(const base::Work& work, const implicit::Implicit& implicit,
                                    const geometry::VecArray& seeds, MeshSettings& settings) {
    while (true) {
        try {
            return triangulate(work, implicit, seeds, settings);
        } catch (const Error& error) {
            if (error.status() != Status::invalid_argument || settings.side > implicit.diagonal()) throw;
            settings.side *= 2.0;
        }
    }
}

} // namespace hrbfnpr::curves
