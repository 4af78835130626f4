// SPDX-License-Identifier: MIT
// Tests whether a place is near any of many points.
#pragma once

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace bench {

class NearPoints {
public:
    // points: packed x y z.
    NearPoints(std::vector<double> points, double side) : points_(std::move(points)), side_(side) {
        for (std::size_t i = 0; i < points_.size(); i += 3) cells_[cell(points_.data() + i, 0, 0, 0)].push_back(i);
    }

    [[nodiscard]] bool is_within(const double* p, double distance) const {
        return !visit(p, distance, [](std::size_t, double) { return false; });
    }

    // Calls see(i, distance) for each point within `distance` until see returns false; returns whether it never did.
    template <class See>
    bool visit(const double* p, double distance, See&& see) const {
        const int reach = static_cast<int>(std::ceil(distance / side_));
        for (int x = -reach; x <= reach; ++x)
            for (int y = -reach; y <= reach; ++y)
                for (int z = -reach; z <= reach; ++z) {
                    const auto found = cells_.find(cell(p, x, y, z));
                    if (found == cells_.end()) continue;
                    for (const std::size_t i : found->second) {
                        const double there =
                            std::hypot(points_[i] - p[0], points_[i + 1] - p[1], points_[i + 2] - p[2]);
                        if (there <= distance && !see(i / 3, there)) return false;
                    }
                }
        return true;
    }

private:
    [[nodiscard]] std::uint64_t cell(const double* p, int x, int y, int z) const {
        const auto along = [&](double at, int step) {
            return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(at / side_)) + step) & 0x1FFFFFU;
        };
        return along(p[0], x) | along(p[1], y) << 21U | along(p[2], z) << 42U;
    }

    std::vector<double> points_;
    double side_;
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
};

} // namespace bench
