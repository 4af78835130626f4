// SPDX-License-Identifier: MIT
#include "mesh/pieces/cells.h"

#include "mesh/pieces/box_faces.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace hrbfnpr::mesh {
namespace {

using implicit::PiecesData;

constexpr double root_side = 1.02 * PiecesData::reach; // diagonals
constexpr double reach = PiecesData::cell_reach;
constexpr std::int32_t least_level = 4;       // of cells with surface, ...
constexpr std::int32_t least_plain_level = 3; // ... and without
constexpr std::int32_t most_level = 9;
constexpr std::int64_t most_cells = 60'000;
constexpr double near = 2e-4;      // diagonals: how near to the surface signs may be wrong
constexpr double plain_fall = 0.8; // of its value, that a plain cell's function falls by in the cell at most

struct Node {
    glm::dvec3 centre;
    double half;
    std::int64_t parent; // its place in the lists of faces
};

// What was found of a node.
struct Found {
    bool split = false;
    bool poor = false;
    bool surface = false;
    std::int32_t size = 0;
    std::int32_t program[2 * ReadOnceTrees::most];
    double plain[4] = {};
};

class Builder {
public:
    using Faces = base::Array<std::int32_t>;

    Builder(const base::Runtime& runtime, const Mesh& mesh, const Creases& creases, const Sides& sides,
            const base::Array<double>& chord, std::uint64_t seed, PiecesData& data, const base::Progress& progress)
        : runtime_(runtime), mesh_(mesh), creases_(creases), sides_(sides), data_(data), progress_(progress),
          trees_(runtime.memory), near_(near * mesh.bounds.diagonal()),
          tests_(mesh, sides, creases.patch, chord, trees_, near_, seed), nodes_(runtime.memory),
          found_(runtime.memory), faces_(runtime.memory) {}

    [[nodiscard]] CellsReport run() {
        data_.bounds = mesh_.bounds;
        data_.side = root_side * mesh_.bounds.diagonal();
        data_.corner = mesh_.bounds.centre() - 0.5 * data_.side;
        const double half = 0.5 * data_.side;
        nodes_.push_back({mesh_.bounds.centre(), half, 0});
        base::List<Faces> above(runtime_.memory);
        Faces& all = above.add(runtime_.memory);
        for (std::int64_t face = 0; face < mesh_.faces(); ++face) all.push_back(static_cast<std::int32_t>(face));
        for (level_ = 0; !nodes_.empty(); ++level_) {
            look_at_level(above);
            next_level();
            above = std::move(faces_);
            faces_ = base::List<Faces>(runtime_.memory);
            progress_.update(static_cast<double>(level_ + 1) / (most_level + 1));
        }
        if (!sides_.solid()) continue_surface();
        report_.cells = data_.leaves();
        return report_;
    }

private:
    void look_at_level(const base::List<Faces>& above) {
        const std::int64_t count = nodes_.size();
        found_.resize(count);
        for (std::int64_t i = 0; i < count; ++i) faces_.add(runtime_.memory);
        runtime_.parallel.for_each(count, [&](std::int64_t i) {
            progress_.check();
            const Node& node = nodes_[i];
            faces_in_box({node.centre, reach * node.half}, mesh_, above[node.parent], faces_[i]);
            found_[i] = look_at(node, faces_[i], cell_number(i));
        });
    }

    [[nodiscard]] std::uint64_t cell_number(std::int64_t i) const noexcept {
        return (static_cast<std::uint64_t>(level_) << 32U) + static_cast<std::uint64_t>(i);
    }

    [[nodiscard]] bool may_split() const noexcept {
        return level_ < most_level && data_.child.size() + 8 * nodes_.size() < most_cells;
    }

    [[nodiscard]] Found look_at(const Node& node, const Faces& faces, std::uint64_t number) const {
        Found found;
        if (faces.empty()) {
            found.split = level_ < least_plain_level;
            if (!found.split) make_plain(node, found);
            return found;
        }
        found.surface = true;
        found.split = level_ < least_level;
        if (found.split) return found;
        Faces patches(runtime_.memory);
        gather_patches(node, faces, patches);
        if (patches.size() > ReadOnceTrees::most && may_split()) {
            found.split = true;
            return found;
        }
        patches.resize(std::min<std::int64_t>(patches.size(), ReadOnceTrees::most));
        const CellTests::Choice choice =
            tests_.choose(runtime_.instruction_set, runtime_.memory, data_.sheet, patches.span(), faces.span(),
                          {node.centre, reach * node.half}, number);
        if (choice.side != 0.0) { // faces that meet the box, but not here, or inside another part
            found.plain[0] = 0.5 * choice.side * node.half;
            // Not by a gradient of 0: whoever asks for a direction gets one.
            const glm::dvec3 along = 0.1 * choice.side * sides_.normal(faces[0]);
            for (int c = 0; c < 3; ++c) found.plain[1 + c] = along[c];
            return found;
        }
        found.split = choice.wrong > 0 && may_split();
        found.poor = choice.wrong > 0;
        for (const std::int32_t code : trees_.program(static_cast<std::int32_t>(patches.size()), choice.tree))
            found.program[found.size++] = code >= 0 ? patches[code] : code;
        return found;
    }

    // Nearest first, where there are too many; else rising.
    void gather_patches(const Node& node, const Faces& faces, Faces& patches) const {
        for (const std::int32_t face : faces) {
            const std::int32_t patch = creases_.patch[face];
            if (std::find(patches.begin(), patches.end(), patch) == patches.end()) patches.push_back(patch);
        }
        std::sort(patches.begin(), patches.end());
        if (patches.size() <= ReadOnceTrees::most || may_split()) return;
        base::Array<double> distance(runtime_.memory);
        for (const std::int32_t patch : patches) {
            double least = std::numeric_limits<double>::infinity();
            for (const std::int32_t face : faces)
                if (creases_.patch[face] == patch)
                    least = std::min(least, distance_to(node.centre, mesh_.corners(face)));
            distance.push_back(least);
        }
        Faces order(runtime_.memory);
        for (std::int32_t i = 0; i < patches.size(); ++i) order.push_back(i);
        std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
            return distance[a] < distance[b] || (distance[a] == distance[b] && a < b);
        });
        for (std::int32_t& i : order) i = patches[i];
        patches = std::move(order);
    }

    // As far from 0 as the surface is away, in the middle, and of its sign in all of the cell.
    void make_plain(const Node& node, Found& found) const noexcept {
        const Beside beside = sides_.beside(node.centre);
        const glm::dvec3 off = node.centre - beside.place;
        const double distance = glm::length(off);
        const double far = std::sqrt(3.0) * reach * node.half;
        const double slope = std::min(1.0, plain_fall * distance / far);
        const glm::dvec3 gradient = distance > 0.0 ? (slope / beside.distance) * off : glm::dvec3(0.0);
        found.plain[0] = beside.distance;
        for (int c = 0; c < 3; ++c) found.plain[1 + c] = gradient[c];
    }

    void next_level() {
        const std::int64_t first = data_.child.size() + nodes_.size();
        std::int64_t split = 0;
        base::Array<Node> next(runtime_.memory);
        for (std::int64_t i = 0; i < nodes_.size(); ++i) {
            const Found& found = found_[i];
            if (found.split) {
                data_.child.push_back(static_cast<std::int32_t>(first + 8 * split++));
                const double q = 0.5 * nodes_[i].half;
                for (std::int32_t k = 0; k < 8; ++k)
                    next.push_back({nodes_[i].centre +
                                        glm::dvec3((k & 1) != 0 ? q : -q, (k & 2) != 0 ? q : -q, (k & 4) != 0 ? q : -q),
                                    q, i});
                continue;
            }
            data_.child.push_back(-1 - static_cast<std::int32_t>(data_.program_begin.size()));
            data_.program_begin.push_back(static_cast<std::int32_t>(data_.program.size()));
            for (std::int32_t k = 0; k < found.size; ++k) data_.program.push_back(found.program[k]);
            for (const double number : found.plain) data_.plain.push_back(number);
            report_.surface_cells += found.surface ? 1 : 0;
            report_.poor_cells += found.poor ? 1 : 0;
            centres_.push_back(nodes_[i].centre);
        }
        nodes_ = std::move(next);
        if (nodes_.empty()) data_.program_begin.push_back(static_cast<std::int32_t>(data_.program.size()));
    }

    const base::Runtime& runtime_;
    const Mesh& mesh_;
    const Creases& creases_;
    const Sides& sides_;
    PiecesData& data_;
    const base::Progress& progress_;
    const ReadOnceTrees trees_;
    const double near_;
    const CellTests tests_;
    std::int32_t level_ = 0;
    base::Array<Node> nodes_; // of this level
    base::Array<Found> found_;
    base::List<Faces> faces_;                     // in the box of each
    geometry::VecArray centres_{runtime_.memory}; // of the leaves
    CellsReport report_;

    // Where neither side is all of space, a cell without surface has what the nearest one with surface has: beyond its
    // borders the surface goes on as it comes.
    void continue_surface() {
        base::Array<std::int32_t> from(runtime_.memory, data_.leaves());
        runtime_.parallel.for_chunks(data_.leaves(), 64, [&](std::int64_t begin, std::int64_t end) {
            progress_.check();
            for (std::int64_t leaf = begin; leaf < end; ++leaf) {
                const bool has_surface = data_.program_begin[leaf] < data_.program_begin[leaf + 1];
                from[leaf] =
                    has_surface ? static_cast<std::int32_t>(leaf) : data_.leaf_at(sides_.beside(centres_[leaf]).place);
            }
        });
        base::Array<std::int32_t> begin(runtime_.memory);
        base::Array<std::int32_t> program(runtime_.memory);
        for (const std::int32_t leaf : from) {
            begin.push_back(static_cast<std::int32_t>(program.size()));
            for (std::int32_t at = data_.program_begin[leaf]; at < data_.program_begin[leaf + 1]; ++at)
                program.push_back(data_.program[at]);
        }
        begin.push_back(static_cast<std::int32_t>(program.size()));
        data_.program_begin = std::move(begin);
        data_.program = std::move(program);
    }
};

} // namespace

CellsReport make_cells(const base::Runtime& runtime, const Mesh& mesh, const Creases& creases, const Sides& sides,
                       const base::Array<double>& chord, std::uint64_t seed, PiecesData& data,
                       const base::Progress& progress) {
    return Builder(runtime, mesh, creases, sides, chord, seed, data, progress).run();
}

} // namespace hrbfnpr::mesh
