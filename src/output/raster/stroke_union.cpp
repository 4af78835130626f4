// SPDX-License-Identifier: MIT
#include "output/raster/stroke_union.h"

#include "base/assert.h"
#include "output/raster/tuning.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::output {
namespace {

std::int32_t row_of(double y, std::int32_t rows) noexcept {
    return static_cast<std::int32_t>(std::clamp(y, 0.0, static_cast<double>(rows)));
}

} // namespace

StrokeUnion::StrokeUnion(base::Memory& memory)
    : edges_(memory), shades_(memory), winding_(memory), active_(memory), pieces_(memory), breaks_(memory),
      order_(memory), inside_(memory), spans_(memory), found_(memory) {
    // Few drawings need more room than this.
    edges_.reserve(2048);
    spans_.reserve(1024);
    for (base::Array<std::int32_t>* const numbers : {&winding_, &active_, &order_, &inside_, &found_})
        numbers->reserve(512);
    shades_.reserve(512);
    pieces_.reserve(512);
    breaks_.reserve(raster_tuning.most_breaks + 1);
}

void StrokeUnion::begin(std::int32_t width, std::int32_t height, bool by_depth) noexcept {
    HRBFNPR_ASSERT(width > 0 && width <= most_side && height > 0 && height <= most_side);
    width_ = width;
    height_ = height;
    by_depth_ = by_depth;
    top_ = height;
    bottom_ = 0;
    edges_.clear();
    shades_.clear();
    winding_.clear();
    active_.clear();
    std::fill_n(first_, height, -1);
}

// Outlines of the same constant opacity share a shade.
bool StrokeUnion::same_shade(const Shade& a, const Shade& b) const noexcept {
    return !by_depth_ && a.more_opacity == 0.0F && b.more_opacity == 0.0F && a.opacity == b.opacity;
}

// Edges beyond the tile's right side are left out; edges to the left of it stand at its left side.
void StrokeUnion::add(const Outline& outline, const Shade& shade) {
    if (outline.count == 0) return;
    if (shades_.empty() || !same_shade(shades_.back(), shade)) {
        shades_.push_back(shade);
        winding_.push_back(0);
    }
    const double height = static_cast<double>(height_);
    const auto number = static_cast<std::int32_t>(shades_.size() - 1);
    Place from = outline.at[outline.count - 1];
    for (std::int32_t i = 0; i < outline.count; ++i) {
        const Place to = outline.at[i];
        const bool down = from.y < to.y;
        const Place upper = down ? from : to;
        const Place lower = down ? to : from;
        from = to;
        const double top = std::max(upper.y, 0.0);
        const double bottom = std::min(lower.y, height);
        if (!(top < bottom)) continue;
        double slope = (lower.x - upper.x) / (lower.y - upper.y);
        double x = upper.x + (top - upper.y) * slope;
        const double end = x + (bottom - top) * slope;
        if (std::min(x, end) >= static_cast<double>(width_)) continue;
        if (std::max(x, end) <= 0.0) x = slope = 0.0;
        const std::int32_t row = row_of(top, height_ - 1);
        edges_.push_back({x, top, bottom, slope, down ? -1 : 1, number, first_[row]});
        first_[row] = static_cast<std::int32_t>(edges_.size() - 1);
        top_ = std::min(top_, row);
        bottom_ = std::max(bottom_, row_of(std::ceil(bottom), height_));
    }
}

// Finds the parts of edges in a row. The list of active edges keeps those that go on below.
void StrokeUnion::find_pieces(std::int32_t y) {
    const double top = static_cast<double>(y);
    for (std::int32_t e = first_[y]; e >= 0; e = edges_[e].next) active_.push_back(e);
    pieces_.clear();
    std::int64_t kept = 0;
    for (const std::int32_t number : active_) {
        const Edge& e = edges_[number];
        const double upper = std::max(e.top, top);
        const double lower = std::min(e.bottom, top + 1.0);
        const double a = e.x + (upper - e.top) * e.slope;
        const double b = e.x + (lower - e.top) * e.slope;
        pieces_.push_back(
            {upper, lower, e.x - e.top * e.slope, e.slope, std::min(a, b), std::max(a, b), e.winding, e.shade, 0.0});
        if (e.bottom > top + 1.0) active_[kept++] = number;
    }
    active_.resize(kept);
    std::sort(pieces_.begin(), pieces_.end(), [](const Piece& a, const Piece& b) {
        if (a.low != b.low) return a.low < b.low;
        return a.upper != b.upper ? a.upper < b.upper : a.slope < b.slope;
    });
}

void StrokeUnion::add_crossings() {
    for (std::int64_t i = 0; i < pieces_.size(); ++i) {
        const Piece& a = pieces_[i];
        for (std::int64_t k = i + 1; k < pieces_.size() && pieces_[k].low < a.high; ++k) {
            const Piece& b = pieces_[k];
            const double from = std::max(a.upper, b.upper);
            const double to = std::min(a.lower, b.lower);
            if (!(from < to)) continue;
            const double before = a.at(from) - b.at(from);
            const double after = a.at(to) - b.at(to);
            if (before * after < 0.0) breaks_.push_back(from + (to - from) * (before / (before - after)));
            if (breaks_.size() > raster_tuning.most_breaks) return;
        }
    }
}

// Finds the heights between which nothing begins, ends or crosses, in order.
void StrokeUnion::find_breaks(std::int32_t y) {
    breaks_.clear();
    for (const Piece& p : pieces_) {
        breaks_.push_back(p.upper);
        breaks_.push_back(p.lower);
    }
    if (breaks_.size() <= raster_tuning.most_breaks) add_crossings();
    if (breaks_.size() > raster_tuning.most_breaks) {
        breaks_.clear();
        for (int k = 0; k <= raster_tuning.most_breaks; ++k)
            breaks_.push_back(static_cast<double>(y) + k / double{raster_tuning.most_breaks});
    }
    std::sort(breaks_.begin(), breaks_.end());
}

// The shade that a place belongs to, of those that cover it.
std::int32_t StrokeUnion::owner(double x, double y) const noexcept {
    std::int32_t best = inside_[0];
    float nearest = 0.0F;
    for (std::int64_t i = 0; i < inside_.size(); ++i) {
        if (!by_depth_) {
            best = std::min(best, inside_[i]);
            continue;
        }
        const Shade& s = shades_[inside_[i]];
        const float along =
            std::clamp(s.from + static_cast<float>(x) * s.step_x + static_cast<float>(y) * s.step_y, 0.0F, 1.0F);
        const float window = s.window + along * s.more_window;
        if (i > 0 && !(window < nearest || (window == nearest && inside_[i] < best))) continue;
        best = inside_[i];
        nearest = window;
    }
    return best;
}

void StrokeUnion::add_span(const Piece& left, const Piece& right, double from, double to, std::int32_t shade) {
    spans_.push_back({left.at(from), left.at(to), right.at(from), right.at(to), to - from, shade});
    if (std::find(found_.begin(), found_.end(), shade) == found_.end()) found_.push_back(shade);
}

// Orders the pieces of a slab from left to right. They stand by their leftmost places, so that putting each into its
// place moves few others.
void StrokeUnion::find_order(double y) {
    order_.clear();
    for (std::int32_t number = 0; number < pieces_.size(); ++number) {
        Piece& piece = pieces_[number];
        if (!(piece.upper <= y && y < piece.lower)) continue;
        piece.here = piece.at(y);
        order_.push_back(number);
        std::int64_t k = order_.size() - 1;
        for (; k > 0 && pieces_[order_[k - 1]].here > piece.here; --k) order_[k] = order_[k - 1];
        order_[k] = number;
    }
}

// Adds the trapezoids between two heights where nothing begins, ends or crosses.
void StrokeUnion::add_slab(double from, double to) {
    const double middle = 0.5 * (from + to);
    find_order(middle);
    inside_.clear();
    const Piece* left = nullptr;
    std::int32_t whose = -1;
    for (const std::int32_t number : order_) {
        const Piece& piece = pieces_[number];
        turn(piece.shade, piece.winding);
        const std::int32_t now = inside_.empty() ? -1 : owner(piece.here, middle);
        if (now == whose) continue;
        if (whose >= 0) add_span(*left, piece, from, to, whose);
        left = &piece;
        whose = now;
    }
    constexpr Piece beyond{0.0, 0.0, 1e9, 0.0, 1e9, 1e9, 0, 0, 1e9}; // edges there are left out
    if (whose >= 0) add_span(*left, beyond, from, to, whose);
    for (const std::int32_t shade : inside_) winding_[shade] = 0;
}

// Passes an edge of an outline: its winding number changes.
void StrokeUnion::turn(std::int32_t shade, std::int32_t by) {
    const bool was_inside = winding_[shade] != 0;
    winding_[shade] += by;
    const bool is_inside = winding_[shade] != 0;
    if (was_inside == is_inside) return;
    if (is_inside) {
        inside_.push_back(shade);
        return;
    }
    *std::find(inside_.begin(), inside_.end(), shade) = inside_.back();
    inside_.resize(inside_.size() - 1);
}

std::int32_t StrokeUnion::cut(std::int32_t y) {
    HRBFNPR_ASSERT(y >= 0 && y < height_);
    spans_.clear();
    found_.clear();
    find_pieces(y);
    find_breaks(y);
    for (std::int64_t i = 0; i + 1 < breaks_.size(); ++i)
        if (breaks_[i + 1] - breaks_[i] > raster_tuning.flat) add_slab(breaks_[i], breaks_[i + 1]);
    std::sort(found_.begin(), found_.end());
    return static_cast<std::int32_t>(found_.size());
}

// Adds the area to the right of an edge that goes from x0 to x1 over a height, as steps whose sums are the pixels.
void StrokeUnion::add_edge(double x0, double x1, double height) noexcept {
    double low = std::min(x0, x1);
    double high = std::max(x0, x1);
    const double wide = static_cast<double>(width_);
    if (low >= wide) return;
    const double scale = high > low ? height / (high - low) : 0.0; // height for each pixel
    if (high <= 0.0) {
        steps_[0] += height;
        return;
    }
    if (low < 0.0) {
        steps_[0] -= low * scale;
        height += low * scale;
        low = 0.0;
    }
    if (high > wide) {
        height -= (high - wide) * scale;
        high = wide;
    }
    const auto first = static_cast<std::int32_t>(low);
    const auto last = static_cast<std::int32_t>(high);
    if (first == last || first + 1 >= width_ + 1) { // within a pixel: the mean to its right
        const double beyond = 0.5 * (low + high) - first;
        steps_[first] += height * (1.0 - beyond);
        steps_[first + 1] += height * beyond;
        return;
    }
    for (std::int32_t c = first; c <= last && static_cast<double>(c) < high; ++c) {
        const double from = std::max(low, static_cast<double>(c));
        const double to = std::min(high, static_cast<double>(c) + 1.0);
        const double beyond = 0.5 * (from + to) - c;
        steps_[c] += (to - from) * scale * (1.0 - beyond);
        steps_[c + 1] += (to - from) * scale * beyond;
    }
}

const Shade& StrokeUnion::cover(std::int32_t i, float* pixels, std::int32_t& left, std::int32_t& right) noexcept {
    HRBFNPR_ASSERT(i >= 0 && i < found_.size());
    const std::int32_t shade = found_[i];
    std::fill_n(steps_, width_ + 2, 0.0);
    double low = static_cast<double>(width_);
    double high = 0.0;
    for (const Span& s : spans_) {
        if (s.shade != shade) continue;
        add_edge(s.left_top, s.left_bottom, s.height);
        add_edge(s.right_top, s.right_bottom, -s.height);
        low = std::min({low, s.left_top, s.left_bottom});
        high = std::max({high, s.right_top, s.right_bottom});
    }
    left = row_of(low, width_);
    right = row_of(std::ceil(high), width_);
    double sum = 0.0;
    for (std::int32_t x = 0; x < left; ++x) sum += steps_[x];
    for (std::int32_t x = left; x < right; ++x) {
        sum += steps_[x];
        pixels[x - left] = static_cast<float>(std::clamp(sum, 0.0, 1.0));
    }
    return shades_[shade];
}

} // namespace hrbfnpr::output
