// SPDX-License-Identifier: MIT
// Inks of several colours that lie upon each other: how often the groups of a page must begin anew for them to be
// painted far to near there, as the raster does.
#pragma once

#include "base/operation.h"
#include "drawing/drawing.h"

namespace hrbfnpr::output {

// What is told apart of a drawing's ink: a layer's dots, or its strokes behind so many layers of surface.
struct InkGroups {
    static constexpr std::int32_t most_hidden = 31;
    static constexpr std::int32_t of_layer = most_hidden + 2;

    [[nodiscard]] static std::int32_t of_dots(std::int64_t layer) noexcept {
        return static_cast<std::int32_t>(layer) * of_layer;
    }
    // Those that more surfaces hide come before.
    [[nodiscard]] static std::int32_t of_strokes(std::int64_t layer, std::int32_t hidden) noexcept {
        return of_dots(layer) + 1 + most_hidden - hidden;
    }
    [[nodiscard]] static std::int32_t hidden_of(const drawing::Stroke& stroke) noexcept {
        return stroke.hidden_layers < 0 ? 0 : stroke.hidden_layers < most_hidden ? stroke.hidden_layers : most_hidden;
    }
};

class PaintRuns {
public:
    static constexpr std::int32_t most_runs = 32;

    explicit PaintRuns(base::Memory& memory) noexcept;

    // All groups are painted in their order, run after run.  An ink is in the first run in which it comes after all ink
    // of another colour that it lies upon.
    // far_to_near: else there is one run.
    void find(const drawing::Drawing& drawing, bool far_to_near, const base::Progress& progress);

    [[nodiscard]] std::int32_t runs() const noexcept { return runs_; }
    // Whether there is ink of a group in a run, or of a layer at all.
    [[nodiscard]] bool has(std::int32_t run, std::int32_t group) const noexcept {
        return has_[std::int64_t{run} * groups_ + group] != 0;
    }
    [[nodiscard]] bool has(std::int64_t layer) const noexcept { return has_layer_[layer] != 0; }
    [[nodiscard]] std::int32_t of_stroke(std::int64_t stroke) const noexcept { return stroke_run_[stroke]; }
    [[nodiscard]] std::int32_t of_dot(std::int64_t dot) const noexcept { return dot_run_[dot]; }

private:
    void set_up(const drawing::Drawing& drawing);
    void set_colors(const drawing::Drawing& drawing);
    void assign(const drawing::Drawing& drawing, const base::Progress& progress);
    void note(const drawing::Drawing& drawing);
    void sort_dots(const drawing::Drawing& drawing, const base::Progress& progress);
    void add(const drawing::Dot& dot, std::uint8_t& run);
    void add(const drawing::Drawing& drawing, const drawing::Stroke& stroke, std::uint8_t& run);
    template <class Visit>
    void visit_cells(const drawing::Drawing& drawing, const drawing::Stroke& stroke, Visit&& visit) const;
    template <class Visit>
    void visit_cells(double x, double y, double radius, Visit&& visit) const;
    void find_last(std::int64_t cell, std::int32_t color, std::int32_t& most) const noexcept;
    [[nodiscard]] std::int32_t place_after(std::int32_t most, std::int32_t group) noexcept;

    double left_ = 0.0, top_ = 0.0, cell_ = 1.0;
    std::int64_t columns_ = 1, rows_ = 1;
    std::int32_t groups_ = 1, colors_ = 1, runs_ = 1;
    base::Array<std::int32_t> color_of_; // of each layer
    base::Array<std::int32_t> last_;   // of each cell and colour: the last group, counted on from run to run; -1: none
    base::Array<std::uint32_t> order_; // of dots, far to near
    base::Array<std::uint8_t> stroke_run_, dot_run_;
    base::Array<std::uint8_t> has_, has_layer_;
};

} // namespace hrbfnpr::output
