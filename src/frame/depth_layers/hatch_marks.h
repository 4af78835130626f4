// SPDX-License-Identifier: MIT
// The marks of a stroke as hatching needs them: where they are in the picture, and how wide their line is there.
#pragma once

#include "frame/depth_layers/gather.h"
#include "frame/depth_layers/hatch_law.h"

#include <array>

namespace hrbfnpr::frame {

// Why a line ends.
enum class HatchEnd : std::uint8_t {
    tone = 0,    // it is too light there
    level = 1,   // lines of its level are too close together
    rim = 2,     // the surface turns away
    picture = 3, // far enough outside of the picture
    line = 4     // its stroke ends
};
inline constexpr std::size_t hatch_margins = 4;

// A line between others that there is room for on a short way only, shorter than so many of the shortest parts, is left
// out.
inline constexpr float shortest_filling = 3.0F;

struct HatchMark {
    float x, y; // pixels
    float window, depth, pixels_per_unit;
    float nu;
    float side_x, side_y; // of the unit normal, eye space
    float darkness;
    float spacing; // of the lines of level 0, pixels, if their separation is known
    float width;   // of the line, pixels
    // The line is drawn where none is negative; by HatchEnd.
    std::array<float, hatch_margins> margin;
    std::uint32_t id;
    bool valid; // it has a place in the picture's plane

    [[nodiscard]] bool is_drawn() const noexcept {
        return valid && std::min({margin[0], margin[1], margin[2], margin[3]}) >= 0.0F;
    }
};

// A stroke while its marks are looked at.
struct HatchStroke {
    explicit HatchStroke(base::Memory& memory) noexcept : place(memory), mark(memory), may_draw(memory) {}

    base::Array<std::int64_t> place; // of those that are seen, in the order of the strokes, rising
    base::Array<HatchMark> mark;     // the same; of a closed stroke the first one again
    base::Array<bool> may_draw;      // of each piece
    std::int64_t first = 0,
                 count = 0;  // places; of a closed one without the last mark, if that lies where the first does
    std::int64_t stride = 1; // from one mark that is seen to the next
    bool closed = false;

    [[nodiscard]] std::int64_t bytes() const noexcept { return place.bytes() + mark.bytes() + may_draw.bytes(); }
};

// Looks at the strokes of one run.
class HatchMarks {
public:
    // taus: of each mark of the run, if they are a callback's; else NULL.
    HatchMarks(const Gather& gather, const Scene& scene, const Run& run, const float* taus) noexcept;

    // The marks of a stroke in their order: not those of pieces where nothing is drawn, unless they are next to others,
    // nor more than the picture needs.  piece: the stroke's first one.  Returns whether there are any.
    bool see(std::int64_t stroke, std::int64_t piece, HatchStroke& seen) const;

private:
    [[nodiscard]] std::int32_t most_level() const noexcept;
    [[nodiscard]] std::int32_t most_level(float nearest, float darkness) const noexcept;
    [[nodiscard]] bool may_draw(const marks::StrokePiece& piece, std::int64_t& stride) const noexcept;
    [[nodiscard]] std::int64_t stride_of(const marks::StrokePiece& piece, float nearest) const noexcept;
    void set_ends(std::int64_t stroke, HatchStroke& seen) const noexcept;
    void find_places(HatchStroke& seen) const;
    void see_marks(HatchStroke& seen) const;
    void see_part(const HatchStroke& stroke, std::int64_t begin, std::span<HatchMark> marks) const noexcept;
    void take_places(const Seen& seen, const std::int64_t* places, std::span<HatchMark> marks) const noexcept;
    void set_darkness(const Seen& seen, const std::int64_t* places, std::span<HatchMark> marks) const noexcept;
    [[nodiscard]] float most_darkness(const ClusterView& view) const noexcept;
    [[nodiscard]] float picture_margin(float x, float y) const noexcept;
    void set_width(HatchMark& mark) const noexcept;
    void set_widths(std::span<HatchMark> marks) const noexcept;
    void set_spacing(const HatchStroke& stroke, std::int64_t begin, const MarkRange& range,
                     std::span<HatchMark> marks) const noexcept;
    [[nodiscard]] float spacing_at(const glm::vec3& along, const glm::vec3& normal,
                                   const HatchMark& mark) const noexcept;
    [[nodiscard]] glm::vec3 place(std::int64_t at) const noexcept {
        return glm::vec3(glm::dvec3(run_.position_of(run_.marks->mark_of(at))) * per_unit_);
    }

    const Gather& gather_;
    const Scene& scene_;
    const Run& run_;
    const ItemView& item_;
    const ItemSight& sight_;
    const Seer& seer_;
    const LayerStyle& style_;
    const float* taus_;
    std::int32_t levels_; // the finest one
    double per_unit_;     // of the item: a power of two, as that
    float separation_;    // of the lines of level 0 alone, in the item's unit; 0: not known
    float beyond_;        // the picture, pixels: there lines may end unseen
    float stretch_;       // of a length of 1 at the distance 1, pixels, at most
    std::int32_t shown_;  // no finer level can be seen from here
};

} // namespace hrbfnpr::frame
