// SPDX-License-Identifier: MIT
#include "surface/region.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>

namespace hrbfnpr::surface {
namespace {

// The batch is small because sums over 100 000 centres take long.
constexpr std::int64_t region_batch = implicit::batch_size / 4;
using RegionColumn = std::array<double, static_cast<std::size_t>(region_batch)>;

constexpr std::int64_t grid_side = 24;
constexpr std::int64_t grid_size = grid_side * grid_side * grid_side;
constexpr double safety = 1.5;

// Returns node i of the grid. Its outermost nodes are on the faces of the region.
glm::dvec3 grid_node(const geometry::Bounds& region, std::int64_t i) noexcept {
    const std::int64_t row = i / grid_side;
    const std::int64_t layer = row / grid_side;
    const glm::dvec3 step(static_cast<double>(i % grid_side), static_cast<double>(row % grid_side),
                          static_cast<double>(layer));
    return region.min + step / static_cast<double>(grid_side - 1) * region.size();
}

// Returns the largest finite |grad f| at the nodes [begin, end), which are at most a batch.
double largest_gradient(const implicit::Implicit& implicit, const geometry::Bounds& region, std::int64_t begin,
                        std::int64_t end) {
    RegionColumn x, y, z, gx, gy, gz;
    for (std::int64_t i = begin; i < end; ++i) {
        const auto lane = static_cast<std::size_t>(i - begin);
        const glm::dvec3 p = grid_node(region, i);
        x[lane] = p.x;
        y[lane] = p.y;
        z[lane] = p.z;
    }
    implicit::FieldBatch fields;
    fields.gradient = {gx.data(), gy.data(), gz.data()};
    implicit.evaluate({x.data(), y.data(), z.data(), end - begin}, fields);
    double most = 0.0;
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(end - begin); ++lane) {
        const double slope = glm::length(glm::dvec3(gx[lane], gy[lane], gz[lane]));
        if (std::isfinite(slope)) most = std::max(most, slope);
    }
    return most;
}

// Writes the results for the points [begin, end), which are at most a batch.
void contains_batch(const implicit::Implicit& implicit, const geometry::Bounds& region,
                    const geometry::VecArray& points, base::Array<std::uint8_t>& inside, std::int64_t begin,
                    std::int64_t end) {
    RegionColumn x, y, z, f;
    std::array<std::int64_t, static_cast<std::size_t>(region_batch)> which;
    std::size_t count = 0;
    for (std::int64_t i = begin; i < end; ++i) {
        const glm::dvec3 p = points[i];
        inside[i] = 0;
        if (!region.contains(p)) continue;
        x[count] = p.x;
        y[count] = p.y;
        z[count] = p.z;
        which[count++] = i;
    }
    if (count == 0) return;
    implicit::FieldBatch fields;
    fields.value = f.data();
    implicit.evaluate({x.data(), y.data(), z.data(), static_cast<std::int64_t>(count)}, fields);
    for (std::size_t lane = 0; lane < count; ++lane) inside[which[lane]] = f[lane] < 0.0 ? 1 : 0;
}

} // namespace

geometry::Bounds search_region(const implicit::Implicit& implicit) noexcept {
    return implicit.bounds().grown(region_margin * implicit.diagonal());
}

double lipschitz_estimate(const base::Work& work, const implicit::Implicit& implicit) {
    if (implicit.lipschitz() > 0.0) return implicit.lipschitz();
    constexpr std::int64_t chunks = (grid_size + region_batch - 1) / region_batch;
    const geometry::Bounds region = search_region(implicit);
    std::array<double, static_cast<std::size_t>(chunks)> most{};
    std::atomic<std::int64_t> done{0};
    implicit.threads(work).for_chunks(grid_size, region_batch, [&](std::int64_t begin, std::int64_t end) {
        most[static_cast<std::size_t>(begin / region_batch)] = largest_gradient(implicit, region, begin, end);
        const std::int64_t now = done.fetch_add(end - begin, std::memory_order_relaxed) + end - begin;
        work.update(static_cast<double>(now) / static_cast<double>(grid_size));
    });
    const double estimate = safety * *std::max_element(most.begin(), most.end());
    return std::clamp(estimate, std::numeric_limits<double>::min(), std::numeric_limits<double>::max());
}

void contains(const base::Work& work, const implicit::Implicit& implicit, const geometry::VecArray& points,
              base::Array<std::uint8_t>& inside) {
    const std::int64_t count = points.size();
    const geometry::Bounds region = search_region(implicit);
    inside.resize(count);
    std::atomic<std::int64_t> done{0};
    implicit.threads(work).for_chunks(count, region_batch, [&](std::int64_t begin, std::int64_t end) {
        contains_batch(implicit, region, points, inside, begin, end);
        const std::int64_t now = done.fetch_add(end - begin, std::memory_order_relaxed) + end - begin;
        work.update(static_cast<double>(now) / static_cast<double>(count));
    });
}

} // namespace hrbfnpr::surface
