// SPDX-License-Identifier: MIT
#include "implicit/evaluate_all.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <numeric>

namespace hrbfnpr::implicit {
namespace {

constexpr std::int64_t many_cells = 64; // for each point

using Column = std::array<double, static_cast<std::size_t>(batch_size)>;

// Points from all over, and their fields, side by side.
class Gathered {
public:
    Gathered(const geometry::VecArray& points, const std::int32_t* order, std::int64_t count) noexcept
        : order_(order), count_(count) {
        for (std::int64_t i = 0; i < count; ++i) {
            const glm::dvec3 p = points[order[i]];
            const auto lane = static_cast<std::size_t>(i);
            point_[0][lane] = p.x;
            point_[1][lane] = p.y;
            point_[2][lane] = p.z;
        }
    }

    void evaluate(const Implicit& implicit, const FieldBatch& fields) {
        FieldBatch here;
        std::size_t column = 0;
        const auto want = [&](double* to, double*& from) {
            if (to != nullptr) from = field_[column++].data();
        };
        want(fields.value, here.value);
        for (std::size_t c = 0; c < 3; ++c) want(fields.gradient[c], here.gradient[c]);
        for (std::size_t c = 0; c < 6; ++c) want(fields.hessian[c], here.hessian[c]);
        implicit.evaluate({point_[0].data(), point_[1].data(), point_[2].data(), count_}, here);
        scatter(here.value, fields.value);
        for (std::size_t c = 0; c < 3; ++c) scatter(here.gradient[c], fields.gradient[c]);
        for (std::size_t c = 0; c < 6; ++c) scatter(here.hessian[c], fields.hessian[c]);
    }

private:
    void scatter(const double* from, double* to) const noexcept {
        for (std::int64_t i = 0; to != nullptr && i < count_; ++i) to[order_[i]] = from[i];
    }

    const std::int32_t* order_;
    std::int64_t count_;
    std::array<Column, 3> point_;
    std::array<Column, 10> field_;
};

} // namespace

base::Array<std::int32_t> order_by_cell(const base::Runtime& runtime, const Implicit& implicit,
                                        const geometry::VecArray& points, const base::Progress& progress) {
    base::Array<std::int32_t> order(runtime.memory);
    const std::int64_t cells = implicit.cells();
    if (cells == 0 || points.size() > std::numeric_limits<std::int32_t>::max()) return order;
    base::Array<std::int32_t> cell(runtime.memory);
    cell.resize_for_overwrite(points.size());
    runtime.parallel.for_chunks(points.size(), 4096, progress, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) cell[i] = implicit.cell_of(points[i]);
    });
    order.resize_for_overwrite(points.size());
    if (cells / many_cells > points.size()) { // to pass over them all would take longer
        std::iota(order.begin(), order.end(), 0);
        std::sort(order.begin(), order.end(),
                  [&](std::int32_t a, std::int32_t b) { return cell[a] != cell[b] ? cell[a] < cell[b] : a < b; });
        return order;
    }
    base::Array<std::int32_t> next(runtime.memory, cells + 1);
    for (const std::int32_t c : cell) ++next[c + 1];
    progress.check();
    for (std::int64_t c = 0; c < cells; ++c) next[c + 1] += next[c];
    progress.check();
    for (std::int64_t i = 0; i < points.size(); ++i) {
        if (i % 65536 == 0) progress.check();
        order[next[cell[i]]++] = static_cast<std::int32_t>(i);
    }
    return order;
}

void evaluate_all(const base::Runtime& runtime, const Implicit& implicit, const geometry::VecArray& points,
                  const FieldBatch& fields, const base::Progress& progress) {
    const std::int64_t count = points.size();
    const base::Array<std::int32_t> order = order_by_cell(runtime, implicit, points, progress);
    std::atomic<std::int64_t> done{0};
    implicit.threads(runtime.parallel).for_chunks(count, batch_size, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        if (order.empty())
            implicit.evaluate(slice({points.x.data(), points.y.data(), points.z.data(), count}, begin, end),
                              fields.from(begin));
        else
            base::Boxed<Gathered>(runtime.memory, points, order.data() + begin, end - begin)
                ->evaluate(implicit, fields);
        const std::int64_t now = done.fetch_add(end - begin, std::memory_order_relaxed) + end - begin;
        progress.update(static_cast<double>(now) / static_cast<double>(count));
    });
}

} // namespace hrbfnpr::implicit
