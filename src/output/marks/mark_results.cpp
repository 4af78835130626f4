// SPDX-License-Identifier: MIT
#include "output/marks/mark_results.h"

#include "base/assert.h"

#include <algorithm>
#include <utility>

namespace hrbfnpr::output {
namespace {

using drawing::Dot;
using drawing::Drawing;
using drawing::MarkClass;
using drawing::Stroke;
using drawing::StrokePoint;

// One mark of a run, as it is drawn.
struct Drawn {
    std::int64_t mark;
    std::uint32_t layer; // the number of a layer of the drawing
    float radius, opacity, depth;
};

// Calls f for each mark of the run that is drawn, as a dot or as points of a stroke. A stroke of hatching that is cut
// or closed may have a mark twice.
template <class F>
void for_each_drawn(const Drawing& drawing, const drawing::Run& run, const F& f) {
    const auto is_own = [&](std::uint32_t layer) {
        return drawing.layers[layer].item == run.item && drawing.layers[layer].layer == run.layer;
    };
    for (const drawing::Piece& piece : drawing.dot_pieces) {
        for (std::int64_t i = piece.begin; i < piece.end; ++i) {
            const Dot& dot = drawing.dots[i];
            if (!(dot.opacity > 0.0F) || (dot.flags & drawing::dot_is_paper) != 0 || !is_own(dot.layer)) continue;
            f(Drawn{std::int64_t{dot.id - run.first_id}, dot.layer, dot.radius, dot.opacity, dot.depth});
        }
    }
    for (const Stroke& stroke : drawing.strokes) {
        if (!is_own(stroke.layer)) continue;
        const std::int64_t end = stroke.first + stroke.count;
        for (std::int64_t i = stroke.first; i < end;) {
            const StrokePoint& p = drawing.points[i];
            Drawn drawn{std::int64_t{p.id - run.first_id}, stroke.layer, p.radius, p.opacity, p.depth};
            for (++i; i < end && drawing.points[i].id == p.id; ++i) // hatching has several points with one mark
                drawn.radius = std::max(drawn.radius, drawing.points[i].radius);
            f(drawn);
        }
    }
}

} // namespace

void write_mark_results(const Drawing& drawing, std::int64_t number, const MarkViews& views) {
    HRBFNPR_ASSERT(number >= 0 && number < drawing.runs.size());
    const drawing::Run& run = drawing.runs[number];
    for (const base::OutView* view : {&views.shown, &views.radius, &views.opacity})
        if (*view)
            for (std::int64_t i = 0; i < run.count; ++i) view->set(i, 0, 0.0);
    for_each_drawn(drawing, run, [&](const Drawn& drawn) {
        const drawing::Layer& layer = drawing.layers[drawn.layer];
        if (views.shown) views.shown.set(drawn.mark, 0, static_cast<double>(layer.mark_class));
        if (views.radius) views.radius.set(drawn.mark, 0, static_cast<double>(drawn.radius));
        if (views.opacity) views.opacity.set(drawn.mark, 0, static_cast<double>(drawn.opacity * layer.ink.w));
    });
}

std::span<const std::uint32_t> MarkIndices::of(const Drawing& drawing, std::int64_t number, MarkClass mark_class,
                                               Primitive primitive) {
    HRBFNPR_ASSERT(number >= 0 && number < drawing.runs.size());
    const drawing::Run& run = drawing.runs[number];
    keys_.clear();
    indices_.clear();
    shown_.clear();
    shown_.resize(run.count);
    for_each_drawn(drawing, run, [&](const Drawn& drawn) {
        if (drawing.layers[drawn.layer].mark_class != mark_class || std::exchange(shown_[drawn.mark], 1) != 0) return;
        keys_.push_back(drawing::far_first_key(drawn.depth, static_cast<std::uint32_t>(drawn.mark)));
    });
    if (primitive == Primitive::points) {
        order_.sort(runtime_.parallel, keys_);
        for (const std::uint64_t key : keys_) indices_.push_back(static_cast<std::uint32_t>(key));
        return indices_.span();
    }
    const marks::Layer& layer = drawing.items[run.item].set->layers[run.layer];
    const std::uint32_t sides = primitive == Primitive::triangle_strips ? 2 : 1;
    for (std::int64_t s = 0; s < layer.strokes(); ++s) {
        const std::int64_t end = layer.stroke_first[s + 1];
        for (std::int64_t i = layer.stroke_first[s]; i < end;) {
            std::int64_t stop = i;
            while (stop < end && shown_[layer.mark_of(stop)] != 0) ++stop; // a line takes two marks or more
            for (std::int64_t k = i; stop - i > 1 && k < stop; ++k)
                for (std::uint32_t side = 0; side < sides; ++side)
                    indices_.push_back(sides * static_cast<std::uint32_t>(layer.mark_of(k)) + side);
            if (stop - i > 1) indices_.push_back(index_restart);
            i = std::max(stop, i + 1);
        }
    }
    return indices_.span();
}

} // namespace hrbfnpr::output
