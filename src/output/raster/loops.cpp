// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "output/raster/loops.cpp"
#include "base/simd.h"

#include "base/assert.h"
#include "output/raster/raster.h"

HWY_BEFORE_NAMESPACE();
namespace hrbfnpr::output::HWY_NAMESPACE::raster_loops {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Vectors are short, because most discs are a few pixels wide and segments are short.
using F = hn::CappedTag<float, 8>;
using W = hn::Vec<F>;

// ---- Discs

HWY_INLINE std::int32_t clamped(float at, std::int32_t limit) {
    const float top = static_cast<float>(limit);
    return static_cast<std::int32_t>(at < 0.0F ? 0.0F : at > top ? top : at);
}

// A disc in pixels of the tile.
struct InkDisc {
    float x, y, radius, alpha, depth;
};

// Approximates the share of a pixel that a disc covers. The share depends on the distance from the pixel's centre to
// the disc's rim.
HWY_INLINE W coverage(W squared, W outer) {
    const F d;
    return hn::Min(hn::Max(hn::Sub(outer, hn::Sqrt(squared)), hn::Zero(d)), hn::Set(d, 1.0F));
}

template <class Blend>
HWY_INLINE void for_pixels(const DiscTile& t, const InkDisc& disc, Blend&& blend) {
    const F d;
    const auto lanes = static_cast<std::int32_t>(hn::Lanes(d));
    const float radius = disc.radius > drawing::smallest_radius ? disc.radius : drawing::smallest_radius;
    const float dimmed = disc.radius / radius;
    const float rim = radius + drawing::soft_rim;
    const W alpha = hn::Set(d, disc.alpha * dimmed * dimmed);
    const W outer = hn::Set(d, rim);
    const std::int32_t left = clamped(disc.x - rim, t.width);
    const std::int32_t right = clamped(disc.x + rim + 1.0F, t.width);
    const std::int32_t top = clamped(disc.y - rim, t.height);
    const std::int32_t bottom = clamped(disc.y + rim + 1.0F, t.height);
    const W step = hn::Iota(d, 0.0F);
    for (std::int32_t y = top; y < bottom; ++y) {
        const float dy = static_cast<float>(y) + 0.5F - disc.y;
        const W squared_y = hn::Set(d, dy * dy);
        for (std::int32_t x = left; x < right; x += lanes) {
            const W dx = hn::Add(hn::Set(d, static_cast<float>(x) + 0.5F - disc.x), step);
            const W squared = hn::Add(hn::Mul(dx, dx), squared_y);
            blend(y * t.stride + x, hn::Mul(alpha, coverage(squared, outer)));
        }
    }
}

// Returns `cover`, but 0 for pixels where the host's picture is nearer than the disc.
HWY_INLINE W disc_before_host(const DiscTile& t, const InkDisc& disc, std::int32_t at, W cover) {
    const F d;
    if (t.host == nullptr) return cover;
    return hn::IfThenZeroElse(hn::Lt(hn::LoadU(d, t.host + at), hn::Set(d, disc.depth)), cover);
}

// Blends ink over the paper and over the inks drawn before. `color` is NULL if all inks have one colour.
HWY_INLINE void add_ink(const DiscTile& t, const float* color, std::int32_t at, W ink) {
    const F d;
    const W left = hn::Sub(hn::Set(d, 1.0F), ink);
    hn::StoreU(hn::Mul(hn::LoadU(d, t.transmittance + at), left), d, t.transmittance + at);
    if (color == nullptr) return;
    for (int c = 0; c < 3; ++c) {
        const W own = hn::Mul(hn::Set(d, color[c]), ink);
        hn::StoreU(hn::Add(hn::Mul(hn::LoadU(d, t.color[c] + at), left), own), d, t.color[c] + at);
    }
}

// Blends paper over the inks drawn before.
HWY_INLINE void add_paper(const DiscTile& t, std::int32_t at, W paper) {
    const F d;
    const W left = hn::Sub(hn::Set(d, 1.0F), paper);
    hn::StoreU(hn::Add(hn::Mul(hn::LoadU(d, t.transmittance + at), left), paper), d, t.transmittance + at);
    for (int c = 0; c < 3; ++c) hn::StoreU(hn::Mul(hn::LoadU(d, t.color[c] + at), left), d, t.color[c] + at);
}

void draw_discs(const DiscTile& t, const InkList& list) {
    HRBFNPR_ASSERT(t.stride >= t.width + 8);
    for (std::int64_t i = 0; i < list.count; ++i) {
        const drawing::Dot& ink = list.inks[list.numbers[i]];
        if (!(ink.opacity > 0.0F)) continue;
        const float* const color = t.color[0] != nullptr ? list.colors + 4 * std::int64_t{ink.layer} : nullptr;
        InkDisc disc = {ink.x - list.left, ink.y - list.top, ink.radius,
                        ink.opacity * (color != nullptr ? color[3] : list.one_alpha),
                        ink.window * list.host_depth_sign};
        if ((ink.flags & drawing::dot_is_paper) != 0) {
            HRBFNPR_ASSERT(color != nullptr);
            disc.alpha = ink.opacity;
            for_pixels(t, disc, [&](std::int32_t at, W cover) HWY_ATTR {
                add_paper(t, at, disc_before_host(t, disc, at, cover));
            });
        } else {
            for_pixels(t, disc, [&](std::int32_t at, W cover) HWY_ATTR {
                add_ink(t, color, at, disc_before_host(t, disc, at, cover));
            });
        }
    }
}

void store(const RowColors& colors, const float* transmittance, std::int64_t count, std::uint32_t* pixels) {
    const hn::ScalableTag<float> d;
    const hn::RebindToSigned<decltype(d)> integer;
    const hn::RebindToUnsigned<decltype(d)> word;
    const auto one = hn::Set(d, 1.0F);
    const auto lanes = static_cast<std::int64_t>(hn::Lanes(d));
    for (std::int64_t at = 0; at < count; at += lanes) {
        const auto left = hn::LoadU(d, transmittance + at);
        const auto inked = hn::Sub(one, left);
        auto scale = hn::Set(d, 255.0F);
        const auto channel = [&](int c) HWY_ATTR {
            return hn::Add(hn::Mul(hn::Set(d, colors.paper[c]), left), hn::Mul(hn::Set(d, colors.ink[c]), inked));
        };
        const auto alpha = channel(3);
        if (colors.straight)
            // Formats with straight alpha store transparent pixels as all zeros.
            scale = hn::IfThenElseZero(hn::Gt(alpha, hn::Zero(d)), hn::Div(scale, alpha));
        auto bits = hn::Zero(word);
        const auto add = [&](hn::Vec<decltype(d)> value, int c) HWY_ATTR {
            const auto rounded = hn::Add(hn::Min(hn::Max(value, hn::Zero(d)), hn::Set(d, 255.0F)), hn::Set(d, 0.5F));
            bits = hn::Or(bits, hn::ShiftLeftSame(hn::BitCast(word, hn::ConvertTo(integer, rounded)), 8 * c));
        };
        for (int c = 0; c < 3; ++c) add(hn::Mul(channel(c), scale), c);
        add(hn::Mul(alpha, hn::Set(d, 255.0F)), 3);
        hn::StoreU(bits, word, pixels + at);
    }
}

// ---- Strokes

constexpr std::int32_t most_rows = StrokeUnion::most_side;

HWY_INLINE double least(double a, double b) { return a < b ? a : b; }
HWY_INLINE double most(double a, double b) { return a > b ? a : b; }
HWY_INLINE std::int32_t clamped(double at, std::int32_t limit) {
    return static_cast<std::int32_t>(most(0.0, least(at, static_cast<double>(limit))));
}

// An edge, stored from its upper end to its lower end.
struct Edge {
    double x, top, bottom, slope;
    float sign;        // 1 if the inside lies to the right of the edge, else -1
    std::int32_t next; // the next edge that begins in the same row; -1: none
};

// The part of an edge in a row of pixels. In each pixel, the area to the right of the part is the part's height times
// the mean of clamp(right - x, 0, 1), where `right` is the x of the pixel's right side. If F is the integral of clamp,
// the mean is the difference of F between the ends of the part, divided by the change of x.
struct EdgePart {
    float x, way; // x at the part's upper end, and the change of x to its lower end
    float scale;  // the signed height divided by `way`; if the part is steep, the signed height
    bool steep;
};

// For each row the half-open range of columns that the stroke covers.
struct Spans {
    std::int32_t top, bottom;
    std::int32_t left[most_rows], right[most_rows];
};

struct StrokeTarget {
    const DiscTile& tile;
    const StrokePlanes& planes;
    Spans& spans;
    bool even;          // all segments have one opacity, so the `ink` plane is unused
    float alpha;        // the opacity of all segments, if `even`, times the alpha of the stroke's ink
    bool is_direct;     // there is only one outline; it is blended directly, without the planes
    const float* color; // the ink's colour; NULL if all inks have one colour
};

// An outline's edges, listed by the rows in which they begin.
struct Edges {
    Edge at[Outline::most];
    std::int32_t first[most_rows];
    std::int32_t count, top, bottom; // the number of edges, and the first and last row
};

HWY_INLINE void find_edges(const Outline& outline, std::int32_t rows, Edges& edges) {
    const double height = static_cast<double>(rows);
    double top = height;
    double bottom = 0.0;
    for (std::int32_t i = 0; i < outline.count; ++i) {
        top = least(top, outline.at[i].y);
        bottom = most(bottom, outline.at[i].y);
    }
    edges.count = 0;
    edges.top = clamped(top, rows);
    edges.bottom = clamped(bottom + 1.0, rows);
    for (std::int32_t y = edges.top; y < edges.bottom; ++y) edges.first[y] = -1;
    Place from = outline.at[outline.count - 1];
    for (std::int32_t i = 0; i < outline.count; ++i) {
        const Place to = outline.at[i];
        const bool down = from.y < to.y;
        const Place upper = down ? from : to;
        const Place lower = down ? to : from;
        from = to;
        if (!(upper.y < lower.y && lower.y > 0.0 && upper.y < height)) continue;
        std::int32_t& first = edges.first[clamped(upper.y, rows)];
        edges.at[edges.count] = {
            upper.x, upper.y, lower.y, (lower.x - upper.x) / (lower.y - upper.y), down ? -1.0F : 1.0F, first};
        first = edges.count++;
    }
}

// The edges that cross a row, their parts there, and the range of columns between them.
struct Row {
    std::int32_t edges[Outline::most];
    EdgePart parts[Outline::most];
    std::int32_t edge_count, count;
    std::int32_t left, right;
};

// Finds the parts of edges in row y. row.edges keeps the edges that continue into the next row.
HWY_INLINE void find_parts(const Edges& edges, std::int32_t y, std::int32_t width, Row& row) {
    const double top = static_cast<double>(y);
    const double wide = static_cast<double>(width);
    double left = wide;
    double right = 0.0;
    for (std::int32_t i = edges.first[y]; i >= 0; i = edges.at[i].next) row.edges[row.edge_count++] = i;
    row.count = 0;
    std::int32_t kept = 0;
    for (std::int32_t i = 0; i < row.edge_count; ++i) {
        const Edge& e = edges.at[row.edges[i]];
        if (e.bottom > top + 1.0) row.edges[kept++] = row.edges[i];
        const double upper = most(e.top, top);
        const double lower = least(e.bottom, top + 1.0);
        const double x0 = e.x + (upper - e.top) * e.slope;
        const double x1 = e.x + (lower - e.top) * e.slope;
        const double low = least(x0, x1);
        const double high = most(x0, x1);
        left = least(left, low);
        right = most(right, high);
        if (low >= wide) continue;
        const float tall = static_cast<float>(lower - upper) * e.sign;
        const float way = static_cast<float>(x1 - x0);
        EdgePart& part = row.parts[row.count++];
        part = {static_cast<float>(x0), way, tall, high <= 0.0 || (way < 1.0F / 128.0F && way > -1.0F / 128.0F)};
        if (!part.steep)
            part.scale = tall / way;
        else // edges left of the tile move to its left side
            part.x = high <= 0.0 ? 0.0F : static_cast<float>(x0 + 0.5 * (x1 - x0));
    }
    row.edge_count = kept;
    row.left = clamped(left, width);
    row.right = clamped(right + 1.0, width);
}

// The integral of clamp(t, 0, 1) for t from 0 to u.
HWY_INLINE W integral(W u) {
    const F d;
    const W zero = hn::Zero(d);
    const W one = hn::Set(d, 1.0F);
    const W within = hn::Min(hn::Max(u, zero), one);
    const W beyond = hn::Max(hn::Sub(u, one), zero);
    return hn::Add(hn::Mul(hn::Mul(within, within), hn::Set(d, 0.5F)), beyond);
}

HWY_INLINE W covered(const Row& row, W right) {
    const F d;
    const W zero = hn::Zero(d);
    const W one = hn::Set(d, 1.0F);
    W sum = zero;
    for (std::int32_t i = 0; i < row.count; ++i) {
        const EdgePart& part = row.parts[i];
        const W u = hn::Sub(right, hn::Set(d, part.x));
        const W mean = part.steep ? hn::Min(hn::Max(u, zero), one)
                                  : hn::Sub(integral(u), integral(hn::Sub(u, hn::Set(d, part.way))));
        sum = hn::Add(sum, hn::Mul(mean, hn::Set(d, part.scale)));
    }
    return hn::Min(hn::Max(sum, zero), one);
}

// The positions of pixels along the segment, from 0 at its first point to 1 at its last point.
HWY_INLINE W place_along(const Shade& shade, std::int32_t y, W x) {
    const F d;
    const W start = hn::Set(d, shade.from + (static_cast<float>(y) + 0.5F) * shade.step_y);
    const W along = hn::Add(start, hn::Mul(x, hn::Set(d, shade.step_x)));
    return hn::Min(hn::Max(along, hn::Zero(d)), hn::Set(d, 1.0F));
}

// Adds the coverage of a row's pixels to the cover and ink planes.
HWY_INLINE void add(const StrokeTarget& t, const Shade& shade, std::int32_t y, std::int32_t x, W cover) {
    const F d;
    const std::int32_t at = y * t.tile.stride + x;
    hn::StoreU(hn::Add(hn::LoadU(d, t.planes.cover + at), cover), d, t.planes.cover + at);
    if (t.even) return;
    const W center = hn::Add(hn::Set(d, static_cast<float>(x)), hn::Iota(d, 0.5F));
    W opacity = hn::Set(d, shade.opacity);
    if (shade.more_opacity != 0.0F)
        opacity = hn::Add(opacity, hn::Mul(place_along(shade, y, center), hn::Set(d, shade.more_opacity)));
    hn::StoreU(hn::Add(hn::LoadU(d, t.planes.ink + at), hn::Mul(cover, opacity)), d, t.planes.ink + at);
}

// Returns `cover`, but 0 for pixels where the host's picture is nearer than the segment.
HWY_INLINE W segment_before_host(const StrokeTarget& t, const Shade& shade, std::int32_t y, std::int32_t x, W cover) {
    const F d;
    if (t.tile.host == nullptr) return cover;
    const W center = hn::Add(hn::Set(d, static_cast<float>(x)), hn::Iota(d, 0.5F));
    const W window =
        hn::Add(hn::Set(d, shade.window), hn::Mul(place_along(shade, y, center), hn::Set(d, shade.more_window)));
    return hn::IfThenZeroElse(hn::Lt(hn::LoadU(d, t.tile.host + std::int64_t{y} * t.tile.stride + x), window), cover);
}

HWY_INLINE void extend_span(const StrokeTarget& t, std::int32_t y, std::int32_t left, std::int32_t right) {
    t.spans.left[y] = left < t.spans.left[y] ? left : t.spans.left[y];
    t.spans.right[y] = right > t.spans.right[y] ? right : t.spans.right[y];
}

HWY_INLINE void draw_row(const StrokeTarget& t, const Shade& shade, const Row& row, std::int32_t y) {
    const F d;
    const auto lanes = static_cast<std::int32_t>(hn::Lanes(d));
    for (std::int32_t x = row.left; x < row.right; x += lanes) {
        const W inside = hn::Iota(d, static_cast<float>(x));
        const W cover = hn::IfThenElseZero(hn::Lt(inside, hn::Set(d, static_cast<float>(row.right))),
                                           covered(row, hn::Add(inside, hn::Set(d, 1.0F))));
        if (t.is_direct)
            add_ink(t.tile, t.color, y * t.tile.stride + x, hn::Mul(cover, hn::Set(d, t.alpha)));
        else
            add(t, shade, y, x, segment_before_host(t, shade, y, x, cover));
    }
    if (!t.is_direct) extend_span(t, y, row.left, row.right);
}

void draw_outline(const StrokeTarget& t, const Outline& outline, const Shade& shade) {
    if (outline.count == 0) return;
    Edges edges;
    find_edges(outline, t.tile.height, edges);
    if (!t.is_direct) {
        t.spans.top = edges.top < t.spans.top ? edges.top : t.spans.top;
        t.spans.bottom = edges.bottom > t.spans.bottom ? edges.bottom : t.spans.bottom;
    }
    Row row;
    row.edge_count = 0;
    for (std::int32_t y = edges.top; y < edges.bottom; ++y) {
        find_parts(edges, y, t.tile.width, row);
        if (row.left < row.right) draw_row(t, shade, row, y);
    }
}

HWY_INLINE Shade shade_of(const SegmentList& list, const drawing::StrokePoint& a, const drawing::StrokePoint& b) {
    // Doubles are needed because a segment may begin far outside the tile.
    const double x = static_cast<double>(b.x) - static_cast<double>(a.x);
    const double y = static_cast<double>(b.y) - static_cast<double>(a.y);
    const double square = x * x + y * y;
    const double scale = square > 1e-12 ? 1.0 / square : 0.0;
    const double from = (static_cast<double>(list.left) - static_cast<double>(a.x)) * x +
                        (static_cast<double>(list.top) - static_cast<double>(a.y)) * y;
    return {static_cast<float>(from * scale),
            static_cast<float>(x * scale),
            static_cast<float>(y * scale),
            a.opacity,
            b.opacity - a.opacity,
            a.window * list.host_depth_sign,
            (b.window - a.window) * list.host_depth_sign};
}

HWY_INLINE void clear_spans(const DiscTile& t, Spans& spans) {
    for (std::int32_t y = 0; y < t.height; ++y) {
        spans.left[y] = t.width;
        spans.right[y] = 0;
    }
}

// Draws outlines that do not overlap. Returns false at the first overlap; the caller must then clear the parts that
// were drawn.
HWY_INLINE bool draw_segments(StrokeTarget& t, const SegmentList& list) {
    Outliner outliner(list, false);
    Outline outline;
    const bool single = t.tile.host != nullptr;
    for (std::int64_t i = 0; i < list.count;) {
        const drawing::StrokePoint* const p = list.points + list.numbers[i];
        const std::int64_t segments = outliner.outline(i, single, outline);
        if (outliner.overlaps()) return false;
        Shade shade = shade_of(list, p[0], p[1]);
        if (segments > 1) shade.more_opacity = 0.0F;
        t.is_direct = t.even && !single && segments == list.count;
        if (i == 0 && !t.is_direct) clear_spans(t.tile, t.spans);
        draw_outline(t, outline, shade);
        i += segments;
    }
    return true;
}

HWY_INLINE void add_outlines(StrokeUnion& all, const SegmentList& list, bool single) {
    Outliner outliner(list, true);
    Outline outline;
    for (std::int64_t i = 0; i < list.count;) {
        const drawing::StrokePoint* const p = list.points + list.numbers[i];
        const std::int64_t segments = outliner.outline(i, single, outline);
        Shade shade = shade_of(list, p[0], p[1]);
        if (segments > 1) shade.more_opacity = 0.0F;
        all.add(outline, shade);
        if (outliner.join(outline)) all.add(outline, shade);
        i += segments;
    }
}

// Adds the union of all outlines to the planes.
HWY_INLINE void draw_union(const StrokeTarget& t, const SegmentList& list) {
    const F d;
    const auto lanes = static_cast<std::int32_t>(hn::Lanes(d));
    StrokeUnion& all = *t.planes.overlaps;
    all.begin(t.tile.width, t.tile.height, t.tile.host != nullptr);
    add_outlines(all, list, t.tile.host != nullptr);
    t.spans.top = all.top();
    t.spans.bottom = all.bottom();
    float buffer[most_rows + 16];
    for (std::int32_t y = all.top(); y < all.bottom(); ++y) {
        const std::int32_t shades = all.cut(y);
        for (std::int32_t i = 0; i < shades; ++i) {
            std::int32_t left = 0;
            std::int32_t right = 0;
            const Shade& shade = all.cover(i, buffer, left, right);
            for (std::int32_t x = right; x < right + lanes; ++x) buffer[x - left] = 0.0F;
            for (std::int32_t x = left; x < right; x += lanes)
                add(t, shade, y, x, segment_before_host(t, shade, y, x, hn::LoadU(d, buffer + (x - left))));
            extend_span(t, y, left, right);
        }
    }
}

// Clears the planes where the stroke covered pixels.
HWY_INLINE void clear(const StrokeTarget& t) {
    const F d;
    const auto lanes = static_cast<std::int32_t>(hn::Lanes(d));
    for (std::int32_t y = t.spans.top; y < t.spans.bottom; ++y)
        for (std::int32_t x = t.spans.left[y]; x < t.spans.right[y]; x += lanes) {
            const std::int32_t at = y * t.tile.stride + x;
            hn::StoreU(hn::Zero(d), d, t.planes.cover + at);
            hn::StoreU(hn::Zero(d), d, t.planes.ink + at);
        }
}

// Blends the stroke's ink over the paper, and clears the planes where the stroke covered pixels.
HWY_INLINE void blend(const StrokeTarget& t, float ink_alpha) {
    const F d;
    const auto lanes = static_cast<std::int32_t>(hn::Lanes(d));
    const W alpha = hn::Set(d, ink_alpha);
    const W one = hn::Set(d, 1.0F);
    for (std::int32_t y = t.spans.top; y < t.spans.bottom; ++y) {
        for (std::int32_t x = t.spans.left[y]; x < t.spans.right[y]; x += lanes) {
            const std::int32_t at = y * t.tile.stride + x;
            const W cover = hn::LoadU(d, t.planes.cover + at);
            hn::StoreU(hn::Zero(d), d, t.planes.cover + at);
            W ink = hn::Mul(hn::Min(cover, one), hn::Set(d, t.alpha));
            if (!t.even) {
                ink = hn::Mul(hn::Div(hn::LoadU(d, t.planes.ink + at), hn::Max(cover, one)), alpha);
                hn::StoreU(hn::Zero(d), d, t.planes.ink + at);
            }
            add_ink(t.tile, t.color, at, ink);
        }
    }
}

HWY_INLINE bool has_one_opacity(const SegmentList& list) {
    const float opacity = list.points[list.numbers[0]].opacity;
    for (std::int64_t i = 0; i < list.count; ++i) {
        const drawing::StrokePoint* const p = list.points + list.numbers[i];
        if (p[0].opacity != opacity || p[1].opacity != opacity) return false;
    }
    return true;
}

void draw_stroke(const DiscTile& tile, const SegmentList& list, const StrokePlanes& planes) {
    HRBFNPR_ASSERT(tile.width <= most_rows && tile.height <= most_rows && tile.stride >= tile.width + 8);
    if (list.count == 0) return;
    Spans spans;
    spans.top = tile.height;
    spans.bottom = 0;
    const float opacity = list.points[list.numbers[0]].opacity;
    StrokeTarget target{tile,
                        planes,
                        spans,
                        has_one_opacity(list),
                        opacity * list.color[3],
                        false,
                        tile.color[0] != nullptr ? list.color : nullptr};
    const bool apart = !may_overlap(list);
    if (!apart || !draw_segments(target, list)) {
        if (apart) clear(target);
        clear_spans(tile, spans);
        draw_union(target, list);
    }
    if (!target.is_direct) blend(target, list.color[3]);
}

} // namespace

RasterLoops pick() noexcept { return {draw_discs, draw_stroke, store}; }

} // namespace hrbfnpr::output::HWY_NAMESPACE::raster_loops
HWY_AFTER_NAMESPACE();

HRBFNPR_CHOOSE(hrbfnpr::output, RasterLoops, raster_loops, raster_loops::pick)
