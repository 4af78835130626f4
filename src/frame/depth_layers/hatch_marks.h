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

struct HatchMark {
    float x, y; // pixels
    float window, depth, pixels_per_unit;
    float nu;
    float darkness;
    float width; // of the line, pixels
    // The line is drawn where none is negative; by HatchEnd.
    std::array<float, hatch_margins> margin;
    std::uint32_t id;
    bool valid; // it has a place in the picture's plane

    [[nodiscard]] bool is_drawn() const noexcept {
        return valid && std::min({margin[0], margin[1], margin[2], margin[3]}) >= 0.0F;
    }
};

// Looks at the strokes of one run.
class HatchMarks {
public:
    // taus: of each mark of the run, if they are a callback's; else NULL.
    HatchMarks(const Gather& gather, const Scene& scene, const Run& run, const float* taus) noexcept;

    [[nodiscard]] bool shows(std::int64_t stroke) const noexcept;
    // The marks of a stroke in their order.  Returns whether it is closed: then its last mark is its first one again.
    bool see(std::int64_t stroke, base::Array<HatchMark>& marks) const;

private:
    struct Stroke {
        std::int64_t first, count; // places in the order of the strokes; of a closed one without the last mark, if that
                                   // lies where the first one does
        bool closed;
    };
    [[nodiscard]] std::int32_t most_level() const noexcept;
    [[nodiscard]] Stroke stroke_of(std::int64_t stroke) const noexcept;
    void see_part(std::int64_t first, std::span<HatchMark> marks) const noexcept;
    void take_places(const Seen& seen, std::int64_t first, std::span<HatchMark> marks) const noexcept;
    void set_darkness(const Seen& seen, std::int64_t first, std::span<HatchMark> marks) const noexcept;
    [[nodiscard]] float picture_margin(float x, float y) const noexcept;
    void set_width(const Stroke& stroke, std::int64_t i, HatchMark& mark) const noexcept;
    [[nodiscard]] float spacing_at(const Stroke& stroke, std::int64_t i, const HatchMark& mark) const noexcept;
    [[nodiscard]] glm::vec3 place(std::int64_t at) const noexcept {
        return run_.place_of(run_.marks->mark_of(at), item_.unit);
    }

    const Gather& gather_;
    const Scene& scene_;
    const Run& run_;
    const ItemView& item_;
    const Seer& seer_;
    const LayerStyle& style_;
    const float* taus_;
    std::int32_t levels_; // the finest one
    std::int32_t shown_;  // no finer level can be seen from here
    float separation_;    // of the lines of level 0 alone, in the item's unit; 0: not known
    float beyond_;        // the picture, pixels: there lines may end unseen
};

} // namespace hrbfnpr::frame
