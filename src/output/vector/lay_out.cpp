// SPDX-License-Identifier: MIT
// 1. find_runs: how often groups begin anew, so that inks of several colours that lie upon each other are painted far
// to
//    near, as the raster does.
// 2. lay_out: for each run, layer and number of hiding layers a group with its name and pen, and its dots or strokes.
#include "marks/point_set.h"
#include "output/vector/tuning.h"
#include "output/vector/write_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace hrbfnpr::output {
namespace {

using drawing::Dot;
using drawing::Drawing;
using drawing::Stroke;
using drawing::StrokePoint;

// ---- Groups of ink: a layer's dots, or its strokes that a number of layers of surface hide

constexpr std::int32_t most_hidden = 31; // strokes that more surfaces hide count as hidden by this many
constexpr std::int32_t groups_of_layer = most_hidden + 2;

std::int32_t hidden_layers(const Stroke& stroke) noexcept { return std::clamp(stroke.hidden_layers, 0, most_hidden); }
std::int32_t group_of_dots(std::int64_t layer) noexcept { return static_cast<std::int32_t>(layer) * groups_of_layer; }
// Strokes that more surfaces hide come before others.
std::int32_t group_of_strokes(std::int64_t layer, std::int32_t hidden) noexcept {
    HRBFNPR_ASSERT(hidden >= 0 && hidden <= most_hidden);
    return group_of_dots(layer) + 1 + most_hidden - hidden;
}

// Calls f(dot, number) for the dots that are seen.
template <class F>
void for_dots(const Drawing& drawing, const base::Progress& progress, const F& f) {
    Looks looks(progress, steps_a_look);
    for (const drawing::Piece& piece : drawing.dot_pieces)
        for (std::int64_t i = piece.begin; i < piece.end; ++i) {
            looks.count();
            if (drawing.dots[i].opacity >= drawing::faintest_ink) f(drawing.dots[i], i);
        }
}

// ---- Runs

// All groups are painted in their order, run after run. An ink is in the first run in which it comes after all ink of
// another colour that it lies upon; in the last run it may come before it.
struct Runs {
    explicit Runs(base::Memory& memory) noexcept
        : of_stroke(memory), of_dot(memory), has_group(memory), has_layer(memory) {}

    std::int32_t count = 1, groups = 0;
    base::Array<std::uint8_t> of_stroke, of_dot;
    base::Array<std::uint8_t> has_group; // whether there is ink of each group of each run
    base::Array<std::uint8_t> has_layer; // whether there is ink of each layer

    [[nodiscard]] bool has(std::int32_t run, std::int32_t group) const noexcept {
        HRBFNPR_ASSERT(run < count && group < groups);
        return has_group[std::int64_t{run} * groups + group] != 0;
    }
};

// The cells of a viewport, and where the ink in each was painted last.
struct Cells {
    double left, top, side;
    std::int64_t columns, rows;
    std::int32_t colors;
    base::Array<std::int32_t> color;         // the number of each layer's colour
    base::Array<std::int32_t> painted_where; // for each cell and colour, the last group that painted there, counted on
                                             // from run to run; -1: none

    // Calls visit(cell) for the cells that a disc may touch. Nothing beyond the viewport is seen.
    template <class Visit>
    void for_disc(double x, double y, double radius, const Visit& visit) const {
        const auto cell = [&](double from, std::int64_t most) {
            return static_cast<std::int64_t>(std::clamp(std::floor(from / side), -1.0, static_cast<double>(most)));
        };
        const std::int64_t right = std::min(cell(x + radius - left, columns), columns - 1);
        const std::int64_t bottom = std::min(cell(y + radius - top, rows), rows - 1);
        const std::int64_t first = std::max<std::int64_t>(cell(x - radius - left, columns), 0);
        for (std::int64_t row = std::max<std::int64_t>(cell(y - radius - top, rows), 0); row <= bottom; ++row)
            for (std::int64_t column = first; column <= right; ++column) visit(row * columns + column);
    }
    // The same for a stroke, in steps of a cell at most.
    template <class Visit>
    void for_stroke(const Drawing& drawing, const Stroke& stroke, const Visit& visit) const {
        const StrokePoint* const points = drawing.points.data() + stroke.first;
        for (std::int64_t i = 1; i < stroke.count; ++i) {
            const auto x = static_cast<double>(points[i - 1].x), y = static_cast<double>(points[i - 1].y);
            const double dx = static_cast<double>(points[i].x) - x, dy = static_cast<double>(points[i].y) - y;
            const auto radius = static_cast<double>(std::max(points[i - 1].radius, points[i].radius));
            const double length = std::hypot(dx, dy);
            if (!(length < 1e6)) continue; // far beyond any viewport
            const auto steps = static_cast<int>(length / side) + 1;
            for (int step = 0; step <= steps; ++step)
                for_disc(x + dx * step / steps, y + dy * step / steps, radius, visit);
        }
    }
};

Cells blank_cells(base::Memory& memory, const Drawing& drawing) {
    const glm::dvec4& viewport = drawing.window.viewport;
    Cells cells{
        viewport.x, viewport.y, 1.0, 1, 1, 0, base::Array<std::int32_t>(memory), base::Array<std::int32_t>(memory)};
    for (std::int64_t i = 0; i < drawing.layers.size(); ++i) {
        std::int64_t like = 0;
        while (glm::vec3(drawing.layers[like].ink) != glm::vec3(drawing.layers[i].ink) && like < i) ++like;
        cells.color.push_back(like < i ? cells.color[like] : cells.colors++);
    }
    cells.side = std::max(lay_out_tuning.least_cell,
                          std::sqrt(viewport.z * viewport.w * cells.colors / lay_out_tuning.most_cells));
    cells.columns = std::max(std::int64_t{1}, static_cast<std::int64_t>(std::ceil(viewport.z / cells.side)));
    cells.rows = std::max(std::int64_t{1}, static_cast<std::int64_t>(std::ceil(viewport.w / cells.side)));
    cells.painted_where.resize_for_overwrite(cells.columns * cells.rows * cells.colors);
    std::fill(cells.painted_where.begin(), cells.painted_where.end(), -1);
    return cells;
}

// Paints one ink, whose cells for_cells(visit) visits, and returns its run.
template <class ForCells>
std::uint8_t paint(Cells& cells, Runs& runs, std::uint32_t layer, std::int32_t group, const ForCells& for_cells) {
    const std::int32_t color = cells.color[layer];
    std::int32_t most = -1; // the last group of another colour that is painted below the ink; -1: none
    for_cells([&](std::int64_t cell) {
        for (std::int32_t other = 0; other < cells.colors; ++other)
            if (other != color) most = std::max(most, cells.painted_where[cell * cells.colors + other]);
    });
    std::int32_t run = most < 0 ? 0 : most / runs.groups;
    if (most >= 0 && most % runs.groups > group) ++run;
    run = std::min(run, lay_out_tuning.most_runs - 1);
    runs.count = std::max(runs.count, run + 1);
    for_cells([&](std::int64_t cell) {
        std::int32_t& last = cells.painted_where[cell * cells.colors + color];
        last = std::max(last, run * runs.groups + group);
    });
    return static_cast<std::uint8_t>(run);
}

// Paints all ink far to near.
void paint_all(base::Memory& memory, const Drawing& drawing, const base::Progress& progress, Runs& runs) {
    Cells cells = blank_cells(memory, drawing);
    base::Array<std::uint32_t> order(memory); // the numbers of the dots, far to near
    for_dots(drawing, progress,
             [&](const Dot&, std::int64_t number) { order.push_back(static_cast<std::uint32_t>(number)); });
    Looks comparisons(progress, comparisons_a_look);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        comparisons.count();
        return drawing.before(a, b);
    });
    Looks looks(progress, steps_a_look);
    std::int64_t painted = 0; // the number of dots that were painted
    const auto paint_dots = [&](const auto& comes_before) {
        for (; painted < order.size() && comes_before(drawing.dots[order[painted]]); ++painted) {
            looks.count();
            const Dot& dot = drawing.dots[order[painted]];
            runs.of_dot[order[painted]] =
                paint(cells, runs, dot.layer, group_of_dots(dot.layer), [&](const auto& visit) {
                    cells.for_disc(static_cast<double>(dot.x), static_cast<double>(dot.y),
                                   static_cast<double>(dot.radius), visit);
                });
        }
    };
    for (std::int64_t i = 0; i < drawing.strokes.size(); ++i) {
        const Stroke& stroke = drawing.strokes[i];
        looks.count(1 + stroke.count);
        paint_dots([&](const Dot& dot) { return dot.depth > stroke.depth; });
        runs.of_stroke[i] = paint(cells, runs, stroke.layer, group_of_strokes(stroke.layer, hidden_layers(stroke)),
                                  [&](const auto& visit) { cells.for_stroke(drawing, stroke, visit); });
    }
    paint_dots([](const Dot&) { return true; });
}

Runs find_runs(base::Memory& memory, const Drawing& drawing, bool far_to_near, const base::Progress& progress) {
    Runs runs(memory);
    runs.groups = group_of_dots(drawing.layers.size());
    runs.of_stroke.resize(drawing.strokes.size());
    runs.of_dot.resize(drawing.dots.size());
    if (far_to_near && !drawing.one_color) paint_all(memory, drawing, progress, runs);
    runs.has_group.resize(std::int64_t{runs.count} * runs.groups);
    runs.has_layer.resize(drawing.layers.size());
    const auto note = [&](std::uint32_t layer, std::int64_t run, std::int32_t group) {
        runs.has_group[run * runs.groups + group] = 1;
        runs.has_layer[layer] = 1;
    };
    for (std::int64_t i = 0; i < drawing.strokes.size(); ++i) {
        const Stroke& stroke = drawing.strokes[i];
        note(stroke.layer, runs.of_stroke[i], group_of_strokes(stroke.layer, hidden_layers(stroke)));
    }
    for_dots(drawing, progress, [&](const Dot& dot, std::int64_t number) {
        note(dot.layer, runs.of_dot[number], group_of_dots(dot.layer));
    });
    return runs;
}

// ---- Names and pens

// The names of kinds of lines, by the numbers that hrbfnpr_line_style.kind takes.
constexpr std::array<const char*, 12> line_names{"lines",   "contour",        "suggestive", "ridge",
                                                 "valley",  "apparent ridge", "parabolic",  "isophote",
                                                 "section", "border",         "own",        "crease"};
constexpr std::size_t own_lines = 10;

void name_layer(const Drawing& drawing, std::int64_t number, char (&name)[PageGroup::most]) {
    const drawing::Layer& layer = drawing.layers[number];
    if (layer.layer < 0) {
        const std::size_t kind = std::min<std::size_t>(layer.line_kind, line_names.size() - 1);
        const bool is_own = kind == own_lines && layer.line_name[0] != '\0';
        std::snprintf(name, sizeof name, "%s", is_own ? layer.line_name.data() : line_names[kind]);
        return;
    }
    const marks::Layer& source = drawing.items[layer.item].set->layers[layer.layer];
    const bool contour = layer.mark_class == drawing::MarkClass::silhouette;
    std::snprintf(name, sizeof name, "%.63s%s", source.name.data(), contour ? " contour" : "");
}

void append(char (&name)[PageGroup::most], const char* what, int number) noexcept {
    const std::size_t used = std::string_view(name).size();
    std::snprintf(name + used, sizeof name - used, "%s %d", what, number);
}

bool fits(std::string_view groups, std::string_view name) noexcept {
    if (groups.empty()) return true;
    if (groups.back() != '*') return groups == name;
    groups.remove_suffix(1);
    return name.substr(0, groups.size()) == groups;
}

// A group's name tells it from earlier layers of the same name that have ink. Its pen goes by the name without the
// number of the run.
PageGroup group_of(const Drawing& drawing, const Runs& runs, std::span<const Pen> pens, std::int64_t layer,
                   std::int32_t hidden, std::int32_t run) {
    PageGroup group;
    name_layer(drawing, layer, group.name);
    int namesakes = 0;
    char other[PageGroup::most];
    for (std::int64_t i = 0; i < layer; ++i) {
        if (runs.has_layer[i] == 0) continue;
        name_layer(drawing, i, other);
        namesakes += std::string_view(group.name) == other ? 1 : 0;
    }
    if (namesakes > 0) append(group.name, "", namesakes + 1);
    if (hidden > 0) append(group.name, " hidden", hidden);
    group.ink = drawing.layers[layer].ink;
    group = with_pen(group, pens);
    if (run > 0) append(group.name, ", run", run + 1);
    return group;
}

// ---- Ink

struct Mapping {
    const Placement& placement;

    [[nodiscard]] PagePoint operator()(float x, float y, double radius) const noexcept {
        const glm::dvec4& viewport = placement.drawing->window.viewport;
        return {placement.x + placement.scale * (static_cast<double>(x) - viewport.x),
                placement.y + placement.scale * (static_cast<double>(y) - viewport.y), placement.scale * radius};
    }
};

// The disc has as much ink as the raster's dot, whose rim falls off over a pixel: that covers pi (r^2 + 1 / 12) pixels,
// and tone goes by it. A radius of less than half a pixel is drawn as half a pixel, and paler.
PageDot page_dot(const Mapping& map, const Dot& dot) noexcept {
    constexpr double smallest = static_cast<double>(drawing::smallest_radius);
    const double radius = std::max(static_cast<double>(dot.radius), smallest);
    const double paler = std::min(static_cast<double>(dot.radius) / smallest, 1.0);
    const PagePoint p = map(dot.x, dot.y, paler * std::sqrt(radius * radius + 1.0 / 12.0));
    return {p.x, p.y, p.radius, static_cast<double>(dot.opacity), (dot.flags & drawing::dot_is_paper) != 0};
}

// Hands on the parts of a stroke that have an even opacity.
void add_stroke(const Mapping& map, const Stroke& stroke, base::Array<PagePoint>& page, PageSink& sink) {
    HRBFNPR_ASSERT(stroke.count > 1);
    const StrokePoint* const points = map.placement.drawing->points.data() + stroke.first;
    std::int64_t end = 0;
    for (std::int64_t begin = 0; begin + 1 < stroke.count; begin = end) {
        end = begin + 1;
        while (end + 1 < stroke.count &&
               !(std::abs(points[end + 1].opacity - points[begin].opacity) > lay_out_tuning.opacity_step))
            ++end;
        float opacity = 0.0F;
        for (std::int64_t i = begin; i < end; ++i) opacity += 0.5F * (points[i].opacity + points[i + 1].opacity);
        opacity /= static_cast<float>(end - begin);
        if (opacity < drawing::faintest_ink) continue;
        page.clear();
        for (std::int64_t i = begin; i <= end; ++i)
            page.push_back(map(points[i].x, points[i].y, static_cast<double>(points[i].radius)));
        const bool at_begin = begin == 0, at_end = end + 1 == stroke.count;
        PagePath path;
        path.points = page.span();
        path.begin = at_begin && !stroke.closed ? stroke.cap_begin : drawing::Cap::flat;
        path.end = at_end && !stroke.closed ? stroke.cap_end : drawing::Cap::flat;
        path.closed = stroke.closed && at_begin && at_end;
        path.opacity = static_cast<double>(opacity);
        sink.path(path);
    }
}

// As published, dots of paper and ink stand in the order in which they cover each other. [NPAR 6.1]
void add_published(const Mapping& map, std::span<const Pen> pens, PageSink& sink, const base::Progress& progress) {
    const Drawing& drawing = *map.placement.drawing;
    PageGroup group;
    std::snprintf(group.name, sizeof group.name, "marks");
    if (!drawing.layers.empty()) group.ink = drawing.layers[0].ink;
    sink.begin_group(with_pen(group, pens));
    for_dots(drawing, progress, [&](const Dot& dot, std::int64_t) { sink.dot(page_dot(map, dot)); });
    sink.end_group();
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
    const Drawing& drawing = *placement.drawing;
    const Mapping map{placement};
    sink.begin_view({placement.name, frame_of(placement), drawing.paper, placement.with_paper});
    if (drawing.painting == drawing::Painting::published) {
        add_published(map, pens, sink, progress);
        sink.end_view();
        return;
    }
    const Runs runs = find_runs(memory, drawing, placement.far_to_near, progress);
    base::Array<PagePoint> page(memory);
    Looks looks(progress, steps_a_look);
    for (std::int32_t run = 0; run < runs.count; ++run)
        for (std::int64_t layer = 0; layer < drawing.layers.size(); ++layer) {
            if (runs.has(run, group_of_dots(layer))) {
                sink.begin_group(group_of(drawing, runs, pens, layer, 0, run));
                for_dots(drawing, progress, [&](const Dot& dot, std::int64_t number) {
                    if (dot.layer == layer && runs.of_dot[number] == run) sink.dot(page_dot(map, dot));
                });
                sink.end_group();
            }
            for (std::int32_t hidden = most_hidden; hidden >= 0; --hidden) {
                if (!runs.has(run, group_of_strokes(layer, hidden))) continue;
                sink.begin_group(group_of(drawing, runs, pens, layer, hidden, run));
                for (std::int64_t i = 0; i < drawing.strokes.size(); ++i) {
                    const Stroke& stroke = drawing.strokes[i];
                    const bool is_here = stroke.layer == layer && hidden_layers(stroke) == hidden;
                    looks.count(is_here ? 1 + stroke.count : 1);
                    if (is_here && runs.of_stroke[i] == run) add_stroke(map, stroke, page, sink);
                }
                sink.end_group();
            }
        }
    sink.end_view();
}

} // namespace hrbfnpr::output
