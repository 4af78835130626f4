// SPDX-License-Identifier: MIT
#include "curves/feature_lines.h"

#include "curves/feature_chains.h"
#include "curves/feature_refine.h"

#include <algorithm>
#include <array>
#include <utility>

namespace hrbfnpr::curves {
namespace {

// A chain whose strength by the vertices stays below this share of `upper` is not refined.
constexpr double promising = 0.7;

void value_by_place(const base::Runtime& runtime, const SurfaceMesh& mesh, const FeatureRequest& request,
                    base::Array<FeatureValue>& value, const base::Progress& progress) {
    const bool section = request.kind == FeatureKind::section;
    const bool concurrent = section || request.function->concurrent();
    const base::Parallel threads = concurrent ? runtime.parallel : base::Parallel();
    threads.for_chunks(mesh.vertices(), implicit::batch_size, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        std::array<double, static_cast<std::size_t>(implicit::batch_size)> g;
        if (section)
            for (std::int64_t i = begin; i < end; ++i)
                g[static_cast<std::size_t>(i - begin)] = glm::dot(request.plane, mesh.position[i]);
        else
            request.function->evaluate({mesh.position.x.data() + begin, mesh.position.y.data() + begin,
                                        mesh.position.z.data() + begin, end - begin},
                                       g.data());
        for (std::int64_t i = begin; i < end; ++i)
            value[i] = {g[static_cast<std::size_t>(i - begin)], 1.0, glm::dvec3(0.0)};
    });
}

// At the vertices, by what is held of them.
base::Array<FeatureValue> vertex_values(const base::Runtime& runtime, const FeatureSurface& surface,
                                        const FeatureRequest& request, const base::Progress& progress) {
    const SurfaceMesh& mesh = surface.mesh;
    base::Array<FeatureValue> value(runtime.memory);
    value.resize_for_overwrite(mesh.vertices());
    if (!needs_shape(request.kind)) {
        value_by_place(runtime, mesh, request, value, progress);
        return value;
    }
    const double unit = surface.implicit.diagonal();
    const bool one_side = depends_on_view(request.kind) && !request.far_side;
    const glm::dvec3 eye(request.towards);
    runtime.parallel.for_chunks(mesh.vertices(), 4096, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t i = begin; i < end; ++i) {
            const glm::dvec3 p = mesh.position[i];
            value[i] = feature_value(request.kind, surface.shape[i], p, request.towards, unit);
            if (one_side && glm::dot(surface.shape[i].normal, eye - request.towards.w * p) < 0.0)
                value[i].strength = -1.0;
        }
    });
    return value;
}

// The chains that may become lines, in place; returns how many do not.
std::int64_t keep_promising(FeatureChains& chains, double upper) noexcept {
    std::int64_t kept = 0;
    std::int64_t to = 0;
    for (std::int64_t c = 0; c < chains.chains(); ++c) {
        const std::int64_t begin = chains.first[c];
        const std::int64_t end = chains.first[c + 1];
        double strongest = 0.0;
        for (std::int64_t i = begin; i < end; ++i) strongest = std::max(strongest, chains.crossing[i].strength);
        if (strongest < promising * upper) continue;
        for (std::int64_t i = begin; i < end; ++i) chains.crossing[to + i - begin] = chains.crossing[i];
        chains.first[kept] = to; // not after `begin`, which was read
        chains.closed[kept++] = chains.closed[c];
        to += end - begin;
    }
    const std::int64_t left = chains.chains() - kept;
    chains.first[kept] = to;
    chains.first.resize(kept + 1);
    chains.closed.resize(kept);
    chains.crossing.resize(to);
    return left;
}

// Cuts refined chains where they are too weak, and adds what is strong and long enough to the lines.
class Cutter {
public:
    Cutter(const FeatureRequest& request, double diagonal, FeatureLines& lines) noexcept
        : request_(request), shortest_(request.shortest * diagonal), lines_(lines) {}

    void cut(const FeatureChains& chains, const FeaturePoints& points, std::int32_t level) {
        for (std::int64_t c = 0; c < chains.chains(); ++c)
            cut(points, chains.first[c], chains.first[c + 1] - chains.first[c], chains.closed[c] != 0, level);
    }

private:
    [[nodiscard]] bool goes_on(double strength) const noexcept { return strength > 0.0 && strength >= request_.lower; }

    void cut(const FeaturePoints& points, std::int64_t first, std::int64_t count, bool closed, std::int32_t level) {
        const auto at = [&](std::int64_t i) { return first + i % count; };
        std::int64_t start = 0;
        while (closed && start < count && goes_on(points.strength[at(start)])) ++start;
        if (closed && start == count) {
            add(points, first, count, 0, count, true, level);
            return;
        }
        // A closed one begins after the place where it is cut.
        for (std::int64_t i = start; i < start + count;) {
            std::int64_t end = i;
            while (end < start + count && goes_on(points.strength[at(end)])) ++end;
            if (end > i + 1) add(points, first, count, i, end, false, level);
            i = end + 1;
        }
    }
    void add(const FeaturePoints& points, std::int64_t first, std::int64_t count, std::int64_t begin, std::int64_t end,
             bool closed, std::int32_t level) {
        double strongest = 0.0;
        double length = 0.0;
        for (std::int64_t i = begin; i < end; ++i) {
            const std::int64_t at = first + i % count;
            strongest = std::max(strongest, points.strength[at]);
            if (i + 1 < end || closed)
                length += glm::distance(points.position[at], points.position[first + (i + 1) % count]);
        }
        if (strongest < request_.upper) {
            ++lines_.weak;
            return;
        }
        if (length < shortest_ || end < begin + (closed ? 3 : 2)) {
            ++lines_.small;
            return;
        }
        for (std::int64_t i = begin; i < end; ++i) {
            const std::int64_t at = first + i % count;
            lines_.position.push_back(points.position[at]);
            lines_.normal.push_back(points.normal[at]);
            lines_.strength.push_back(points.strength[at]);
        }
        lines_.first.push_back(lines_.position.size());
        lines_.closed.push_back(closed ? 1 : 0);
        lines_.level.push_back(level);
    }

    const FeatureRequest& request_;
    double shortest_;
    FeatureLines& lines_;
};

FeaturePoints refine(const base::Runtime& runtime, const FeatureSurface& surface, const FeatureRequest& request,
                     double level, const base::Array<FeatureValue>& value, const base::Array<FeatureCrossing>& crossing,
                     const base::Progress& progress) {
    if (request.kind == FeatureKind::section)
        return refine_section(runtime, surface, request.plane, level, crossing, progress);
    FeaturePoints points = refine_crossings(runtime, surface, request, level, value, crossing, progress);
    if (request.kind == FeatureKind::ridge || request.kind == FeatureKind::valley)
        weigh_by_drop(runtime, surface, request.kind, points, progress);
    return points;
}

} // namespace

FeatureLines find_feature_lines(const base::Runtime& runtime, const FeatureSurface& surface,
                                const FeatureRequest& request, const base::Progress& progress) {
    FeatureLines lines(runtime.memory);
    lines.kind = request.kind;
    lines.first.push_back(0);
    base::Array<FeatureValue> value = vertex_values(runtime, surface, request, progress);
    const bool has_levels = !needs_shape(request.kind) || request.kind == FeatureKind::isophote;
    constexpr std::array<double, 1> zero = {0.0};
    const std::span<const double> levels = has_levels ? request.levels : std::span<const double>(zero);
    double before = 0.0;
    for (std::size_t k = 0; k < levels.size(); ++k) {
        progress.update(static_cast<double>(k) / static_cast<double>(levels.size()));
        for (FeatureValue& v : value) v.g += before - levels[k];
        before = levels[k];
        FeatureChains chains =
            find_feature_chains(runtime, surface.mesh, value, is_directed(request.kind), request.lower, progress);
        lines.weak += keep_promising(chains, request.upper);
        const FeaturePoints points = refine(runtime, surface, request, levels[k], value, chains.crossing, progress);
        lines.unresolved += points.unresolved;
        Cutter(request, surface.implicit.diagonal(), lines).cut(chains, points, static_cast<std::int32_t>(k));
    }
    return lines;
}

} // namespace hrbfnpr::curves
