// SPDX-License-Identifier: MIT
// Lines that go on where others end become one.
#pragma once

#include "output/vector/near_tree.h"
#include "output/vector/plot_lines.h"

namespace hrbfnpr::output {

struct JoinSettings {
    double distance = 0.0;        // mm, between ends; 0: the thinner line's width
    bool any_opacity = true;      // else lines of different opacities stay apart
    double sharpest = 1.04719755; // by how much the line may turn at a join, and its link on either side
};

class JoinLines {
public:
    explicit JoinLines(base::Memory& memory) noexcept;

    // Replaces `from` by the joined lines, in the order of the first of each, and returns the number of joins.  An end
    // takes the other one that it goes on into best: near, and without a turn.  Ends of neighbouring rows of hatching
    // point alike, so that they are never joined into a zigzag.
    std::int64_t join(PlotLines& from, const JoinSettings& settings, const base::Progress& progress);

private:
    struct Pair {
        double cost;
        std::int32_t a, b; // ends: 2 i is where line i begins, 2 i + 1 where it ends
    };
    void find_ends(const PlotLines& from, const base::Progress& progress);
    void find_pairs(PlotLines& from, const JoinSettings& settings, const base::Progress& progress);
    [[nodiscard]] double cost_of(const PlotLine& line, const PlotLine& other, std::int32_t a, std::int32_t b,
                                 double distance, double most, double sharpest) const noexcept;
    std::int64_t choose_pairs(const PlotLines& from, const base::Progress& progress);
    [[nodiscard]] std::int32_t chain_of(std::int32_t line) noexcept;
    void add_chain(const PlotLines& from, std::int32_t end);
    void add_points(std::int64_t chain, std::span<const PagePoint> points, bool reversed);

    base::Array<glm::dvec2> ends_, outward_; // places, and directions out of the lines
    base::Array<Pair> pairs_;
    base::Array<std::int32_t> partner_; // of each end; -1: none
    base::Array<std::int32_t> chain_;   // of each line: another of the same chain, or itself
    base::Array<double> length_;        // of the chain, at the line that chain_ leads to
    base::Array<std::uint8_t> done_;    // lines that stand in a chain
    NearTree tree_;
    PlotLines joined_;
};

} // namespace hrbfnpr::output
