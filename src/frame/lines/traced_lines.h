// SPDX-License-Identifier: MIT
// All lines of a drawing's items, traced for its camera, and the styles that they are drawn in.
#pragma once

#include "features/line_set.h"
#include "frame/lines/last_contours.h"
#include "frame/lines/stroke_parts.h"
#include "visibility/subject.h"

#include <span>

namespace hrbfnpr::frame {

class TracedLines {
public:
    // Adds a layer to the drawing for each style of lines.
    TracedLines(const base::Runtime& runtime, const Scene& scene, std::span<const Item> items, LastContours& last,
                const base::Progress& progress, drawing::Drawing& drawing);

    [[nodiscard]] std::span<const visibility::Subject> subjects() const noexcept { return subjects_.span(); }
    [[nodiscard]] std::span<const visibility::Occluder> occluders() const noexcept { return occluders_.span(); }
    // Of the occluders: which of the drawing's items each is.
    [[nodiscard]] std::span<const std::int32_t> items() const noexcept { return items_.span(); }
    [[nodiscard]] std::span<const DrawnAs> styles() const noexcept { return styles_.span(); }
    // Contours that end inside the surface, and places where one was missed.
    [[nodiscard]] std::int64_t broken() const noexcept { return broken_; }

private:
    // An item that has lines.
    struct Source {
        const Item* item;
        curves::View view;
        std::int32_t number; // among the occluders
        bool mirrored;
    };

    // Subjects, from the first to before the end.
    struct Range {
        std::int32_t begin, end;
    };

    void trace_contours(const Source& source);
    void trace_part(const Source& source, const implicit::Implicit& surface, std::int64_t part);
    void add_border(const Source& source);
    void add_creases(const Source& source);
    void add_style(const Source& source, const LineStyle& style, std::uint32_t layer);
    void add_found(const Source& source, const LineStyle& style, std::uint32_t layer);
    void add_bent(const Source& source, const LineStyle& style, std::uint32_t layer);
    void add_features(const Source& source, const LineStyle& style, std::uint32_t layer);
    // Lines on the surface, cut where they turn away from the eye; `sheets` as of a Subject.
    void add_lines(const Source& source, const curves::SurfaceLines& lines, const LineStyle* style, std::uint32_t layer,
                   std::int32_t sheets);
    visibility::Subject& add_subject(const Source& source, const curves::Curves& curves);

    const base::Runtime& runtime_;
    LastContours& last_;
    base::Progress progress_;
    base::Array<Source> sources_;
    // What subjects refer to, each in a place of its own.
    base::List<std::unique_ptr<curves::ContourLevel>> levels_;
    base::List<std::unique_ptr<curves::SurfaceLines>> lines_;
    base::Array<visibility::Subject> subjects_;
    base::Array<visibility::Occluder> occluders_;
    base::Array<std::int32_t> items_;
    base::Array<DrawnAs> styles_;
    base::List<std::unique_ptr<curves::CreaseParts>> creases_; // of each source
    base::List<base::Array<float>> strengths_;
    base::Array<Range> contours_of_;     // of each source: its contours, and creases that are such
    base::Array<std::int32_t> folds_of_; // ... the latter; -1: there are none
    base::Array<std::int32_t> borders_of_;
    glm::dvec4 light_{0.0}; // of the item at hand, in its own space
    std::int64_t broken_ = 0;
};

} // namespace hrbfnpr::frame
