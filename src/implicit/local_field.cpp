// SPDX-License-Identifier: MIT
#include "implicit/local_field.h"

#include "base/long_array.h"

#include "implicit/cube_loops.h"
#include "implicit/cube_shift.h"
#include "implicit/mirrored_basis.h"
#include "implicit/mirrored_sums.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace hrbfnpr::implicit {
namespace {

// A centre is part of a cube's polynomial only if at least this many cubes lie between the cube and the cube of the
// centre. With one cube between them, the same accuracy needs twice the degree.
constexpr int separation = 2;

// From this degree on, the polynomial of centres with at least three cubes between has a degree that is lower by 2. It
// is then as accurate as that of centres with two cubes between. Smaller: faster, but less accurate.
constexpr int high_degree = 15;

// By default, a cube is divided if it has more near centres than most_near() returns. At that number, summing the near
// centres takes three times as long as evaluating the polynomial, and dividing the cube pays from about 300 points in
// it. With at least `many_centres` centres the number is higher, because making the cubes then takes longer than
// evaluating a million points.
constexpr std::int64_t many_centres = 16384;
[[nodiscard]] std::int64_t most_near(std::int64_t centres) noexcept { return centres < many_centres ? 180 : 500; }
// A child of a cube is made if there is a centre within this distance of the child's middle, in half widths of the
// child.
constexpr double beside = 1.2;
// A cube of the tree of centres with at most this many centres is not divided. Cubes of places are at most as small as
// the smallest cubes of the tree, so a larger number leaves more near centres than most_near() allows. A smaller number
// makes near ranges shorter, and making cubes slower.
constexpr std::int64_t sources_in_leaf = 8;
// The margin around the centres, as a share of their width. It is needed because a surface bulges beyond its samples.
constexpr double margin = 0.2;

constexpr std::int64_t cells_a_task = 32; // number of cells that a task handles

// Returns the root mean square of the weights. For weights of a smooth function, the error of the sums is proportional
// to it.
[[nodiscard]] double root_mean_square(const double* alpha, const geometry::VecArray& beta) noexcept {
    double sum = 0.0;
    for (std::int64_t i = 0; i < beta.size(); ++i) sum += alpha[i] * alpha[i] + glm::dot(beta[i], beta[i]);
    return std::sqrt(sum / static_cast<double>(std::max<std::int64_t>(1, beta.size())));
}

// Returns the tolerance from which the degrees are chosen. The degrees below are chosen for weights with a root
// mean square of 0.2, as on a rough surface. Smaller weights need lower degrees. The exponent was found by
// experiments with fits of 512 to 65 536 samples.
[[nodiscard]] double tolerance_of(const LocalFieldOptions& options, double weight) noexcept {
    return options.tolerance * std::pow(0.2 / std::max(1e-6, weight), 0.7);
}

// Returns whether cells of this level have polynomials. On the first two levels all cubes touch each other.
[[nodiscard]] bool has_polynomials(std::int32_t level) noexcept { return level >= 2; }

// Returns the degree of the polynomials of cells with this width, in units of the spacing. With two cubes between a
// source and a target, the error is about 5.5^-degree times width^3.4. Between its terms for values and gradients that
// is the growth of sums over sources of random weights on a surface. The constants were found by experiments with fits
// of 600 to 12 000 samples: no level causes most of the error. Degrees are odd numbers, as MirroredBasis needs them.
[[nodiscard]] int degree_for(double width, double tolerance, int finer) noexcept {
    const double degree = 12.1 + std::log(1e-9 / tolerance) / std::log(5.5) + 1.4 * std::log2(std::max(1.0, width));
    return std::clamp(2 * (static_cast<int>(std::ceil(0.5 * degree)) + finer) - 1, MirroredBasis::degree_min,
                      MirroredBasis::degree_max);
}

} // namespace

// Makes the cells level by level.
class LocalField::Builder {
public:
    Builder(const base::Runtime& runtime, LocalField& field, const LocalFieldOptions& options)
        : runtime_(runtime), field_(field), tree_(field.tree_), loops_(cube_loops(runtime.instruction_set)),
          add_sums_(mirrored_sums(runtime.instruction_set)),
          most_near_(options.most_near > 0 ? options.most_near : most_near(tree_.points().size())),
          candidate_begin_(runtime.memory), candidates_(runtime.memory), kind_(runtime.memory) {}

    void run(const base::Progress& progress) {
        field_.cells_.push_back({{0, 0, 0}, 0, 0, 0, 0, 0, -1});
        candidate_begin_.push_back(0);
        candidates_.push_back(0);
        candidate_begin_.push_back(1);
        for (std::int32_t level = 0; begin_ < field_.cells_.size(); ++level) {
            progress.check();
            end_ = field_.cells_.size();
            classify(progress);
            if (has_polynomials(level)) {
                place_terms(level, progress);
                make_terms(level, progress);
                if (has_polynomials(level - 1)) pass_down(level, progress);
            }
            divide(level, progress);
            above_begin_ = begin_;
            begin_ = end_;
        }
    }

private:
    // How the centres of a node act on a cell: one by one at each place, or by the cell's polynomial. `farther` centres
    // have at least one more cube between.
    enum Kind : std::uint8_t { near, far, farther };

    // Returns whether fewer than `cubes` cubes of the cell's size lie between the cell and the node.
    [[nodiscard]] static bool too_near(const Cell& cell, const geometry::Octree::Node& node, int cubes) noexcept {
        const int shift = cell.level - node.level;
        for (std::size_t c = 0; c < 3; ++c)
            if (cell.cell[c] < (node.cell[c] << shift) - cubes || cell.cell[c] >= ((node.cell[c] + 1) << shift) + cubes)
                return false;
        return true;
    }

    [[nodiscard]] static Kind kind_of(const Cell& cell, const geometry::Octree::Node& node) noexcept {
        if (too_near(cell, node, separation)) return near;
        return too_near(cell, node, separation + 1) ? far : farther;
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
        const CubeShift shift(field_.degree_[level - 1], field_.degree_[level]);
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
        const std::int64_t stride = CubeBasis::padded(CubeBasis::terms(field_.degree_[level]));
        std::int64_t size = field_.terms_.size();
        for (std::int64_t cell = begin_; cell < end_; ++cell, size += stride) field_.cells_[cell].terms = size;
        base::resize_long(field_.terms_, size, progress);
    }

    // Makes the polynomials of the level's cells from the sums over far centres.
    void make_terms(std::int32_t level, const base::Progress& progress) {
        const int degree = field_.degree_[level];
        add_polynomials(level, far, basis(degree, progress), progress);
        add_polynomials(level, farther, basis(degree < high_degree ? degree : degree - 2, progress), progress);
    }

    [[nodiscard]] const MirroredBasis& basis(int degree, const base::Progress& progress) {
        std::unique_ptr<MirroredBasis>& its = bases_[static_cast<std::size_t>(degree / 2)];
        if (its == nullptr) its = std::make_unique<MirroredBasis>(base::Work(runtime_, progress), degree);
        return *its;
    }

    // Adds the polynomials of the sums over the centres of one kind.
    void add_polynomials(std::int32_t level, Kind kind, const MirroredBasis& basis, const base::Progress& progress) {
        const double half = tree_.half_width(level);
        runtime_.parallel.for_chunks(end_ - begin_, cube_batch, progress, [&](std::int64_t first, std::int64_t last) {
            base::OwnedObject<MirroredSources> sources(runtime_.memory);
            base::Array<double> values(runtime_.memory, basis.size());
            MirroredBasis::Batch batch(runtime_.memory, basis, field_.degree_[level]);
            for (std::int64_t k = first; k < last; ++k) {
                std::fill(values.begin(), values.end(), 0.0);
                add_sums(k, kind, basis.nodes(), *sources, values.data(), progress);
                batch.add(values.data(), half * half * half, field_.terms_.data() + field_.cells_[begin_ + k].terms);
            }
            batch.flush(loops_);
        });
    }

    // Adds the sums over the centres that act on cell k in this way to the values at mirrored nodes.
    void add_sums(std::int64_t k, Kind kind, const geometry::VecArray& nodes, MirroredSources& sources, double* values,
                  const base::Progress& progress) const {
        const Cell& cell = field_.cells_[begin_ + k];
        const glm::dvec3 centre = field_.centre(cell);
        const double middle[3] = {centre.x, centre.y, centre.z};
        const auto add = [&] {
            progress.check();
            add_sums_({nodes.x.data(), nodes.y.data(), nodes.z.data(), nodes.size()}, sources, values);
            sources.count = 0;
        };
        const Sources all = field_.sources(0, tree_.points().size());
        for (std::int64_t i = candidate_begin_[k]; i < candidate_begin_[k + 1]; ++i) {
            if (kind_[i] != kind) continue;
            const geometry::Octree::Node& node = tree_.nodes()[candidates_[i]];
            for (std::int64_t at = node.begin; at < node.end; ++at) {
                if (sources.count == MirroredSources::most) add();
                sources.add(all, at, middle, tree_.half_width(cell.level));
            }
        }
        add();
    }

    const base::Runtime& runtime_;
    LocalField& field_;
    const geometry::Octree& tree_;
    CubeLoops loops_;
    AddMirroredSums add_sums_;
    std::int64_t most_near_;
    // The bases that were needed, at half their degree.
    std::array<std::unique_ptr<MirroredBasis>, MirroredBasis::degree_max / 2 + 1> bases_;
    std::int64_t above_begin_ = 0;              // index of the first cell of the level above
    std::int64_t begin_ = 0;                    // index of the first cell of this level
    std::int64_t end_ = 0;                      // end of this level
    base::Array<std::int64_t> candidate_begin_; // for each cell of the level, the index of its first candidate
    base::Array<std::int64_t> candidates_;      // the tree nodes that may act on a cell; its parent cell chooses them
    base::Array<Kind> kind_;                    // how each candidate acts on the cell
};

LocalField::LocalField(const base::Work& work, const geometry::VecArray& centres, const double* alpha,
                       const geometry::VecArray& beta, const LocalFieldOptions& options)
    : set_(work.instruction_set), tree_(centres, sources_in_leaf, margin, work), alpha_(work.memory, centres.size()),
      beta_(work.memory, centres.size()), degree_(work.memory), cells_(work.memory), near_(work.memory),
      terms_(work.memory), start_(work.memory) {
    load(alpha, beta, work);
    const double tolerance = tolerance_of(options, root_mean_square(alpha, beta));
    for (std::int32_t level = 0; level < tree_.levels(); ++level)
        degree_.push_back(degree_for(tree_.half_width(level) / options.spacing, tolerance, options.finer));
    Builder(work, *this, options).run(work);
    find_starts();
}

void LocalField::load(const double* alpha, const geometry::VecArray& beta, const base::Progress& progress) {
    for (const std::int64_t at : progress.over(tree_.points().size())) {
        alpha_[at] = alpha[tree_.index(at)];
        beta_.set(at, beta[tree_.index(at)]);
    }
}

Sources LocalField::sources(std::int64_t begin, std::int64_t end) const noexcept {
    const geometry::VecArray& p = tree_.points();
    return {p.x.data() + begin,     p.y.data() + begin,     p.z.data() + begin,     alpha_.data() + begin,
            beta_.x.data() + begin, beta_.y.data() + begin, beta_.z.data() + begin, end - begin};
}

void LocalField::find_starts() {
    constexpr std::uint32_t side = 1U << start_level;
    constexpr std::int32_t below = geometry::Octree::deepest_level - start_level;
    start_.resize(std::int64_t{side} * side * side);
    for (std::uint32_t z = 0; z < side; ++z)
        for (std::uint32_t y = 0; y < side; ++y)
            for (std::uint32_t x = 0; x < side; ++x) {
                start_[(std::int64_t{z} * side + y) * side + x] =
                    descend(0, {x << below, y << below, z << below}, start_level);
            }
}

std::int32_t LocalField::descend(std::int32_t from, const std::array<std::uint32_t, 3>& cube,
                                 std::int32_t deepest) const noexcept {
    std::int32_t at = from;
    while (cells_[at].octants != 0 && cells_[at].level < deepest) {
        const int bit = geometry::Octree::deepest_level - 1 - cells_[at].level;
        const auto octant =
            static_cast<int>((cube[0] >> bit & 1) | (cube[1] >> bit & 1) << 1 | (cube[2] >> bit & 1) << 2);
        if (!cells_[at].has_child(octant)) break;
        at = cells_[at].child(octant);
    }
    return at;
}

glm::dvec3 LocalField::centre(const Cell& cell) const noexcept {
    const double half = tree_.half_width(cell.level);
    return tree_.corner() + half * glm::dvec3(2 * cell.cell[0] + 1, 2 * cell.cell[1] + 1, 2 * cell.cell[2] + 1);
}

std::int32_t LocalField::cube_of(const glm::dvec3& point) const noexcept {
    constexpr int digits = geometry::Octree::deepest_level;
    const double scale = 0.5 * static_cast<double>(1 << digits) / tree_.half_width(0);
    const glm::dvec3 place = (point - tree_.corner()) * scale;
    constexpr double last = static_cast<double>(1 << digits);
    for (glm::length_t c = 0; c < 3; ++c)
        if (!(place[c] >= 0.0 && place[c] < last)) return -1;
    const std::array<std::uint32_t, 3> cell{static_cast<std::uint32_t>(place.x), static_cast<std::uint32_t>(place.y),
                                            static_cast<std::uint32_t>(place.z)};
    constexpr int below = digits - start_level;
    const std::uint32_t start =
        ((cell[2] >> below << start_level | cell[1] >> below) << start_level) | cell[0] >> below;
    return descend(start_[start], cell, digits);
}

CubeSamples LocalField::samples(const Cell& cell, const double* x, const double* y, const double* z,
                                std::int64_t count) const noexcept {
    const glm::dvec3 middle = centre(cell);
    return {x, y, z, count, {middle.x, middle.y, middle.z}, tree_.half_width(cell.level)};
}

void LocalField::add(std::int32_t cube, const Targets& t) const noexcept {
    const Cell& cell = cells_[cube];
    const AddHermiteSums add_sums = hermite_sums(set_, kernel::Kind::triharmonic);
    for (std::int64_t k = cell.near_begin; k < cell.near_end; ++k)
        add_sums(0.0, sources(near_[k].begin, near_[k].end), t);
    if (cell.terms < 0) return;
    double* const gradient[3] = {t.gradient_x, t.gradient_y, t.gradient_z};
    cube_loops(set_).evaluate(degree_[cell.level], terms_.data() + cell.terms, samples(cell, t.x, t.y, t.z, t.count),
                              t.value, gradient);
}

void LocalField::add_jets(std::int32_t cube, const JetTargets& t) const noexcept {
    const Cell& cell = cells_[cube];
    triharmonic_jets_of(set_)(sources(0, tree_.points().size()), near_.data() + cell.near_begin,
                              cell.near_end - cell.near_begin, t);
    if (cell.terms < 0) return;
    const CubeLoops loops = cube_loops(set_);
    const int degree = degree_[cell.level];
    const CubeSamples at = samples(cell, t.x, t.y, t.z, t.count);
    loops.evaluate(degree, terms_.data() + cell.terms, at, t.value, t.gradient);
    loops.hessian(degree, terms_.data() + cell.terms, at, t.hessian);
}

std::int64_t LocalField::near_centres(std::int32_t cube) const noexcept {
    std::int64_t count = 0;
    for (std::int64_t k = cells_[cube].near_begin; k < cells_[cube].near_end; ++k)
        count += near_[k].end - near_[k].begin;
    return count;
}

std::int64_t LocalField::bytes() const noexcept {
    return alpha_.bytes() + beta_.bytes() + cells_.bytes() + near_.bytes() + terms_.bytes() + start_.bytes();
}

} // namespace hrbfnpr::implicit
