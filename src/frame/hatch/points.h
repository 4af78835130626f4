// SPDX-License-Identifier: MIT
// From the strokes of a run to even samples along their lines in the picture, whatever the distance of the marks.
//
// Most of a frame's strokes are not drawn. So first whole pieces of a stroke are passed over by what bounds them, then
// marks by their normals alone; the rest is projected and given its width on vectors of the processor (loops.h). What
// is left are chains of marks that follow each other, which are sampled at even steps and where the line may end.
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
    float side_x, side_y; // the unit normal's, eye space
    float width;          // the line's, pixels
    float way;            // from the mark before, pixels
    std::array<float, hatch_margins> margin;
    float pixels_per_unit;
    float begins_chain; // 1: marks before this one were left out, and the line does not go on over them; else 0
    float unused;
    std::uint32_t id;

    // Whether it has a place in the picture's plane.
    [[nodiscard]] bool is_valid() const noexcept { return margin[margin_picture] > hatch_nowhere; }
};

// How a line ends where its stroke does.
enum class StrokeEnd : std::uint8_t { open, crease };

// The marks of a stroke that its line needs.
struct HatchStroke {
    explicit HatchStroke(base::Memory& memory) noexcept
        : mark(memory), may_draw(memory), range(memory), number(memory), row(memory) {}

    // Half-open, places in the order of the strokes.
    struct Range {
        std::int64_t begin, end;
    };

    base::Array<HatchMark> mark; // those near places that are drawn; a ring ends with its first mark
    bool ring = false;           // the stroke is closed, and none of its marks was left out
    std::int64_t first_kept = 0; // the row of mark[0]; its number along the stroke, where no marks were left out
    StrokeEnd begins = StrokeEnd::open, ends = StrokeEnd::open;
    bool has_begin = false, has_end = false; // mark[0] is the stroke's first mark; the last one its last

    // Scratch.
    base::Array<std::uint32_t> may_draw; // a bit for each mark of a piece, for each piece
    base::Array<Range> range;            // the places that are looked at, rising
    base::Array<std::uint32_t> number;   // in the layer, of those marks
    base::Array<float> row;              // memory of HatchRows
    std::int64_t first = 0, count = 0;   // places; of a closed one without a last mark that lies where the first does
    bool closed = false;

    [[nodiscard]] std::int64_t bytes() const noexcept {
        return mark.bytes() + may_draw.bytes() + range.bytes() + number.bytes() + row.bytes();
    }
};

// How marks are seen; the same for all strokes of a frame.
struct HatchView {
    const SeeLoops& see;
    const HatchLoops& loops;
    const Scene& scene;
    const Frustum& frustum;
};

// ---- Samples

// A sample has the numbers of a mark at the same places, so that all of them are interpolated at once.
struct HatchSample {
    float x, y, window, depth;
    float side_x, side_y;                    // as in HatchMark
    float width;                             // the line's, pixels: the mean over half a step to either side
    float overshoot;                         // pixels by which a hand goes on beyond the tone that the line ends at
    std::array<float, hatch_margins> margin; // as in HatchMark
    float pixels_per_unit;
    std::array<float, 2> unused;
    std::uint32_t id; // the nearest mark's

    // In the picture, of any length: across a contour that would be here.
    [[nodiscard]] glm::vec2 across_rim() const noexcept { return {side_x, -side_y}; }
};
static_assert(sizeof(HatchSample) == sizeof(HatchMark) &&
              offsetof(HatchSample, margin) == offsetof(HatchMark, margin) &&
              offsetof(HatchSample, side_x) == offsetof(HatchMark, side_x) &&
              offsetof(HatchSample, pixels_per_unit) == offsetof(HatchMark, pixels_per_unit));

// Samples that follow each other at even steps. A stroke has several chains where marks between them were left out.
struct HatchChain {
    std::int64_t first = 0; // its first sample
    std::int64_t count = 0; // 2 and more; the last sample of a ring is its first one
    bool ring = false;
    bool has_begin = false, has_end = false; // the stroke begins at its first sample; ends at its last one
    StrokeEnd begins = StrokeEnd::open, ends = StrokeEnd::open;
};

struct HatchSamples {
    explicit HatchSamples(base::Memory& memory) noexcept
        : chain(memory), sample(memory), length(memory), area(memory), tangent(memory), at(memory), ends(memory) {}

    base::Array<HatchChain> chain;
    base::Array<HatchSample> sample;

    // Scratch: the way to each mark of a chain from its first one, pixels; the area of the line up to there; and the
    // curve's tangent there, of unit length where marks lie evenly.
    base::Array<float> length, area;
    base::Array<glm::vec2> tangent;
    base::Array<float> at;          // lengths at which a chain is sampled
    base::Array<std::uint8_t> ends; // a bit for each margin that is 0 there

    void clear() noexcept {
        chain.clear();
        sample.clear();
    }
    [[nodiscard]] std::int64_t bytes() const noexcept {
        return chain.bytes() + sample.bytes() + length.bytes() + area.bytes() + tangent.bytes() + at.bytes() +
               ends.bytes();
    }
};

// Strokes of a run, from the one of number `begin`, whose first piece has the number `piece`, up to `end`.
struct HatchRange {
    std::int64_t begin = 0, end = 0, piece = 0;
};

// Appends the chains of strokes. `taus` are the tones of the run's marks, if a callback gives them; else NULL.
void sample_strokes(const HatchView& view, const Run& run, const ItemSight& sight, const float* taus,
                    const HatchRange& range, HatchStroke& scratch, HatchSamples& to);

// ---- Samples as dots, so that depth layers hide them as they hide all other ink

// Dots that follow each other in one tile of a picture.
struct HatchDotRun {
    std::int64_t tile, begin, end;
};

// A line is seen on one side of a place between two of its samples, and hidden on the other.
struct HatchCut {
    std::int64_t before = -1; // the first of the two samples; -1: there is no such place
    float at = 0.0F;          // along the line, pixels

    [[nodiscard]] bool any() const noexcept { return before >= 0; }
};

// What strokes are made of a batch of samples (strokes.h).
struct HatchStrokePart {
    explicit HatchStrokePart(base::Memory& memory) noexcept
        : made(memory), length(memory), cuts(memory), row(memory), near(memory), raw(memory) {}

    LineStrokes made;
    std::int64_t seen = 0;              // dots
    std::int64_t shown = 0, hidden = 0; // marks

    // Scratch.
    base::Array<float> length; // the way from a chain's first sample to each, pixels
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
    // Strokes that follow each other: the unit of work.  Threads fill batches that lie side by side.
    struct alignas(base::Memory::alignment) Batch {
        explicit Batch(base::Memory& memory) noexcept
            : samples(memory), stroke(memory), tile_runs(memory), part(memory) {}

        std::int32_t run = 0;
        HatchRange strokes;
        std::int64_t first_dot = 0; // its first sample in the drawing
        HatchSamples samples;
        HatchStroke stroke;                 // one of them
        base::Array<HatchDotRun> tile_runs; // its samples, by the tiles that they are in
        HatchStrokePart part;
    };

    explicit HatchPoints(const base::Runtime& runtime) noexcept
        : runtime_(runtime), see_(see_loops(runtime.instruction_set)), loops_(hatch_loops(runtime.instruction_set)),
          batches_(runtime.memory), taus_(runtime.memory) {}

    // How the other marks of the frame are seen.
    struct Seen {
        const Scene& scene;
        std::span<const ItemSight> sights; // one for each item
        const Frustum& frustum;
        std::span<const float> taus; // tones that a callback gave, by the place of the mark
    };

    // Adds the samples of all hatching to the drawing's dots, after all others. The drawing has been gathered.
    void run(const Seen& seen, drawing::Drawing& drawing);

    // The batches of the last run, in the order of the strokes.
    [[nodiscard]] std::span<Batch> batches() noexcept { return {batches_.begin(), static_cast<std::size_t>(count_)}; }
    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    void add_batches(const Scene& scene);
    void take_taus(const Seen& seen);

    const base::Runtime& runtime_;
    SeeLoops see_;
    HatchLoops loops_;
    base::List<Batch> batches_; // more than `count_` where an earlier frame had more
    std::int64_t count_ = 0;
    base::Array<float> taus_; // the tone of each mark of the scene, where callbacks give tones
};

// The row or column of tiles that a place lies in or is nearest to. `count` is the number of rows or columns.
[[nodiscard]] inline std::int64_t tile_of(float at, std::int64_t count) noexcept {
    constexpr float scale = 1.0F / static_cast<float>(drawing::tile_size);
    return static_cast<std::int64_t>(std::clamp(at * scale, 0.0F, static_cast<float>(count - 1)));
}

// The points in each tile of a picture. Points follow each other along lines, so that many of them are one entry.
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
