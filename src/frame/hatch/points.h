// SPDX-License-Identifier: MIT
// Makes even samples along the lines of a run's strokes in the picture, whatever the distance of the marks.
//
// Most of a frame's strokes are not drawn. So whole pieces of a stroke are skipped by their bounds first, and then
// marks by their normals alone. The other marks are projected and given widths on vectors of the processor (loops.h).
// The result is chains of consecutive marks, which are sampled at even steps and where the line may end.
#pragma once

#include "base/list.h"
#include "drawing/drawing.h"
#include "frame/hatch/loops.h"
#include "frame/scene/scene.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace hrbfnpr::frame {

// ---- Marks

// The margins of a mark. The line is drawn where none is negative.
enum HatchMargin : std::size_t {
    margin_tone = 0,    // how much darker it is than where lines begin
    margin_level = 1,   // how much room there is for lines of the mark's level
    margin_rim = 2,     // how far it faces the eye
    margin_picture = 3, // how far it lies inside the picture and a strip around it, pixels
    hatch_margins = 4
};

// A mark in the picture.
struct HatchMark {
    float x, y; // pixels
    float window, depth;
    float side_x, side_y;  // x and y of the unit normal, eye space
    float width;           // line width, pixels
    float distance_before; // distance from the mark before, pixels
    std::array<float, hatch_margins> margin;
    float pixels_per_unit;
    float begins_chain; // 1: marks before this mark were left out, and the line does not continue across them; else 0
    float unused;
    std::uint32_t id;

    // Whether the mark has a place in the picture's plane.
    [[nodiscard]] bool is_valid() const noexcept { return margin[margin_picture] > hatch_nowhere; }
};

// How a line ends at the end of its stroke.
enum class StrokeEnd : std::uint8_t { open, crease };

// The marks of a stroke that its line needs.
struct HatchStroke {
    explicit HatchStroke(base::Memory& memory) noexcept
        : mark(memory), may_draw(memory), range(memory), number(memory), row(memory) {}

    // A half-open range of places in the order of the strokes.
    struct Range {
        std::int64_t begin, end;
    };

    base::Array<HatchMark> mark; // the marks near places that are drawn; in a ring, the last mark repeats the first
    bool ring = false;           // the stroke is closed, and none of its marks was left out
    std::int64_t first_kept = 0; // the row of mark[0]; this is its number along the stroke if no marks were left out
    StrokeEnd begins = StrokeEnd::open, ends = StrokeEnd::open;
    bool has_begin = false, has_end = false; // mark[0] is the stroke's first mark; the last mark is the stroke's last

    // Scratch.
    base::Array<std::uint32_t> may_draw; // for each piece, a bit for each of its marks
    base::Array<Range> range;            // the places of the marks that are loaded, ascending
    base::Array<std::uint32_t> number;   // the numbers of the loaded marks in the layer
    base::Array<float> row;              // memory of HatchRows
    // The stroke's places. A closed stroke's last mark is left out if it lies where the first one does.
    std::int64_t first = 0, count = 0;
    bool closed = false;

    [[nodiscard]] std::int64_t bytes() const noexcept {
        return mark.bytes() + may_draw.bytes() + range.bytes() + number.bytes() + row.bytes();
    }
};

// The data by which marks are seen, the same for all strokes of a frame.
struct HatchView {
    const ProjectionLoops& see;
    const HatchLoops& loops;
    const Scene& scene;
    const Frustum& frustum;
};

// ---- Samples

// A sample has the same numbers as a mark, at the same offsets, so that all are interpolated at once.
struct HatchSample {
    float x, y, window, depth;
    float side_x, side_y;                    // as in HatchMark
    float width;                             // line width, pixels: the mean over half a step on either side
    float overshoot;                         // how far an overshoot runs past the end of the line's tone, pixels
    std::array<float, hatch_margins> margin; // as in HatchMark
    float pixels_per_unit;
    std::array<float, 2> unused;
    std::uint32_t id; // the number of the nearest mark

    // Returns the direction in the picture across a contour at this sample, as if a contour were there; it has any
    // length.
    [[nodiscard]] glm::vec2 across_rim() const noexcept { return {side_x, -side_y}; }
};
static_assert(sizeof(HatchSample) == sizeof(HatchMark) &&
              offsetof(HatchSample, margin) == offsetof(HatchMark, margin) &&
              offsetof(HatchSample, side_x) == offsetof(HatchMark, side_x) &&
              offsetof(HatchSample, pixels_per_unit) == offsetof(HatchMark, pixels_per_unit));

// Consecutive samples at even steps. A stroke has several chains where marks between them were left out.
struct HatchChain {
    std::int64_t first = 0; // the index of the first sample
    std::int64_t count = 0; // at least 2; in a ring, the last sample equals the first
    bool ring = false;
    bool has_begin = false, has_end = false; // the stroke begins at its first sample; ends at its last one
    StrokeEnd begins = StrokeEnd::open, ends = StrokeEnd::open;
};

struct HatchSamples {
    explicit HatchSamples(base::Memory& memory) noexcept
        : chain(memory), sample(memory), length(memory), area(memory), tangent(memory), at(memory), ends(memory) {}

    base::Array<HatchChain> chain;
    base::Array<HatchSample> sample;

    // Scratch. The distance along the line from a chain's first mark to each mark, in pixels; the area of the line up
    // to there; and the curve's tangent there, of unit length where marks lie evenly.
    base::Array<float> length, area;
    base::Array<glm::vec2> tangent;
    base::Array<float> at;          // lengths at which a chain is sampled
    base::Array<std::uint8_t> ends; // for each of the lengths in `at`, a bit for each margin that is 0 there

    void clear() noexcept {
        chain.clear();
        sample.clear();
    }
    [[nodiscard]] std::int64_t bytes() const noexcept {
        return chain.bytes() + sample.bytes() + length.bytes() + area.bytes() + tangent.bytes() + at.bytes() +
               ends.bytes();
    }
};

// Strokes of a run, from number `begin` up to `end`. `piece` is the number of the first piece of stroke `begin`.
struct HatchRange {
    std::int64_t begin = 0, end = 0, piece = 0;
};

// Appends the chains of strokes. `taus` are the tones of the run's marks, if a callback gives them; else NULL.
void sample_strokes(const HatchView& view, const Run& run, const ItemSight& sight, const float* taus,
                    const HatchRange& range, HatchStroke& scratch, HatchSamples& to);

// ---- Samples as dots, so that depth layers hide them as they hide all other ink

// Consecutive dots of a batch that lie in one tile of a picture.
struct HatchDotRun {
    std::int64_t tile, begin, end;
};

// A line is seen on one side of a place between two of its samples, and hidden on the other.
struct HatchCut {
    std::int64_t before = -1; // the first of the two samples between which the line is cut; -1: the line is not cut
    float at = 0.0F;          // along the line, pixels

    [[nodiscard]] bool any() const noexcept { return before >= 0; }
};

// The strokes that are made of a batch of samples (strokes.h).
struct HatchStrokePart {
    explicit HatchStrokePart(base::Memory& memory) noexcept
        : made(memory), length(memory), cuts(memory), row(memory), near(memory), raw(memory) {}

    LineStrokes made;
    std::int64_t seen = 0;              // dots that are seen
    std::int64_t shown = 0, hidden = 0; // marks

    // Scratch.
    base::Array<float> length; // distance along the line from a chain's first sample to each sample, pixels
    base::Array<HatchCut> cuts;
    base::Array<float> row;         // presences of a chain
    base::Array<std::uint8_t> near; // for each sample, a bit for each reason by which the line ends or fades near it
    base::Array<drawing::StrokePoint> raw; // a stroke's points, before some are chosen

    void clear() noexcept {
        made.strokes.clear();
        made.points.clear();
        seen = shown = hidden = 0;
    }
    [[nodiscard]] std::int64_t bytes() const noexcept {
        return made.strokes.bytes() + made.points.bytes() + length.bytes() + cuts.bytes() + row.bytes() + near.bytes() +
               raw.bytes();
    }
};

class HatchPoints {
public:
    // Consecutive strokes: the unit of work. Threads fill batches that lie side by side.
    struct alignas(base::Memory::alignment) Batch {
        explicit Batch(base::Memory& memory) noexcept
            : samples(memory), stroke(memory), tile_runs(memory), part(memory) {}

        std::int32_t run = 0;
        HatchRange strokes;
        std::int64_t first_dot = 0; // the number of its first sample among the drawing's dots
        HatchSamples samples;
        HatchStroke stroke;                 // scratch for one stroke
        base::Array<HatchDotRun> tile_runs; // the samples of the stroke, as runs in one tile each
        HatchStrokePart part;
    };

    explicit HatchPoints(const base::Runtime& runtime) noexcept
        : runtime_(runtime), see_(projection_loops(runtime.instruction_set)),
          loops_(hatch_loops(runtime.instruction_set)), batches_(runtime.memory), taus_(runtime.memory) {}

    // How the other marks of the frame are seen.
    struct Input {
        const Scene& scene;
        std::span<const ItemSight> sights; // one for each item
        const Frustum& frustum;
        std::span<const float> taus; // tones that a callback gave, by the place of the mark
    };

    // Adds the samples of all hatching after the drawing's other dots. The drawing must have been gathered.
    void run(const Input& seen, drawing::Drawing& drawing);

    // The batches of the last run, in the order of the strokes.
    [[nodiscard]] std::span<Batch> batches() noexcept { return {batches_.begin(), static_cast<std::size_t>(count_)}; }
    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    void add_batches(const Scene& scene);
    void take_taus(const Input& seen);

    const base::Runtime& runtime_;
    ProjectionLoops see_;
    HatchLoops loops_;
    base::List<Batch> batches_; // may hold more than `count_`, if an earlier frame had more
    std::int64_t count_ = 0;
    base::Array<float> taus_; // the tone of each mark of the scene, where callbacks give tones
};

// The row or column of tiles that a place lies in or is nearest to. `count` is the number of rows or columns.
[[nodiscard]] inline std::int64_t tile_of(float at, std::int64_t count) noexcept {
    constexpr float scale = 1.0F / static_cast<float>(drawing::tile_size);
    return static_cast<std::int64_t>(std::clamp(at * scale, 0.0F, static_cast<float>(count - 1)));
}

// The points in each tile of a picture. Points follow each other along lines, so a run of many points is one entry.
class HatchTiles {
public:
    explicit HatchTiles(const base::Runtime& runtime) noexcept
        : runtime_(runtime), offsets_(runtime.memory), runs_(runtime.memory) {}

    // Each point belongs to one tile, which Tiles::own_extent() of the drawing's dots gives.
    void build(std::span<HatchPoints::Batch> batches, const drawing::Drawing& drawing);

    // Calls f(number) for the tile's dots, in ascending order.
    template <class F>
    void for_tile(std::int64_t tile, const F& f) const {
        for (std::int64_t i = offsets_[tile]; i < offsets_[tile + 1]; ++i)
            for (std::int64_t dot = runs_[i].begin; dot < runs_[i].end; ++dot) f(dot);
    }

    [[nodiscard]] std::int64_t bytes() const noexcept { return offsets_.bytes() + runs_.bytes(); }

private:
    const base::Runtime& runtime_;
    base::Array<std::int64_t> offsets_; // the first run of each tile, and the end
    base::Array<HatchDotRun> runs_;
};

} // namespace hrbfnpr::frame
