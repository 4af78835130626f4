// SPDX-License-Identifier: MIT
#include "output/vector/lay_out.h"

#include "marks/point_set.h"
#include "output/vector/line_types.h"
#include "output/vector/look.h"
#include "output/vector/paint_runs.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>

namespace hrbfnpr::output {
namespace {

using drawing::Dot;
using drawing::Drawing;
using drawing::Stroke;
using drawing::StrokePoint;

constexpr float opacity_step = 1.0F / 32.0F;      // within a part of a stroke
constexpr std::int64_t laid_out_at_a_time = 4096; // dots, or points of strokes

// Numbers of HRBFNPR_LINE_KIND_...
constexpr std::array<const char*, 12> line_names{"lines",   "contour",        "suggestive", "ridge",
                                                 "valley",  "apparent ridge", "parabolic",  "isophote",
                                                 "section", "border",         "own",        "crease"};

constexpr std::size_t own_lines = 10;

class LayOut {
public:
    LayOut(base::Memory& memory, const Placement& placement, std::span<const Pen> pens, PageSink& sink,
           const base::Progress& progress)
        : drawing_(*placement.drawing), placement_(placement), pens_(pens), sink_(sink), progress_(progress),
          points_(memory), runs_(memory) {}

    void run() {
        sink_.begin_view({placement_.name, frame_of(placement_), drawing_.paper, placement_.with_paper});
        if (drawing_.painting == drawing::Painting::published) {
            add_published();
        } else {
            runs_.find(drawing_, placement_.far_to_near, progress_);
            for (std::int32_t run = 0; run < runs_.runs(); ++run)
                for (std::int64_t layer = 0; layer < drawing_.layers.size(); ++layer) {
                    if (runs_.has(run, InkGroups::of_dots(layer))) add_dots(layer, run);
                    for (std::int32_t hidden = InkGroups::most_hidden; hidden >= 0; --hidden)
                        if (runs_.has(run, InkGroups::of_strokes(layer, hidden))) add_strokes(layer, hidden, run);
                }
        }
        sink_.end_view();
    }

private:
    [[nodiscard]] double x_of(float x) const noexcept {
        return placement_.x + placement_.scale * (static_cast<double>(x) - drawing_.window.viewport.x);
    }
    [[nodiscard]] double y_of(float y) const noexcept {
        return placement_.y + placement_.scale * (static_cast<double>(y) - drawing_.window.viewport.y);
    }

    template <class F>
    void for_dots(const F& f) const {
        for (const drawing::Piece& piece : drawing_.dot_pieces)
            for (std::int64_t i = piece.begin; i < piece.end; ++i) {
                if (i % laid_out_at_a_time == 0) look(progress_);
                if (drawing_.dots[i].opacity >= drawing::faintest_ink) f(drawing_.dots[i], i);
            }
    }

    // Another layer that would have the same name comes before: how many.
    [[nodiscard]] int namesakes(std::int64_t layer, const char* name) const {
        int count = 0;
        char other[PageGroup::most];
        for (std::int64_t i = 0; i < layer; ++i) {
            if (!runs_.has(i)) continue;
            name_layer(i, other);
            count += std::string_view(name) == other ? 1 : 0;
        }
        return count;
    }

    void name_layer(std::int64_t number, char (&name)[PageGroup::most]) const {
        const drawing::Layer& layer = drawing_.layers[number];
        if (layer.layer < 0) {
            const std::size_t kind = std::min<std::size_t>(layer.line_kind, line_names.size() - 1);
            const bool is_own = kind == own_lines && layer.line_name[0] != '\0';
            std::snprintf(name, sizeof name, "%s", is_own ? layer.line_name.data() : line_names[kind]);
            return;
        }
        const marks::Layer& source = drawing_.items[layer.item].set->layers[layer.layer];
        const bool contour = layer.mark_class == drawing::MarkClass::silhouette;
        std::snprintf(name, sizeof name, "%.63s%s", source.name.data(), contour ? " contour" : "");
    }

    static void append(char (&name)[PageGroup::most], const char* what, int number) noexcept {
        const std::size_t used = std::string_view(name).size();
        std::snprintf(name + used, sizeof name - used, "%s %d", what, number);
    }

    // A pen goes by the name without the number of the run.
    void begin(std::int64_t layer, std::int32_t hidden, std::int32_t run) {
        PageGroup group;
        name_layer(layer, group.name);
        if (const int others = namesakes(layer, group.name); others > 0) append(group.name, "", others + 1);
        if (hidden > 0) append(group.name, " hidden", hidden);
        group.ink = drawing_.layers[layer].ink;
        group = with_pen(group, pens_);
        if (run > 0) append(group.name, ", run", run + 1);
        sink_.begin_group(group);
    }

    void add_dots(std::int64_t layer, std::int32_t run) {
        begin(layer, 0, run);
        for_dots([&](const Dot& dot, std::int64_t number) {
            if (dot.layer == layer && runs_.of_dot(number) == run) add_dot(dot);
        });
        sink_.end_group();
    }

    // The radius of a disc with as much ink as the raster's dot, whose rim falls off over a pixel: it covers
    // pi (r^2 + 1 / 12) pixels, and tone goes by that.  Less than half a pixel is drawn that large, and paler.
    [[nodiscard]] static double radius_of(const Dot& dot) noexcept {
        constexpr double smallest = static_cast<double>(drawing::smallest_radius);
        const double radius = std::max(static_cast<double>(dot.radius), smallest);
        const double paler = std::min(static_cast<double>(dot.radius) / smallest, 1.0);
        return paler * std::sqrt(radius * radius + 1.0 / 12.0);
    }

    void add_dot(const Dot& dot) {
        sink_.dot({x_of(dot.x), y_of(dot.y), placement_.scale * radius_of(dot), static_cast<double>(dot.opacity),
                   (dot.flags & drawing::dot_is_paper) != 0});
    }

    // In the order in which they cover each other.                                              [NPAR 6.1]
    void add_published() {
        PageGroup group;
        std::snprintf(group.name, sizeof group.name, "marks");
        if (!drawing_.layers.empty()) group.ink = drawing_.layers[0].ink;
        sink_.begin_group(with_pen(group, pens_));
        for_dots([&](const Dot& dot, std::int64_t) { add_dot(dot); });
        sink_.end_group();
    }

    void add_strokes(std::int64_t layer, std::int32_t hidden, std::int32_t run) {
        begin(layer, hidden, run);
        Looks looks(progress_, laid_out_at_a_time);
        for (std::int64_t i = 0; i < drawing_.strokes.size(); ++i) {
            const Stroke& stroke = drawing_.strokes[i];
            const bool is_here = stroke.layer == layer && InkGroups::hidden_of(stroke) == hidden;
            looks.count(is_here ? 1 + stroke.count : 1);
            if (is_here && runs_.of_stroke(i) == run) add_stroke(stroke);
        }
        sink_.end_group();
    }

    void add_stroke(const Stroke& stroke) {
        points_.clear();
        const StrokePoint* const points = drawing_.points.data() + stroke.first;
        std::int64_t begin = 0;
        for (std::int64_t i = 0; i < stroke.count; ++i) {
            const StrokePoint& p = points[i];
            points_.push_back({x_of(p.x), y_of(p.y), placement_.scale * static_cast<double>(p.radius)});
            const bool is_last = i + 1 == stroke.count;
            if (!is_last && !changes(points, begin, i)) continue;
            if (i > begin) add_part(stroke, points, begin, i);
            begin = i;
            points_.clear();
            points_.push_back({x_of(p.x), y_of(p.y), placement_.scale * static_cast<double>(p.radius)});
        }
    }

    // Whether the part ends at point i, as the next one's opacity is another.
    [[nodiscard]] static bool changes(const StrokePoint* points, std::int64_t begin, std::int64_t i) noexcept {
        return i > begin && std::abs(points[i + 1].opacity - points[begin].opacity) > opacity_step;
    }

    void add_part(const Stroke& stroke, const StrokePoint* points, std::int64_t begin, std::int64_t end) {
        float opacity = 0.0F;
        for (std::int64_t i = begin; i < end; ++i) opacity += 0.5F * (points[i].opacity + points[i + 1].opacity);
        opacity /= static_cast<float>(end - begin);
        if (opacity < drawing::faintest_ink) return;
        const bool is_whole = begin == 0 && end + 1 == stroke.count;
        PagePath path;
        path.points = points_.span();
        path.begin = begin == 0 && !stroke.closed ? stroke.cap_begin : drawing::Cap::flat;
        path.end = end + 1 == stroke.count && !stroke.closed ? stroke.cap_end : drawing::Cap::flat;
        path.closed = stroke.closed && is_whole;
        path.opacity = static_cast<double>(opacity);
        sink_.path(path);
    }

    const Drawing& drawing_;
    const Placement& placement_;
    std::span<const Pen> pens_;
    PageSink& sink_;
    const base::Progress& progress_;
    base::Array<PagePoint> points_;
    PaintRuns runs_;
};

bool fits(std::string_view groups, std::string_view name) noexcept {
    if (groups.empty()) return true;
    if (groups.back() != '*') return groups == name;
    groups.remove_suffix(1);
    return name.substr(0, groups.size()) == groups;
}

} // namespace

Frame frame_of(const Placement& placement) noexcept {
    const glm::dvec4& viewport = placement.drawing->window.viewport;
    return {placement.x, placement.y, placement.x + placement.scale * viewport.z,
            placement.y + placement.scale * viewport.w};
}

PageGroup with_pen(PageGroup group, std::span<const Pen> pens) noexcept {
    for (std::size_t i = pens.size(); i-- > 0;) {
        const Pen& pen = pens[i];
        if (!fits(pen.groups, group.name)) continue;
        group.pen_width = pen.width;
        if (pen.ink.w > 0.0F) group.ink = pen.ink;
        group.pen = pen.number;
        if (pen.line_type != LineType::as_drawn) group.line_type = pen.line_type;
        break;
    }
    return group;
}

void lay_out(base::Memory& memory, const Placement& placement, std::span<const Pen> pens, PageSink& sink,
             const base::Progress& progress) {
    LayOut(memory, placement, pens, sink, progress).run();
}

} // namespace hrbfnpr::output
