// SPDX-License-Identifier: MIT
#include "output/vector/write_page.h"

#include "output/vector/gcode.h"
#include "output/vector/hpgl.h"
#include "output/vector/look.h"
#include "output/vector/pdf.h"
#include "output/vector/plot_order.h"
#include "output/vector/svg.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace hrbfnpr::output {
namespace {

constexpr std::int64_t written_at_a_time = 2048; // numbers of annotations

bool is_plotter(PageFormat format) noexcept { return format == PageFormat::hpgl || format == PageFormat::gcode; }

std::unique_ptr<PageSink> writer_of(base::Memory& memory, const PageInfo& info, const PageSettings& settings,
                                    io::Writer& writer, PageCounts& counts) {
    if (settings.format == PageFormat::pdf)
        return std::make_unique<PdfWriter>(memory, writer, info, settings.shapes, counts);
    const PlotSettings& plot = settings.plot;
    const PlotFormat format{
        settings.shapes, {plot.draw_speed, plot.travel_speed, plot.pen_seconds}, plot.pen_down, plot.pen_up};
    if (settings.format == PageFormat::hpgl) return std::make_unique<HpglWriter>(memory, writer, info, format, counts);
    if (settings.format == PageFormat::gcode)
        return std::make_unique<GcodeWriter>(memory, writer, info, format, counts);
    return std::make_unique<SvgWriter>(memory, writer, info, settings.shapes, counts);
}

void add_annotation(const Annotation& annotation, PageSink& sink, base::Array<PagePoint>& points) {
    points.clear();
    for (std::size_t i = 0; i + 1 < annotation.points.size(); i += 2)
        points.push_back({annotation.points[i], annotation.points[i + 1], 0.5 * annotation.width});
    if (points.empty()) return;
    if (annotation.text != nullptr) {
        sink.text({points[0].x, points[0].y, annotation.width, annotation.text});
        return;
    }
    const PagePoint& first = points[0];
    const PagePoint& last = points[points.size() - 1];
    PagePath path;
    path.points = points.span();
    path.closed = points.size() > 3 && first.x == last.x && first.y == last.y;
    path.begin = path.end = drawing::Cap::flat;
    if (points.size() > 1) sink.path(path);
}

void add_annotations(base::Memory& memory, const Page& page, PageSink& sink, const base::Progress& progress) {
    Looks looks(progress, written_at_a_time);
    base::Array<PagePoint> points(memory);
    const Annotation* open = nullptr;
    for (const Annotation& annotation : page.annotations) {
        looks.count(static_cast<std::int64_t>(annotation.points.size()));
        if (open == nullptr || open->group != annotation.group) {
            if (open != nullptr) sink.end_group();
            PageGroup group;
            group.name[annotation.group.copy(group.name, PageGroup::most - 1)] = '\0';
            group.ink = annotation.ink;
            group.line_type = annotation.line_type;
            sink.begin_group(with_pen(group, page.pens));
            open = &annotation;
        }
        add_annotation(annotation, sink, points);
    }
    if (open != nullptr) sink.end_group();
}

} // namespace

namespace {

// The whole page has the paper of its first drawing; white if there is none.
void add_paper(const glm::vec4& paper, const PageInfo& info, PageSink& sink) {
    sink.begin_view({{}, {0.0, 0.0, info.width, info.height}, paper, true});
    sink.end_view();
}

} // namespace

glm::dvec2 page_size(const Page& page, const PageSettings& settings) noexcept {
    glm::dvec2 reach(0.0);
    for (const Placement& placement : page.placements) {
        const Frame frame = frame_of(placement);
        reach = {std::max(reach.x, frame.right), std::max(reach.y, frame.bottom)};
    }
    return {settings.width > 0.0 ? settings.width : reach.x, settings.height > 0.0 ? settings.height : reach.y};
}

PageCounts write_page(const base::Runtime& runtime, const Page& page, const PageSettings& settings, io::Writer& writer,
                      const base::Progress& progress) {
    PageCounts counts;
    PageInfo info = page.info;
    const glm::dvec2 size = page_size(page, settings);
    info.width = size.x;
    info.height = size.y;
    const std::unique_ptr<PageSink> file = writer_of(runtime.memory, info, settings, writer, counts);
    const PlotSettings& plot = settings.plot;
    PenTrack track(counts, {plot.draw_speed, plot.travel_speed, plot.pen_seconds}, {0.0, size.y});
    std::optional<PlotOrder> sorted;
    if (settings.in_plot_order || is_plotter(settings.format)) {
        const PlotOrderSettings order{
            plot.join,      plot.shortest, plot.dot_distance, is_plotter(settings.format), {0.0, 0.0, size.x, size.y},
            settings.shapes};
        // Plotters' writers track the pen themselves, by what they have rounded.
        sorted.emplace(runtime.memory, *file, order, counts, order.for_plotter ? nullptr : &track, progress);
    }
    LineTypes dashed(runtime.memory, sorted ? static_cast<PageSink&>(*sorted) : *file);
    const auto parts = static_cast<double>(page.placements.size() + 1);
    double done = 0.0;
    const bool filled = !settings.without_paper;
    const glm::vec4 paper = page.placements.empty() ? glm::vec4(1.0F) : page.placements[0].drawing->paper;
    if (filled) add_paper(paper, info, dashed);
    for (Placement placement : page.placements) {
        placement.with_paper = filled && placement.drawing->paper != paper;
        placement.far_to_near = !sorted; // each pen is taken up once
        lay_out(runtime.memory, placement, page.pens, dashed, progress.part(done / parts, (done + 1.0) / parts));
        done += 1.0;
        progress.update(done / parts);
    }
    add_annotations(runtime.memory, page, dashed, progress);
    dashed.finish();
    return counts;
}

} // namespace hrbfnpr::output
