// SPDX-License-Identifier: MIT
#include "frame/hatch/edges.h"

#include "base/scratch.h"
#include "geometry/segment.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::frame {

using drawing::Dot;
using drawing::StrokePoint;

namespace {

constexpr float cell_side = 16.0F; // pixels
// An edge lies before a line if it is nearer to the eye by this many pixels.
constexpr float least_before = 1.0F;
// Edges that are no nearer than halo_gap have no halo on a line, those that are so much nearer have all of it, pixels.
constexpr float halo_gap = scene_tuning.halo_gap;
constexpr float full_halo = 3.0F * halo_gap;
// Without a halo a line ends where it crosses an edge, pixels.
constexpr float at_edge = 0.05F;
// Crossings farther along than this tell nothing of what is here, pixels; then a surface may be so steep, depth over
// pixels.
constexpr float farthest_crossing = 24.0F;
constexpr float steepest_surface = 6.0F;
// A line ends bluntly at an edge that it makes an angle of at least the first cosine with.
constexpr float goes_across = 0.25F;
constexpr float goes_along = 0.5F;
// Longer edges are cut into fewer pieces than would lie in few cells.
constexpr float most_pieces = 4096.0F;

[[nodiscard]] glm::vec2 place(const Dot& dot) noexcept { return {dot.x, dot.y}; }

[[nodiscard]] float cross(const glm::vec2& a, const glm::vec2& b) noexcept { return a.x * b.y - a.y * b.x; }

[[nodiscard]] float halo_of(float before, float halo) noexcept {
    return std::max(at_edge, halo * std::clamp((before - halo_gap) / (full_halo - halo_gap), 0.0F, 1.0F));
}

// The first share of the way from p, outside, at which it comes into the disc around the centre.
[[nodiscard]] float entry_of_disc(const glm::vec2& p, const glm::vec2& way, const glm::vec2& centre,
                                  float radius) noexcept {
    const glm::vec2 from = p - centre;
    const float square = glm::dot(way, way);
    const float half = glm::dot(from, way);
    const float root = half * half - square * (glm::dot(from, from) - radius * radius);
    return half < 0.0F && root >= 0.0F ? (-half - std::sqrt(root)) / square : NearerEdges::nowhere;
}

// Into what is no farther than that from a straight piece: one of the discs at its ends, or the strip between.
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

} // namespace

NearerEdges::Cells NearerEdges::cells(const glm::vec2& low, const glm::vec2& high) const noexcept {
    const auto cell = [](float at, std::int32_t count) {
        return static_cast<std::int32_t>(std::clamp(at / cell_side, 0.0F, static_cast<float>(count - 1)));
    };
    return {cell(low.x - corner_.x, columns_), cell(low.y - corner_.y, rows_), cell(high.x - corner_.x, columns_) + 1,
            cell(high.y - corner_.y, rows_) + 1};
}

// Pieces that are no longer than a cell lie in few of those that they might cross.
template <class F>
void NearerEdges::for_cells_of(const Edge& edge, const F& f) const {
    const auto pieces = 1 + static_cast<std::int32_t>(std::min(glm::distance(edge.a, edge.b) / cell_side, most_pieces));
    for (std::int32_t i = 0; i < pieces; ++i) {
        const auto at = [&](std::int32_t k) {
            return edge.a + static_cast<float>(k) / static_cast<float>(pieces) * (edge.b - edge.a);
        };
        const Cells own = cells(glm::min(at(i), at(i + 1)), glm::max(at(i), at(i + 1)));
        for (std::int32_t row = own.top; row < own.bottom; ++row)
            for (std::int32_t column = own.left; column < own.right; ++column) f(row * columns_ + column);
    }
}

template <class F>
void NearerEdges::for_near(const glm::vec2& low, const glm::vec2& high, const F& f) const {
    const Cells own = cells(low, high);
    for (std::int32_t row = own.top; row < own.bottom; ++row)
        for (std::int32_t column = own.left; column < own.right; ++column)
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
            const Edge edge{{point[i].x, point[i].y},
                            {point[i + 1].x, point[i + 1].y},
                            point[i].depth,
                            point[i + 1].depth,
                            is_crease};
            if (glm::all(glm::lessThan(glm::min(edge.a, edge.b), high)) &&
                glm::all(glm::greaterThan(glm::max(edge.a, edge.b), low)))
                edges_.push_back(edge);
        }
    }
    bin();
}

void NearerEdges::bin() {
    // Counted one place farther on, where filling moves them back from.
    base::resize_scratch(first_, std::int64_t{columns_} * rows_ + 2);
    std::fill(first_.begin(), first_.end(), 0);
    for (const Edge& edge : edges_) for_cells_of(edge, [&](std::int32_t cell) { ++first_[cell + 2]; });
    for (std::int64_t i = 2; i < first_.size(); ++i) first_[i] += first_[i - 1];
    base::resize_scratch(numbers_, first_[first_.size() - 1]);
    for (std::int64_t i = 0; i < edges_.size(); ++i)
        for_cells_of(edges_[i],
                     [&](std::int32_t cell) { numbers_[first_[cell + 1]++] = static_cast<std::int32_t>(i); });
}

// By how many pixels an edge's place is nearer to the eye than what is at that place, at that depth.
float NearerEdges::before(const Edge& edge, const glm::vec2& at, float depth, float pixels_per_unit) noexcept {
    const float share = geometry::nearest_share(at, edge.a, edge.b);
    return (depth - edge.depth_a - share * (edge.depth_b - edge.depth_a)) * pixels_per_unit;
}

// The same of a line that runs on from a as to b: where it would cross the edge, if that ran on.  So it is 0 for
// an edge of its own surface, however steep that is.
float NearerEdges::before(const Edge& edge, const Dot& a, const Dot& b) noexcept {
    const glm::vec2 way = place(b) - place(a);
    const glm::vec2 along = edge.b - edge.a;
    const glm::vec2 to = edge.a - place(a);
    const float turn = cross(way, along);
    const float share = cross(to, along) / turn;
    const float edge_share = cross(to, way) / turn;
    const float length = glm::length(along);
    if (std::abs(share) * glm::length(way) <= farthest_crossing &&
        std::abs(edge_share - 0.5F) * length <= farthest_crossing + 0.5F * length)
        return (a.depth + share * (b.depth - a.depth) - edge.depth_a - edge_share * (edge.depth_b - edge.depth_a)) *
               a.pixels_per_unit;
    return before(edge, place(a), a.depth, a.pixels_per_unit) -
           steepest_surface * geometry::distance_to_segment(place(a), edge.a, edge.b);
}

bool NearerEdges::is_near(const Dot& dot, float reach, float halo) const noexcept {
    const glm::vec2 at = place(dot);
    const float most = std::max(reach, halo);
    bool found = false;
    for_near(at - most, at + most, [&](const Edge& edge) {
        const float square = geometry::square_from_segment(at, edge.a, edge.b);
        if (found || square > most * most) return;
        const float nearer = before(edge, at, dot.depth, dot.pixels_per_unit);
        const float limit = std::max(reach, halo_of(nearer, halo));
        found = nearer > least_before && square <= limit * limit;
    });
    return found;
}

float NearerEdges::entry(const Dot& a, const Dot& b, float halo) const noexcept {
    const glm::vec2 from = place(a);
    const glm::vec2 way = place(b) - from;
    const float length = glm::length(way);
    if (!(length > 0.0F)) return nowhere;
    const float reach = length + std::max(halo, at_edge);
    float first = nowhere;
    for_near(from - reach, from + reach, [&](const Edge& edge) {
        const float square = geometry::square_from_segment(from, edge.a, edge.b);
        if (square > reach * reach) return;
        const float nearer = before(edge, a, b);
        const float radius = halo_of(nearer, halo);
        if (nearer > least_before && square > radius * radius)
            first = std::min(first, entry_of_strip(from, way, edge.a, edge.b, radius));
    });
    return first <= 1.0F ? first : nowhere;
}

float NearerEdges::room(const StrokePoint& point, const glm::vec2& along, float radius, float halo) const noexcept {
    const float way = glm::length(along);
    if (!(way > 0.0F)) return radius;
    const glm::vec2 at(point.x, point.y);
    const glm::vec2 u = along / way;
    const float reach = radius + std::max(halo, at_edge);
    float least = radius;
    for_near(at - reach, at + reach, [&](const Edge& edge) {
        // Where the line across the line through the point meets the edge.
        const float from = glm::dot(edge.a - at, u);
        const float to = glm::dot(edge.b - at, u);
        if (from * to > 0.0F || from == to) return;
        const float share = from / (from - to);
        const float aside = std::abs(cross(u, edge.a + share * (edge.b - edge.a) - at));
        if (aside > reach) return;
        const float own = least_before + steepest_surface * aside;
        const float nearer =
            (point.depth - edge.depth_a - share * (edge.depth_b - edge.depth_a)) * point.pixels_per_unit;
        if (!(nearer > own) && !(edge.is_crease && nearer > -own)) return;
        const float cosine = std::abs(to - from) / glm::distance(edge.a, edge.b);
        const float along_edge = std::clamp((cosine - goes_across) / (goes_along - goes_across), 0.0F, 1.0F);
        const float free = nearer > own ? aside - halo_of(nearer - own, halo) : aside;
        least = std::min(least, std::lerp(radius, std::max(free, 0.0F), along_edge));
    });
    return least;
}

} // namespace hrbfnpr::frame
