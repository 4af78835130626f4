// SPDX-License-Identifier: MIT
#include "frame/hatch/strokes.h"

#include "base/assert.h"
#include "base/scratch.h"
#include "frame/hatch/tuning.h"
#include "geometry/segment.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::frame {

using drawing::Dot;
using drawing::StrokePoint;

namespace {

constexpr float cell_side = 16.0F; // in pixels
// A long edge is cut into at most this many pieces.
constexpr float most_pieces = 4096.0F;

[[nodiscard]] glm::vec2 place(const Dot& dot) noexcept { return {dot.x, dot.y}; }

[[nodiscard]] float cross(const glm::vec2& a, const glm::vec2& b) noexcept { return a.x * b.y - a.y * b.x; }

// Returns the width of the halo of an edge that is nearer than a line by `before` pixels.
[[nodiscard]] float halo_of(float before, float halo) noexcept {
    return std::max(
        hatch_tuning.edge_gap,
        halo * std::clamp((before - scene_tuning.halo_gap) / ((hatch_tuning.full_halo - 1.0F) * scene_tuning.halo_gap),
                          0.0F, 1.0F));
}

// The vector `way` starts at p, which is outside the disc. Returns the share of its length at which it enters the disc.
[[nodiscard]] float entry_of_disc(const glm::vec2& p, const glm::vec2& way, const glm::vec2& centre,
                                  float radius) noexcept {
    const glm::vec2 from = p - centre;
    const float square = glm::dot(way, way);
    const float half = glm::dot(from, way);
    const float root = half * half - square * (glm::dot(from, from) - radius * radius);
    return half < 0.0F && root >= 0.0F ? (-half - std::sqrt(root)) / square : NearerEdges::nowhere;
}

// The vector `way` starts at p. Returns the share of its length at which it enters the strip of all points within
// `radius` of a segment. The strip has a half disc at each end.
[[nodiscard]] float entry_of_strip(const glm::vec2& p, const glm::vec2& way, const glm::vec2& from, const glm::vec2& to,
                                   float radius) noexcept {
    const glm::vec2 along = to - from;
    const float length = glm::length(along);
    float first = std::min(entry_of_disc(p, way, from, radius), entry_of_disc(p, way, to, radius));
    if (!(length > 0.0F)) return first;
    const glm::vec2 u = along / length;
    const glm::vec2 v(-u.y, u.x);
    const float side = glm::dot(p - from, v);
    const float share = (std::copysign(radius, side) - side) / glm::dot(way, v);
    if (std::abs(side) > radius && share >= 0.0F) {
        const float at = glm::dot(p + share * way - from, u);
        if (at >= 0.0F && at <= length) first = std::min(first, share);
    }
    return first;
}

// Returns how much nearer to the eye than `depth` the edge is, in pixels, at its point closest to `at`.
[[nodiscard]] float nearer_at(const NearerEdge& edge, const glm::vec2& at, float depth,
                              float pixels_per_unit) noexcept {
    const float share = geometry::nearest_parameter(at, edge.a, edge.b);
    return (depth - edge.depth_a - share * (edge.depth_b - edge.depth_a)) * pixels_per_unit;
}

// Returns how much nearer to the eye an edge is than the line from a to b, in pixels. Both are extended to the place
// where they cross. So for an edge of the line's own surface the result is 0, however steep the surface is.
[[nodiscard]] float nearer_on(const NearerEdge& edge, const Dot& a, const Dot& b) noexcept {
    const glm::vec2 way = place(b) - place(a);
    const glm::vec2 along = edge.b - edge.a;
    const glm::vec2 to = edge.a - place(a);
    const float turn = cross(way, along);
    const float share = cross(to, along) / turn;
    const float edge_share = cross(to, way) / turn;
    const float length = glm::length(along);
    if (std::abs(share) * glm::length(way) <= hatch_tuning.farthest_crossing &&
        std::abs(edge_share - 0.5F) * length <= hatch_tuning.farthest_crossing + 0.5F * length)
        return (a.depth + share * (b.depth - a.depth) - edge.depth_a - edge_share * (edge.depth_b - edge.depth_a)) *
               a.pixels_per_unit;
    return nearer_at(edge, place(a), a.depth, a.pixels_per_unit) -
           hatch_tuning.steepest_slope * geometry::distance_to_segment(place(a), edge.a, edge.b);
}

} // namespace

glm::ivec4 NearerEdges::cells(const glm::vec2& low, const glm::vec2& high) const noexcept {
    const auto cell = [](float at, std::int32_t count) {
        return static_cast<std::int32_t>(std::clamp(at / cell_side, 0.0F, static_cast<float>(count - 1)));
    };
    return {cell(low.x - corner_.x, columns_), cell(low.y - corner_.y, rows_), cell(high.x - corner_.x, columns_) + 1,
            cell(high.y - corner_.y, rows_) + 1};
}

// Divides the edge into pieces no longer than a cell, so that the bounding boxes of pieces touch few cells that the
// edge does not cross.
template <class F>
void NearerEdges::for_cells_of(const NearerEdge& edge, const F& f) const {
    const auto pieces = 1 + static_cast<std::int32_t>(std::min(glm::distance(edge.a, edge.b) / cell_side, most_pieces));
    for (std::int32_t i = 0; i < pieces; ++i) {
        const auto at = [&](std::int32_t k) {
            return edge.a + static_cast<float>(k) / static_cast<float>(pieces) * (edge.b - edge.a);
        };
        const glm::ivec4 own = cells(glm::min(at(i), at(i + 1)), glm::max(at(i), at(i + 1)));
        for (std::int32_t row = own.y; row < own.w; ++row)
            for (std::int32_t column = own.x; column < own.z; ++column) f(row * columns_ + column);
    }
}

template <class F>
void NearerEdges::for_near(const glm::vec2& low, const glm::vec2& high, const F& f) const {
    const glm::ivec4 own = cells(low, high);
    for (std::int32_t row = own.y; row < own.w; ++row)
        for (std::int32_t column = own.x; column < own.z; ++column)
            for (std::int32_t i = first_[row * columns_ + column]; i < first_[row * columns_ + column + 1]; ++i)
                f(edges_[numbers_[i]]);
}

void NearerEdges::build(const LineStrokes& lines, std::span<const drawing::Layer> layers, const glm::vec4& picture) {
    corner_ = glm::vec2(picture);
    columns_ = 1 + static_cast<std::int32_t>(picture.z / cell_side);
    rows_ = 1 + static_cast<std::int32_t>(picture.w / cell_side);
    const glm::vec2 low = corner_ - cell_side;
    const glm::vec2 high = corner_ + glm::vec2(picture.z, picture.w) + cell_side;
    edges_.clear();
    for (const drawing::Stroke& stroke : lines.strokes) {
        if (stroke.hidden_layers > 0) continue;
        const drawing::Layer& layer = layers[stroke.layer];
        const bool is_crease = layer.line_kind == static_cast<std::uint32_t>(LineKind::crease);
        const StrokePoint* const point = lines.points.data() + stroke.first;
        for (std::int32_t i = 0; i + 1 < stroke.count; ++i) {
            const NearerEdge edge{{point[i].x, point[i].y},
                                  {point[i + 1].x, point[i + 1].y},
                                  point[i].depth,
                                  point[i + 1].depth,
                                  is_crease,
                                  std::max(point[i].radius, point[i + 1].radius)};
            if (glm::all(glm::lessThan(glm::min(edge.a, edge.b), high)) &&
                glm::all(glm::greaterThan(glm::max(edge.a, edge.b), low)))
                edges_.push_back(edge);
        }
    }
    // The count of a cell is stored in first_[cell + 2], and becomes a sum. The loop that fills `numbers_` advances
    // first_[cell + 1]. So in the end, first_[cell] is the beginning of the cell.
    base::resize_scratch(first_, std::int64_t{columns_} * rows_ + 2);
    std::fill(first_.begin(), first_.end(), 0);
    for (const NearerEdge& edge : edges_) for_cells_of(edge, [&](std::int32_t cell) { ++first_[cell + 2]; });
    for (std::int64_t i = 2; i < first_.size(); ++i) first_[i] += first_[i - 1];
    base::resize_scratch(numbers_, first_[first_.size() - 1]);
    for (std::int64_t i = 0; i < edges_.size(); ++i)
        for_cells_of(edges_[i],
                     [&](std::int32_t cell) { numbers_[first_[cell + 1]++] = static_cast<std::int32_t>(i); });
}

bool NearerEdges::is_near(const Dot& dot, float reach, float halo) const noexcept {
    const glm::vec2 at = place(dot);
    const float most = std::max(reach, halo);
    bool found = false;
    for_near(at - most, at + most, [&](const NearerEdge& edge) {
        const float square = geometry::squared_distance_to_segment(at, edge.a, edge.b);
        if (found || square > most * most) return;
        const float nearer = nearer_at(edge, at, dot.depth, dot.pixels_per_unit);
        const float limit = std::max(reach, halo_of(nearer, halo));
        found = nearer > hatch_tuning.least_depth_gap && square <= limit * limit;
    });
    return found;
}

float NearerEdges::width_near(const glm::vec2& at, float reach) const noexcept {
    float widest = 0.0F;
    if (empty()) return widest;
    for_near(at - reach, at + reach, [&](const NearerEdge& edge) {
        if (geometry::distance_to_segment(at, edge.a, edge.b) <= reach) widest = std::max(widest, 2.0F * edge.radius);
    });
    return widest;
}

float NearerEdges::entry(const Dot& a, const Dot& b, float halo) const noexcept {
    const glm::vec2 from = place(a);
    const glm::vec2 way = place(b) - from;
    const float length = glm::length(way);
    if (!(length > 0.0F)) return nowhere;
    const float reach = length + std::max(halo, hatch_tuning.edge_gap);
    float first = nowhere;
    for_near(from - reach, from + reach, [&](const NearerEdge& edge) {
        const float square = geometry::squared_distance_to_segment(from, edge.a, edge.b);
        if (square > reach * reach) return;
        const float nearer = nearer_on(edge, a, b);
        const float radius = halo_of(nearer, halo);
        if (nearer > hatch_tuning.least_depth_gap && square > radius * radius)
            first = std::min(first, entry_of_strip(from, way, edge.a, edge.b, radius));
    });
    return first <= 1.0F ? first : nowhere;
}

float NearerEdges::clear_width(const StrokePoint& point, const glm::vec2& along, float radius,
                               float halo) const noexcept {
    const float way = glm::length(along);
    if (!(way > 0.0F)) return radius;
    const glm::vec2 at(point.x, point.y);
    const glm::vec2 u = along / way;
    const float reach = radius + std::max(halo, hatch_tuning.edge_gap);
    float least = radius;
    for_near(at - reach, at + reach, [&](const NearerEdge& edge) {
        // An edge counts only if it crosses the perpendicular to the line at the point.
        const float from = glm::dot(edge.a - at, u);
        const float to = glm::dot(edge.b - at, u);
        if (from * to > 0.0F || from == to) return;
        const float share = from / (from - to);
        const float aside = std::abs(cross(u, edge.a + share * (edge.b - edge.a) - at));
        if (aside > reach) return;
        const float own = hatch_tuning.least_depth_gap + hatch_tuning.steepest_slope * aside;
        const float nearer =
            (point.depth - edge.depth_a - share * (edge.depth_b - edge.depth_a)) * point.pixels_per_unit;
        if (!(nearer > own) && !(edge.is_crease && nearer > -own)) return;
        const float cosine = std::abs(to - from) / glm::distance(edge.a, edge.b);
        const float along_edge =
            std::clamp((cosine - hatch_tuning.across_cosine) / (hatch_tuning.along_cosine - hatch_tuning.across_cosine),
                       0.0F, 1.0F);
        const float free = nearer > own ? aside - halo_of(nearer - own, halo) : aside;
        least = std::min(least, std::lerp(radius, std::max(free, 0.0F), along_edge));
    });
    return least;
}

namespace {

// A line, with the visibility of its samples, and the edges that hide it.
struct SeenLine {
    const Hiding& hiding;
    float halo;
    std::span<Dot> dots;
    const base::Array<float>& length;

    [[nodiscard]] std::int64_t size() const noexcept { return static_cast<std::int64_t>(dots.size()); }
    [[nodiscard]] Dot& operator[](std::int64_t i) const noexcept {
        HRBFNPR_ASSERT(i >= 0 && i < size());
        return dots[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] bool seen(std::int64_t i) const noexcept { return (*this)[i].opacity > 0.0F; }
    [[nodiscard]] bool is_near(std::int64_t i, float reach) const noexcept {
        return hiding.edges.is_near((*this)[i], reach, halo);
    }
    // Returns the distance from an edge within which splats may wrongly hide a sample.
    [[nodiscard]] float reach_of_splats(std::int64_t i) const noexcept {
        const drawing::Tiles& tiles = hiding.drawing.dot_tiles;
        const glm::vec2 at = place((*this)[i]) - glm::vec2(hiding.drawing.first_pixel);
        const std::int64_t tile = tile_of(at.y, tiles.rows()) * tiles.columns() + tile_of(at.x, tiles.columns());
        const float splat = hiding.largest_splat.empty() ? 0.0F : hiding.largest_splat[static_cast<std::size_t>(tile)];
        return std::min(splat + hatch_tuning.splat_margin, hatch_tuning.farthest_hidden);
    }
    // Returns whether splats may wrongly hide the sample.
    [[nodiscard]] bool may_be_seen(std::int64_t i) const noexcept { return is_near(i, reach_of_splats(i)); }
};

// A range [first, end) of hidden samples, between the seen samples [seen, first) and [end, next).
struct Gap {
    std::int64_t seen, first, end, next;
};

// Returns whether splats hide the gap by mistake. Near a crease, they may belong to the line's own surface. The gap is
// a mistake if it is short or splats may be wrong at all of its samples, and if no edge hides the line in the gap.
[[nodiscard]] bool is_mistake(const SeenLine& line, const Gap& gap) noexcept {
    const bool is_short = line.length[gap.end - 1] - line.length[gap.first] <= line.reach_of_splats(gap.first);
    for (std::int64_t i = gap.first; i < gap.end; ++i)
        if (!is_short && !line.may_be_seen(i)) return false;
    for (std::int64_t i = std::max<std::int64_t>(gap.first - 1, 0); i < std::min(gap.end, line.size() - 1); ++i)
        if (line.hiding.edges.entry(line[i], line[i + 1], line.halo) <= 1.0F) return false;
    return true;
}

// Finds the cut near sample `last`, which is the last seen sample before a gap in the direction `way` (1 or -1). The
// search begins at a sample far from all edges, but not before `first_seen`, and ends at `last_hidden`.
[[nodiscard]] HatchCut search(const SeenLine& line, std::int64_t last, std::int64_t way, std::int64_t first_seen,
                              std::int64_t last_hidden) noexcept {
    std::int64_t i = last;
    while (i != first_seen &&
           ((last - i) * way < hatch_tuning.samples_back || line.is_near(i, hatch_tuning.edge_reach)))
        i -= way;
    for (; i != last_hidden; i += way) {
        if ((i - last) * way > 0 && !line.may_be_seen(i)) break;
        const float share = line.hiding.edges.entry(line[i], line[i + way], line.halo);
        if (share <= 1.0F)
            return {std::min(i, i + way), line.length[i] + share * (line.length[i + way] - line.length[i])};
    }
    return {};
}

// Makes the samples up to the cut seen, and the samples after it hidden.
void apply(const SeenLine& line, const HatchCut& cut, std::int64_t last, std::int64_t way) noexcept {
    const std::int64_t end = way > 0 ? cut.before : cut.before + 1; // the last seen sample after the change
    const float opacity = line[last].opacity;
    for (std::int64_t i = last; (end - i) * way > 0; i += way) line[i + way].opacity = opacity;
    for (std::int64_t i = last; (i - end) * way > 0; i -= way) line[i].opacity = 0.0F;
}

// Finds the cuts at both ends of a gap, or closes the gap. Returns the beginning of the seen part after the gap. For a
// closed gap, this is the beginning of the seen part before the gap.
std::int64_t cut_gap(const SeenLine& line, const Gap& gap, base::Array<HatchCut>& cuts) {
    HatchCut ends, begins;
    if (gap.first > gap.seen) ends = search(line, gap.first - 1, 1, (gap.seen + gap.first - 1) / 2, gap.end - 1);
    if (gap.end < line.size()) begins = search(line, gap.end, -1, (gap.end + gap.next - 1) / 2, gap.first);
    const bool touched = ends.any() && begins.any() && !(ends.before < begins.before);
    if (touched || (!ends.any() && !begins.any())) {
        if (!touched && (gap.end - gap.first == line.size() || !is_mistake(line, gap))) return gap.end;
        const float opacity = line[gap.first > 0 ? gap.first - 1 : gap.end].opacity;
        for (std::int64_t i = gap.first; i < gap.end; ++i) line[i].opacity = opacity;
        return gap.seen;
    }
    if (ends.any()) {
        apply(line, ends, gap.first - 1, 1);
        cuts.push_back(ends);
    }
    if (!begins.any()) return gap.end;
    apply(line, begins, gap.end, -1);
    cuts.push_back(begins);
    return begins.before + 1;
}

} // namespace

void find_cuts(const Hiding& hiding, float halo, std::span<Dot> dots, const base::Array<float>& length,
               base::Array<HatchCut>& cuts) {
    HRBFNPR_ASSERT(length.size() == static_cast<std::int64_t>(dots.size()));
    const SeenLine line{hiding, std::min(halo, hatch_tuning.widest_halo), dots, length};
    cuts.clear();
    std::int64_t begin = 0;
    for (std::int64_t i = 0; i < line.size(); ++i) {
        if (line.seen(i)) continue;
        Gap gap{begin, i, i, i};
        while (gap.end < line.size() && !line.seen(gap.end)) ++gap.end;
        gap.next = gap.end;
        while (gap.next < line.size() && line.seen(gap.next)) ++gap.next;
        begin = cut_gap(line, gap, cuts);
        i = std::max(begin, gap.end) - 1;
    }
}

} // namespace hrbfnpr::frame
