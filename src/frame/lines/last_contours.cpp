// SPDX-License-Identifier: MIT
#include "frame/lines/last_contours.h"

#include "curves/curve_changes.h"
#include "curves/trace.h"

#include <algorithm>
#include <utility>

namespace hrbfnpr::frame {
namespace {

// In the mesh's sides: points that move by more are not begun with; and of so many, none is.
constexpr double farthest = 1.0;
constexpr double most_left_out = 0.1;
// In the mesh's sides: what is left after so short a step is a millionth, and the next frame asks again.
constexpr double tolerance = 1e-3;

void trace(const base::Runtime& runtime, const curves::SurfaceMesh& mesh, const curves::ContourLevel& level,
           const curves::Curves* near, const base::Progress& progress, Contours& contours) {
    curves::TraceReport report;
    curves::TraceSettings settings;
    if (near != nullptr) settings.tolerance = tolerance;
    contours.traced = curves::trace(runtime, level, mesh, settings, report, progress, near);
    contours.from_last = near != nullptr;
    contours.broken = report.broken + report.missed;
}

// From the last ones if all of them go on.
void trace_on(const base::Runtime& runtime, const curves::SurfaceMesh& mesh, const curves::ContourLevel& level,
              const curves::Curves& last, const base::Progress& progress, Contours& contours) {
    const curves::Curves moved = curves::moved_contours(runtime.memory, level.view(), last, farthest * mesh.side);
    const bool little = !moved.point.empty() && static_cast<double>(moved.point.size()) >=
                                                    (1.0 - most_left_out) * static_cast<double>(last.point.size());
    if (little) trace(runtime, mesh, level, &moved, progress, contours);
    if (!little || contours.broken > 0) trace(runtime, mesh, level, nullptr, progress, contours);
}

} // namespace

bool LastContours::are_from_last() const noexcept {
    return std::any_of(now_.begin(), now_.end(), [](const auto& contours) { return contours->from_last; });
}

void LastContours::begin_frame() noexcept {
    std::swap(last_, now_);
    now_.clear();
}

std::unique_ptr<Contours> LastContours::take(const curves::LineSet& lines, std::int64_t item,
                                             std::int64_t part) noexcept {
    for (std::unique_ptr<Contours>& known : last_)
        if (known != nullptr && known->item == item && known->part == part && known->set == lines.identity())
            return std::move(known);
    return nullptr;
}

const Contours& LastContours::find(const base::Runtime& runtime, const curves::LineSet& lines, std::int64_t item,
                                   std::int64_t part, const curves::ContourLevel& level, const curves::View& view,
                                   const base::Progress& progress) {
    std::unique_ptr<Contours> last = take(lines, item, part);
    const curves::SurfaceMesh& mesh = lines.parts().empty() ? lines.mesh() : lines.parts()[part]->mesh;
    if (last != nullptr && last->eye == view.eye) return *now_.add(std::move(last));
    auto contours = std::make_unique<Contours>(runtime.memory);
    contours->set = lines.identity();
    contours->item = item;
    contours->part = part;
    contours->eye = view.eye;
    if (last != nullptr)
        trace_on(runtime, mesh, level, last->traced, progress, *contours);
    else
        trace(runtime, mesh, level, nullptr, progress, *contours);
    std::int64_t evaluations = 0;
    contours->with_cusps = curves::with_cusps(runtime, level, view, contours->traced, evaluations, progress);
    return *now_.add(std::move(contours));
}

} // namespace hrbfnpr::frame
