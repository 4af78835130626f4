// SPDX-License-Identifier: MIT
#include "output/vector/paint_runs.h"

#include "output/vector/look.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::output {
namespace {

using drawing::Dot;
using drawing::Drawing;
using drawing::Stroke;
using drawing::StrokePoint;

constexpr double least_cell = 4.0; // pixels
constexpr double most_cells = 4e6; // times colours
constexpr std::int64_t painted_at_a_time = 1024;
constexpr std::int64_t runs_compared_at_a_time = 65536;

} // namespace

PaintRuns::PaintRuns(base::Memory& memory) noexcept
    : color_of_(memory), last_(memory), order_(memory), stroke_run_(memory), dot_run_(memory), has_(memory),
      has_layer_(memory) {}

void PaintRuns::find(const Drawing& drawing, bool far_to_near, const base::Progress& progress) {
    set_up(drawing);
    if (far_to_near && !drawing.one_color) assign(drawing, progress);
    note(drawing);
}

// Ink by ink, far to near.
void PaintRuns::assign(const Drawing& drawing, const base::Progress& progress) {
    set_colors(drawing);
    sort_dots(drawing, progress);
    std::int64_t dot = 0;
    const auto add_dots = [&](auto&& comes_before) {
        for (; dot < order_.size() && comes_before(drawing.dots[order_[dot]]); ++dot) {
            if (dot % painted_at_a_time == 0) look(progress);
            add(drawing.dots[order_[dot]], dot_run_[order_[dot]]);
        }
    };
    Looks looks(progress, painted_at_a_time);
    for (std::int64_t i = 0; i < drawing.strokes.size(); ++i) {
        const Stroke& stroke = drawing.strokes[i];
        looks.count(1 + stroke.count);
        add_dots([&](const Dot& one) { return one.depth > stroke.depth; });
        add(drawing, stroke, stroke_run_[i]);
    }
    add_dots([](const Dot&) { return true; });
}

void PaintRuns::set_up(const Drawing& drawing) {
    runs_ = colors_ = 1;
    stroke_run_.clear();
    stroke_run_.resize(drawing.strokes.size());
    dot_run_.clear();
    dot_run_.resize(drawing.dots.size());
    groups_ = InkGroups::of_dots(drawing.layers.size());
}

// And the cells, which are all blank.
void PaintRuns::set_colors(const Drawing& drawing) {
    colors_ = 0;
    color_of_.clear();
    for (std::int64_t i = 0; i < drawing.layers.size(); ++i) {
        std::int32_t color = -1;
        for (std::int64_t k = 0; k < i && color < 0; ++k)
            if (glm::vec3(drawing.layers[k].ink) == glm::vec3(drawing.layers[i].ink)) color = color_of_[k];
        color_of_.push_back(color < 0 ? colors_++ : color);
    }
    const glm::dvec4& viewport = drawing.window.viewport;
    left_ = viewport.x;
    top_ = viewport.y;
    cell_ = std::max(least_cell, std::sqrt(viewport.z * viewport.w * colors_ / most_cells));
    columns_ = std::max(std::int64_t{1}, static_cast<std::int64_t>(std::ceil(viewport.z / cell_)));
    rows_ = std::max(std::int64_t{1}, static_cast<std::int64_t>(std::ceil(viewport.w / cell_)));
    last_.resize_for_overwrite(columns_ * rows_ * colors_);
    std::fill(last_.begin(), last_.end(), -1);
}

void PaintRuns::note(const Drawing& drawing) {
    has_.clear();
    has_.resize(std::int64_t{runs_} * groups_);
    has_layer_.clear();
    has_layer_.resize(drawing.layers.size());
    const auto add_one = [&](std::uint32_t layer, std::int64_t run, std::int32_t group) {
        has_[run * groups_ + group] = 1;
        has_layer_[layer] = 1;
    };
    for (std::int64_t i = 0; i < drawing.strokes.size(); ++i) {
        const Stroke& stroke = drawing.strokes[i];
        add_one(stroke.layer, stroke_run_[i], InkGroups::of_strokes(stroke.layer, InkGroups::hidden_of(stroke)));
    }
    for (const drawing::Piece& piece : drawing.dot_pieces)
        for (std::int64_t i = piece.begin; i < piece.end; ++i)
            if (drawing.dots[i].opacity >= drawing::faintest_ink)
                add_one(drawing.dots[i].layer, dot_run_[i], InkGroups::of_dots(drawing.dots[i].layer));
}

void PaintRuns::sort_dots(const Drawing& drawing, const base::Progress& progress) {
    order_.clear();
    for (const drawing::Piece& piece : drawing.dot_pieces)
        for (std::int64_t i = piece.begin; i < piece.end; ++i)
            if (drawing.dots[i].opacity >= drawing::faintest_ink) order_.push_back(static_cast<std::uint32_t>(i));
    Looks looks(progress, runs_compared_at_a_time);
    std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
        looks.count();
        return drawing.before(a, b);
    });
}

template <class Visit>
void PaintRuns::visit_cells(double x, double y, double radius, Visit&& visit) const {
    const auto cell = [&](double from, std::int64_t most) { // nothing that is beyond the viewport is seen
        return static_cast<std::int64_t>(std::clamp(std::floor(from / cell_), -1.0, static_cast<double>(most)));
    };
    const std::int64_t right = std::min(cell(x + radius - left_, columns_), columns_ - 1);
    const std::int64_t bottom = std::min(cell(y + radius - top_, rows_), rows_ - 1);
    for (std::int64_t row = std::max<std::int64_t>(cell(y - radius - top_, rows_), 0); row <= bottom; ++row)
        for (std::int64_t column = std::max<std::int64_t>(cell(x - radius - left_, columns_), 0); column <= right;
             ++column)
            visit(row * columns_ + column);
}

// In steps of a cell at most.
template <class Visit>
void PaintRuns::visit_cells(const Drawing& drawing, const Stroke& stroke, Visit&& visit) const {
    const StrokePoint* const points = drawing.points.data() + stroke.first;
    for (std::int64_t i = 1; i < stroke.count; ++i) {
        const auto x = static_cast<double>(points[i - 1].x), y = static_cast<double>(points[i - 1].y);
        const double dx = static_cast<double>(points[i].x) - x, dy = static_cast<double>(points[i].y) - y;
        const auto radius = static_cast<double>(std::max(points[i - 1].radius, points[i].radius));
        const double length = std::hypot(dx, dy);
        if (!(length < 1e6)) continue; // far beyond any viewport
        const auto steps = static_cast<int>(length / cell_) + 1;
        for (int step = 0; step <= steps; ++step)
            visit_cells(x + dx * step / steps, y + dy * step / steps, radius, visit);
    }
}

void PaintRuns::find_last(std::int64_t cell, std::int32_t color, std::int32_t& most) const noexcept {
    for (std::int32_t other = 0; other < colors_; ++other)
        if (other != color) most = std::max(most, last_[cell * colors_ + other]);
}

// The first place of a group, counted on from run to run, behind another; in the last run it may be before it.
std::int32_t PaintRuns::place_after(std::int32_t most, std::int32_t group) noexcept {
    std::int32_t run = most < 0 ? 0 : most / groups_;
    if (most >= 0 && most % groups_ > group) ++run;
    run = std::min(run, most_runs - 1);
    runs_ = std::max(runs_, run + 1);
    return run * groups_ + group;
}

void PaintRuns::add(const Dot& dot, std::uint8_t& run) {
    const std::int32_t color = color_of_[dot.layer];
    std::int32_t most = -1;
    const auto x = static_cast<double>(dot.x), y = static_cast<double>(dot.y), radius = static_cast<double>(dot.radius);
    visit_cells(x, y, radius, [&](std::int64_t cell) { find_last(cell, color, most); });
    const std::int32_t place = place_after(most, InkGroups::of_dots(dot.layer));
    visit_cells(x, y, radius, [&](std::int64_t cell) {
        std::int32_t& last = last_[cell * colors_ + color];
        last = std::max(last, place);
    });
    run = static_cast<std::uint8_t>(place / groups_);
}

void PaintRuns::add(const Drawing& drawing, const Stroke& stroke, std::uint8_t& run) {
    const std::int32_t color = color_of_[stroke.layer];
    std::int32_t most = -1;
    visit_cells(drawing, stroke, [&](std::int64_t cell) { find_last(cell, color, most); });
    const std::int32_t place = place_after(most, InkGroups::of_strokes(stroke.layer, InkGroups::hidden_of(stroke)));
    visit_cells(drawing, stroke, [&](std::int64_t cell) {
        std::int32_t& last = last_[cell * colors_ + color];
        last = std::max(last, place);
    });
    run = static_cast<std::uint8_t>(place / groups_);
}

} // namespace hrbfnpr::output
