// The first half of a frame by sheets: from clusters of marks to ink and covers.     [NPAR 6, 6.2]
#pragma once

#include "base/runtime.h"
#include "frame/cluster_view.h"
#include "frame/ink.h"
#include "frame/tile_bins.h"
#include "frame/tone_calls.h"
#include "frame/tone_curve.h"

namespace hrbfnpr::frame {

// How much ink there is per area of an item's image, if all of its marks are shown.
struct ItemInk {
    struct Term {
        const Pen* pen = nullptr;
        float marks_per_area = 0.0F; // in eye space
        float step = 0.0F;           // between the marks of a stroke, eye units; 0: no strokes
    };
    std::array<Term, 3> term;
    std::size_t terms = 0;
    // ink_for() of these coverages, so that a mark need not take a root.
    std::array<float, needed_steps + 1> needed{};

    [[nodiscard]] float per_pixel(float ppe) const noexcept;
};

// What a sheet lets through, by |nu|.
struct ClearTable {
    static constexpr std::size_t steps = 256;
    std::array<float, steps + 1> front, back;
    float halo;

    [[nodiscard]] float at(float nu) const noexcept {
        const auto step = static_cast<std::size_t>(std::min(std::abs(nu), 1.0F) * steps + 0.5F);
        return nu > 0.0F ? back[step] : front[step];
    }
};

class Gather {
public:
    explicit Gather(const base::Runtime& runtime) noexcept;

    // Throws Error{callback, out_of_memory}.
    void run(Scene& scene);

    [[nodiscard]] std::span<Ink> inks() noexcept { return inks_.span(); }
    [[nodiscard]] std::span<const Cover> covers() const noexcept { return covers_.span(); }
    // Where in those arrays there are any.
    [[nodiscard]] std::span<const Piece> ink_pieces() const noexcept { return ink_pieces_.span(); }
    [[nodiscard]] std::span<const Piece> cover_pieces() const noexcept { return cover_pieces_.span(); }
    [[nodiscard]] FrameInfo info() const noexcept;
    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    friend class Gatherer;

    void set_up(const Scene& scene);
    void add_pieces(const Scene& scene);
    [[nodiscard]] ItemInk ink_of(const Scene& scene, std::int64_t first) const noexcept;
    void ask_tones(Scene& scene);
    void ask_cluster(const Scene& scene, const Run& run, const sampling::Cluster& cluster);

    // Consecutive clusters of a run: the unit of work.
    struct Work {
        std::int32_t run;
        std::int32_t begin, end;  // clusters
        std::int64_t first_place; // of its marks in the arrays
    };

    const base::Runtime& runtime_;
    SeeLoops loops_;
    Frustum frustum_;
    base::Array<ItemSight> sights_;
    base::Array<ItemInk> item_inks_;
    base::Array<ClearTable> clears_;
    base::Array<std::int32_t> clear_of_; // each item's
    base::Array<Work> work_;
    base::Array<Ink> inks_;
    base::Array<Cover> covers_;
    base::Array<Piece> ink_pieces_, cover_pieces_;
    base::Array<FrameInfo> counts_;
    base::Array<float> tau_; // of the marks whose tone is a callback's, by place
    ToneCalls tone_calls_;
};

} // namespace hrbfnpr::frame
