// SPDX-License-Identifier: MIT
#include "implicit/pieces_block.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::implicit {
namespace {

// A cell has a say up to so many half sides from its centre.
constexpr double reach = 1.4;
// Beyond these distances from the bounds' centre, in their half diagonals, a sphere begins to have a say, and has all.
// Beyond what is searched for surface, as that of an open sheet ends there.
constexpr double sphere_begins = 1.45;
constexpr double sphere_rules = PiecesData::reach;

// Wendland's function (1 - t)^4 (4 t + 1) of one coordinate, with two derivatives (Wendland, "Piecewise polynomial,
// positive definite and compactly supported radial functions of minimal degree", 1995).
struct Bump {
    Bump(double offset, double width) noexcept {
        const double t = std::min(1.0, std::abs(offset) / width);
        const double s = 1.0 - t;
        w = s * s * s * s * (4.0 * t + 1.0);
        d = std::copysign(20.0 * t * s * s * s / width, -offset);
        h = 20.0 * s * s * (4.0 * t - 1.0) / (width * width);
    }
    double w, d, h;
};

void add_symmetric(const glm::dvec3& a, const glm::dvec3& b, double* h) noexcept {
    h[0] += 2.0 * a.x * b.x;
    h[1] += a.x * b.y + a.y * b.x;
    h[2] += a.x * b.z + a.z * b.x;
    h[3] += 2.0 * a.y * b.y;
    h[4] += a.y * b.z + a.z * b.y;
    h[5] += 2.0 * a.z * b.z;
}

// Adds the Hessian of a function of the distance, with derivatives d and h, along the unit vector u.
void radial_hessian(const glm::dvec3& u, double d, double h, double distance, double* to) noexcept {
    const double across = d / distance;
    add_symmetric(u, 0.5 * (h - across) * u, to);
    to[0] += across;
    to[3] += across;
    to[5] += across;
}

} // namespace

PiecesBlock::Weight PiecesBlock::weight_of(const Node& cell, const glm::dvec3& place) noexcept {
    const glm::dvec3 off = place - cell.centre;
    const double width = reach * cell.half;
    const Bump x(off.x, width);
    const Bump y(off.y, width);
    const Bump z(off.z, width);
    return {x.w * y.w * z.w,
            {x.d * y.w * z.w, x.w * y.d * z.w, x.w * y.w * z.d},
            {x.h * y.w * z.w, x.d * y.d * z.w, x.d * y.w * z.d, x.w * y.h * z.w, x.w * y.d * z.d, x.w * y.w * z.h}};
}

void PiecesBlock::add_hit(const Node& cell, const glm::dvec3& place) noexcept {
    const std::int32_t leaf = -1 - data_.child[cell.node];
    Hit& hit = hit_[hits_++];
    hit.leaf = leaf;
    hit.pair = plain;
    hit.weight = weight_of(cell, place);
    const double* const p = data_.plain.data() + 4 * std::int64_t{leaf};
    hit.gradient = {p[1], p[2], p[3]};
    hit.value = p[0] + glm::dot(hit.gradient, place - cell.centre);
}

void PiecesBlock::add_outside(const glm::dvec3& place) noexcept {
    const double radius = 0.5 * data_.bounds.diagonal();
    const glm::dvec3 off = place - data_.bounds.centre();
    const double distance = glm::length(off);
    if (!(distance > sphere_begins * radius)) return;
    const glm::dvec3 u = off / distance;
    const double width = (sphere_rules - sphere_begins) * radius;
    const double t = std::min(1.0, (distance - sphere_begins * radius) / width);
    Hit& hit = hit_[hits_++];
    hit.leaf = -1;
    hit.pair = plain;
    hit.value = distance - radius;
    hit.gradient = u;
    // t^3 (10 - 15 t + 6 t^2): two derivatives are 0 at both ends.
    hit.weight.w = t * t * t * (10.0 + t * (6.0 * t - 15.0));
    const double d = 30.0 * t * t * (1.0 - t) * (1.0 - t) / width;
    const double h = 60.0 * t * (1.0 - t) * (1.0 - 2.0 * t) / (width * width);
    hit.weight.d = d * u;
    std::fill_n(hit.weight.h, 6, 0.0);
    radial_hessian(u, d, h, distance, hit.weight.h);
}

void PiecesBlock::find_hits(const glm::dvec3& place) noexcept {
    constexpr std::size_t stack_size = 8 * PiecesData::most_levels;
    Node stack[stack_size];
    std::size_t depth = 0;
    const std::int64_t limit = hits_ + most_at_point - 1;
    const double half = 0.5 * data_.side;
    stack[depth++] = {0, data_.corner + half, half};
    while (depth > 0 && hits_ < limit) {
        const Node cell = stack[--depth];
        const glm::dvec3 off = glm::abs(place - cell.centre);
        if (!(std::max({off.x, off.y, off.z}) < reach * cell.half)) continue;
        const std::int32_t child = data_.child[cell.node];
        if (child < 0) {
            add_hit(cell, place);
            continue;
        }
        const double q = 0.5 * cell.half;
        for (std::int32_t k = 7; k >= 0; --k)
            stack[depth++] = {
                child + k,
                cell.centre + glm::dvec3((k & 1) != 0 ? q : -q, (k & 2) != 0 ? q : -q, (k & 4) != 0 ? q : -q), q};
    }
    add_outside(place);
}

// Every sheet that a cell of the point asks for, once.
void PiecesBlock::add_pairs(std::int64_t point) noexcept {
    const std::int64_t first = first_pair_[point];
    for (std::int64_t k = first_hit_[point]; k < hits_; ++k) {
        if (hit_[k].leaf < 0) continue;
        const std::int32_t* const program = data_.program.data();
        for (std::int32_t at = data_.program_begin[hit_[k].leaf]; at < data_.program_begin[hit_[k].leaf + 1]; ++at) {
            const std::int32_t sheet = program[at];
            if (sheet < 0) continue;
            bool known = false;
            for (std::int64_t i = first; i < pairs_ && !known; ++i) known = pair_[i].sheet == sheet;
            if (known || pairs_ - first >= most_at_point) continue;
            Pair& pair = pair_[pairs_++];
            pair.sheet = sheet;
            pair.point = static_cast<std::int32_t>(point);
            pair.weight = {};
        }
    }
}

std::int64_t PiecesBlock::take(const PointBatch& points) noexcept {
    hits_ = pairs_ = 0;
    std::int64_t count = 0;
    while (count < std::min(points.count, most_points) && hits_ + most_at_point <= most_hits &&
           pairs_ + most_at_point <= most_pairs) {
        first_hit_[count] = hits_;
        first_pair_[count] = pairs_;
        find_hits({points.x[count], points.y[count], points.z[count]});
        add_pairs(count++);
    }
    first_hit_[count] = hits_;
    first_pair_[count] = pairs_;
    points_ = slice(points, 0, count);
    for (std::int64_t i = 0; i < pairs_; ++i) order_[i] = static_cast<std::int32_t>(i);
    std::sort(order_, order_ + pairs_, [&](std::int32_t a, std::int32_t b) {
        return pair_[a].sheet < pair_[b].sheet || (pair_[a].sheet == pair_[b].sheet && a < b);
    });
    return count;
}

namespace {

// The points of some pairs side by side, and what a sheet is there.
template <std::size_t size>
struct Side {
    double x[size], y[size], z[size], value[size], gradient[3][size], hessian[6][size];
    [[nodiscard]] PointBatch points(std::int64_t count) const noexcept { return {x, y, z, count}; }
};

} // namespace

void PiecesBlock::evaluate_sheets(bool gradient) noexcept {
    Side<std::size_t{most_points}> side;
    for (std::int64_t begin = 0; begin < pairs_;) {
        const std::int32_t sheet = pair_[order_[begin]].sheet;
        std::int64_t count = 0;
        for (; begin + count < pairs_ && pair_[order_[begin + count]].sheet == sheet; ++count) {
            const std::int32_t point = pair_[order_[begin + count]].point;
            side.x[count] = points_.x[point];
            side.y[count] = points_.y[point];
            side.z[count] = points_.z[point];
        }
        FieldBatch fields{side.value, {}, {}};
        if (gradient) fields.gradient = {side.gradient[0], side.gradient[1], side.gradient[2]};
        implicit::evaluate(set_, data_.sheet[sheet], side.points(count), fields);
        for (std::int64_t i = 0; i < count; ++i) {
            Pair& pair = pair_[order_[begin + i]];
            pair.value = side.value[i];
            if (gradient) pair.gradient = {side.gradient[0][i], side.gradient[1][i], side.gradient[2][i]};
        }
        begin += count;
    }
}

// Of the sheets that rule somewhere.
void PiecesBlock::evaluate_hessians() noexcept {
    Side<std::size_t{most_points}> side;
    std::int32_t which[most_points];
    for (std::int64_t begin = 0; begin < pairs_;) {
        const std::int32_t sheet = pair_[order_[begin]].sheet;
        std::int64_t count = 0;
        for (; begin < pairs_ && pair_[order_[begin]].sheet == sheet; ++begin) {
            const Pair& pair = pair_[order_[begin]];
            if (!(pair.weight.w > 0.0)) continue;
            which[count] = order_[begin];
            side.x[count] = points_.x[pair.point];
            side.y[count] = points_.y[pair.point];
            side.z[count++] = points_.z[pair.point];
        }
        if (count == 0) continue;
        FieldBatch fields;
        for (std::size_t c = 0; c < 6; ++c) fields.hessian[c] = side.hessian[c];
        implicit::evaluate(set_, data_.sheet[sheet], side.points(count), fields);
        for (std::int64_t i = 0; i < count; ++i)
            for (std::size_t c = 0; c < 6; ++c) pair_[which[i]].hessian[c] = side.hessian[c][i];
    }
}

// The pair that a leaf's program ends with; plain if it has none.
std::int32_t PiecesBlock::run(std::int32_t leaf, std::int64_t point) const noexcept {
    std::int32_t stack[PiecesData::most_operands + 1];
    std::size_t depth = 0;
    for (std::int32_t at = data_.program_begin[leaf]; at < data_.program_begin[leaf + 1]; ++at) {
        const std::int32_t code = data_.program[at];
        if (code >= 0) {
            std::int64_t i = first_pair_[point];
            while (i < first_pair_[point + 1] && pair_[i].sheet != code) ++i;
            if (i == first_pair_[point + 1]) return plain; // there was no room for it
            stack[depth++] = static_cast<std::int32_t>(i);
            continue;
        }
        const std::int32_t b = stack[--depth];
        const std::int32_t a = stack[depth - 1];
        const bool second =
            code == PiecesData::larger ? pair_[b].value > pair_[a].value : pair_[b].value < pair_[a].value;
        if (second) stack[depth - 1] = b;
    }
    return depth == 1 ? stack[0] : plain;
}

// Which sheet rules each cell, and what all cells of a sheet weigh.
void PiecesBlock::choose(std::int64_t point) noexcept {
    for (std::int64_t k = first_hit_[point]; k < first_hit_[point + 1]; ++k) {
        Hit& hit = hit_[k];
        if (hit.leaf < 0) continue;
        hit.pair = run(hit.leaf, point);
        if (hit.pair == plain) continue;
        Weight& sum = pair_[hit.pair].weight;
        sum.w += hit.weight.w;
        sum.d += hit.weight.d;
        for (std::size_t c = 0; c < 6; ++c) sum.h[c] += hit.weight.h[c];
    }
}

// What f is the mean of at a point: visit(weight, value, gradient, Hessian or null).
template <class Visit>
void PiecesBlock::for_parts(std::int64_t point, Visit&& visit) const noexcept {
    for (std::int64_t i = first_pair_[point]; i < first_pair_[point + 1]; ++i)
        if (pair_[i].weight.w > 0.0) visit(pair_[i].weight, pair_[i].value, pair_[i].gradient, pair_[i].hessian);
    for (std::int64_t k = first_hit_[point]; k < first_hit_[point + 1]; ++k) {
        const Hit& hit = hit_[k];
        if (hit.pair != plain || !(hit.weight.w > 0.0)) continue;
        double h[6] = {};
        if (hit.leaf < 0)
            radial_hessian(
                hit.gradient, 1.0, 0.0,
                glm::distance(data_.bounds.centre(), glm::dvec3(points_.x[point], points_.y[point], points_.z[point])),
                h);
        visit(hit.weight, hit.value, hit.gradient, h);
    }
}

// f = sum w_k f_k / sum w_k.  What concerns the weights' derivatives is 0 where the parts agree.
void PiecesBlock::combine(std::int64_t point, const FieldBatch& fields) const noexcept {
    double total = 0.0;
    double sum = 0.0;
    double first = std::numeric_limits<double>::quiet_NaN(); // at no place
    bool one = true;
    std::int64_t parts = 0;
    for_parts(point, [&](const Weight& weight, double value, const glm::dvec3&, const double*) {
        if (parts++ == 0) first = value;
        one = one && value == first;
        total += weight.w;
        sum += weight.w * value;
    });
    const double value = one ? first : sum / total;
    if (fields.value != nullptr) fields.value[point] = value;
    if (fields.wants_gradient() || fields.wants_hessian()) add_derivatives(point, value, total, fields);
}

void PiecesBlock::add_derivatives(std::int64_t point, double value, double total,
                                  const FieldBatch& fields) const noexcept {
    glm::dvec3 gradient(0.0);
    for_parts(point, [&](const Weight& weight, double v, const glm::dvec3& g, const double*) {
        gradient += (weight.w / total) * g + ((v - value) / total) * weight.d;
    });
    for (glm::length_t c = 0; fields.wants_gradient() && c < 3; ++c)
        fields.gradient[static_cast<std::size_t>(c)][point] = gradient[c];
    if (!fields.wants_hessian()) return;
    double hessian[6] = {};
    for_parts(point, [&](const Weight& weight, double v, const glm::dvec3& g, const double* h) {
        for (std::size_t c = 0; c < 6; ++c) hessian[c] += (weight.w * h[c] + (v - value) * weight.h[c]) / total;
        add_symmetric(weight.d / total, g - gradient, hessian);
    });
    for (std::size_t c = 0; c < 6; ++c) fields.hessian[c][point] = hessian[c];
}

void PiecesBlock::evaluate(const FieldBatch& fields) noexcept {
    evaluate_sheets(fields.wants_gradient() || fields.wants_hessian());
    for (std::int64_t point = 0; point < points_.count; ++point) choose(point);
    if (fields.wants_hessian()) evaluate_hessians();
    for (std::int64_t point = 0; point < points_.count; ++point) combine(point, fields);
}

void PiecesBlock::active(std::int32_t* sheet) noexcept {
    evaluate_sheets(false);
    for (std::int64_t point = 0; point < points_.count; ++point) {
        choose(point);
        double most = 0.0;
        double all = 0.0;
        for (std::int64_t k = first_hit_[point]; k < first_hit_[point + 1]; ++k)
            if (hit_[k].pair == plain) all += hit_[k].weight.w;
        most = all;
        sheet[point] = static_cast<std::int32_t>(data_.sheet.size());
        for (std::int64_t i = first_pair_[point]; i < first_pair_[point + 1]; ++i)
            if (pair_[i].weight.w > most) {
                most = pair_[i].weight.w;
                sheet[point] = pair_[i].sheet;
            }
    }
}

} // namespace hrbfnpr::implicit
