// SPDX-License-Identifier: MIT
#include "implicit/evaluate_all.h"

#include "implicit/lanes.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <numeric>

namespace hrbfnpr::implicit {
namespace {

// With more cells than this for each point, points are sorted by comparison and not by counting.
constexpr std::int64_t many_cells = 64;

// Points of a batch gathered from anywhere, and their fields.
struct GatheredBatch {
    PointLanes<std::size_t{batch_size}> points;
    FieldLanes<std::size_t{batch_size}> fields;
};

} // namespace

base::Array<std::int32_t> order_by_cell(const base::Work& work, const Implicit& implicit,
                                        const geometry::VecArray& points) {
    base::Array<std::int32_t> order(work.memory);
    const std::int64_t cells = implicit.cells();
    if (cells == 0 || points.size() > std::numeric_limits<std::int32_t>::max()) return order;
    base::Array<std::int32_t> cell(work.memory);
    cell.resize_for_overwrite(points.size());
    work.for_chunks(points.size(), 4096, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) cell[i] = implicit.cell_of(points[i]);
    });
    order.resize_for_overwrite(points.size());
    if (cells / many_cells > points.size()) { // sorting by counting visits every cell, and takes longer here
        std::iota(order.begin(), order.end(), 0);
        std::sort(order.begin(), order.end(),
                  [&](std::int32_t a, std::int32_t b) { return cell[a] != cell[b] ? cell[a] < cell[b] : a < b; });
        return order;
    }
    base::Array<std::int32_t> next(work.memory, cells + 1);
    for (const std::int32_t c : cell) ++next[c + 1];
    work.check();
    for (std::int64_t c = 0; c < cells; ++c) next[c + 1] += next[c];
    work.check();
    for (const std::int64_t i : work.over(points.size())) {
        order[next[cell[i]]++] = static_cast<std::int32_t>(i);
    }
    return order;
}

void evaluate_all(const base::Work& work, const Implicit& implicit, const geometry::VecArray& points,
                  const FieldBatch& fields) {
    const std::int64_t count = points.size();
    const base::Array<std::int32_t> order = order_by_cell(work, implicit, points);
    std::atomic<std::int64_t> done{0};
    implicit.threads(work).for_chunks(count, batch_size, [&](std::int64_t begin, std::int64_t end) {
        if (order.empty()) {
            implicit.evaluate(slice({points.x.data(), points.y.data(), points.z.data(), count}, begin, end),
                              fields.from(begin));
        } else {
            base::OwnedObject<GatheredBatch> some(work.memory);
            for (std::int64_t i = begin; i < end; ++i) some->points.add(points[order[i]], order[i]);
            implicit.evaluate(
                some->points.points(),
                some->fields.fields(fields.value != nullptr, fields.wants_gradient(), fields.wants_hessian()));
            some->fields.scatter(some->points.index, end - begin, fields);
        }
        const std::int64_t now = done.fetch_add(end - begin, std::memory_order_relaxed) + end - begin;
        work.update(static_cast<double>(now) / static_cast<double>(count));
    });
}

} // namespace hrbfnpr::implicit
