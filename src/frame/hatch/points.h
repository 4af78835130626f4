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

// The margins of a mark. The line is drawn where none of them is negative.
enum HatchMargin : std::size_t {
    margin_tone = 0,    // how much darker the mark is than the tone at which lines begin
    margin_level = 1,   // how much space other lines leave for a line of the mark's level; 1: enough
    margin_rim = 2,     // how far the mark is turned towards the eye
    margin_picture = 3, // how far the mark is inside the picture and a strip around it, in pixels
    hatch_margins = 4
};

// A mark as seen in the picture.
struct HatchMark {
    float x, y; // position in pixels
    float window, depth;
    float side_x, side_y;  // x and y of the unit normal in eye space
    float width;           // line width in pixels
    float distance_before; // distance from the previous mark, in pixels
    std::array<float, hatch_margins> margin;
    float pixels_per_unit;
    float begins_chain; // 1 if the marks just before were left out, so that a new chain begins here; else 0
    float unused;
    std::uint32_t id;

    // Returns whether the mark has a position in the picture.
    [[nodiscard]] bool is_valid() const noexcept { return margin[margin_picture] > hatch_nowhere; }
};

// How a line ends at the end of its stroke.
enum class StrokeEnd : std::uint8_t { open, crease };

// Those marks of a stroke that are needed to draw its line.
struct HatchStroke {
    explicit HatchStroke(base::Memory& memory) noexcept
        : mark(memory), may_draw(memory), range(memory), number(memory), row(memory) {}

    // A half-open range of positions in the order of the strokes.
    struct Range {
        std::int64_t begin, end;
    };

    base::Array<HatchMark> mark; // the marks at and near drawn places; in a ring, the last mark repeats the first
    bool ring = false;           // True if the stroke is closed and all of its marks are present.
    // The index of mark[0] in the rows. If no marks were left out, it is also the index of the mark along the stroke.
    std::int64_t first_kept = 0;
    StrokeEnd begins = StrokeEnd::open, ends = StrokeEnd::open;
    // whether mark[0] is the stroke's first mark, and whether the last mark is the stroke's last
    bool has_begin = false, has_end = false;

    // Working memory.
    base::Array<std::uint32_t> may_draw; // for each piece of the stroke: a bit for each of its marks
    base::Array<Range> range;            // the ranges of positions of the loaded marks, in ascending order
    base::Array<std::uint32_t> number;   // the indices of the loaded marks in their layer
    base::Array<float> row;              // the memory of HatchRows
    // The stroke's range of positions. If the last mark of a closed stroke coincides with the first, it is left out.
    std::int64_t first = 0, count = 0;
    float step = 0.0F; // the distance of the stroke's first two marks, in the item's unit
    bool closed = false;

    [[nodiscard]] std::int64_t bytes() const noexcept {
        return mark.bytes() + may_draw.bytes() + range.bytes() + number.bytes() + row.bytes();
    }
};

// The data for finding how marks look. It is the same for all strokes of a frame.
struct HatchView {
    const ProjectionLoops& see;
    const HatchLoops& loops;
    const Scene& scene;
    const Frustum& frustum;
};

// ---- Samples

// A sample has the same members as a mark, at the same offsets, so that all can be interpolated in one loop.
struct HatchSample {
    float x, y, window, depth;
    float side_x, side_y; // as in HatchMark
    float width;          // line width in pixels: the mean over half a step to either side
    float overshoot;      // how far an overshoot continues beyond the end of the line's tone, in pixels
    std::array<float, hatch_margins> margin; // as in HatchMark
    float pixels_per_unit;
    std::array<float, 2> unused;
    std::uint32_t id; // the id of the nearest mark

    // If there were a contour at this sample, returns the direction across the contour in the picture. The vector has
    // no particular length.
    [[nodiscard]] glm::vec2 across_rim() const noexcept { return {side_x, -side_y}; }
};
static_assert(sizeof(HatchSample) == sizeof(HatchMark) &&
              offsetof(HatchSample, margin) == offsetof(HatchMark, margin) &&
              offsetof(HatchSample, side_x) == offsetof(HatchMark, side_x) &&
              offsetof(HatchSample, pixels_per_unit) == offsetof(HatchMark, pixels_per_unit));

// Consecutive samples at even steps along a stroke. If marks were left out, the stroke has several chains.
struct HatchChain {
    std::int64_t first = 0; // the index of the first sample
    std::int64_t count = 0; // at least 2; in a ring, the last sample repeats the first
    bool ring = false;
    // whether the stroke begins at the first sample, and whether it ends at the last one
    bool has_begin = false, has_end = false;
    StrokeEnd begins = StrokeEnd::open, ends = StrokeEnd::open;
};

struct HatchSamples {
    explicit HatchSamples(base::Memory& memory) noexcept
        : chain(memory), sample(memory), length(memory), area(memory), tangent(memory), at(memory), ends(memory) {}

    base::Array<HatchChain> chain;
    base::Array<HatchSample> sample;

    // Working memory. For each mark of a chain: the distance along the line from the first mark, in pixels; the area of
    // the line up to the mark; and the tangent of the curve, which has unit length if marks are evenly spaced.
    base::Array<float> length, area;
    base::Array<glm::vec2> tangent;
    base::Array<float> at;          // the distances at which a chain is sampled
    base::Array<std::uint8_t> ends; // for each element of `at`: a bit for each margin that is 0 there

    void clear() noexcept {
        chain.clear();
        sample.clear();
    }
    [[nodiscard]] std::int64_t bytes() const noexcept {
        return chain.bytes() + sample.bytes() + length.bytes() + area.bytes() + tangent.bytes() + at.bytes() +
               ends.bytes();
    }
};

// The strokes [begin, end) of a run. `piece` is the index of the first piece of stroke `begin`.
struct HatchRange {
    std::int64_t begin = 0, end = 0, piece = 0;
};

// Appends the chains of the given strokes. `taus` has the tones of the run's marks if a callback gives them, else it is
// NULL.
void sample_strokes(const HatchView& view, const Run& run, const ItemSight& sight, const float* taus,
                    const HatchRange& range, HatchStroke& scratch, HatchSamples& to);

// ---- Samples as dots, so that depth layers hide them as they hide all other ink

// Consecutive dots of a batch in the same tile of a picture.
struct HatchDotRun {
    std::int64_t tile, begin, end;
};

// A cut of a line between two of its samples: the line is seen on one side of it and hidden on the other.
struct HatchCut {
    std::int64_t before = -1; // The first of the two samples around the cut. -1 if the line is not cut.
    float at = 0.0F;          // position along the line, in pixels

    [[nodiscard]] bool any() const noexcept { return before >= 0; }
};

// The strokes made from a batch of samples (strokes.h).
struct HatchStrokePart {
    explicit HatchStrokePart(base::Memory& memory) noexcept
        : made(memory), length(memory), cuts(memory), row(memory), near(memory), raw(memory), inks(memory) {}

    LineStrokes made;
    std::int64_t seen = 0;              // how many dots are seen
    std::int64_t shown = 0, hidden = 0; // the counts of shown and hidden marks

    // Working memory.
    base::Array<float> length; // for each sample of a chain: distance from the first one along the line, pixels
    base::Array<HatchCut> cuts;
    base::Array<float> row;                // the presences of a chain
    base::Array<std::uint8_t> near;        // for each sample: a bit for each reason why the line ends or fades near it
    base::Array<drawing::StrokePoint> raw; // all points of a stroke, before some are left out
    base::Array<std::uint8_t> inks;        // the inks of these points

    void clear() noexcept {
        made.strokes.clear();
        made.points.clear();
        seen = shown = hidden = 0;
    }
    [[nodiscard]] std::int64_t bytes() const noexcept {
        return made.strokes.bytes() + made.points.bytes() + length.bytes() + cuts.bytes() + row.bytes() + near.bytes() +
               raw.bytes() + inks.bytes();
    }
};

class HatchPoints {
public:
    // Consecutive strokes, which one thread processes. Batches are adjacent in memory.
    struct alignas(base::Memory::alignment) Batch {
        explicit Batch(base::Memory& memory) noexcept
            : samples(memory), stroke(memory), tile_runs(memory), part(memory) {}

        std::int32_t run = 0;
        HatchRange strokes;
        std::int64_t first_dot = 0; // the index of the batch's first sample among the drawing's dots
        HatchSamples samples;
        HatchStroke stroke;                 // working memory for one stroke
        base::Array<HatchDotRun> tile_runs; // the samples of a stroke, divided into runs within one tile
        HatchStrokePart part;
    };

    explicit HatchPoints(const base::Runtime& runtime) noexcept
        : runtime_(runtime), see_(projection_loops(runtime.instruction_set)),
          loops_(hatch_loops(runtime.instruction_set)), batches_(runtime.memory), taus_(runtime.memory) {}

    // The results of gather() that hatching needs.
    struct Input {
        const Scene& scene;
        std::span<const ItemSight> sights; // one element for each item
        const Frustum& frustum;
        // The tones from callbacks, for the marks of all runs, in the order of the clusters' blocks.
        std::span<const float> taus;
    };

    // Adds the samples of all hatching to the drawing, after all other dots. gather() must be called first.
    void run(const Input& seen, drawing::Drawing& drawing);

    // Returns the batches of the last run, in the order of the strokes.
    [[nodiscard]] std::span<Batch> batches() noexcept { return {batches_.begin(), static_cast<std::size_t>(count_)}; }
    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    void add_batches(const Scene& scene);
    void take_taus(const Input& seen);

    const base::Runtime& runtime_;
    ProjectionLoops see_;
    HatchLoops loops_;
    base::List<Batch> batches_; // The list may hold more than `count_` batches, from an earlier frame.
    std::int64_t count_ = 0;
    base::Array<float> taus_; // for each mark of the scene: its tone, if a callback gives it
};

// Returns the row or column of tiles that contains a position or is nearest to it. `count` is the number of rows or
// columns.
[[nodiscard]] inline std::int64_t tile_of(float at, std::int64_t count) noexcept {
    constexpr float scale = 1.0F / static_cast<float>(drawing::tile_size);
    return static_cast<std::int64_t>(std::clamp(at * scale, 0.0F, static_cast<float>(count - 1)));
}

// The points in each tile of a picture. Consecutive points of a line in the same tile are stored as one entry.
class HatchTiles {
public:
    explicit HatchTiles(const base::Runtime& runtime) noexcept
        : runtime_(runtime), offsets_(runtime.memory), runs_(runtime.memory) {}

    // Each point belongs to one tile, found by Tiles::own_extent() of the drawing's dots.
    void build(std::span<HatchPoints::Batch> batches, const drawing::Drawing& drawing);

    // Calls f(index) for the dots of a tile, in ascending order of their indices.
    template <class F>
    void for_tile(std::int64_t tile, const F& f) const {
        for (std::int64_t i = offsets_[tile]; i < offsets_[tile + 1]; ++i)
            for (std::int64_t dot = runs_[i].begin; dot < runs_[i].end; ++dot) f(dot);
    }

    [[nodiscard]] std::int64_t bytes() const noexcept { return offsets_.bytes() + runs_.bytes(); }

private:
    const base::Runtime& runtime_;
    base::Array<std::int64_t> offsets_; // for each tile: the index of its first run; at the end, the number of runs
    base::Array<HatchDotRun> runs_;
};

} // namespace hrbfnpr::frame
