// SPDX-License-Identifier: MIT
#include "frame/lines/line_frame.h"

#include "base/clock.h"
#include "curves/contour_level.h"
#include "curves/cusps.h"
#include "curves/trace.h"
#include "frame/lines/stroke_parts.h"

#include <glm/matrix.hpp>

#include <memory>
#include <vector>

namespace hrbfnpr::frame {
namespace {

// What is traced of one item.
struct Traced {
    Traced(base::Memory& memory, const Item& its, const curves::View& seen)
        : item(its), view(seen), level(its.lines->surface(), seen), contours(memory) {}

    const Item& item;
    curves::View view;
    curves::ContourLevel level;
    curves::Curves contours;
};

curves::View view_of(const Scene& scene, const Item& item) {
    // In the caller's units, in double: large coordinates lose nothing here.
    const Optics optics = make_optics(scene.camera);
    const glm::dmat4 to_eye = scene.camera.view * item.transform;
    const glm::dvec4 eye = glm::inverse(to_eye) * optics.centre;
    return {eye.w != 0.0 ? eye / eye.w : eye, optics.window * to_eye};
}

// Whether the camera shows surfaces mirrored: their outside, seen with x to the right and y up, runs the other way.
bool is_mirrored(const Scene& scene, const Item& item) {
    return glm::determinant(glm::dmat3(scene.camera.view * item.transform)) < 0.0;
}

bool draws_lines(const Item& item) noexcept { return item.lines != nullptr && !item.style.lines.empty(); }

class LineDrawer {
public:
    LineDrawer(const base::Runtime& runtime, const Scene& scene, std::span<const Item> items, LineStrokes& strokes,
               drawing::Drawing& drawing)
        : runtime_(runtime), scene_(scene), items_(items), strokes_(strokes), drawing_(drawing) {}

    void run() {
        for (std::size_t i = 0; i < items_.size(); ++i)
            if (items_[i].lines != nullptr) trace(i);
        const visibility::Invisibility found =
            visibility::find_invisibility(runtime_, subjects_, occluders_, {}, base::Progress());
        count(found);
        for (std::size_t i = 0; i < items_.size(); ++i)
            if (draws_lines(items_[i])) add_layers(i);
        StrokeParts(runtime_, scene_, subjects_, found, strokes_).run(styles_);
    }

private:
    void trace(std::size_t i);
    void add_layers(std::size_t i);
    void count(const visibility::Invisibility& found) noexcept;

    const base::Runtime& runtime_;
    const Scene& scene_;
    std::span<const Item> items_;
    LineStrokes& strokes_;
    drawing::Drawing& drawing_;
    std::vector<std::unique_ptr<Traced>> traced_; // as many as there are items with lines
    std::vector<visibility::Subject> subjects_;
    std::vector<visibility::Occluder> occluders_;
    std::vector<DrawnAs> styles_;
    curves::TraceReport report_;
};

void LineDrawer::trace(std::size_t i) {
    const Item& item = items_[i];
    traced_.push_back(std::make_unique<Traced>(runtime_.memory, item, view_of(scene_, item)));
    Traced& its = *traced_.back();
    curves::TraceReport report;
    const curves::SurfaceMesh& mesh = item.lines->mesh();
    const curves::Curves curves = curves::trace(runtime_, its.level, mesh, {}, report, base::Progress());
    its.contours = curves::with_cusps(runtime_, its.level, its.view, curves, report.evaluations, base::Progress());
    report_.broken += report.broken;
    report_.missed += report.missed;
    visibility::Subject subject;
    subject.curves = &its.contours;
    subject.level = &its.level;
    subject.view = its.view;
    subject.side = mesh.side;
    subject.to_world = item.transform;
    subject.item = static_cast<std::int32_t>(occluders_.size());
    subject.mirrored = is_mirrored(scene_, item);
    subjects_.push_back(subject);
    occluders_.push_back({&item.lines->sheets(), &item.lines->surface(), item.transform, its.view.eye, mesh.side});
}

// A layer of the drawing for each style.
void LineDrawer::add_layers(std::size_t i) {
    for (std::size_t s = 0; s < items_[i].style.lines.size(); ++s) {
        const LineStyle& style = items_[i].style.lines[s];
        drawing::Layer layer;
        layer.item = static_cast<std::int32_t>(i);
        layer.layer = -1;
        layer.line_kind = static_cast<std::uint32_t>(style.kind);
        layer.mark_class = drawing::MarkClass::silhouette;
        layer.as_strokes = true;
        layer.ink = glm::vec4(style.ink[0], style.ink[1], style.ink[2], style.ink[3]);
        for (std::size_t t = 0; t < traced_.size(); ++t)
            if (&traced_[t]->item == &items_[i] && style.kind == LineKind::contour)
                styles_.push_back(
                    {&style, static_cast<std::int32_t>(t), static_cast<std::uint32_t>(drawing_.layers.size())});
        drawing_.layers.push_back(layer);
    }
}

void LineDrawer::count(const visibility::Invisibility& found) noexcept {
    drawing::LineCounts& counts = drawing_.line_counts;
    counts.curves = found.report.lines;
    counts.cusps = found.report.cusps;
    counts.crossings = found.crossings.size();
    counts.broken = report_.broken + report_.missed;
    counts.settled = found.report.settled;
    counts.contradictions = found.report.contradictions;
}

} // namespace

const LineStrokes& LineFrame::run(const Scene& scene, std::span<const Item> items, drawing::Drawing& drawing) {
    strokes_.strokes.clear();
    strokes_.points.clear();
    if (std::none_of(items.begin(), items.end(), draws_lines)) return strokes_;
    const base::Stopwatch watch;
    LineDrawer(runtime_, scene, items, strokes_, drawing).run();
    drawing.line_counts.nanoseconds = watch.nanoseconds();
    return strokes_;
}

} // namespace hrbfnpr::frame
