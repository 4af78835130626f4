// SPDX-License-Identifier: MIT
#include "frame/depth_layers/join_strokes.h"

#include "base/scratch.h"
#include "drawing/segments.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::frame {

using drawing::Stroke;
using drawing::StrokePoint;

namespace {

constexpr std::int64_t strokes_of_work = 256;

} // namespace

const LineStrokes& StrokeJoiner::list_of(const Ready& ready, const Found& found) noexcept {
    return found.run == of_lines ? ready.lines : ready.hatching[static_cast<std::size_t>(found.end)].made;
}

void StrokeJoiner::run(const Scene& scene, const Ready& ready, drawing::Drawing& drawing) {
    found_.clear();
    find_joined(scene, drawing);
    find_ready(ready.lines, of_lines, 0);
    for (std::size_t part = 0; part < ready.hatching.size(); ++part)
        find_ready(ready.hatching[part].made, of_hatching, static_cast<std::int64_t>(part));
    if (found_.empty()) return;
    keys_.clear();
    for (std::int64_t i = 0; i < found_.size(); ++i)
        keys_.push_back(drawing::far_first_key(found_[i].depth, static_cast<std::uint32_t>(i)));
    order_.sort(runtime_.parallel, keys_);
    make_room(ready, drawing);
    for (const std::uint64_t key : keys_) {
        const Found& found = found_[static_cast<std::uint32_t>(key)];
        if (found.run < 0)
            put_stroke(list_of(ready, found).strokes[found.begin], drawing);
        else
            put(scene, found, drawing);
    }
    put_points(ready, drawing);
    drawing::bin_segments(runtime_.parallel, drawing);
}

void StrokeJoiner::find_ready(const LineStrokes& strokes, std::int32_t run, std::int64_t part) {
    for (std::int64_t i = 0; i < strokes.strokes.size(); ++i)
        found_.push_back({run, strokes.strokes[i].depth, i, part});
}

void StrokeJoiner::make_room(const Ready& ready, drawing::Drawing& drawing) const {
    std::int64_t points = 0;
    for (const Found& found : found_)
        points += found.run < 0 ? list_of(ready, found).strokes[found.begin].count : found.end - found.begin;
    base::resize_scratch(drawing.points, points);
    drawing.points.clear();
}

// Its points follow later.
void StrokeJoiner::put_stroke(Stroke stroke, drawing::Drawing& drawing) {
    stroke.first = drawing.points.size();
    drawing.points.resize_for_overwrite(stroke.first + stroke.count);
    drawing.strokes.push_back(stroke);
}

// Of the strokes that were ready.
void StrokeJoiner::put_points(const Ready& ready, drawing::Drawing& drawing) const {
    runtime_.parallel.for_chunks(keys_.size(), strokes_of_work, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const Found& found = found_[static_cast<std::uint32_t>(keys_[i])];
            if (found.run >= 0) continue;
            const LineStrokes& own = list_of(ready, found);
            const Stroke& stroke = drawing.strokes[i];
            std::copy_n(own.points.data() + own.strokes[found.begin].first, stroke.count,
                        drawing.points.data() + stroke.first);
        }
    });
}

void StrokeJoiner::find_joined(const Scene& scene, const drawing::Drawing& drawing) {
    std::int64_t marks = 0;
    for (const Run& run : scene.runs)
        if (run.as_strokes) marks += run.count;
    if (marks == 0) return;
    base::resize_scratch(dot_of_, marks);
    std::fill(dot_of_.begin(), dot_of_.end(), -1);
    for (std::int64_t r = 0; r < scene.runs.size(); ++r) {
        const Run& run = scene.runs[r];
        if (!run.as_strokes) continue;
        note_dots(run, static_cast<std::uint32_t>(2 * r), drawing);
        find_lines(run, static_cast<std::int32_t>(r), drawing);
    }
}

void StrokeJoiner::note_dots(const Run& run, std::uint32_t layer, const drawing::Drawing& drawing) {
    for (const Piece& piece : drawing.dot_pieces) {
        if (piece.begin < run.first_place || piece.begin >= run.first_place + run.places()) continue;
        for (std::int64_t i = piece.begin; i < piece.end; ++i) {
            const Dot& dot = drawing.dots[i];
            if (dot.layer == layer && dot.opacity > 0.0F) dot_of_[run.first_joined + (dot.id - run.first_id)] = i;
        }
    }
}

void StrokeJoiner::find_lines(const Run& run, std::int32_t number, const drawing::Drawing& drawing) {
    const marks::Layer& layer = *run.marks;
    const auto shown = [&](std::int64_t at) { return dot_of_[run.first_joined + layer.mark_of(at)]; };
    for (std::int64_t s = 0; s < layer.strokes(); ++s) {
        const std::int64_t end = layer.stroke_first[s + 1];
        std::int64_t stop = 0;
        for (std::int64_t i = layer.stroke_first[s]; i < end; i = std::max(stop, i + 1)) {
            stop = i;
            while (stop < end && shown(stop) >= 0) ++stop;
            if (stop - i > 1) found_.push_back({number, drawing.dots[shown((i + stop) / 2)].depth, i, stop});
        }
    }
}

void StrokeJoiner::put(const Scene& scene, const Found& line, drawing::Drawing& drawing) {
    const Run& run = scene.runs[line.run];
    Stroke stroke;
    stroke.first = drawing.points.size();
    stroke.count = static_cast<std::int32_t>(line.end - line.begin);
    stroke.layer = 2U * static_cast<std::uint32_t>(line.run);
    stroke.depth = line.depth;
    float length = 0.0F;
    for (std::int64_t i = line.begin; i < line.end; ++i) {
        Dot& dot = drawing.dots[dot_of_[run.first_joined + run.marks->mark_of(i)]];
        if (i > line.begin) {
            const StrokePoint& last = drawing.points.back();
            length += std::hypot(dot.x - last.x, dot.y - last.y);
        }
        drawing.points.push_back(
            {dot.x, dot.y, dot.radius, dot.opacity, dot.depth, dot.window, dot.pixels_per_unit, length, dot.id});
        dot.opacity = 0.0F;
        --drawing.dot_count;
    }
    drawing.strokes.push_back(stroke);
}

} // namespace hrbfnpr::frame
