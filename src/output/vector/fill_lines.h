// SPDX-License-Identifier: MIT
// Lines wider than their pen are filled: several passes side by side, so that what their width carries is on paper.
#pragma once

#include "base/operation.h"
#include "output/vector/plot_lines.h"

namespace hrbfnpr::output {

class FillLines {
public:
    explicit FillLines(base::Memory& memory) noexcept;

    // Enough for another pass.
    [[nodiscard]] static bool is_wider(std::span<const PagePoint> points, double pen) noexcept;
    // Replaces lines that are wider than their pen by lines that are as wide as that, and returns how many they were.
    // The pen goes along the line at even distances, and along its sides; each pass is only where the line is so wide.
    // Passes whose ends are near to each other become one line, drawn to and fro.
    std::int64_t fill(PlotLines& lines, double tolerance, const base::Progress& progress);

private:
    // A place on the centre of the line, and how far to either side of it the pen may go.
    struct Node {
        glm::dvec2 place, normal; // unit, to the left
        double reach, at;         // `at`: along the line
    };
    // One pass, between two places on one side of the line: its points in `passes_`.
    struct Pass {
        std::int64_t first, count;
        double begin, end; // along the line
        bool used;
    };
    // The pass at a distance from the centre, where the line reaches farther than one further in covers.
    struct Track {
        double side, level, least;
    };
    void find_nodes(std::span<const PagePoint> points, const PlotLine& line);
    void add_place(const PagePoint& p);
    void begin_where_narrow();
    void add_cap(drawing::Cap cap, bool at_end);
    void shorten(bool at_end);
    void find_normals(bool closed);
    void find_passes();
    void add_track(const Track& track);
    void add_pass(const Track& track, double begin, double end);
    void put(const Track& track, const Node& node);
    [[nodiscard]] static Node between(const Node& a, const Node& b, double t) noexcept;
    [[nodiscard]] bool goes_in_pairs() const noexcept;
    void link_passes(const PlotLine& line, PlotLines& out);
    [[nodiscard]] std::int64_t nearest_pass(const glm::dvec2& from, double at, bool& reversed) const noexcept;
    [[nodiscard]] double apart(double a, double b) const noexcept;

    double pen_ = 0.0, spacing_ = 0.0;
    double length_ = 0.0; // of the line that is filled
    bool closed_ = false;
    base::Array<Node> nodes_, turned_;
    base::Array<glm::dvec2> points_; // of passes
    base::Array<Pass> passes_;
    PlotLines filled_;
};

} // namespace hrbfnpr::output
