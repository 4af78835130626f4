// SPDX-License-Identifier: MIT
// What the laws of a style say of the width of its lines: by depth, light and curvature at the points of curves, and by
// what lies beside a line along it.
#pragma once

#include "base/runtime.h"
#include "frame/lines/drawn_as.h"
#include "frame/lines/line_numbers.h"
#include "frame/scene/scene.h"
#include "visibility/outline.h"

#include <span>

namespace hrbfnpr::frame {

// What is drawn of which items, and how.
struct LineInput {
    std::span<const visibility::Subject> subjects;
    std::span<const visibility::Occluder> occluders;
    std::span<const std::int32_t> items; // of the occluders
    std::span<const DrawnAs> styles;
    const visibility::Invisibility& found;
    const visibility::Lengths& lengths;
    const LineNumbers& numbers;
};

class WidthLaws {
public:
    // Throws Error{callback, out_of_memory}.
    WidthLaws(const base::Runtime& runtime, const Scene& scene, const drawing::Drawing& drawing, const LineInput& input,
              const base::Progress& progress);

    // Those of the input, with the factors of points.
    [[nodiscard]] std::span<const DrawnAs> styles() const noexcept { return styles_.span(); }

    // Of a place along a line: times that of the points around it.
    [[nodiscard]] double along(const DrawnAs& as, std::int32_t line, double at) const noexcept;
    // Whether that is not 1 everywhere, and whether it changes between two places along a line.
    [[nodiscard]] bool changes_along(const DrawnAs& as) const noexcept;
    [[nodiscard]] bool changes(const DrawnAs& as, std::int32_t line, double from, double to) const noexcept;
    // Between places that a chord of the line may have where it does, pixels.
    [[nodiscard]] double step(const DrawnAs& as) const noexcept;

private:
    struct DepthRange {
        double nearest, farthest;
    };

    void add_points(std::int64_t style);
    void add_curvature(const DrawnAs& as, std::span<float> factors) const;
    static void find_radial_curvature(const visibility::Subject& subject, base::Array<double>& curvature);
    void find_curvature_across(const visibility::Subject& subject, base::Array<double>& curvature) const;
    void smooth_along(const visibility::Subject& subject, double pixels, base::Array<double>& values) const;
    void find_outline();
    [[nodiscard]] DepthRange depth_range() const;
    [[nodiscard]] std::span<const visibility::OutlinePart> outline_of(std::int32_t line) const noexcept;
    [[nodiscard]] static double away(std::span<const visibility::OutlinePart> parts, double at) noexcept;
    [[nodiscard]] const visibility::Subject& subject_of(const DrawnAs& as) const noexcept {
        return input_.subjects[static_cast<std::size_t>(as.subject)];
    }

    const base::Runtime& runtime_;
    const Scene& scene_;
    const drawing::Drawing& drawing_;
    LineInput input_;
    base::Progress progress_;
    base::Array<DrawnAs> styles_;
    base::List<base::Array<float>> factors_; // of the points of the subjects of styles that have them
    visibility::Outline outline_;
    DepthRange depths_{0.0, 0.0};
};

} // namespace hrbfnpr::frame
