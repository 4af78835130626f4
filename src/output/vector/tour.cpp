// SPDX-License-Identifier: MIT
#include "output/vector/tour.h"

#include "geometry/cell_grid.h"
#include "output/vector/look.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>

namespace hrbfnpr::output {
namespace {

using glm::dvec2;

constexpr std::int32_t most_near_ends = 8;
constexpr std::int32_t longest_moved = 3;   // stops that an Or-opt move takes elsewhere together
constexpr std::int64_t most_doors = 32;     // of a closed line, before the best of its points is looked for
constexpr std::int64_t work_of_stop = 8000; // steps of moves, at most
constexpr std::int64_t work_of_kicks = 2000;
constexpr std::int64_t work_of_few = 10000;      // where there are so few stops that they take no more than
constexpr std::int64_t least_work = 200000;      // this together
constexpr std::int64_t longest_swapped = 30;     // stops of each part that a kick exchanges
constexpr std::int64_t longest_reversed = 50000; // stops that a move may turn round or pass by
constexpr std::int64_t longest_kicked = 1000;    // the same after a kick
constexpr std::int64_t toured_at_a_time = 512;
constexpr int most_rounds = 4;      // of moves, and of turning closed lines
constexpr double least_gain = 1e-9; // mm

bool is_point(const Stop& stop) noexcept { return stop.closed || stop.points.size() == 1; }

} // namespace

Tour::Tour(base::Memory& memory) noexcept
    : place_(memory), start_(memory), order_(memory), position_(memory), near_(memory), queue_(memory), waits_(memory),
      log_(memory), swapped_(memory), doors_(memory), door_stop_(memory), door_point_(memory), first_door_(memory),
      tree_(memory), legs_(memory) {}

std::span<const Leg> Tour::find(std::span<const Stop> stops, const dvec2& from, const base::Progress& progress) {
    legs_.clear();
    if (stops.empty()) return legs_.span();
    set_up(stops, from);
    look(progress);
    go_greedily(stops, progress);
    for (int round = 0; round < most_rounds; ++round) {
        find_neighbours(progress);
        improve(progress);
        if (round == 0) kick(progress);
        if (!turn_closed(stops, progress)) break;
    }
    look(progress);
    write_legs(stops);
    return legs_.span();
}

void Tour::set_up(std::span<const Stop> stops, const dvec2& from) {
    stops_ = static_cast<std::int32_t>(stops.size());
    count_ = stops_ + 1;
    place_.resize_for_overwrite(2 * std::int64_t{count_});
    set_places(stops_, from, from);
    for (std::int32_t i = 0; i < stops_; ++i) {
        const PagePoint& first = stops[static_cast<std::size_t>(i)].points.front();
        const PagePoint& last = stops[static_cast<std::size_t>(i)].points.back();
        set_places(i, {first.x, first.y}, {last.x, last.y});
    }
    start_.clear();
    start_.resize(stops_);
    position_.resize_for_overwrite(count_);
    order_.resize_for_overwrite(count_);
    waits_.clear();
    waits_.resize(count_);
    queue_.resize_for_overwrite(count_);
    queue_first_ = queue_size_ = 0;
}

// From the pen to the nearest end, from its other end to the next nearest, and so on.
void Tour::go_greedily(std::span<const Stop> stops, const base::Progress& progress) {
    doors_.clear();
    door_stop_.clear();
    door_point_.clear();
    first_door_.clear();
    for (std::int32_t i = 0; i < stops_; ++i) {
        if (i % toured_at_a_time == 0) look(progress);
        const Stop& stop = stops[static_cast<std::size_t>(i)];
        first_door_.push_back(static_cast<std::int32_t>(doors_.size()));
        const auto last = static_cast<std::int64_t>(stop.points.size()) - 1;
        const std::int64_t step = stop.closed ? last / most_doors + 1 : std::max<std::int64_t>(last, 1);
        for (std::int64_t p = 0; p <= (stop.closed ? last - 1 : last); p += step) {
            const PagePoint& point = stop.points[static_cast<std::size_t>(p)];
            doors_.push_back({point.x, point.y});
            door_stop_.push_back(i);
            door_point_.push_back(static_cast<std::int32_t>(p));
        }
    }
    first_door_.push_back(static_cast<std::int32_t>(doors_.size()));
    tree_.build(doors_.span(), progress);
    put(0, free_end());
    dvec2 pen = place_[free_end() + 1];
    for (std::int32_t next = 1; next < count_; ++next) {
        if (next % toured_at_a_time == 0) look(progress);
        const std::int32_t door = tree_.nearest(pen);
        const std::int32_t stop = door_stop_[door];
        if (stops[static_cast<std::size_t>(stop)].closed) {
            start_[stop] = door_point_[door];
            set_places(stop, doors_[door], doors_[door]);
        }
        put(next, 2 * stop + (stops[static_cast<std::size_t>(stop)].closed || door_point_[door] == 0 ? 0 : 1));
        pen = place_[exit(next)];
        for (std::int32_t d = first_door_[stop]; d < first_door_[stop + 1]; ++d) tree_.remove(d);
    }
}

void Tour::find_neighbours(const base::Progress& progress) {
    // Of a stop whose ends are in one place the first stands for both.
    doors_.clear();
    door_stop_.clear();
    for (Node node = 0; node < 2 * count_; ++node) {
        if (node == free_end() || (node % 2 == 1 && node / 2 < stops_ && place_[node] == place_[node - 1])) continue;
        doors_.push_back(place_[node]);
        door_stop_.push_back(node);
    }
    tree_.build(doors_.span(), progress);
    near_.resize_for_overwrite(std::int64_t{most_near_ends} * 2 * count_);
    for (Node node = 0; node < 2 * count_; ++node) {
        if (node % toured_at_a_time == 0) look(progress);
        Node* const near = near_.data() + std::int64_t{most_near_ends} * node;
        double squares[most_near_ends];
        int count = 0;
        double square = node == free_end() ? 0.0 : std::numeric_limits<double>::infinity();
        tree_.search(place_[node], square, [&](std::int32_t door, double from) {
            if (door_stop_[door] / 2 == node / 2) return;
            int to = count < most_near_ends ? count++ : most_near_ends - 1;
            for (; to > 0 && squares[to - 1] > from; --to) {
                squares[to] = squares[to - 1];
                near[to] = near[to - 1];
            }
            squares[to] = from;
            near[to] = door_stop_[door];
            if (count == most_near_ends) square = squares[most_near_ends - 1];
        });
        std::fill(near + count, near + most_near_ends, -1);
    }
}

void Tour::wake(Node node) {
    const std::int32_t stop = node / 2;
    if (waits_[stop] != 0) return;
    waits_[stop] = 1;
    std::int64_t last = queue_first_ + queue_size_++;
    if (last >= count_) last -= count_;
    queue_[last] = stop;
}

void Tour::improve(const base::Progress& progress) {
    work_ = checked_ = work_of_stop * count_;
    longest_ = longest_reversed;
    for (std::int32_t p = 0; p < count_; ++p) wake(order_[p]);
    settle(progress);
}

// Until no move makes the tour shorter, or the work is used up.
void Tour::settle(const base::Progress& progress) {
    while (queue_size_ > 0) {
        if (checked_ - work_ > 100000) {
            look(progress);
            checked_ = work_;
        }
        const std::int32_t stop = queue_[queue_first_];
        if (++queue_first_ == count_) queue_first_ = 0;
        --queue_size_;
        waits_[stop] = 0;
        while (work_ > 0 && (improve_at(2 * stop) || improve_at(2 * stop + 1))) {
        }
    }
}

// Exchanges two neighbouring parts anywhere, a double bridge, which no one move undoes, lets the tour settle, and takes
// that back unless it became shorter.
void Tour::kick(const base::Progress& progress) {
    const std::int64_t most = std::min<std::int64_t>(longest_swapped, (count_ - 1) / 2);
    if (most < 1) return;
    work_ = checked_ = std::max(work_of_kicks * count_, std::min(work_of_few * count_, least_work));
    longest_ = longest_kicked;
    keeps_log_ = true;
    for (std::uint64_t number = 0; work_ > 0; ++number) {
        const auto one_of = [&](std::uint64_t which, std::int64_t count) { // splitmix64
            return static_cast<std::int64_t>(geometry::mixed_bits((3 * number + which) * 0x9E3779B97F4A7C15U) %
                                             static_cast<std::uint64_t>(count));
        };
        gained_ = -swap_segments(one_of(1, count_), 1 + one_of(2, most), 1 + one_of(3, most));
        settle(progress);
        if (gained_ < least_gain) undo();
        log_.clear();
        work_ -= 100;
    }
    keeps_log_ = false;
}

// Of the stops from a position, so many and so many others behind them; returns by how much the tour becomes longer.
double Tour::swap_segments(std::int64_t first, std::int64_t length, std::int64_t other) {
    const Node ends[6] = {exit(first - 1),
                          entry(first),
                          exit(first + length - 1),
                          entry(first + length),
                          exit(first + length + other - 1),
                          entry(at(first + length + other))};
    swapped_.clear();
    for (std::int64_t i = 0; i < length; ++i) swapped_.push_back(entry(first + i));
    for (std::int64_t i = 0; i < other; ++i) put(first + i, entry(first + length + i));
    for (std::int64_t i = 0; i < length; ++i) put(first + other + i, swapped_[i]);
    for (const Node end : ends) wake(end);
    return distance(ends[0], ends[3]) + distance(ends[4], ends[1]) + distance(ends[2], ends[5]) -
           distance(ends[0], ends[1]) - distance(ends[2], ends[3]) - distance(ends[4], ends[5]);
}

void Tour::undo() noexcept {
    for (std::int64_t i = log_.size(); i > 0; --i) {
        order_[log_[i - 1].position] = log_[i - 1].node;
        position_[log_[i - 1].node / 2] = log_[i - 1].position;
    }
}

// Takes the first move that links the node to one of its neighbours and makes the tour shorter.
bool Tour::improve_at(Node node) {
    if (node == free_end()) return false;
    const double link = distance(node, linked(node));
    const Node* const near = near_.data() + std::int64_t{most_near_ends} * node;
    for (int i = 0; i < most_near_ends && near[i] >= 0; ++i) {
        const double nearer = distance(node, near[i]);
        if (nearer >= link) break;
        work_ -= 20;
        const bool both = near[i] / 2 < stops_ && place_[near[i]] == place_[near[i] ^ 1];
        for (const Node to : {near[i], static_cast<Node>(near[i] ^ 1)}) {
            if (to != near[i] && !both) continue;
            const Node next = linked(node), beyond = linked(to);
            if (is_exit(to) == is_exit(node)) { // 2-opt
                const double gain = link + distance(to, beyond) - nearer - distance(next, beyond);
                const std::int64_t a = position_[node / 2], b = position_[to / 2];
                const std::int64_t way = std::abs(b - a);
                if (gain > least_gain && std::min(way, count_ - way) <= longest_) {
                    if (is_exit(node))
                        reverse(a + 1, b);
                    else
                        reverse(a, b - 1);
                    gained_ += gain;
                    for (const Node end : {node, to, next, beyond}) wake(end);
                    return true;
                }
            }
            if (move_segment(node, to, nearer)) return true;
        }
    }
    return false;
}

// Or-opt: up to three stops that end with the node go between another node and what that is linked to.
bool Tour::move_segment(Node node, Node to, double nearer) {
    const bool at_exit = is_exit(node);
    const std::int64_t p = position_[node / 2];
    const Node next = linked(node), beyond = linked(to);
    if (next == to) return false;
    const double link = distance(node, next) + distance(to, beyond) - nearer;
    for (std::int32_t length = 1; length <= longest_moved && length + 2 <= count_; ++length) {
        const std::int64_t first = at_exit ? p - length + 1 : p;
        const Node other = at_exit ? entry(first) : exit(p + length - 1);
        if (other / 2 == to / 2) return false; // it would take the other node along
        const Node before = linked(other);
        if (before == to) return false;
        const double gain = link + distance(other, before) - distance(before, next) - distance(other, beyond);
        const std::int64_t gap = is_exit(to) ? position_[to / 2] : position_[beyond / 2];
        const std::int64_t way = std::abs(gap - p);
        if (gain <= least_gain || std::min(way, count_ - way) > longest_) continue;
        gained_ += gain;
        shift(at(first), length, gap, at_exit == is_exit(to));
        for (const Node end : {node, to, next, beyond, other, before}) wake(end);
        return true;
    }
    return false;
}

void Tour::put(std::int64_t position, Node entry) {
    const std::int32_t place = at(position);
    if (keeps_log_) log_.push_back({place, order_[place]});
    order_[place] = entry;
    position_[entry / 2] = place;
}

// Turns round the stops from one position to another, which come in this order round the tour, or all others: that is
// the same tour.
void Tour::reverse(std::int64_t first, std::int64_t last) {
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
        put(first, b ^ 1);
        put(last, a ^ 1);
        first = at(first + 1);
        last = at(last - 1);
    }
}

// Takes stops from their positions to between `gap` and the next; those between move the shorter way.
void Tour::shift(std::int64_t first, std::int32_t length, std::int64_t gap, bool reversed) {
    Node moved[longest_moved];
    for (std::int32_t i = 0; i < length; ++i) moved[i] = reversed ? exit(first + length - 1 - i) : entry(first + i);
    const std::int64_t ahead = (gap - (first + length - 1) + 2 * std::int64_t{count_}) % count_;
    const std::int64_t behind = count_ - length - ahead;
    work_ -= std::min(ahead, behind);
    std::int64_t to = first;
    if (ahead <= behind) {
        for (std::int64_t i = 0; i < ahead; ++i) put(at(first + i), entry(at(first + i) + length));
        to = at(first + ahead);
    } else {
        for (std::int64_t i = 1; i <= behind; ++i) {
            const std::int64_t from = at(first - i);
            put(at(from + length), order_[from]);
        }
        to = at(first - behind);
    }
    for (std::int32_t i = 0; i < length; ++i) put(at(to + i), moved[i]);
}

// Lets each closed line begin where the way to it and from it is shortest; false: all do.
bool Tour::turn_closed(std::span<const Stop> stops, const base::Progress& progress) {
    bool turned = false;
    Looks looks(progress, toured_at_a_time);
    for (std::int32_t i = 0; i < stops_; ++i) {
        const Stop& stop = stops[static_cast<std::size_t>(i)];
        looks.count(stop.closed ? static_cast<std::int64_t>(stop.points.size()) : 1);
        if (!stop.closed) continue;
        const std::int64_t p = position_[i];
        const Node before = exit(p - 1), after = entry(p + 1);
        const auto way = [&](const dvec2& place) {
            return (before == free_end() ? 0.0 : glm::distance(place_[before], place)) +
                   (after == free_end() ? 0.0 : glm::distance(place, place_[after]));
        };
        double least = way(place_[entry(p)]) - least_gain;
        for (std::size_t k = 0; k + 1 < stop.points.size(); ++k) {
            const dvec2 place(stop.points[k].x, stop.points[k].y);
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

// From the pen, which the tour may stand in either way round.
void Tour::write_legs(std::span<const Stop> stops) {
    const std::int64_t pen = position_[stops_];
    const bool forward = order_[pen] == free_end();
    for (std::int64_t i = 1; i < count_; ++i) {
        const Node first = forward ? entry(at(pen + i)) : exit(at(pen - i));
        const Stop& stop = stops[static_cast<std::size_t>(first / 2)];
        legs_.push_back({first / 2, start_[first / 2], first % 2 == 1 && !is_point(stop)});
    }
}

} // namespace hrbfnpr::output
