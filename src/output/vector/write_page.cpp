// SPDX-License-Identifier: MIT
// From drawings to a file:
// 1. find_runs decides how often the groups are repeated, so that overlapping inks of several colours are painted from
//    far to near, as in the raster.
// 2. lay_out makes a group with a name and a pen for each run, layer and number of hiding surfaces, and adds its dots
//    or strokes.
// 3. write_page makes the writer and the filters before it (filters.cpp), and passes drawings and annotations to them.
#include "marks/point_set.h"
#include "output/vector/shapes.h"
#include "output/vector/tuning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace hrbfnpr::output {
namespace {

using drawing::Dot;
using drawing::Drawing;
using drawing::Stroke;
using drawing::StrokePoint;

// ---- Groups of ink: the dots of a layer, or the strokes of a layer that a given number of surfaces hides

// The largest number of hiding surfaces that has a group. Strokes that more surfaces hide are in this group, too.
constexpr std::int32_t most_hidden = 31;
constexpr std::int32_t groups_of_layer = most_hidden + 2;

std::int32_t hidden_layers(const Stroke& stroke) noexcept { return std::clamp(stroke.hidden_layers, 0, most_hidden); }
std::int32_t group_of_dots(std::int64_t layer) noexcept { return static_cast<std::int32_t>(layer) * groups_of_layer; }
// Returns the index of a group of strokes. Groups that more surfaces hide come first.
std::int32_t group_of_strokes(std::int64_t layer, std::int32_t hidden) noexcept {
    HRBFNPR_ASSERT(hidden >= 0 && hidden <= most_hidden);
    return group_of_dots(layer) + 1 + most_hidden - hidden;
}

// Calls f(dot, number) for the visible dots.
template <class F>
void for_dots(const Drawing& drawing, const base::Progress& progress, const F& f) {
    CancelChecks checks(progress, steps_per_check);
    for (const drawing::IndexRange& piece : drawing.dot_ranges)
        for (std::int64_t i = piece.begin; i < piece.end; ++i) {
            checks.count();
            if (drawing.dots[i].opacity >= drawing::faintest_ink) f(drawing.dots[i], i);
        }
}

// ---- Runs

// The assignment of ink to runs. All groups of a run are painted in order, then those of the next run. A dot or stroke
// belongs to the first run in which it is painted after all ink of other colours below it. In the last run, this order
// may be violated.
struct Runs {
    explicit Runs(base::Memory& memory) noexcept
        : of_stroke(memory), of_dot(memory), has_group(memory), has_layer(memory) {}

    std::int32_t count = 1, groups = 0;
    base::Array<std::uint8_t> of_stroke, of_dot;
    base::Array<std::uint8_t> has_group; // whether each group of each run has ink
    base::Array<std::uint8_t> has_layer; // whether each layer has ink

    [[nodiscard]] bool has(std::int32_t run, std::int32_t group) const noexcept {
        HRBFNPR_ASSERT(run < count && group < groups);
        return has_group[std::int64_t{run} * groups + group] != 0;
    }
};

// The cells of a viewport, and which ink was painted last in each.
struct Cells {
    double left, top, side;
    std::int64_t columns, rows;
    std::int32_t colors;
    base::Array<std::int32_t> color; // the colour number of each layer
    // For each cell and colour, run * groups + group of the last ink; -1: no ink.
    base::Array<std::int32_t> painted_where;

    // Calls visit(cell) for the cells in the viewport that a disc may touch.
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
    // Calls visit(cell) for the cells that a stroke may touch, sampled in steps of at most one cell.
    template <class Visit>
    void for_stroke(const Drawing& drawing, const Stroke& stroke, const Visit& visit) const {
        const StrokePoint* const points = drawing.points.data() + stroke.first;
        for (std::int64_t i = 1; i < stroke.count; ++i) {
            const auto x = static_cast<double>(points[i - 1].x), y = static_cast<double>(points[i - 1].y);
            const double dx = static_cast<double>(points[i].x) - x, dy = static_cast<double>(points[i].y) - y;
            const auto radius = static_cast<double>(std::max(points[i - 1].radius, points[i].radius));
            const double length = std::hypot(dx, dy);
            if (!(length < 1e6)) continue; // the stroke is far beyond any viewport
            const auto steps = static_cast<int>(length / side) + 1;
            for (int step = 0; step <= steps; ++step)
                for_disc(x + dx * step / steps, y + dy * step / steps, radius, visit);
        }
    }
};

// Returns whether it does not matter which of two layers is painted first: both have one colour, or they are inks of
// one layer of marks.
[[nodiscard]] bool have_one_order(const drawing::Layer& a, const drawing::Layer& b) noexcept {
    if (glm::vec3(a.ink) == glm::vec3(b.ink)) return true;
    return a.layer >= 0 && a.item == b.item && a.layer == b.layer && a.mark_class == b.mark_class;
}

Cells blank_cells(base::Memory& memory, const Drawing& drawing) {
    const glm::dvec4& viewport = drawing.window.viewport;
    Cells cells{
        viewport.x, viewport.y, 1.0, 1, 1, 0, base::Array<std::int32_t>(memory), base::Array<std::int32_t>(memory)};
    for (std::int64_t i = 0; i < drawing.layers.size(); ++i) {
        std::int64_t like = 0;
        while (like < i && !have_one_order(drawing.layers[like], drawing.layers[i])) ++like;
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

// Paints a dot or stroke into the cells that for_cells(visit) visits. Returns the run of the dot or stroke.
template <class ForCells>
std::uint8_t paint(Cells& cells, Runs& runs, std::uint32_t layer, std::int32_t group, const ForCells& for_cells) {
    const std::int32_t color = cells.color[layer];
    std::int32_t most = -1; // run * groups + group of the last ink of another colour in these cells; -1: none
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

// Assigns all ink to runs, from far to near.
void paint_all(base::Memory& memory, const Drawing& drawing, const base::Progress& progress, Runs& runs) {
    Cells cells = blank_cells(memory, drawing);
    base::Array<std::uint32_t> order(memory); // the numbers of the dots, far to near
    for_dots(drawing, progress,
             [&](const Dot&, std::int64_t number) { order.push_back(static_cast<std::uint32_t>(number)); });
    CancelChecks comparisons(progress, comparisons_per_check);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        comparisons.count();
        return drawing.before(a, b);
    });
    CancelChecks checks(progress, steps_per_check);
    std::int64_t painted = 0; // the number of dots painted
    const auto paint_dots = [&](const auto& comes_before) {
        for (; painted < order.size() && comes_before(drawing.dots[order[painted]]); ++painted) {
            checks.count();
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
        checks.count(1 + stroke.count);
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

// The names of kinds of lines, indexed by hrbfnpr_line_style.kind.
constexpr std::array<const char*, 17> line_names{
    "lines",     "contour",    "suggestive", "ridge",        "valley",      "apparent ridge",
    "parabolic", "isophote",   "section",    "border",       "own",         "crease",
    "shadow",    "terminator", "soft edge",  "intersection", "tangent edge"};
constexpr std::size_t own_lines = 10;

void append(char (&name)[PageGroup::most], const char* what, int number) noexcept {
    const std::size_t used = std::string_view(name).size();
    std::snprintf(name + used, sizeof name - used, "%s %d", what, number);
}

// The ink is not part of the name, because numbers of namesakes stand before it.
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
    std::snprintf(name, sizeof name, "%.63s%s%s", source.name.data(), contour ? " contour" : "",
                  layer.other_side ? " back" : "");
}

// The placement's viewport on the page.
Frame frame_of(const Placement& placement) noexcept {
    const glm::dvec4& viewport = placement.drawing->window.viewport;
    return {placement.x, placement.y, placement.x + placement.scale * viewport.z,
            placement.y + placement.scale * viewport.w};
}

// Returns the number of a group's pen if pens for several groups begin at `first`. Groups without a number of an ink
// share the first pen, and each ink of a palette has one of the next pens.
[[nodiscard]] std::uint32_t pen_of(std::uint32_t first, std::int32_t ink_number) noexcept {
    return first + static_cast<std::uint32_t>(1 + ink_number);
}

// Returns the group with the last pen whose pattern matches the group's name.
PageGroup with_pen(PageGroup group, std::span<const Pen> pens) noexcept {
    for (std::size_t i = pens.size(); i-- > 0;) {
        const Pen& pen = pens[i];
        const bool is_beginning = pen.groups.ends_with('*');
        const std::string_view groups = pen.groups.substr(0, pen.groups.size() - (is_beginning ? 1 : 0));
        const std::string_view name = group.name;
        if (!pen.groups.empty() && (is_beginning ? !name.starts_with(groups) : name != groups)) continue;
        group.pen_width = pen.width;
        if (pen.ink.w > 0.0F) group.ink = pen.ink;
        const bool is_for_one = !is_beginning && !pen.groups.empty();
        group.pen = is_for_one ? pen.number : pen_of(pen.number, group.ink_number);
        if (pen.line_type != LineType::as_drawn) group.line_type = pen.line_type;
        break;
    }
    return group;
}

// A group's name gets a number if earlier layers of the same name have drawn in the same ink of the palette. The number
// of the run is added after the pen was chosen, so pens match names without it.
PageGroup group_of(const Drawing& drawing, const Runs& runs, std::span<const Pen> pens, std::int64_t layer,
                   std::int32_t hidden, std::int32_t run) {
    PageGroup group;
    name_layer(drawing, layer, group.name);
    int namesakes = 0;
    char other[PageGroup::most];
    const std::int32_t ink_number = drawing.layers[layer].ink_number;
    for (std::int64_t i = 0; i < layer; ++i) {
        if (runs.has_layer[i] == 0 || drawing.layers[i].ink_number != ink_number) continue;
        name_layer(drawing, i, other);
        namesakes += std::string_view(group.name) == other ? 1 : 0;
    }
    if (namesakes > 0) append(group.name, "", namesakes + 1);
    if (ink_number >= 0) append(group.name, " ink", ink_number + 1);
    if (hidden > 0) append(group.name, " hidden", hidden);
    group.ink = drawing.layers[layer].ink;
    group.ink_number = ink_number;
    group.pen = pen_of(1, group.ink_number);
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

// Returns a disc with as much ink as the raster's dot. The rim of that dot falls off over one pixel, so it covers pi
// (r^2 + 1 / 12) square pixels, which determines the tone. A radius below half a pixel is drawn as half a pixel, but
// paler.
PageDot page_dot(const Mapping& map, const Dot& dot) noexcept {
    constexpr double smallest = static_cast<double>(drawing::smallest_radius);
    const double radius = std::max(static_cast<double>(dot.radius), smallest);
    const double paler = std::min(static_cast<double>(dot.radius) / smallest, 1.0);
    const PagePoint p = map(dot.x, dot.y, paler * std::sqrt(radius * radius + 1.0 / 12.0));
    return {p.x, p.y, p.radius, static_cast<double>(dot.opacity), (dot.flags & drawing::dot_is_paper) != 0};
}

// Passes on the parts of a stroke that have constant opacity.
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

// ---- Groups

// Lists the groups of a page, and ignores its ink.
class GroupList final : public PageSink {
public:
    explicit GroupList(base::Array<PageGroup>& groups) noexcept : groups_(groups) {}
    void begin_view(const PageView&) override {}
    void begin_group(const PageGroup& group) override { groups_.push_back(group); }
    void path(const PagePath&) override {}
    void dot(const PageDot&) override {}
    void text(const PageText&) override {}
    void end_group() override {}
    void end_view() override {}
    void finish() override {}

private:
    base::Array<PageGroup>& groups_;
};
// The share of the work that lists the groups of a page.
constexpr double share_of_groups = 0.1;

// ---- Annotations

// Writes the annotations. Consecutive annotations of the same group form one group on the page.
void add_annotations(base::Memory& memory, const Page& page, PageSink& sink, const base::Progress& progress) {
    base::Array<PagePoint> points(memory);
    const Annotation* open = nullptr;
    CancelChecks checks(progress, steps_per_check);
    for (const Annotation& annotation : page.annotations) {
        checks.count(1 + static_cast<std::int64_t>(annotation.points.size()));
        if (open == nullptr || open->group != annotation.group) {
            if (open != nullptr) sink.end_group();
            PageGroup group;
            group.name[annotation.group.copy(group.name, PageGroup::most - 1)] = '\0';
            group.ink = annotation.ink;
            group.line_type = annotation.line_type;
            sink.begin_group(with_pen(group, page.pens));
            open = &annotation;
        }
        points.clear();
        for (std::size_t i = 0; i + 1 < annotation.points.size(); i += 2)
            points.push_back({annotation.points[i], annotation.points[i + 1], 0.5 * annotation.width});
        PagePath path;
        path.points = points.span();
        path.closed = points.size() > 3 && place_of(points[0]) == place_of(points.back());
        path.begin = path.end = drawing::Cap::flat;
        if (annotation.text == nullptr && points.size() > 1) sink.path(path);
        if (annotation.text != nullptr && !points.empty())
            sink.text({points[0].x, points[0].y, annotation.width, annotation.text});
    }
    if (open != nullptr) sink.end_group();
}

} // namespace

void lay_out(base::Memory& memory, const Placement& placement, std::span<const Pen> pens, PageSink& sink,
             const base::Progress& progress) {
    const Drawing& drawing = *placement.drawing;
    const Mapping map{placement};
    sink.begin_view({placement.name, frame_of(placement), drawing.paper, placement.with_paper});
    if (drawing.painting == drawing::Painting::published) {
        // Dots of paper and ink keep the order in which they cover each other. [NPAR 6.1]
        PageGroup group;
        std::snprintf(group.name, sizeof group.name, "marks");
        if (!drawing.layers.empty()) group.ink = drawing.layers[0].ink;
        sink.begin_group(with_pen(group, pens));
        for_dots(drawing, progress, [&](const Dot& dot, std::int64_t) { sink.dot(page_dot(map, dot)); });
        sink.end_group();
        sink.end_view();
        return;
    }
    const Runs runs = find_runs(memory, drawing, placement.far_to_near, progress);
    base::Array<PagePoint> page(memory);
    CancelChecks checks(progress, steps_per_check);
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
                    checks.count(is_here ? 1 + stroke.count : 1);
                    if (is_here && runs.of_stroke[i] == run) add_stroke(map, stroke, page, sink);
                }
                sink.end_group();
            }
        }
    sink.end_view();
}

glm::dvec2 page_size(const Page& page, const PageSettings& settings) noexcept {
    glm::dvec2 reach(0.0);
    for (const Placement& placement : page.placements) {
        const Frame frame = frame_of(placement);
        reach = {std::max(reach.x, frame.right), std::max(reach.y, frame.bottom)};
    }
    return {settings.width > 0.0 ? settings.width : reach.x, settings.height > 0.0 ? settings.height : reach.y};
}

PageCounts write_page(const base::Work& work, const Page& page, const PageSettings& given, io::Writer& writer) {
    PageCounts counts;
    PageInfo info = page.info;
    PageSettings settings = given;
    const glm::dvec2 size = page_size(page, given);
    info.width = settings.width = size.x;
    info.height = settings.height = size.y;
    base::Memory& memory = work.memory;
    const bool is_dxf = settings.format == PageFormat::dxf;
    const bool is_sorted = settings.in_plot_order || settings.for_plotter();
    const bool filled = !settings.without_paper;
    const glm::vec4 paper = page.placements.empty() ? glm::vec4(1.0F) : page.placements[0].drawing->paper;
    const auto add_all = [&](PageSink& sink, const base::Work& progress) {
        const auto parts = static_cast<double>(page.placements.size() + 1);
        double done = 0.0;
        if (filled) { // the page gets the paper of its first drawing, or white
            sink.begin_view({{}, {0.0, 0.0, size.x, size.y}, paper, true});
            sink.end_view();
        }
        for (Placement placement : page.placements) {
            placement.with_paper = filled && placement.drawing->paper != paper;
            // Each pen or layer is used only once if lines are sorted for plotting, and in DXF. Then ink is not ordered
            // from far to near.
            placement.far_to_near = !is_sorted && !is_dxf;
            lay_out(memory, placement, page.pens, sink, progress.part(done / parts, (done + 1.0) / parts));
            done += 1.0;
            progress.update(done / parts);
        }
        add_annotations(memory, page, sink, progress);
        sink.finish();
    };
    base::Array<PageGroup> groups(memory);
    if (is_dxf) {
        GroupList list(groups);
        add_all(list, work.part(0.0, share_of_groups));
        info.groups = groups.span();
    }
    // The pipeline is built from its end: first the writer, then the filters before it.
    const std::unique_ptr<PageSink> file = make_writer(memory, writer, info, settings, counts);
    PenTrack track(counts, settings.plot.speeds, {0.0, size.y}, settings.plot.longest);
    std::unique_ptr<PageSink> filter;
    // Writers for plotters track the pen themselves, in their own rounded units.
    if (is_sorted)
        filter = plot_order(memory, *file, settings, counts, settings.for_plotter() ? nullptr : &track, work);
    else if (is_dxf)
        filter = clip_to_frames(memory, *file, settings);
    PageSink& next = filter ? *filter : *file;
    if (is_dxf) // line types are part of the format
        add_all(next, work.part(share_of_groups, 1.0));
    else
        add_all(*line_types(memory, next), work);
    return counts;
}

} // namespace hrbfnpr::output
