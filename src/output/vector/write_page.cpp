// SPDX-License-Identifier: MIT
#include "output/vector/write_page.h"

#include "output/vector/filters.h"
#include "output/vector/tuning.h"
#include "output/vector/writers.h"

#include <algorithm>
#include <optional>

namespace hrbfnpr::output {
namespace {

void add_annotation(const Annotation& annotation, PageSink& sink, base::Array<PagePoint>& points) {
    points.clear();
    for (std::size_t i = 0; i + 1 < annotation.points.size(); i += 2)
        points.push_back({annotation.points[i], annotation.points[i + 1], 0.5 * annotation.width});
    if (points.empty()) return;
    if (annotation.text != nullptr) {
        sink.text({points[0].x, points[0].y, annotation.width, annotation.text});
        return;
    }
    PagePath path;
    path.points = points.span();
    path.closed = points.size() > 3 && place_of(points[0]) == place_of(points.back());
    path.begin = path.end = drawing::Cap::flat;
    if (points.size() > 1) sink.path(path);
}

// Annotations of one group that follow each other make one group on the page.
void add_annotations(base::Memory& memory, const Page& page, PageSink& sink, const base::Progress& progress) {
    base::Array<PagePoint> points(memory);
    const Annotation* open = nullptr;
    Looks looks(progress, steps_a_look);
    for (const Annotation& annotation : page.annotations) {
        looks.count(1 + static_cast<std::int64_t>(annotation.points.size()));
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

glm::dvec2 page_size(const Page& page, const PageSettings& settings) noexcept {
    glm::dvec2 reach(0.0);
    for (const Placement& placement : page.placements) {
        const Frame frame = frame_of(placement);
        reach = {std::max(reach.x, frame.right), std::max(reach.y, frame.bottom)};
    }
    return {settings.width > 0.0 ? settings.width : reach.x, settings.height > 0.0 ? settings.height : reach.y};
}

PageCounts write_page(const base::Runtime& runtime, const Page& page, const PageSettings& given, io::Writer& writer,
                      const base::Progress& progress) {
    PageCounts counts;
    PageInfo info = page.info;
    PageSettings settings = given;
    const glm::dvec2 size = page_size(page, given);
    info.width = settings.width = size.x;
    info.height = settings.height = size.y;
    // The pipeline is made from its end: the writer, and before it filters.
    base::Memory& memory = runtime.memory;
    MakeWriter& make = settings.for_plotter()               ? plotter_writer
                       : settings.format == PageFormat::pdf ? pdf_writer
                                                            : svg_writer;
    const std::unique_ptr<PageSink> file = make(memory, writer, info, settings, counts);
    PenTrack track(counts, settings.plot.speeds, {0.0, size.y});
    std::optional<PlotOrder> sorted;
    // Plotters' writers track the pen themselves, by the units that they round to.
    if (settings.in_plot_order || settings.for_plotter())
        sorted.emplace(memory, *file, settings, counts, settings.for_plotter() ? nullptr : &track, progress);
    LineTypes dashed(memory, sorted ? static_cast<PageSink&>(*sorted) : *file);
    const auto parts = static_cast<double>(page.placements.size() + 1);
    double done = 0.0;
    const bool filled = !settings.without_paper;
    const glm::vec4 paper = page.placements.empty() ? glm::vec4(1.0F) : page.placements[0].drawing->paper;
    if (filled) { // the whole page has the paper of its first drawing, or is white
        dashed.begin_view({{}, {0.0, 0.0, size.x, size.y}, paper, true});
        dashed.end_view();
    }
    for (Placement placement : page.placements) {
        placement.with_paper = filled && placement.drawing->paper != paper;
        placement.far_to_near = !sorted; // each pen is taken up once
        lay_out(memory, placement, page.pens, dashed, progress.part(done / parts, (done + 1.0) / parts));
        done += 1.0;
        progress.update(done / parts);
    }
    add_annotations(memory, page, dashed, progress);
    dashed.finish();
    return counts;
}

} // namespace hrbfnpr::output
