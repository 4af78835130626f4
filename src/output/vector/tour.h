// SPDX-License-Identifier: MIT
// The order in which a pen goes through lines and dots, so that it travels little between them.
#pragma once

#include "output/vector/near_tree.h"
#include "output/vector/page.h"

namespace hrbfnpr::output {

// A line that is drawn one way or the other, a closed one from any of its points, or a dot: one point.
struct Stop {
    std::span<const PagePoint> points;
    bool closed = false; // the last point stands where the first one does
};

struct Leg {
    std::int32_t stop = 0;
    std::int32_t start = 0; // the point that a closed one begins at
    bool reversed = false;
};

// Greedy, then 2-opt and Or-opt moves, then such moves after small random changes, which are kept if they gain
// [Johnson and McGeoch 1997, "The traveling salesman problem: a case study in local optimization"]: a tour of 2 n
// cities, the ends of n stops, whose two are always neighbours.
class Tour {
public:
    explicit Tour(base::Memory& memory) noexcept;

    // Through all stops from a place; the tour ends anywhere.  Valid until the next call.
    std::span<const Leg> find(std::span<const Stop> stops, const glm::dvec2& from, const base::Progress& progress);

private:
    using Node = std::int32_t; // 2 i and 2 i + 1 are the ends of stop i; of a closed one both are where it begins

    [[nodiscard]] Node free_end() const noexcept { return 2 * stops_; }
    [[nodiscard]] double distance(Node a, Node b) const noexcept {
        return a == free_end() || b == free_end() ? 0.0 : glm::distance(place_[a], place_[b]);
    }
    [[nodiscard]] std::int32_t at(std::int64_t position) const noexcept {
        return static_cast<std::int32_t>(position < 0         ? position + count_
                                         : position >= count_ ? position - count_
                                                              : position);
    }
    [[nodiscard]] Node entry(std::int64_t position) const noexcept { return order_[at(position)]; }
    [[nodiscard]] Node exit(std::int64_t position) const noexcept { return order_[at(position)] ^ 1; }
    [[nodiscard]] bool is_exit(Node node) const noexcept { return (order_[position_[node / 2]] ^ 1) == node; }
    [[nodiscard]] Node linked(Node node) const noexcept {
        const std::int64_t p = position_[node / 2];
        return is_exit(node) ? entry(p + 1) : exit(p - 1);
    }

    void set_places(std::int32_t stop, const glm::dvec2& first, const glm::dvec2& last) noexcept {
        const Node node = 2 * stop;
        place_[node] = first;
        place_[node + 1] = last;
    }
    void set_up(std::span<const Stop> stops, const glm::dvec2& from);
    void go_greedily(std::span<const Stop> stops, const base::Progress& progress);
    void find_neighbours(const base::Progress& progress);
    void improve(const base::Progress& progress);
    void settle(const base::Progress& progress);
    bool improve_at(Node node);
    bool move_segment(Node node, Node to, double nearer);
    void kick(const base::Progress& progress);
    double swap_segments(std::int64_t first, std::int64_t length, std::int64_t other);
    void undo() noexcept;
    void reverse(std::int64_t first, std::int64_t last);
    void shift(std::int64_t first, std::int32_t length, std::int64_t gap, bool reversed);
    void put(std::int64_t position, Node entry);
    void wake(Node node);
    bool turn_closed(std::span<const Stop> stops, const base::Progress& progress);
    void write_legs(std::span<const Stop> stops);

    std::int32_t stops_ = 0, count_ = 0;  // stops; and the pen, which is one whose first end is free, its second here
    std::int64_t work_ = 0, checked_ = 0; // that is left for moves, and was when a cancel was looked for
    std::int64_t longest_ = 0;            // stops that a move may take along
    double gained_ = 0.0;                 // mm, by moves
    bool keeps_log_ = false;
    base::Array<glm::dvec2> place_;      // of each node
    base::Array<std::int32_t> start_;    // of each closed stop
    base::Array<Node> order_;            // the tour: the node that each stop is entered by
    base::Array<std::int32_t> position_; // of each stop
    base::Array<Node> near_;             // `most_near` of each node, nearest first; -1: no more
    base::Array<std::int32_t> queue_;    // stops whose ends are to be looked at; a ring
    std::int64_t queue_first_ = 0, queue_size_ = 0;
    base::Array<std::uint8_t> waits_; // whether a stop is in the queue
    struct Entry {
        std::int32_t position;
        Node node;
    };
    base::Array<Entry> log_;        // what stood where before it was overwritten
    base::Array<Node> swapped_;     // by a kick
    base::Array<glm::dvec2> doors_; // where stops may be entered
    base::Array<std::int32_t> door_stop_, door_point_, first_door_;
    NearTree tree_;
    base::Array<Leg> legs_;
};

} // namespace hrbfnpr::output
