// SPDX-License-Identifier: MIT
#include "implicit/prepared.h"

#include "base/clock.h"
#include "base/random.h"
#include "implicit/evaluate_all.h"
#include "implicit/hrbf_block.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hrbfnpr::implicit {
namespace {

constexpr std::int64_t fewest_centres = 512;
// The measured error is the maximum over about a hundred places. If it exceeds the tolerance by more than this factor,
// the field is made finer, or given up.
constexpr double slack = 200.0;
// This limit replaces `slack` if a finer field does not reduce the error enough. Then the error comes from rounding:
// weights have large magnitudes if parts of a mesh cross or lie close to each other, and rounding alone causes errors
// of 100 or 1000 times the tolerance. Sums over all centres would not make better drawings, but lines and every frame
// would take minutes.
constexpr double slack_of_rounding = 5000.0;
// A finer field does not reduce the error enough if its error is above this share of the previous error.
constexpr double no_better = 0.5;
constexpr double gradients_share = 100.0;
constexpr int finest = 2;
constexpr std::int64_t probes = 512;

[[nodiscard]] double spacing_of(const HrbfData& data) noexcept {
    return data.spacing > 0.0 ? data.spacing / data.scale : 1.0;
}

} // namespace

// Times were measured on two cores with AVX-512: a pair of a point and a centre takes 0.15 ns; a field takes 0.02 s
// plus 28 us for each centre. A field is made if it takes less than twice the time of all pairs, because later calls
// use it, too. The results of a call do not depend on earlier calls.
bool Prepared::pays(const HrbfData& data, double points) noexcept {
    const auto centres = static_cast<double>(data.count());
    return data.kernel == kernel::Kind::triharmonic && data.count() >= fewest_centres &&
           1.5e-10 * points * centres > 0.01 + 1.4e-5 * centres;
}

std::unique_ptr<Prepared> Prepared::make(const base::Work& work, const HrbfData& data,
                                         const LocalFieldOptions& options) {
    if (data.kernel != kernel::Kind::triharmonic || data.count() < fewest_centres) return nullptr;
    LocalFieldOptions its = options;
    its.spacing = spacing_of(data);
    double before = std::numeric_limits<double>::infinity();
    for (int finer = 0; finer <= finest; ++finer) {
        const base::Stopwatch watch;
        its.finer = finer;
        auto prepared = std::make_unique<Prepared>(work, data, its);
        const Error error = prepared->error();
        work.runtime().log(
            base::LogLevel::info,
            "evaluation: %lld centres prepared in %.3f s, %.1f MB; errors: values %.1e diagonals, gradients %.1e",
            static_cast<long long>(data.count()), watch.seconds(), static_cast<double>(prepared->bytes()) / 1e6,
            error.value, error.gradient);
        const double allowed = (error.value > no_better * before ? slack_of_rounding : slack) * options.tolerance;
        if (error.value <= allowed && error.gradient <= gradients_share * allowed) return prepared;
        if (error.value >= before) break; // a finer field would not help, because the error comes from rounding
        before = error.value;
    }
    return nullptr;
}

Prepared::Prepared(const base::Work& work, const HrbfData& data, const LocalFieldOptions& options)
    : set_(work.instruction_set), data_(data),
      field_(work, data.centre_position, data.alpha.data(), data.beta, options) {
    measure_error(work);
}

std::int32_t Prepared::cell_of(const glm::dvec3& point) const noexcept {
    const std::int32_t cube = field_.cube_of({normalised(point.x, data_.centre.x, data_.scale),
                                              normalised(point.y, data_.centre.y, data_.scale),
                                              normalised(point.z, data_.centre.z, data_.scale)});
    return cube >= 0 ? cube : static_cast<std::int32_t>(field_.cubes());
}

// Evaluates sequences of consecutive points that lie in one cell. evaluate_all() sorts the points so that the sequences
// are long.
void Prepared::evaluate(const PointBatch& points, const FieldBatch& fields) const {
    std::int64_t begin = 0;
    std::int32_t cell = points.count > 0 ? cell_of({points.x[0], points.y[0], points.z[0]}) : 0;
    while (begin < points.count) {
        std::int64_t end = begin + 1;
        std::int32_t next = cell;
        for (; end < points.count; ++end) {
            next = cell_of({points.x[end], points.y[end], points.z[end]});
            if (next != cell) break;
        }
        evaluate_cell(cell, slice(points, begin, end), fields.from(begin));
        begin = end;
        cell = next;
    }
}

void Prepared::evaluate_cell(std::int32_t cell, const PointBatch& points, const FieldBatch& fields) const noexcept {
    if (cell == field_.cubes()) return implicit::evaluate(set_, data_, points, fields);
    Block block;
    double(&g)[3][block_size] = block.gradient;
    double(&h)[6][block_size] = block.hessian;
    for (std::int64_t begin = 0; begin < points.count; begin += block_size) {
        const std::int64_t count = std::min(block_size, points.count - begin);
        start(data_, slice(points, begin, begin + count), block);
        if (fields.wants_hessian())
            field_.add_jets(cell, {block.x,
                                   block.y,
                                   block.z,
                                   block.value,
                                   {g[0], g[1], g[2]},
                                   {h[0], h[1], h[2], h[3], h[4], h[5]},
                                   count});
        else
            field_.add(cell, {block.x, block.y, block.z, block.value, g[0], g[1], g[2], count});
        finish(data_, block, count, fields.from(begin));
    }
}

// Measures the errors by comparing with the sums over all centres, at places about a spacing away from centres.
void Prepared::measure_error(const base::Work& work) {
    const std::int64_t count = std::min(probes, data_.count());
    geometry::VecArray places(work.memory);
    for (std::int64_t k = 0; k < count; ++k) {
        const std::int64_t i = k * data_.count() / count;
        const std::array<double, 4> u = base::uniform4(0, static_cast<std::uint64_t>(i), base::Purpose::probe, 0);
        const glm::dvec3 off = 2.0 * glm::dvec3(u[0], u[1], u[2]) - 1.0;
        places.push_back(data_.centre + data_.scale * (data_.centre_position[i] + spacing_of(data_) * off));
    }
    base::Array<double> value(work.memory, 2 * count);
    geometry::VecArray gradient(work.memory, 2 * count);
    const FieldBatch quick{value.data(), {gradient.x.data(), gradient.y.data(), gradient.z.data()}, {}};
    evaluate_all(work, *this, places, quick);
    const FieldBatch plain = quick.from(count);
    work.for_chunks(count, block_size, [&](std::int64_t begin, std::int64_t end) {
        implicit::evaluate(set_, data_, slice({places.x.data(), places.y.data(), places.z.data(), count}, begin, end),
                           plain.from(begin));
    });
    for (std::int64_t k = 0; k < count; ++k) {
        error_.value = std::max(error_.value, std::abs(value[k] - value[count + k]) / diagonal());
        error_.gradient = std::max(error_.gradient, glm::distance(gradient[k], gradient[count + k]));
    }
}

} // namespace hrbfnpr::implicit
