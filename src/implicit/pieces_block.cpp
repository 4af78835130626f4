// SPDX-License-Identifier: MIT
#include "implicit/pieces_block.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::implicit {
namespace {

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
    const double width = PiecesData::cell_reach * cell.half;
    const Bump x(off.x, width);
    const Bump y(off.y, width);
    const Bump z(off.z, width);
    return {x.w * y.w * z.w,
            {x.d * y.w * z.w, x.w * y.d * z.w, x.w * y.w * z.d},
            {x.h * y.w * z.w, x.d * y.d * z.w, x.d * y.w * z.d, x.w * y.h * z.w, x.w * y.d * z.d, x.w * y.w * z.h}};
}

void PiecesBlock::weigh(Hit& hit, const glm::dvec3& place) const noexcept {
    if (hit.leaf < 0) return weigh_outside(hit, place);
    hit.weight = weight_of(hit.cell, place);
    const double* const p = data_.plain.data() + 4 * std::int64_t{hit.leaf};
    hit.gradient = {p[1], p[2], p[3]};
    hit.value = p[0] + glm::dot(hit.gradient, place - hit.cell.centre);
}

void PiecesBlock::weigh_outside(Hit& hit, const glm::dvec3& place) const noexcept {
    const double radius = 0.5 * data_.bounds.diagonal();
    const glm::dvec3 off = place - data_.bounds.centre();
    const double distance = glm::length(off);
    const glm::dvec3 u = off / distance;
    const double width = (PiecesData::sphere_rules - PiecesData::sphere_begins) * radius;
    const double t = std::min(1.0, (distance - PiecesData::sphere_begins * radius) / width);
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
    const glm::dvec3 middle = data_.corner + half;
    const glm::dvec3 from_middle = glm::abs(place - middle);
    if (std::max({from_middle.x, from_middle.y, from_middle.z}) < PiecesData::cell_reach * half)
        stack[depth++] = {0, middle, half};
    while (depth > 0 && hits_ < limit) {
        Node cell = stack[--depth];
        std::int32_t child = data_.child[cell.node];
        while (child >= 0) {
            // Along each axis the lower children reach so far up, and the upper ones so far down.
            const glm::dvec3 off = place - cell.centre;
            const double q = 0.5 * cell.half;
            const double both = (PiecesData::cell_reach - 1.0) * q;
            const int low = (off.x < both ? 1 : 0) | (off.y < both ? 2 : 0) | (off.z < both ? 4 : 0);
            const int high = (off.x > -both ? 1 : 0) | (off.y > -both ? 2 : 0) | (off.z > -both ? 4 : 0);
            for (int k = 7; (low & high) != 0 && k >= 0; --k)
                if (k != high && (k & high) == k && (~k & 7 & low) == (~k & 7))
                    stack[depth++] = {child + k, cell.centre + PiecesData::child_offset(k, q), q};
            cell = {child + high, cell.centre + PiecesData::child_offset(high, q), q};
            child = data_.child[cell.node];
        }
        const std::int32_t leaf = -1 - child;
        const std::int32_t begin = data_.program_begin[leaf];
        add_hit(cell, leaf, data_.program.data() + begin, data_.program_begin[leaf + 1] - begin);
    }
    const double radius = 0.5 * data_.bounds.diagonal();
    if (!(glm::distance(place, data_.bounds.centre()) > PiecesData::sphere_begins * radius)) return;
    add_hit({}, -1, nullptr, 0);
}

void PiecesBlock::add_hit(const Node& cell, std::int32_t leaf, const std::int32_t* program,
                          std::int32_t codes) noexcept {
    Hit& hit = hit_[hits_++];
    hit.cell = cell;
    hit.leaf = leaf;
    hit.program = program;
    hit.codes = codes;
    hit.pair = plain;
}

void PiecesBlock::take_hits(const At& at, const glm::dvec3& place) noexcept {
    const PiecesZones& zones = *parts_.zones;
    const auto add = [&](const PiecesZones::Part& part) {
        add_hit(zones.node(part.leaf), part.leaf, zones.programs() + part.begin, part.end - part.begin);
    };
    if (at.alone != nullptr) return add(*at.alone);
    for (const PiecesZones::Part& part : zones.parts(zones[at.zone]))
        if (zones.node(part.leaf).reaches(place)) add(part);
}

// Every sheet that a cell of the point asks for, once.
void PiecesBlock::add_pairs(std::int64_t point) noexcept {
    const std::int64_t first = first_pair_[point];
    for (std::int64_t k = first_hit_[point]; k < hits_; ++k) {
        for (std::int32_t at = 0; at < hit_[k].codes; ++at) {
            const std::int32_t sheet = hit_[k].program[at];
            if (sheet < 0) continue;
            bool known = false;
            for (std::int64_t i = first; i < pairs_ && !known; ++i) known = pair_[i].sheet == sheet;
            if (known || pairs_ - first >= most_at_point) continue;
            add_pair(sheet, point);
        }
    }
}

void PiecesBlock::add_pair(std::int32_t sheet, std::int64_t point) noexcept {
    const auto number = static_cast<std::int32_t>(pairs_++);
    Pair& pair = pair_[number];
    pair.sheet = sheet;
    pair.point = static_cast<std::int32_t>(point);
    pair.weight = {};
    pair.next = -1;
    for (std::int64_t g = groups_ - 1; g >= 0; --g) {
        if (group_[g].sheet != sheet) continue;
        pair_[group_[g].last].next = number;
        group_[g].last = number;
        return;
    }
    group_[groups_++] = {sheet, number, number};
}

std::int64_t PiecesBlock::take(const PointBatch& points, const At* at) noexcept {
    hits_ = pairs_ = groups_ = 0;
    std::int64_t count = 0;
    while (count < std::min(points.count, most_points) && hits_ + most_at_point <= most_hits &&
           pairs_ + most_at_point <= most_pairs) {
        first_hit_[count] = hits_;
        first_pair_[count] = pairs_;
        const glm::dvec3 where(points.x[count], points.y[count], points.z[count]);
        if (at != nullptr && at[count].zone >= 0)
            take_hits(at[count], where);
        else
            find_hits(where);
        add_pairs(count++);
    }
    first_hit_[count] = hits_;
    first_pair_[count] = pairs_;
    points_ = slice(points, 0, count);
    return count;
}

namespace {

// The points of some pairs side by side, and what a sheet is there.
template <std::size_t size>
struct Side {
    double x[size], y[size], z[size], value[size], gradient[3][size], hessian[6][size];
    [[nodiscard]] PointBatch points(std::int64_t count) const noexcept { return {x, y, z, count}; }
    void add(const PointBatch& from, std::int32_t point, std::int64_t at) noexcept {
        x[at] = from.x[point];
        y[at] = from.y[point];
        z[at] = from.z[point];
    }
};

} // namespace

void PiecesBlock::evaluate_sheets(bool gradient) {
    Side<std::size_t{most_points}> side;
    FieldBatch fields{side.value, {}, {}};
    if (gradient) fields.gradient = {side.gradient[0], side.gradient[1], side.gradient[2]};
    for (std::int64_t g = 0; g < groups_; ++g) {
        std::int64_t count = 0;
        for (std::int32_t i = group_[g].first; i >= 0; i = pair_[i].next) side.add(points_, pair_[i].point, count++);
        parts_.evaluate_sheet(group_[g].sheet, side.points(count), fields);
        count = 0;
        for (std::int32_t i = group_[g].first; i >= 0; i = pair_[i].next, ++count) {
            pair_[i].value = side.value[count];
            if (gradient)
                pair_[i].gradient = {side.gradient[0][count], side.gradient[1][count], side.gradient[2][count]};
        }
    }
}

// Of the sheets that rule somewhere.
void PiecesBlock::evaluate_hessians() {
    Side<std::size_t{most_points}> side;
    FieldBatch fields;
    for (std::size_t c = 0; c < 6; ++c) fields.hessian[c] = side.hessian[c];
    for (std::int64_t g = 0; g < groups_; ++g) {
        std::int64_t count = 0;
        for (std::int32_t i = group_[g].first; i >= 0; i = pair_[i].next)
            if (pair_[i].weight.w > 0.0) side.add(points_, pair_[i].point, count++);
        if (count == 0) continue;
        parts_.evaluate_sheet(group_[g].sheet, side.points(count), fields);
        count = 0;
        for (std::int32_t i = group_[g].first; i >= 0; i = pair_[i].next) {
            if (!(pair_[i].weight.w > 0.0)) continue;
            for (std::size_t c = 0; c < 6; ++c) pair_[i].hessian[c] = side.hessian[c][count];
            ++count;
        }
    }
}

// The pair that a cell's program ends with; plain if it has none.
std::int32_t PiecesBlock::run(const Hit& hit, std::int64_t point) const noexcept {
    std::int32_t stack[PiecesData::most_operands + 1];
    std::size_t depth = 0;
    for (std::int32_t at = 0; at < hit.codes; ++at) {
        const std::int32_t code = hit.program[at];
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

// Which sheet rules each cell, and what all cells of a sheet weigh: 1 where it is all of them.
void PiecesBlock::choose(std::int64_t point) noexcept {
    const std::int64_t begin = first_hit_[point];
    const std::int64_t end = first_hit_[point + 1];
    bool one = begin < end;
    for (std::int64_t k = begin; k < end; ++k) {
        hit_[k].pair = run(hit_[k], point);
        one = one && hit_[k].pair != plain && hit_[k].pair == hit_[begin].pair;
    }
    ruler_[point] = one ? hit_[begin].pair : plain;
    if (one) {
        pair_[hit_[begin].pair].weight.w = 1.0;
        return;
    }
    for (std::int64_t k = begin; k < end; ++k) {
        weigh(hit_[k], place(point));
        if (hit_[k].pair == plain) continue;
        Weight& sum = pair_[hit_[k].pair].weight;
        sum.w += hit_[k].weight.w;
        sum.d += hit_[k].weight.d;
        for (std::size_t c = 0; c < 6; ++c) sum.h[c] += hit_[k].weight.h[c];
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
        if (hit.leaf < 0) radial_hessian(hit.gradient, 1.0, 0.0, glm::distance(data_.bounds.centre(), place(point)), h);
        visit(hit.weight, hit.value, hit.gradient, h);
    }
}

// Of a point that one sheet rules.
void PiecesBlock::copy(std::int64_t point, const FieldBatch& fields) const noexcept {
    const Pair& pair = pair_[ruler_[point]];
    if (fields.value != nullptr) fields.value[point] = pair.value;
    for (glm::length_t c = 0; fields.wants_gradient() && c < 3; ++c)
        fields.gradient[static_cast<std::size_t>(c)][point] = pair.gradient[c];
    for (std::size_t c = 0; fields.wants_hessian() && c < 6; ++c) fields.hessian[c][point] = pair.hessian[c];
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

void PiecesBlock::evaluate(const FieldBatch& fields) {
    evaluate_sheets(fields.wants_gradient() || fields.wants_hessian());
    for (std::int64_t point = 0; point < points_.count; ++point) choose(point);
    if (fields.wants_hessian()) evaluate_hessians();
    for (std::int64_t point = 0; point < points_.count; ++point)
        if (ruler_[point] != plain)
            copy(point, fields);
        else
            combine(point, fields);
}

void PiecesBlock::active(std::int32_t* sheet) {
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
