// SPDX-License-Identifier: MIT
// Finds a short tour through the 2 n ends of n stops, in which the two ends of a stop are always adjacent [Johnson and
// McGeoch 1997, "The traveling salesman problem: a case study in local optimization"]:
// 1. build_greedy_tour starts at the pen and goes to the nearest end, then from that stop's other end to the next
// nearest.
// 2. improve makes 2-opt and Or-opt moves that link a node to one of its neighbours, until none shortens the tour.
// 3. kick does the same after small random changes, and keeps those that shorten the tour.
// 4. turn_closed moves the start of each closed line to its best point; then step 2 is repeated.
#include "geometry/cell_grid.h"
#include "geometry/point_tree.h"
#include "output/vector/plot_lines.h"
#include "output/vector/tuning.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace hrbfnpr::output {
namespace {

using glm::dvec2;

// `order_` and `position_` are inverse permutations. They are changed only by set_entry(), and by kick() when it undoes
// a change.
class Tour {
public:
    Tour(base::Memory& memory, std::span<const Stop> stops, const dvec2& from, const base::Progress& progress)
        : stops_(stops), progress_(progress), pen_(static_cast<std::int32_t>(stops.size())), count_(pen_ + 1),
          place_(memory, 2 * std::int64_t{count_}), start_(memory, pen_), order_(memory, count_),
          position_(memory, count_), neighbours_(memory, std::int64_t{plot_tuning.most_neighbours} * 2 * count_),
          queue_(memory, count_), is_queued_(memory, count_), log_(memory), swapped_(memory) {
        set_places(pen_, from, from);
        for (std::int32_t i = 0; i < pen_; ++i)
            set_places(i, place_of(stop(i).points.front()), place_of(stop(i).points.back()));
    }

    base::Array<Leg> find() {
        check_cancel(progress_);
        build_greedy_tour();
        for (int round = 0; round < plot_tuning.most_rounds; ++round) {
            find_neighbours();
            improve();
            if (round == 0) kick();
            if (!turn_closed()) break;
        }
        check_cancel(progress_);
        return legs();
    }

private:
    // An end of a stop. Nodes 2 i and 2 i + 1 are the ends of stop i; for a closed line both are its starting point.
    // The pen is a stop, too: its first end is free, and its second end is the pen's position.
    using Node = std::int32_t;

    [[nodiscard]] const Stop& stop(std::int32_t number) const noexcept {
        HRBFNPR_ASSERT(number >= 0 && number < pen_);
        return stops_[static_cast<std::size_t>(number)];
    }
    [[nodiscard]] Node free_end() const noexcept { return 2 * pen_; }
    [[nodiscard]] double distance(Node a, Node b) const noexcept {
        return a == free_end() || b == free_end() ? 0.0 : glm::distance(place_[a], place_[b]);
    }
    // Wraps a position, since the tour is cyclic.
    [[nodiscard]] std::int32_t at(std::int64_t position) const noexcept {
        HRBFNPR_ASSERT(position >= -count_ && position < 2 * std::int64_t{count_});
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
    void set_places(std::int32_t number, const dvec2& first, const dvec2& last) noexcept {
        place_[2 * std::int64_t{number}] = first;
        place_[2 * std::int64_t{number} + 1] = last;
    }
    void set_entry(std::int64_t position, Node entry) {
        const std::int32_t place = at(position);
        if (keeps_log_) log_.push_back({place, order_[place]});
        order_[place] = entry;
        position_[entry / 2] = place;
    }

    void build_greedy_tour() {
        struct EntryPoint { // a point at which a stop may be entered
            std::int32_t stop, point;
        };
        base::Memory& memory = place_.memory();
        base::Array<EntryPoint> entry_points(memory);
        base::Array<std::int64_t> first_entry_point(memory);
        geometry::VecArray places(memory);
        for (std::int32_t i = 0; i < pen_; ++i) {
            if (i % steps_per_check == 0) check_cancel(progress_);
            const bool closed = stop(i).closed;
            first_entry_point.push_back(entry_points.size());
            const auto last = static_cast<std::int64_t>(stop(i).points.size()) - 1;
            const std::int64_t step =
                closed ? last / plot_tuning.most_entry_points + 1 : std::max<std::int64_t>(last, 1);
            for (std::int64_t p = 0; p <= (closed ? last - 1 : last); p += step) {
                places.push_back({place_of(stop(i).points[static_cast<std::size_t>(p)]), 0.0});
                entry_points.push_back({i, static_cast<std::int32_t>(p)});
            }
        }
        first_entry_point.push_back(entry_points.size());
        const geometry::PointTree tree(places, progress_);
        // For each node of the tree, the number of entry points of unvisited stops.
        base::Array<std::int64_t> left(memory, tree.nodes());
        base::Array<std::int64_t> at_of(memory, tree.size()); // the index in the tree of each entry point
        base::Array<std::uint8_t> visited(memory, pen_);
        for (std::int64_t at = 0; at < tree.size(); ++at) {
            if (at % steps_per_check == 0) check_cancel(progress_);
            at_of[tree.index(at)] = at;
            tree.for_nodes_of(at, [&](std::int64_t node) { ++left[node]; });
        }
        set_entry(0, free_end());
        dvec2 from = place_[free_end() + 1];
        for (std::int32_t next = 1; next < count_; ++next) {
            if (next % steps_per_check == 0) check_cancel(progress_);
            std::int64_t found = -1;
            tree.nearest(
                {from, 0.0}, 1, [&](std::int64_t node) { return left[node] > 0; },
                [&](std::int64_t at) { return visited[entry_points[tree.index(at)].stop] == 0; }, &found);
            HRBFNPR_ASSERT(found >= 0);
            const EntryPoint entry_point = entry_points[tree.index(found)];
            const bool closed = stop(entry_point.stop).closed;
            if (closed) {
                start_[entry_point.stop] = entry_point.point;
                const dvec2 place(tree.points()[found]);
                set_places(entry_point.stop, place, place);
            }
            set_entry(next, 2 * entry_point.stop + (closed || entry_point.point == 0 ? 0 : 1));
            from = place_[exit(next)];
            visited[entry_point.stop] = 1;
            for (std::int64_t d = first_entry_point[entry_point.stop]; d < first_entry_point[entry_point.stop + 1]; ++d)
                tree.for_nodes_of(at_of[d], [&](std::int64_t node) { --left[node]; });
        }
    }

    // If both ends of a stop are at the same place, only the first is listed as a neighbour of other nodes.
    void find_neighbours() {
        base::Array<Node> node_of(place_.memory());
        geometry::VecArray places(place_.memory());
        for (Node node = 0; node < 2 * count_; ++node) {
            if (node == free_end() || (node % 2 == 1 && node / 2 < pen_ && place_[node] == place_[node - 1])) continue;
            places.push_back({place_[node], 0.0});
            node_of.push_back(node);
        }
        const geometry::PointTree tree(places, progress_);
        const auto any = [](std::int64_t) { return true; };
        std::array<std::int64_t, plot_tuning.most_neighbours> found;
        for (Node node = 0; node < 2 * count_; ++node) {
            if (node % steps_per_check == 0) check_cancel(progress_);
            std::int64_t count = 0;
            if (node != free_end())
                count = tree.nearest(
                    {place_[node], 0.0}, plot_tuning.most_neighbours, any,
                    [&](std::int64_t at) { return node_of[tree.index(at)] / 2 != node / 2; }, found.data());
            for (std::int64_t i = 0; i < plot_tuning.most_neighbours; ++i)
                neighbours_[std::int64_t{plot_tuning.most_neighbours} * node + i] =
                    i < count ? node_of[tree.index(found[static_cast<std::size_t>(i)])] : -1;
        }
    }

    // ---- Moves

    void enqueue(Node node) {
        const std::int32_t number = node / 2;
        if (is_queued_[number] != 0) return;
        is_queued_[number] = 1;
        std::int64_t last = queue_first_ + queue_size_++;
        if (last >= count_) last -= count_;
        queue_[last] = number;
    }

    void improve() {
        work_ = checked_ = plot_tuning.work_of_stop * count_;
        longest_ = plot_tuning.longest_reversed;
        for (std::int32_t p = 0; p < count_; ++p) enqueue(order_[p]);
        run_moves();
    }

    // Makes moves until no move shortens the tour, or the allowed work is used up.
    void run_moves() {
        constexpr std::int64_t work_per_check = 100000;
        while (queue_size_ > 0) {
            if (checked_ - work_ > work_per_check) {
                check_cancel(progress_);
                checked_ = work_;
            }
            const std::int32_t number = queue_[queue_first_];
            if (++queue_first_ == count_) queue_first_ = 0;
            --queue_size_;
            is_queued_[number] = 0;
            while (work_ > 0 && (improve_at(2 * number) || improve_at(2 * number + 1))) {
            }
        }
    }

    // Repeatedly swaps two adjacent segments of the tour at a random position and improves the tour again. Such a swap,
    // called a double bridge, cannot be undone by a single 2-opt or Or-opt move. A change that does not shorten the
    // tour is undone.
    void kick() {
        const std::int64_t most = std::min<std::int64_t>(plot_tuning.longest_swapped, (count_ - 1) / 2);
        if (most < 1) return;
        work_ = checked_ = std::max(plot_tuning.work_of_kicks * count_,
                                    std::min(plot_tuning.work_of_few * count_, plot_tuning.least_work));
        longest_ = plot_tuning.longest_kicked;
        keeps_log_ = true;
        for (std::uint64_t number = 0; work_ > 0; ++number) {
            const auto one_of = [&](std::uint64_t which, std::int64_t count) { // random numbers by splitmix64
                return static_cast<std::int64_t>(geometry::hash_bits((3 * number + which) * 0x9E3779B97F4A7C15U) %
                                                 static_cast<std::uint64_t>(count));
            };
            gained_ = -swap_segments(one_of(1, count_), 1 + one_of(2, most), 1 + one_of(3, most));
            run_moves();
            if (gained_ < plot_tuning.least_gain)
                for (std::int64_t i = log_.size(); i > 0; --i) { // undo the changes in reverse order
                    order_[log_[i - 1].position] = log_[i - 1].node;
                    position_[log_[i - 1].node / 2] = log_[i - 1].position;
                }
            log_.clear();
            work_ -= 100;
        }
        keeps_log_ = false;
    }

    // Swaps the segment of `length` stops from `first` with the next `other` stops. Returns the change in the tour's
    // length.
    double swap_segments(std::int64_t first, std::int64_t length, std::int64_t other) {
        HRBFNPR_ASSERT(length > 0 && other > 0 && length + other < count_);
        const Node ends[6] = {exit(first - 1),
                              entry(first),
                              exit(first + length - 1),
                              entry(first + length),
                              exit(first + length + other - 1),
                              entry(at(first + length + other))};
        swapped_.clear();
        for (std::int64_t i = 0; i < length; ++i) swapped_.push_back(entry(first + i));
        for (std::int64_t i = 0; i < other; ++i) set_entry(first + i, entry(first + length + i));
        for (std::int64_t i = 0; i < length; ++i) set_entry(first + other + i, swapped_[i]);
        for (const Node end : ends) enqueue(end);
        return distance(ends[0], ends[3]) + distance(ends[4], ends[1]) + distance(ends[2], ends[5]) -
               distance(ends[0], ends[1]) - distance(ends[2], ends[3]) - distance(ends[4], ends[5]);
    }

    // Looks for a move that links the node to one of its neighbours and shortens the tour, and makes the first one
    // found.
    bool improve_at(Node node) {
        if (node == free_end()) return false;
        const double link = distance(node, linked(node));
        const Node* const near = neighbours_.data() + std::int64_t{plot_tuning.most_neighbours} * node;
        for (int i = 0; i < plot_tuning.most_neighbours && near[i] >= 0; ++i) {
            const double nearer = distance(node, near[i]);
            if (nearer >= link) break;
            work_ -= 20;
            const bool both = near[i] / 2 < pen_ && place_[near[i]] == place_[near[i] ^ 1];
            for (const Node to : {near[i], static_cast<Node>(near[i] ^ 1)}) {
                if (to != near[i] && !both) continue;
                if ((is_exit(to) == is_exit(node) && turn_part(node, to, link, nearer)) ||
                    move_segment(node, to, nearer))
                    return true;
            }
        }
        return false;
    }

    // 2-opt: reverses the stops between two nodes, which links the nodes.
    bool turn_part(Node node, Node to, double link, double nearer) {
        const Node next = linked(node), beyond = linked(to);
        const double gain = link + distance(to, beyond) - nearer - distance(next, beyond);
        const std::int64_t a = position_[node / 2], b = position_[to / 2];
        const std::int64_t way = std::abs(b - a);
        if (gain <= plot_tuning.least_gain || std::min(way, count_ - way) > longest_) return false;
        if (is_exit(node))
            reverse(a + 1, b);
        else
            reverse(a, b - 1);
        gained_ += gain;
        for (const Node end : {node, to, next, beyond}) enqueue(end);
        return true;
    }

    // Or-opt: moves up to three stops, the last of which has the end `node`. They are inserted between `to` and the
    // node linked to `to`.
    bool move_segment(Node node, Node to, double nearer) {
        const bool at_exit = is_exit(node);
        const std::int64_t p = position_[node / 2];
        const Node next = linked(node), beyond = linked(to);
        if (next == to) return false;
        const double link = distance(node, next) + distance(to, beyond) - nearer;
        for (std::int32_t length = 1; length <= plot_tuning.longest_moved && length + 2 <= count_; ++length) {
            const std::int64_t first = at_exit ? p - length + 1 : p;
            const Node other = at_exit ? entry(first) : exit(p + length - 1);
            if (other / 2 == to / 2) return false; // `to` belongs to the moved stops
            const Node before = linked(other);
            if (before == to) return false;
            const double gain = link + distance(other, before) - distance(before, next) - distance(other, beyond);
            const std::int64_t gap = is_exit(to) ? position_[to / 2] : position_[beyond / 2];
            const std::int64_t way = std::abs(gap - p);
            if (gain <= plot_tuning.least_gain || std::min(way, count_ - way) > longest_) continue;
            gained_ += gain;
            shift(at(first), length, gap, at_exit == is_exit(to));
            for (const Node end : {node, to, next, beyond, other, before}) enqueue(end);
            return true;
        }
        return false;
    }

    // Reverses the stops from one position to another, or else all other stops, whichever are fewer. Both give the same
    // tour.
    void reverse(std::int64_t first, std::int64_t last) {
        first = at(first);
        last = at(last);
        std::int64_t length = (last - first + count_) % count_ + 1;
        if (2 * length > count_) {
            std::swap(first, last);
            first = at(first + 1);
            last = at(last - 1);
            length = count_ - length;
        }
        work_ -= length;
        for (std::int64_t left = length; left > 0; left -= 2) {
            const Node a = order_[first], b = order_[last];
            set_entry(first, b ^ 1);
            set_entry(last, a ^ 1);
            first = at(first + 1);
            last = at(last - 1);
        }
    }

    // Moves stops into the gap after the position `gap`. The stops between their old place and the gap are shifted, on
    // the side with fewer stops.
    void shift(std::int64_t first, std::int32_t length, std::int64_t gap, bool reversed) {
        HRBFNPR_ASSERT(length <= plot_tuning.longest_moved);
        Node moved[plot_tuning.longest_moved];
        for (std::int32_t i = 0; i < length; ++i) moved[i] = reversed ? exit(first + length - 1 - i) : entry(first + i);
        const std::int64_t ahead = (gap - (first + length - 1) + 2 * std::int64_t{count_}) % count_;
        const std::int64_t behind = count_ - length - ahead;
        work_ -= std::min(ahead, behind);
        if (ahead <= behind) {
            for (std::int64_t i = 0; i < ahead; ++i) set_entry(at(first + i), entry(at(first + i) + length));
        } else {
            for (std::int64_t i = 1; i <= behind; ++i) set_entry(at(first - i) + length, order_[at(first - i)]);
        }
        const std::int64_t to = at(ahead <= behind ? first + ahead : first - behind);
        for (std::int32_t i = 0; i < length; ++i) set_entry(at(to + i), moved[i]);
    }

    // ---- Closed lines, and the result

    // Moves closed lines to their best starting points. Returns false if all of them already start there.
    bool turn_closed() {
        bool turned = false;
        CancelChecks checks(progress_, steps_per_check);
        for (std::int32_t i = 0; i < pen_; ++i) {
            const std::span<const PagePoint> points = stop(i).points;
            checks.count(stop(i).closed ? static_cast<std::int64_t>(points.size()) : 1);
            if (!stop(i).closed) continue;
            const std::int64_t p = position_[i];
            const Node before = exit(p - 1), after = entry(p + 1);
            const auto way = [&](const dvec2& place) {
                return (before == free_end() ? 0.0 : glm::distance(place_[before], place)) +
                       (after == free_end() ? 0.0 : glm::distance(place, place_[after]));
            };
            double least = way(place_[entry(p)]) - plot_tuning.least_gain;
            for (std::size_t k = 0; k + 1 < points.size(); ++k) {
                const dvec2 place = place_of(points[k]);
                if (const double length = way(place); length < least) {
                    least = length;
                    start_[i] = static_cast<std::int32_t>(k);
                    set_places(i, place, place);
                    turned = true;
                }
            }
        }
        return turned;
    }

    // Returns the legs in order from the pen. The tour may be stored in either direction.
    [[nodiscard]] base::Array<Leg> legs() const {
        base::Array<Leg> result(place_.memory());
        const std::int64_t pen = position_[pen_];
        const bool forward = order_[pen] == free_end();
        for (std::int64_t i = 1; i < count_; ++i) {
            const Node first = forward ? entry(pen + i) : exit(pen - i);
            const Stop& own = stop(first / 2);
            const bool is_point = own.closed || own.points.size() == 1;
            result.push_back({first / 2, start_[first / 2], first % 2 == 1 && !is_point});
        }
        return result;
    }

    struct Entry {
        std::int32_t position;
        Node node;
    };
    std::span<const Stop> stops_;
    const base::Progress& progress_;
    // The index of the pen, which follows the indices of the stops; and the number of stops including the pen.
    std::int32_t pen_, count_;
    // The work that moves may still use, and its value at the last check for cancellation.
    std::int64_t work_ = 0, checked_ = 0;
    std::int64_t longest_ = 0; // the largest number of stops that a move may reverse or pass
    double gained_ = 0.0;      // the length saved by the last moves, in mm
    bool keeps_log_ = false;
    base::Array<dvec2> place_;           // the place of each node, in mm
    base::Array<std::int32_t> start_;    // the starting point of each closed stop
    base::Array<Node> order_;            // the tour: the node at which each stop is entered
    base::Array<std::int32_t> position_; // the index of each stop in `order_`
    base::Array<Node>
        neighbours_; // for each node the `most_neighbours` nearest nodes of other stops, nearest first; -1: no more
    base::Array<std::int32_t> queue_; // a ring buffer of the stops whose ends are still to be examined
    std::int64_t queue_first_ = 0, queue_size_ = 0;
    base::Array<std::uint8_t> is_queued_; // whether a stop is in the queue
    base::Array<Entry> log_;              // overwritten entries of `order_`
    base::Array<Node> swapped_;           // a copy of the first of the two swapped segments
};

} // namespace

base::Array<Leg> find_tour(base::Memory& memory, std::span<const Stop> stops, const dvec2& from,
                           const base::Progress& progress) {
    return stops.empty() ? base::Array<Leg>(memory) : Tour(memory, stops, from, progress).find();
}

} // namespace hrbfnpr::output
