// SPDX-License-Identifier: MIT
#include "implicit/local_field.h"

#include "base/long_array.h"

#include "implicit/cube_loops.h"
#include "implicit/cube_shift.h"
#include "implicit/cube_vectors.h"
#include "implicit/mirrored_basis.h"
#include "implicit/mirrored_sums.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace hrbfnpr::implicit {
namespace {

// A centre is part of a cube's polynomial only if at least this many cubes lie between the cube and the cube of the
// centre. With one cube between them, the same accuracy needs twice the degree.
constexpr int separation = 2;

// By default, a cube is divided if it has more near centres than most_near() returns. At that number, summing the near
// centres takes slightly more time than evaluating the polynomial. A lower number would not pay, because dividing takes
// time, too. With at least `many_centres` centres the number is higher, because making the cubes then takes longer than
// evaluating a million points.
constexpr std::int64_t many_centres = 16384;
[[nodiscard]] std::int64_t most_near(std::int64_t centres) noexcept { return centres < many_centres ? 250 : 500; }
// A child of a cube is made if there is a centre within this distance of the child's middle, in half widths of the
// child.
constexpr double beside = 1.4;
// A node of the tree acts on a cube directly, centre by centre, if it has fewer centres than this share of the cube's
// number of interpolation nodes. Then a translation would take more time.
constexpr double worth_a_node = 0.1;
// A cube of the tree of centres with at most this many centres is not divided.
constexpr std::int64_t sources_in_leaf = 24;
// The margin around the centres, as a share of their width. It is needed because a surface bulges beyond its samples.
constexpr double margin = 0.2;

constexpr std::int64_t cells_a_task = 32; // number of cells that a task handles
// The number of cells in a task of a translation. These cells share the elements of the translation's matrix.
constexpr std::int64_t translate_cells = 1024;
constexpr std::int64_t local_tasks = 24;

// Returns the root mean square of the weights. For weights of a smooth function, the error of the sums is proportional
// to it.
[[nodiscard]] double root_mean_square(const double* alpha, const geometry::VecArray& beta) noexcept {
    double sum = 0.0;
    for (std::int64_t i = 0; i < beta.size(); ++i) sum += alpha[i] * alpha[i] + glm::dot(beta[i], beta[i]);
    return std::sqrt(sum / static_cast<double>(std::max<std::int64_t>(1, beta.size())));
}

// Returns the tolerance from which the degrees are chosen. The degrees in source_tree.cpp are chosen for weights with a
// root mean square of 0.2, as on a rough surface. Smaller weights need lower degrees. The exponent was found by
// experiments with fits of 512 to 65 536 samples.
[[nodiscard]] double tolerance_of(const LocalFieldOptions& options, double weight) noexcept {
    return options.tolerance * std::pow(0.2 / std::max(1e-6, weight), 0.7);
}

} // namespace

// Makes the cells level by level.
class LocalField::Builder {
public:
    Builder(const base::Runtime& runtime, LocalField& field, const LocalFieldOptions& options)
        : runtime_(runtime), field_(field), tree_(field.sources_.tree()), loops_(cube_loops(runtime.instruction_set)),
          add_sums_(mirrored_sums(runtime.instruction_set)),
          translates_(tree_.points().size() >= options.worth_translations),
          most_near_(options.most_near > 0 ? options.most_near : most_near(tree_.points().size())),
          candidate_begin_(runtime.memory), candidates_(runtime.memory), kind_(runtime.memory),
          incoming_(runtime.memory) {}

    void run(const base::Progress& progress) {
        if (translates_) field_.sources_.gather(progress);
        field_.cells_.push_back({{0, 0, 0}, 0, 0, 0, 0, 0, -1});
        candidate_begin_.push_back(0);
        candidates_.push_back(0);
        candidate_begin_.push_back(1);
        for (std::int32_t level = 0; begin_ < field_.cells_.size(); ++level) {
            progress.check();
            end_ = field_.cells_.size();
            classify(progress);
            if (SourceTree::has_expansions(level)) {
                place_terms(level, progress);
                if (translates_)
                    make_terms_by_nodes(level, progress);
                else
                    make_terms(level, progress);
                if (SourceTree::has_expansions(level - 1)) pass_down(level, progress);
            }
            divide(level, progress);
            above_begin_ = begin_;
            begin_ = end_;
        }
    }

private:
    enum Kind : std::uint8_t { near, translated, direct };

    [[nodiscard]] static bool too_near(const Cell& cell, const geometry::Octree::Node& node) noexcept {
        const int shift = cell.level - node.level;
        for (std::size_t c = 0; c < 3; ++c)
            if (cell.cell[c] < (node.cell[c] << shift) - separation ||
                cell.cell[c] >= ((node.cell[c] + 1) << shift) + separation)
                return false;
        return true;
    }

    [[nodiscard]] Kind kind_of(const Cell& cell, const geometry::Octree::Node& node) const noexcept {
        if (too_near(cell, node)) return near;
        if (!translates_ || node.leaf()) return direct;
        const double few = worth_a_node * field_.sources_.basis(cell.level).size();
        return static_cast<double>(node.count()) < few ? direct : translated;
    }

    void classify(const base::Progress& progress) {
        base::resize_long(kind_, candidates_.size(), progress);
        runtime_.parallel.for_chunks(end_ - begin_, 256, progress, [&](std::int64_t first, std::int64_t last) {
            for (std::int64_t k = first; k < last; ++k)
                for (std::int64_t i = candidate_begin_[k]; i < candidate_begin_[k + 1]; ++i)
                    kind_[i] = kind_of(field_.cells_[begin_ + k], tree_.nodes()[candidates_[i]]);
        });
    }

    // Adds the polynomials of the level above to the polynomials of its children.
    void pass_down(std::int32_t level, const base::Progress& progress) {
        const CubeShift shift(field_.sources_.degree(level - 1), field_.sources_.degree(level));
        runtime_.parallel.for_chunks(
            begin_ - above_begin_, cells_a_task, progress, [&](std::int64_t first, std::int64_t last) {
                base::OwnedObject<CubeShift::Work> work(runtime_.memory);
                for (std::int64_t k = first; k < last; ++k) {
                    const Cell& parent = field_.cells_[above_begin_ + k];
                    for (int octant = 0; octant < 8; ++octant)
                        if (parent.has_child(octant))
                            shift.add(field_.terms_.data() + parent.terms, octant,
                                      field_.terms_.data() + field_.cells_[parent.child(octant)].terms, *work);
                }
            });
    }

    // Returns pairs of a cell in [first, last) of the level and a node that acts on it by translation. Pairs with the
    // same offset are consecutive.
    [[nodiscard]] base::Array<SourceTree::Pair> pairs_of(std::int64_t first, std::int64_t last) const {
        base::Array<SourceTree::Pair> pairs(runtime_.memory);
        for (std::int64_t k = first; k < last; ++k)
            for (std::int64_t i = candidate_begin_[k]; i < candidate_begin_[k + 1]; ++i) {
                if (kind_[i] != translated) continue;
                const std::int64_t node = candidates_[i];
                pairs.push_back({SourceTree::direction(field_.cells_[begin_ + k].cell, tree_.nodes()[node].cell),
                                 static_cast<std::int32_t>(node), static_cast<std::int32_t>(k)});
            }
        std::sort(pairs.begin(), pairs.end(), [](const SourceTree::Pair& a, const SourceTree::Pair& b) {
            return a.direction != b.direction ? a.direction < b.direction : a.target < b.target;
        });
        return pairs;
    }

    // A task handles a group of cells and a part of their nodes, so that there are enough tasks and all are short.
    void translate(std::int32_t level, const base::Progress& progress) {
        const std::int64_t rows = field_.sources_.basis(level).stride();
        for (std::int64_t first = 0; first < end_ - begin_; first += translate_cells) {
            progress.check();
            const base::Array<SourceTree::Pair> pairs =
                pairs_of(first, std::min(end_ - begin_, first + translate_cells));
            const std::int64_t parts = std::min(local_tasks, rows / 8);
            runtime_.parallel.for_each(parts, progress, [&](std::int64_t part) {
                field_.sources_.translate(level, pairs.span(), static_cast<int>(part * (rows / 8) / parts * 8),
                                          static_cast<int>((part + 1) * (rows / 8) / parts * 8), incoming_.data(),
                                          progress);
            });
        }
    }

    // Some tree nodes act on a cell directly, because they have few centres. Adds the sums over these centres to the
    // values at the cell's interpolation nodes.
    void add_direct_nodes(std::int32_t level, const base::Progress& progress) {
        const CubeBasis& basis = field_.sources_.basis(level);
        const double half = tree_.half_width(level);
        const AddTriharmonicValues add = triharmonic_values_of(runtime_.instruction_set);
        runtime_.parallel.for_chunks(end_ - begin_, cells_a_task, [&](std::int64_t first, std::int64_t last) {
            geometry::VecArray place(runtime_.memory, basis.size());
            for (std::int64_t k = first; k < last; ++k) {
                const glm::dvec3 centre = field_.centre(field_.cells_[begin_ + k]);
                for (std::int64_t i = 0; i < basis.size(); ++i) place.set(i, centre + half * basis.nodes()[i]);
                for (std::int64_t i = candidate_begin_[k]; i < candidate_begin_[k + 1];) {
                    progress.check();
                    const SourceRange range = direct_range(i, candidate_begin_[k + 1]);
                    if (range.begin < range.end)
                        add(field_.sources_.sources(range.begin, range.end), place.x.data(), place.y.data(),
                            place.z.data(), incoming_.data() + k * basis.stride(), basis.size());
                }
            }
        });
    }

    // Returns one range of centres, for consecutive candidates that act directly. The range ends when the centres of
    // the next such candidate do not follow the centres before. Sets `i` to the index of that candidate, or to `end`.
    [[nodiscard]] SourceRange direct_range(std::int64_t& i, std::int64_t end) const noexcept {
        SourceRange range{0, 0};
        for (; i < end; ++i) {
            if (kind_[i] != direct) continue;
            const geometry::Octree::Node& node = tree_.nodes()[candidates_[i]];
            if (range.begin < range.end && node.begin != range.end) break;
            if (range.begin == range.end) range.begin = node.begin;
            range.end = node.end;
        }
        return range;
    }

    // Gives children to cells. The candidates of a child are the tree nodes near the cell. A cell that has places
    // outside its children keeps its near centres.
    void divide(std::int32_t level, const base::Progress& progress) {
        base::Array<std::int64_t> next_begin(runtime_.memory);
        base::Array<std::int64_t> next(runtime_.memory);
        next_begin.push_back(0);
        for (const std::int64_t k : progress.over(end_ - begin_)) {
            if (level + 1 < tree_.levels() && near_centres(k) > most_near_) add_children(k, next_begin, next, progress);
            if (field_.cells_[begin_ + k].serves()) keep_near(k, progress);
        }
        std::swap(candidate_begin_, next_begin);
        std::swap(candidates_, next);
    }

    [[nodiscard]] std::int64_t near_centres(std::int64_t k) const noexcept {
        std::int64_t count = 0;
        for (std::int64_t i = candidate_begin_[k]; i < candidate_begin_[k + 1]; ++i)
            if (kind_[i] == near) count += tree_.nodes()[candidates_[i]].count();
        return count;
    }

    // Returns whether a child cell is needed: whether centres lie in the child or just beside it. Other places are
    // seldom evaluated.
    [[nodiscard]] bool is_wanted(std::int64_t parent, const Cell& cell) const noexcept {
        const glm::dvec3 middle = field_.centre(cell);
        const double reach = beside * tree_.half_width(cell.level);
        for (std::int64_t i = candidate_begin_[parent]; i < candidate_begin_[parent + 1]; ++i) {
            if (kind_[i] != near) continue;
            const geometry::Octree::Node& node = tree_.nodes()[candidates_[i]];
            const glm::dvec3 apart = glm::abs(tree_.centre(node) - middle) - tree_.half_width(node.level);
            if (std::max({apart.x, apart.y, apart.z}) > reach) continue;
            for (std::int64_t at = node.begin; at < node.end; ++at) {
                const glm::dvec3 off = glm::abs(tree_.points()[at] - middle);
                if (std::max({off.x, off.y, off.z}) <= reach) return true;
            }
        }
        return false;
    }

    void add_children(std::int64_t k, base::Array<std::int64_t>& next_begin, base::Array<std::int64_t>& next,
                      const base::Progress& progress) {
        const Cell parent = field_.cells_[begin_ + k];
        const auto first = static_cast<std::int32_t>(field_.cells_.size());
        std::uint32_t octants = 0;
        for (int octant = 0; octant < 8; ++octant) {
            progress.check(); // this loop may take long, because all centres are near the first cells
            const Cell child{{2 * parent.cell[0] + (octant & 1), 2 * parent.cell[1] + (octant >> 1 & 1),
                              2 * parent.cell[2] + (octant >> 2)},
                             parent.level + 1,
                             0,
                             0,
                             0,
                             0,
                             -1};
            if (!is_wanted(k, child)) continue;
            octants |= 1U << octant;
            field_.cells_.push_back(child);
            add_candidates(k, next, progress);
            next_begin.push_back(next.size());
        }
        field_.cells_[begin_ + k].first_child = first;
        field_.cells_[begin_ + k].octants = octants;
    }

    // Adds the tree nodes near a cell as candidates of its child: nodes of the child's level, and larger nodes without
    // children.
    void add_candidates(std::int64_t parent, base::Array<std::int64_t>& next, const base::Progress& progress) const {
        for (std::int64_t i = candidate_begin_[parent]; i < candidate_begin_[parent + 1]; ++i) {
            if (kind_[i] != near) continue;
            const geometry::Octree::Node& node = tree_.nodes()[candidates_[i]];
            if (node.leaf()) base::push_back_long(next, candidates_[i], progress);
            for (std::int64_t child = 0; child < node.children; ++child)
                base::push_back_long(next, node.first_child + child, progress);
        }
    }

    void keep_near(std::int64_t k, const base::Progress& progress) {
        Cell& cell = field_.cells_[begin_ + k];
        cell.near_begin = field_.near_.size();
        for (std::int64_t i = candidate_begin_[k]; i < candidate_begin_[k + 1]; ++i) {
            if (kind_[i] != near) continue;
            const geometry::Octree::Node& node = tree_.nodes()[candidates_[i]];
            const bool continues =
                field_.near_.size() > cell.near_begin && field_.near_[field_.near_.size() - 1].end == node.begin;
            if (continues)
                field_.near_[field_.near_.size() - 1].end = node.end;
            else
                base::push_back_long(field_.near_, {node.begin, node.end}, progress);
        }
        cell.near_end = field_.near_.size();
    }

    void place_terms(std::int32_t level, const base::Progress& progress) {
        const std::int64_t stride = CubeBasis::padded(CubeBasis::terms(field_.sources_.degree(level)));
        std::int64_t size = field_.terms_.size();
        for (std::int64_t cell = begin_; cell < end_; ++cell, size += stride) field_.cells_[cell].terms = size;
        base::resize_long(field_.terms_, size, progress);
    }

    // Makes the polynomials of the level's cells from the sums over far centres.
    void make_terms(std::int32_t level, const base::Progress& progress) {
        if (basis_ == nullptr || basis_->degree() != field_.sources_.degree(level))
            basis_ = std::make_unique<MirroredBasis>(base::Work(runtime_, progress), field_.sources_.degree(level));
        runtime_.parallel.for_chunks(end_ - begin_, cube_batch, progress, [&](std::int64_t first, std::int64_t last) {
            base::OwnedObject<MirroredSources> sources(runtime_.memory);
            base::Array<double> values(runtime_.memory, basis_->size());
            MirroredBasis::Batch batch(runtime_.memory, *basis_);
            const double half = tree_.half_width(level);
            for (std::int64_t k = first; k < last; ++k) {
                std::fill(values.begin(), values.end(), 0.0);
                add_far_centres(k, *sources, values.data(), progress);
                batch.add(values.data(), half * half * half,
                          field_.terms_.data() + field_.cells_[begin_ + k].terms);
            }
            batch.flush(loops_);
        });
    }

    // Adds the sums over the centres that act on cell k directly.
    void add_far_centres(std::int64_t k, MirroredSources& sources, double* values,
                         const base::Progress& progress) const {
        const Cell& cell = field_.cells_[begin_ + k];
        const glm::dvec3 centre = field_.centre(cell);
        const double middle[3] = {centre.x, centre.y, centre.z};
        const geometry::VecArray& nodes = basis_->nodes();
        const auto add = [&] {
            progress.check();
            add_sums_({nodes.x.data(), nodes.y.data(), nodes.z.data(), nodes.size()}, sources, values);
            sources.count = 0;
        };
        const Sources all = field_.sources_.sources(0, tree_.points().size());
        for (std::int64_t i = candidate_begin_[k]; i < candidate_begin_[k + 1]; ++i) {
            if (kind_[i] != direct) continue;
            const geometry::Octree::Node& node = tree_.nodes()[candidates_[i]];
            for (std::int64_t at = node.begin; at < node.end; ++at) {
                if (sources.count == MirroredSources::most) add();
                sources.add(all, at, middle, tree_.half_width(cell.level));
            }
        }
        add();
    }

    // Makes the polynomials of the level's cells by way of values at the nodes of CubeBasis.
    void make_terms_by_nodes(std::int32_t level, const base::Progress& progress) {
        const CubeBasis& basis = field_.sources_.basis(level);
        incoming_.clear();
        base::resize_long(incoming_,
                          (end_ - begin_) * basis.stride() + CubeBasis::padded(CubeBasis::terms(CubeBasis::degree_max)),
                          progress);
        translate(level, progress);
        add_direct_nodes(level, progress);
        interpolate(basis, progress);
    }

    // Computes the polynomials of the level's cells from the values in incoming_.
    void interpolate(const CubeBasis& basis, const base::Progress& progress) {
        runtime_.parallel.for_chunks(end_ - begin_, 64, progress, [&](std::int64_t first, std::int64_t last) {
            base::Array<double> nobody(runtime_.memory, basis.term_stride());
            CubeVectors batch(runtime_.memory, basis.size());
            for (std::int64_t k = first; k < last; ++k) {
                batch.add(incoming_.data() + k * basis.stride(), basis.size(),
                          field_.terms_.data() + field_.cells_[begin_ + k].terms);
                if (!batch.full() && k + 1 < last) continue;
                progress.check();
                loops_.multiply(basis.to_coefficients().data(), basis.term_stride(), basis.term_stride(), basis.size(),
                                batch.in(), batch.out(nobody.data()), batch.count());
                batch.clear();
            }
        });
    }

    const base::Runtime& runtime_;
    LocalField& field_;
    const geometry::Octree& tree_;
    CubeLoops loops_;
    AddMirroredSums add_sums_;
    bool translates_;
    std::int64_t most_near_;
    std::unique_ptr<MirroredBasis> basis_;      // of the level, unless cells are translated
    std::int64_t above_begin_ = 0;              // index of the first cell of the level above
    std::int64_t begin_ = 0;                    // index of the first cell of this level
    std::int64_t end_ = 0;                      // end of this level
    base::Array<std::int64_t> candidate_begin_; // for each cell of the level, the index of its first candidate
    base::Array<std::int64_t> candidates_;      // the tree nodes that may act on a cell; its parent cell chooses them
    base::Array<Kind> kind_;                    // how each candidate acts on the cell
    base::Array<double> incoming_; // for each cell of the level, the sum at its nodes over the centres that act on it
};

LocalField::LocalField(const base::Work& work, const geometry::VecArray& centres, const double* alpha,
                       const geometry::VecArray& beta, const LocalFieldOptions& options)
    : set_(work.instruction_set), sources_(work, centres,
                                           {options.spacing, options.finer, sources_in_leaf,
                                            tolerance_of(options, root_mean_square(alpha, beta)), separation, margin,
                                            centres.size() >= options.worth_translations}),
      cells_(work.memory), near_(work.memory), terms_(work.memory) {
    sources_.load(alpha, beta, work);
    Builder(work, *this, options).run(work);
    sources_.forget_expansions();
}

glm::dvec3 LocalField::centre(const Cell& cell) const noexcept {
    const double half = sources_.tree().half_width(cell.level);
    return sources_.tree().corner() +
           half * glm::dvec3(2 * cell.cell[0] + 1, 2 * cell.cell[1] + 1, 2 * cell.cell[2] + 1);
}

std::int32_t LocalField::cube_of(const glm::dvec3& point) const noexcept {
    constexpr int digits = geometry::Octree::deepest_level;
    const double scale = 0.5 * static_cast<double>(1 << digits) / sources_.tree().half_width(0);
    const glm::dvec3 place = (point - sources_.tree().corner()) * scale;
    constexpr double last = static_cast<double>(1 << digits);
    for (glm::length_t c = 0; c < 3; ++c)
        if (!(place[c] >= 0.0 && place[c] < last)) return -1;
    const std::array<std::uint32_t, 3> cell{static_cast<std::uint32_t>(place.x), static_cast<std::uint32_t>(place.y),
                                            static_cast<std::uint32_t>(place.z)};
    std::int32_t at = 0;
    for (int bit = digits - 1; cells_[at].octants != 0; --bit) {
        const auto octant =
            static_cast<int>((cell[0] >> bit & 1) | (cell[1] >> bit & 1) << 1 | (cell[2] >> bit & 1) << 2);
        if (!cells_[at].has_child(octant)) break;
        at = cells_[at].child(octant);
    }
    return at;
}

CubeSamples LocalField::samples(const Cell& cell, const double* x, const double* y, const double* z,
                                std::int64_t count) const noexcept {
    const glm::dvec3 middle = centre(cell);
    return {x, y, z, count, {middle.x, middle.y, middle.z}, sources_.tree().half_width(cell.level)};
}

void LocalField::add(std::int32_t cube, const Targets& t) const noexcept {
    const Cell& cell = cells_[cube];
    const AddHermiteSums add_sums = hermite_sums(set_, kernel::Kind::triharmonic);
    for (std::int64_t k = cell.near_begin; k < cell.near_end; ++k)
        add_sums(0.0, sources_.sources(near_[k].begin, near_[k].end), t);
    if (cell.terms < 0) return;
    double* const gradient[3] = {t.gradient_x, t.gradient_y, t.gradient_z};
    cube_loops(set_).evaluate(sources_.degree(cell.level), terms_.data() + cell.terms,
                              samples(cell, t.x, t.y, t.z, t.count), t.value, gradient);
}

void LocalField::add_jets(std::int32_t cube, const JetTargets& t) const noexcept {
    const Cell& cell = cells_[cube];
    triharmonic_jets_of(set_)(sources_.sources(0, sources_.tree().points().size()), near_.data() + cell.near_begin,
                              cell.near_end - cell.near_begin, t);
    if (cell.terms < 0) return;
    const CubeLoops loops = cube_loops(set_);
    const int degree = sources_.degree(cell.level);
    const CubeSamples at = samples(cell, t.x, t.y, t.z, t.count);
    loops.evaluate(degree, terms_.data() + cell.terms, at, t.value, t.gradient);
    loops.hessian(degree, terms_.data() + cell.terms, at, t.hessian);
}

std::int64_t LocalField::bytes() const noexcept {
    return sources_.bytes() + cells_.bytes() + near_.bytes() + terms_.bytes();
}

} // namespace hrbfnpr::implicit
