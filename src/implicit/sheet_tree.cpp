// SPDX-License-Identifier: MIT
// A block of points is evaluated in five steps: 1. find the points whose sheet is known from zones, and, for the other
// points, the cells that reach them; 2. collect the terms at the other points: a term for each sheet in the program of
// a cell, and for each cell without a program; 3. evaluate each sheet at all its points at once; 4. find the sheet that
// the program of each cell selects, and sum the weights of the cells by sheet; 5. compute the weighted mean of the
// terms.
#include "implicit/sheet_tree.h"

#include "implicit/lanes.h"
#include "implicit/prepared.h"
#include "implicit/tuning.h"

#include <cmath>

namespace hrbfnpr::implicit {
namespace {

// Wendland's function (1 - t)^4 (4 t + 1) of one coordinate, with its first two derivatives (Wendland, "Piecewise
// polynomial, positive definite and compactly supported radial functions of minimal degree", 1995).
struct WendlandFunction {
    WendlandFunction(double offset, double width) noexcept {
        const double t = std::min(1.0, std::abs(offset) / width);
        const double s = 1.0 - t;
        w = s * s * s * s * (4.0 * t + 1.0);
        d = std::copysign(20.0 * t * s * s * s / width, -offset);
        h = 20.0 * s * s * (4.0 * t - 1.0) / (width * width);
    }
    double w, d, h;
};

// Adds a b^T + b a^T to a Hessian in the order xx xy xz yy yz zz.
void add_symmetric(const glm::dvec3& a, const glm::dvec3& b, std::array<double, 6>& h) noexcept {
    h[0] += 2.0 * a.x * b.x;
    h[1] += a.x * b.y + a.y * b.x;
    h[2] += a.x * b.z + a.z * b.x;
    h[3] += 2.0 * a.y * b.y;
    h[4] += a.y * b.z + a.z * b.y;
    h[5] += 2.0 * a.z * b.z;
}

// Adds the Hessian of a radial function: a function of the distance from a centre. `d` and `h` are its first and second
// derivative with respect to the distance. u is the unit vector from the centre.
void add_radial(const glm::dvec3& u, double d, double h, double distance, std::array<double, 6>& to) noexcept {
    const double across = d / distance;
    add_symmetric(u, 0.5 * (h - across) * u, to);
    to[0] += across;
    to[3] += across;
    to[5] += across;
}

Jet weight_of(const SheetTreeNode& cell, const glm::dvec3& place) noexcept {
    const glm::dvec3 off = place - cell.centre;
    const double width = SheetTreeData::cell_reach * cell.half;
    const WendlandFunction x(off.x, width);
    const WendlandFunction y(off.y, width);
    const WendlandFunction z(off.z, width);
    return {x.w * y.w * z.w,
            {x.d * y.w * z.w, x.w * y.d * z.w, x.w * y.w * z.d},
            {x.h * y.w * z.w, x.d * y.d * z.w, x.d * y.w * z.d, x.w * y.h * z.w, x.w * y.d * z.d, x.w * y.w * z.h}};
}

// One of the functions whose weighted mean is f at a point: a sheet, or a function that replaces sheets where no
// surface is near.
struct Term {
    std::int32_t sheet; // index of the sheet; -1: the term is not a sheet
    std::int32_t point;
    std::int32_t next; // next term of the same sheet, or -1
    Jet jet;
    Jet weight; // the sum of the weights of all cells in which f equals this term
};

// A cell whose weight at a point is above 0.
struct ReachingCell {
    SheetTreeNode cell;
    std::int32_t leaf;         // index of the leaf; -1: this entry stands for the sphere that f equals far outside
    std::int32_t result_term;  // the term that the program selects, or -1
    const std::int32_t* begin; // the program is the range [begin, end)
    const std::int32_t* end;

    [[nodiscard]] std::span<const std::int32_t> program() const noexcept { return {begin, end}; }
};

// Returns the linear function of a cell without a program.
Term plain_term(const SheetTreeData& data, const ReachingCell& hit, const glm::dvec3& place) noexcept {
    const double* const p = data.plain.data() + 4 * std::int64_t{hit.leaf};
    Term term{-1, 0, -1, {}, {}};
    term.jet.gradient = {p[1], p[2], p[3]};
    term.jet.value = p[0] + glm::dot(term.jet.gradient, place - hit.cell.centre);
    term.weight = weight_of(hit.cell, place);
    return term;
}

// Returns the sphere around the bounds. Far outside, f is this sphere.
Term sphere_term(const SheetTreeData& data, const glm::dvec3& place) noexcept {
    const double radius = 0.5 * data.bounds.diagonal();
    const glm::dvec3 off = place - data.bounds.centre();
    const double distance = glm::length(off);
    const glm::dvec3 u = off / distance;
    const double width = (SheetTreeData::sphere_rules - SheetTreeData::sphere_begins) * radius;
    const double t = std::min(1.0, (distance - SheetTreeData::sphere_begins * radius) / width);
    Term term{-1, 0, -1, {}, {}};
    term.jet.value = distance - radius;
    term.jet.gradient = u;
    add_radial(u, 1.0, 0.0, distance, term.jet.hessian);
    // The weight is t^3 (10 - 15 t + 6 t^2). Its first two derivatives are 0 at both ends of [0, 1].
    term.weight.value = t * t * t * (10.0 + t * (6.0 * t - 15.0));
    const double d = 30.0 * t * t * (1.0 - t) * (1.0 - t) / width;
    const double h = 60.0 * t * (1.0 - t) * (1.0 - 2.0 * t) / (width * width);
    term.weight.gradient = d * u;
    add_radial(u, d, h, distance, term.weight.hessian);
    return term;
}

class SheetTreeBlock {
public:
    explicit SheetTreeBlock(const SheetTreeBase& tree) noexcept : tree_(tree), data_(tree.data()) {}

    // Takes as many points as the block has room for, at least one, and returns their number.
    std::int64_t take(const PointBatch& points) noexcept;
    void evaluate(const FieldBatch& fields);
    void active(std::int32_t* sheet);

private:
    static constexpr std::int64_t most_points = PiecesTuning::points;
    static constexpr std::int64_t most_at_point = 96; // the most cells, or sheets, of one point
    static constexpr std::int64_t most_hits = 768;    // the most cells of all points together
    static constexpr std::int64_t most_terms = 768;

    // A sheet, the points at which f is known to equal it, and the terms that need it.
    struct Group {
        std::int32_t sheet;
        std::int32_t point, term; // first element of each linked list, or -1
    };

    [[nodiscard]] std::span<ReachingCell> hits(std::int64_t point) noexcept {
        return {hit_ + first_hit_[point], hit_ + first_hit_[point + 1]};
    }
    [[nodiscard]] std::span<const Term> terms(std::int64_t point) const noexcept {
        return {term_ + first_term_[point], term_ + first_term_[point + 1]};
    }
    Group& group_of(std::int32_t sheet) noexcept;
    void add_hit(const SheetTreeNode& cell, std::int32_t leaf, std::span<const std::int32_t> program) noexcept {
        HRBFNPR_ASSERT(hits_ < most_hits);
        hit_[hits_++] = {cell, leaf, -1, program.data(), program.data() + program.size()};
    }
    void find_hits(const SheetTreeNode& cell, const glm::dvec3& place, std::int64_t limit) noexcept;
    void add_reaching_cells(std::span<const SheetTreeZones::Part> parts, const glm::dvec3& place) noexcept;
    void add_terms(std::int64_t point, const glm::dvec3& place) noexcept;
    void evaluate_single_sheets(const FieldBatch& fields);
    void evaluate_terms(bool gradient, bool hessian);
    void weigh_sheets(std::int64_t point) noexcept;
    [[nodiscard]] std::int32_t run_program(const ReachingCell& hit, std::int64_t point) const noexcept;
    [[nodiscard]] Jet mean(std::int64_t point, const FieldBatch& wanted) const noexcept;

    const SheetTreeBase& tree_;
    const SheetTreeData& data_;
    PointBatch points_;
    std::int64_t hits_ = 0;
    std::int64_t terms_ = 0;
    std::int64_t groups_ = 0;
    std::int64_t first_hit_[most_points + 1];
    std::int64_t first_term_[most_points + 1];
    std::int32_t only_sheet_[most_points];    // for each point, the sheet that f is known to equal, or -1
    std::int32_t next_of_sheet_[most_points]; // next point with the same known sheet, or -1
    std::int32_t only_term_[most_points];     // for the other points: the term that all cells select, or -1
    ReachingCell hit_[most_hits];
    Term term_[most_terms];
    Group group_[most_points + most_terms];
    PointLanes<std::size_t{most_points}> lanes_;
    FieldLanes<std::size_t{most_points}> answer_;
};

SheetTreeBlock::Group& SheetTreeBlock::group_of(std::int32_t sheet) noexcept {
    HRBFNPR_ASSERT(sheet >= 0 && sheet < data_.sheet.size());
    for (std::int64_t g = groups_ - 1; g >= 0; --g)
        if (group_[g].sheet == sheet) return group_[g];
    group_[groups_] = {sheet, -1, -1};
    return group_[groups_++];
}

// Adds the leaves below a cell that reach a place. The first is the leaf that contains the place or is nearest to it.
void SheetTreeBlock::find_hits(const SheetTreeNode& cell, const glm::dvec3& place, std::int64_t limit) noexcept {
    const std::int32_t child = data_.child[cell.node];
    if (child < 0) {
        if (hits_ < limit) add_hit(cell, -1 - child, data_.program_of(-1 - child));
        return;
    }
    // Along each axis, the lower children reach beyond the middle, and the upper children reach below it.
    const glm::dvec3 off = place - cell.centre;
    const double both = (SheetTreeData::cell_reach - 1.0) * 0.5 * cell.half;
    const int low = (off.x < both ? 1 : 0) | (off.y < both ? 2 : 0) | (off.z < both ? 4 : 0);
    const int high = (off.x > -both ? 1 : 0) | (off.y > -both ? 2 : 0) | (off.z > -both ? 4 : 0);
    find_hits(cell.child(child, high), place, limit);
    for (int k = 0; (low & high) != 0 && k < 8; ++k)
        if (k != high && (k & high) == k && (~k & 7 & low) == (~k & 7)) find_hits(cell.child(child, k), place, limit);
}

// Adds the cells that reach a place. `parts` are the candidates that the zones know; if it is empty, the tree is
// searched.
void SheetTreeBlock::add_reaching_cells(std::span<const SheetTreeZones::Part> parts, const glm::dvec3& place) noexcept {
    const SheetTreeZones* const zones = tree_.zones();
    for (const SheetTreeZones::Part& part : parts)
        if (const SheetTreeNode& cell = zones->node(part.leaf); parts.size() == 1 || cell.reaches(place))
            add_hit(cell, part.leaf, zones->program_of(part));
    if (!parts.empty()) return;
    const SheetTreeNode root = root_of(data_);
    if (root.reaches(place)) find_hits(root, place, hits_ + most_at_point - 1);
    const double begins = SheetTreeData::sphere_begins * 0.5 * data_.bounds.diagonal();
    if (glm::distance(place, data_.bounds.centre()) > begins) add_hit(root, -1, {});
}

// Adds a term for each sheet in the programs of the point's cells. If there is no room for the sheets of a cell, the
// cell is handled like a cell without a program.
void SheetTreeBlock::add_terms(std::int64_t point, const glm::dvec3& place) noexcept {
    const std::int64_t first = terms_;
    bool plain = false;
    for (ReachingCell& hit : std::span(hit_ + first_hit_[point], hit_ + hits_)) {
        for (const std::int32_t sheet : hit.program()) {
            if (sheet < 0) continue;
            std::int64_t i = first;
            while (i < terms_ && term_[i].sheet != sheet) ++i;
            if (i < terms_) continue;
            if (i - first >= most_at_point) {
                hit.end = hit.begin;
                break;
            }
            Term& term = term_[terms_++];
            term.sheet = sheet;
            term.point = static_cast<std::int32_t>(point);
            term.next = std::exchange(group_of(sheet).term, static_cast<std::int32_t>(i));
            term.weight = {};
        }
        plain = plain || hit.begin == hit.end;
    }
    for (std::int64_t k = first_hit_[point]; plain && k < hits_; ++k)
        if (const ReachingCell& hit = hit_[k]; hit.begin == hit.end)
            term_[terms_++] = hit.leaf >= 0 ? plain_term(data_, hit, place) : sphere_term(data_, place);
}

std::int64_t SheetTreeBlock::take(const PointBatch& points) noexcept {
    const SheetTreeZones* const zones = tree_.zones();
    hits_ = terms_ = groups_ = 0;
    first_hit_[0] = first_term_[0] = 0;
    std::int64_t count = 0;
    while (count < std::min(points.count, most_points) && hits_ + most_at_point <= most_hits &&
           terms_ + 2 * most_at_point <= most_terms) {
        const glm::dvec3 place = point_at(points, count);
        SheetTreeZones::Candidates found;
        if (zones != nullptr) found = zones->candidates_at(place);
        only_sheet_[count] = found.sheet;
        if (found.sheet >= 0) {
            next_of_sheet_[count] = std::exchange(group_of(found.sheet).point, static_cast<std::int32_t>(count));
        } else {
            add_reaching_cells(found.parts, place);
            add_terms(count, place);
        }
        first_hit_[++count] = hits_;
        first_term_[count] = terms_;
    }
    points_ = slice(points, 0, count);
    return count;
}

void SheetTreeBlock::evaluate_single_sheets(const FieldBatch& fields) {
    for (const Group& group : std::span(group_, static_cast<std::size_t>(groups_))) {
        lanes_.count = 0;
        for (std::int32_t i = group.point; i >= 0; i = next_of_sheet_[i]) lanes_.add(point_at(points_, i), i);
        if (lanes_.count == 0) continue;
        tree_.evaluate(group.sheet, lanes_.points(),
                       answer_.fields(fields.value != nullptr, fields.wants_gradient(), fields.wants_hessian()));
        answer_.scatter(lanes_.index, lanes_.count, fields);
    }
}

// Evaluates values, with or without gradients. Hessians are evaluated in a separate call, and only for terms with a
// positive weight.
void SheetTreeBlock::evaluate_terms(bool gradient, bool hessian) {
    for (const Group& group : std::span(group_, static_cast<std::size_t>(groups_))) {
        lanes_.count = 0;
        for (std::int32_t i = group.term; i >= 0; i = term_[i].next)
            if (!hessian || term_[i].weight.value > 0.0) lanes_.add(point_at(points_, term_[i].point), i);
        if (lanes_.count == 0) continue;
        tree_.evaluate(group.sheet, lanes_.points(), answer_.fields(!hessian, gradient, hessian));
        for (std::int64_t k = 0; k < lanes_.count; ++k) {
            Jet& jet = term_[lanes_.index[k]].jet;
            if (!hessian) jet.value = answer_.field[0][k];
            for (int c = 0; gradient && c < 3; ++c) jet.gradient[c] = answer_.field[1 + c][k];
            for (std::size_t c = 0; hessian && c < 6; ++c) jet.hessian[c] = answer_.field[4 + c][k];
        }
    }
}

// Returns the term that the program of a cell selects.
std::int32_t SheetTreeBlock::run_program(const ReachingCell& hit, std::int64_t point) const noexcept {
    std::int32_t stack[SheetTreeData::most_operands + 1];
    std::size_t depth = 0;
    for (const std::int32_t code : hit.program()) {
        if (code >= 0) {
            std::int64_t i = first_term_[point];
            while (term_[i].sheet != code) ++i;
            HRBFNPR_ASSERT(i < first_term_[point + 1]);
            stack[depth++] = static_cast<std::int32_t>(i);
            continue;
        }
        HRBFNPR_ASSERT(depth >= 2);
        const double sign = code == SheetTreeData::minimum ? 1.0 : -1.0;
        const std::int32_t b = stack[--depth];
        std::int32_t& a = stack[depth - 1];
        if (takes_lower(sign * term_[a].jet.value, sign * term_[b].jet.value)) a = b;
    }
    return depth == 1 ? stack[0] : -1;
}

// Finds the sheet that the program of each cell selects, and sums the weights of the cells by sheet. If all cells
// select the same sheet, its weight is 1.
void SheetTreeBlock::weigh_sheets(std::int64_t point) noexcept {
    const std::span<ReachingCell> hits = this->hits(point);
    bool one = !hits.empty();
    for (ReachingCell& hit : hits) {
        hit.result_term = run_program(hit, point);
        one = one && hit.result_term >= 0 && hit.result_term == hits[0].result_term;
    }
    only_term_[point] = one ? hits[0].result_term : -1;
    if (one) term_[only_term_[point]].weight.value = 1.0;
    for (const ReachingCell& hit : hits)
        if (!one && hit.result_term >= 0)
            term_[hit.result_term].weight.add(weight_of(hit.cell, point_at(points_, point)));
}

// Returns f = sum w_k f_k / sum w_k. The derivatives of the weights contribute nothing where the terms are equal.
Jet SheetTreeBlock::mean(std::int64_t point, const FieldBatch& wanted) const noexcept {
    double total = 0.0;
    double sum = 0.0;
    double first = std::numeric_limits<double>::quiet_NaN(); // it stays NaN if no term has a positive weight
    bool one = true;
    for (const Term& term : terms(point)) {
        if (!(term.weight.value > 0.0)) continue;
        if (total == 0.0) first = term.jet.value;
        one = one && term.jet.value == first;
        total += term.weight.value;
        sum += term.weight.value * term.jet.value;
    }
    Jet mean{one ? first : sum / total, glm::dvec3(0.0), {}};
    for (const auto& [sheet, number, next, jet, weight] : terms(point))
        if ((wanted.wants_gradient() || wanted.wants_hessian()) && weight.value > 0.0)
            mean.gradient +=
                (weight.value / total) * jet.gradient + ((jet.value - mean.value) / total) * weight.gradient;
    for (const auto& [sheet, number, next, jet, weight] : terms(point)) {
        if (!wanted.wants_hessian() || !(weight.value > 0.0)) continue;
        for (std::size_t c = 0; c < 6; ++c)
            mean.hessian[c] += (weight.value * jet.hessian[c] + (jet.value - mean.value) * weight.hessian[c]) / total;
        add_symmetric(weight.gradient / total, jet.gradient - mean.gradient, mean.hessian);
    }
    return mean;
}

void SheetTreeBlock::evaluate(const FieldBatch& fields) {
    evaluate_single_sheets(fields);
    evaluate_terms(fields.wants_gradient() || fields.wants_hessian(), false);
    for (std::int64_t point = 0; point < points_.count; ++point)
        if (only_sheet_[point] < 0) weigh_sheets(point);
    if (fields.wants_hessian()) evaluate_terms(false, true);
    for (std::int64_t point = 0; point < points_.count; ++point) {
        if (only_sheet_[point] >= 0) continue;
        Jet mixed;
        Jet& jet = only_term_[point] >= 0 ? term_[only_term_[point]].jet : (mixed = mean(point, fields));
        for_columns(fields, [&](std::size_t c, double* column) { column[point] = jet[c]; });
    }
}

// Writes the sheet with the largest weight. If the cells without a program together have at least that weight, it
// writes the last sheet, which is f.
void SheetTreeBlock::active(std::int32_t* sheet) {
    evaluate_terms(false, false);
    for (std::int64_t point = 0; point < points_.count; ++point) {
        sheet[point] = only_sheet_[point];
        if (sheet[point] >= 0) continue;
        weigh_sheets(point);
        double most = 0.0;
        for (const Term& term : terms(point))
            if (term.sheet < 0) most += term.weight.value;
        sheet[point] = tree_.count() - 1;
        for (const Term& term : terms(point)) {
            if (term.sheet < 0 || !(term.weight.value > most)) continue;
            most = term.weight.value;
            sheet[point] = term.sheet;
        }
    }
}

// Calls work(block, first) for one block of points after another.
template <class F>
void in_blocks(const SheetTreeBase& of, const PointBatch& points, F&& work) {
    base::OwnedObject<SheetTreeBlock> block(of.data().child.memory(), of);
    for (std::int64_t begin = 0; begin < points.count;) {
        const std::int64_t count = block->take(slice(points, begin, points.count));
        work(*block, begin);
        begin += count;
    }
}

} // namespace

void SheetTreeBase::evaluate(const PointBatch& points, const FieldBatch& fields) const {
    in_blocks(*this, points, [&](SheetTreeBlock& block, std::int64_t begin) { block.evaluate(fields.from(begin)); });
}

void SheetTreeBase::active(const PointBatch& points, std::int32_t* sheet) const {
    in_blocks(*this, points, [&](SheetTreeBlock& block, std::int64_t begin) { block.active(sheet + begin); });
}

void SheetTreeBase::evaluate(std::int32_t sheet, const PointBatch& points, const FieldBatch& fields) const {
    HRBFNPR_ASSERT(sheet >= 0 && sheet < count());
    if (sheet == data_.sheet.size())
        evaluate(points, fields);
    else if (const Prepared* const its = prepared(sheet); its != nullptr)
        its->evaluate(points, fields);
    else
        implicit::evaluate(set_, data_.sheet[sheet], points, fields);
}

std::int64_t SheetTreeBase::cells() const noexcept {
    if (zones_ == nullptr) return data_.leaves();
    bool order = data_.sheet.size() > pieces_tuning.few_sheets;
    for (std::int64_t i = 0; !order && i < data_.sheet.size(); ++i) order = prepared(i) != nullptr;
    return order ? zones_->cells() : 0;
}

std::optional<PreparedSheetTree::Scope> PreparedSheetTree::pays(const SheetTreeData& data, double points) noexcept {
    if (points < pieces_tuning.points_a_cell * static_cast<double>(data.leaves())) return std::nullopt;
    const auto all = static_cast<double>(data.centres());
    // The share of the points at which a sheet is evaluated is about the sheet's share of all centres.
    for (const HrbfData& one : data.sheet)
        if (Prepared::pays(one, points * static_cast<double>(one.count()) / all)) return Scope::sheets;
    return Scope::zones;
}

PreparedSheetTree::PreparedSheetTree(const base::Work& work, const SheetTreeBase& of, Scope scope)
    : SheetTreeBase(of.instruction_set(), of.data(), &own_zones_, &sheet_), own_zones_(work, of.data()),
      sheet_(work.memory) {
    work.runtime().log(base::LogLevel::info, "evaluation: cells of %lld sheets prepared in %.3f s, %.1f MB",
                       static_cast<long long>(data().sheet.size()), watch_.seconds(),
                       static_cast<double>(own_zones_.bytes()) / 1e6);
    for (std::int64_t i = 0; scope == Scope::sheets && i < data().sheet.size(); ++i)
        sheet_.add(Prepared::make(work, data().sheet[i]));
}

PreparedSheetTree::~PreparedSheetTree() = default;

std::int64_t PreparedSheetTree::bytes() const noexcept {
    std::int64_t sum = own_zones_.bytes();
    for (const std::unique_ptr<Prepared>& one : sheet_) sum += one != nullptr ? one->bytes() : 0;
    return sum;
}

} // namespace hrbfnpr::implicit
