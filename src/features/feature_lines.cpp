// SPDX-License-Identifier: MIT
#include "features/feature_lines.h"

#include "features/feature_chains.h"
#include "features/feature_refine.h"

#include <algorithm>
#include <array>
#include <utility>

namespace hrbfnpr::curves {
namespace {

// A chain whose strength by the vertices stays below this share of `upper` is not refined.
constexpr double promising = 0.7;
// In cells of the mesh: points of a line that are nearer to each other are one.
constexpr double least_gap = 1e-3;

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
        for (std::int64_t i = begin; i < end; ++i) value[i] = {g[static_cast<std::size_t>(i - begin)], 1.0};
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
    runtime.parallel.for_chunks(mesh.vertices(), 4096, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t i = begin; i < end; ++i)
            value[i] = requested_value(request, surface.shape[i], mesh.position[i], unit);
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
class FeatureCutter {
public:
    // `gap`: between the points of a line at least.
    FeatureCutter(const FeatureRequest& request, double diagonal, double gap, FeatureLines& lines) noexcept
        : request_(request), shortest_(request.shortest * diagonal), gap_(gap), lines_(lines) {}

    void cut(const FeatureChains& chains, const FeaturePoints& points, std::int32_t level) {
        for (std::int64_t c = 0; c < chains.chains(); ++c) {
            const std::int64_t first = chains.first[c];
            const std::int64_t count = chains.first[c + 1] - first;
            const bool closed = chains.closed[c] != 0;
            const auto at = [&](std::int64_t i) { return first + (i + count) % count; };
            for_parts(
                count, closed, [&](std::int64_t i) { return counts(points, first + i); },
                [&](std::int64_t begin, std::int64_t end, bool whole) {
                    if (!whole && (closed || begin > 0)) add_end(points, at(begin), at(begin - 1));
                    for (std::int64_t i = begin; i < end; ++i) add(points, at(i));
                    if (!whole && (closed || end < count)) add_end(points, at(end - 1), at(end));
                    finish(whole, level);
                });
        }
    }

private:
    [[nodiscard]] bool counts(const FeaturePoints& points, std::int64_t i) const noexcept {
        return points.strength[i] > 0.0 && points.strength[i] >= request_.lower && points.facing[i] >= 0.0 &&
               points.resolved[i] != 0;
    }
    // A vertex that the line passes is crossed by several edges: their points would say nothing of its direction.
    void add(const FeaturePoints& points, std::int64_t i) {
        const std::int64_t last = lines_.position.size() - 1;
        if (last >= lines_.first.back() && glm::distance(points.position[i], lines_.position[last]) < gap_) return;
        lines_.position.push_back(points.position[i]);
        lines_.normal.push_back(points.normal[i]);
        lines_.strength.push_back(points.strength[i]);
    }
    // Between a point that counts and one that does not, where the line ends by linear interpolation.
    void add_end(const FeaturePoints& points, std::int64_t inside, std::int64_t outside) {
        if (points.resolved[outside] == 0) return;
        const auto root = [](double in, double out) { return out < 0.0 && in >= 0.0 ? in / (in - out) : 1.0; };
        const double share =
            std::min(root(points.strength[inside] - request_.lower, points.strength[outside] - request_.lower),
                     root(points.facing[inside], points.facing[outside]));
        if (!(share > 0.0 && share < 1.0)) return;
        lines_.position.push_back(glm::mix(points.position[inside], points.position[outside], share));
        lines_.normal.push_back(glm::normalize(glm::mix(points.normal[inside], points.normal[outside], share)));
        lines_.strength.push_back(std::max(glm::mix(points.strength[inside], points.strength[outside], share), 0.0));
    }
    // What was added since the last line is one, unless it is too weak or too short.
    void finish(bool closed, std::int32_t level) {
        const std::int64_t begin = lines_.first.back();
        const std::int64_t end = lines_.position.size();
        double strongest = 0.0;
        double length = 0.0;
        for (std::int64_t i = begin; i < end; ++i) {
            strongest = std::max(strongest, lines_.strength[i]);
            if (i + 1 < end || closed)
                length += glm::distance(lines_.position[i], lines_.position[i + 1 < end ? i + 1 : begin]);
        }
        const bool weak = strongest < request_.upper;
        if (weak || length < shortest_ || end < begin + (closed ? 3 : 2)) {
            ++(weak ? lines_.weak : lines_.small);
            lines_.position.resize(begin);
            lines_.normal.resize(begin);
            lines_.strength.resize(begin);
            return;
        }
        lines_.first.push_back(end);
        lines_.closed.push_back(closed ? 1 : 0);
        lines_.level.push_back(level);
    }

    const FeatureRequest& request_;
    double shortest_;
    double gap_;
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
        // A ridge's curvature is least, that of the others largest.
        if (is_directed(request.kind)) chains = keep_extrema(chains, request.kind == FeatureKind::ridge ? 1.0 : -1.0);
        lines.weak += keep_promising(chains, request.upper);
        const FeaturePoints points = refine(runtime, surface, request, levels[k], value, chains.crossing, progress);
        for (const std::uint8_t resolved : points.resolved) lines.unresolved += resolved != 0 ? 0 : 1;
        FeatureCutter(request, surface.implicit.diagonal(), least_gap * surface.mesh.side, lines)
            .cut(chains, points, static_cast<std::int32_t>(k));
    }
    return lines;
}

SurfaceLines as_lines(base::Memory& memory, const FeatureLines& features) {
    SurfaceLines lines(memory);
    LineBuilder builder(lines);
    for (std::int64_t l = 0; l < features.lines(); ++l) {
        for (std::int64_t i = features.first[l]; i < features.first[l + 1]; ++i)
            builder.add(features.position[i], features.normal[i], features.strength[i]);
        builder.end(features.closed[l] != 0);
    }
    return lines;
}

} // namespace hrbfnpr::curves
