// SPDX-License-Identifier: MIT
#include "curves/mesh_chains.h"

#include <array>

namespace hrbfnpr::curves {
namespace {

constexpr std::int64_t chained_a_task = 8192;

// A triangle that the zero line passes through is left over the edge that goes from positive to negative in the
// triangle's own sense, and entered over the one that goes from negative to positive.
class Walk {
public:
    Walk(const SurfaceMesh& mesh, const base::Array<double>& level) noexcept : mesh_(mesh), level_(level) {}

    [[nodiscard]] bool crossed(std::int64_t triangle) const noexcept { return edge(triangle, true) >= 0; }
    [[nodiscard]] std::int64_t after(std::int64_t triangle) const noexcept {
        return mesh_.neighbour[3 * triangle + edge(triangle, true)];
    }
    [[nodiscard]] std::int64_t before(std::int64_t triangle) const noexcept {
        return mesh_.neighbour[3 * triangle + edge(triangle, false)];
    }
    [[nodiscard]] Crossing entry(std::int64_t triangle) const noexcept { return crossing(triangle, false); }
    [[nodiscard]] Crossing exit(std::int64_t triangle) const noexcept { return crossing(triangle, true); }

private:
    [[nodiscard]] std::int32_t corner(std::int64_t triangle, int k) const noexcept {
        return mesh_.corner[3 * triangle + k % 3];
    }
    [[nodiscard]] bool negative(std::int32_t vertex) const noexcept { return level_[vertex] < 0.0; }

    // -1: there is none.
    [[nodiscard]] int edge(std::int64_t triangle, bool leaving) const noexcept {
        for (int k = 0; k < 3; ++k) {
            const bool from = negative(corner(triangle, k));
            if (from != negative(corner(triangle, k + 1)) && from != leaving) return k;
        }
        return -1;
    }
    [[nodiscard]] Crossing crossing(std::int64_t triangle, bool leaving) const noexcept {
        const int k = edge(triangle, leaving);
        const std::int32_t from = corner(triangle, k);
        const std::int32_t to = corner(triangle, k + 1);
        const std::int32_t a = leaving ? to : from;
        const std::int32_t b = leaving ? from : to;
        const double drop = level_[b] - level_[a];
        return {a, b, drop > 0.0 ? -level_[a] / drop : 0.5};
    }

    const SurfaceMesh& mesh_;
    const base::Array<double>& level_;
};

// The triangles that are crossed, ascending.
base::Array<std::int32_t> crossed_triangles(const base::Runtime& runtime, const SurfaceMesh& mesh, const Walk& walk) {
    const std::int64_t tasks = (mesh.triangles() + chained_a_task - 1) / chained_a_task;
    base::Array<std::int32_t> found(runtime.memory, mesh.triangles());
    base::Array<std::int64_t> count(runtime.memory, tasks);
    runtime.parallel.for_chunks(mesh.triangles(), chained_a_task, [&](std::int64_t begin, std::int64_t end) {
        std::int64_t at = begin;
        for (std::int64_t t = begin; t < end; ++t)
            if (walk.crossed(t)) found[at++] = static_cast<std::int32_t>(t);
        count[begin / chained_a_task] = at - begin;
    });
    std::int64_t all = 0;
    for (std::int64_t task = 0; task < tasks; ++task)
        for (std::int64_t i = 0; i < count[task]; ++i) found[all++] = found[task * chained_a_task + i];
    found.resize(all);
    return found;
}

class Collector {
public:
    Collector(base::Memory& memory, const SurfaceMesh& mesh, const Walk& walk)
        : walk_(walk), taken_(memory, mesh.triangles()), chains_(memory) {
        chains_.first.push_back(0);
    }

    void open(std::int64_t triangle) {
        if (taken_[triangle] != 0 || walk_.before(triangle) >= 0) return;
        chains_.crossing.push_back(walk_.entry(triangle));
        for (std::int64_t t = triangle; t >= 0; t = walk_.after(t)) take(t);
        close(false);
    }
    void loop(std::int64_t triangle) {
        if (taken_[triangle] != 0) return;
        for (std::int64_t t = triangle; taken_[t] == 0; t = walk_.after(t)) take(t);
        close(true);
    }
    [[nodiscard]] MeshChains result() && { return std::move(chains_); }

private:
    void take(std::int64_t triangle) {
        taken_[triangle] = 1;
        chains_.crossing.push_back(walk_.exit(triangle));
    }
    void close(bool closed) {
        chains_.first.push_back(chains_.crossing.size());
        chains_.closed.push_back(closed ? 1 : 0);
    }

    const Walk& walk_;
    base::Array<std::uint8_t> taken_;
    MeshChains chains_;
};

} // namespace

MeshChains find_chains(const base::Runtime& runtime, const SurfaceMesh& mesh, const base::Array<double>& level) {
    const Walk walk(mesh, level);
    const base::Array<std::int32_t> crossed = crossed_triangles(runtime, mesh, walk);
    Collector collector(runtime.memory, mesh, walk);
    for (const std::int32_t t : crossed) collector.open(t);
    for (const std::int32_t t : crossed) collector.loop(t);
    return std::move(collector).result();
}

} // namespace hrbfnpr::curves
