// SPDX-License-Identifier: MIT
// Lines are moved to the middle between those beside them, and then straightened where they turn too much.
#include "geometry/long_vec_array.h"
#include "geometry/point_grid.h"
#include "hatching/lines.h"
#include "hatching/tuning.h"

#include <algorithm>
#include <array>

namespace hrbfnpr::hatching {
namespace {

constexpr std::int64_t lines_a_task = 16;

// The points of a line: those from begin up to end.
struct Stretch {
    std::int64_t begin, end;
    bool closed;

    // The neighbours of a point along the line; -1 beyond an end.
    [[nodiscard]] std::int64_t after(std::int64_t i) const noexcept {
        return i + 1 < end ? i + 1 : closed ? begin : -1;
    }
    [[nodiscard]] std::int64_t before(std::int64_t i) const noexcept {
        return i > begin ? i - 1 : closed ? end - 1 : -1;
    }
};

template <class Visit>
void for_lines(const base::Runtime& runtime, const Lines& lines, const base::Progress& progress, const Visit& visit) {
    runtime.parallel.for_chunks(lines.count(), lines_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t l = begin; l < end; ++l) {
            progress.check();
            visit(Stretch{lines.first[l], lines.first[l + 1], lines.closed[l] != 0});
        }
    });
}

// Replaces the points of a line by moved(point before, point, point after) of where they were; open ends stay.
template <class Moved>
void move_between(geometry::VecArray& position, const Stretch& line, const Moved& moved) {
    const glm::dvec3 first = position[line.begin];
    glm::dvec3 before = line.closed ? position[line.end - 1] : first;
    for (std::int64_t i = line.begin; i < line.end; ++i) {
        const glm::dvec3 here = position[i];
        const glm::dvec3 after = i + 1 < line.end ? position[i + 1] : first;
        if (line.before(i) >= 0 && line.after(i) >= 0) position.set(i, moved(i, before, here, after));
        before = here;
    }
}

// The unit tangents across a line; 0 where it does not go on.
void set_across(const Lines& lines, const Stretch& line, geometry::VecArray& across) {
    for (std::int64_t i = line.begin; i < line.end; ++i) {
        const std::int64_t last = line.before(i);
        const std::int64_t next = line.after(i);
        const glm::dvec3 along = lines.position[next < 0 ? i : next] - lines.position[last < 0 ? i : last];
        const glm::dvec3 way = glm::cross(lines.normal[i], along);
        const double length = glm::length(way);
        across.set(i, length > 0.0 ? way / length : glm::dvec3(0.0));
    }
}

// ---- Neighbours

// A place between two points of the line beside a point.
struct Neighbour {
    std::int32_t from = -1, to = -1; // -1: there is no line
    float share = 0.0F;              // where the place is between the two points: 0 at `from`, 1 at `to`
    float gap = 0.0F;                // the distance to that place, in separations
    float sense = 0.0F;              // 1 if that line's way across points to the same side, else -1
};

// The neighbours of each point: against its way across, and along it.
using Beside = base::Array<std::array<Neighbour, 2>>;

// Where the plane across the line at each point meets other lines, or a part of the same line farther on: the nearest
// place on either side.
void find_beside(const base::Runtime& runtime, const Lines& lines, const geometry::VecArray& across, double separation,
                 Beside& beside, const base::Progress& progress) {
    const double step = hatching_tuning.even_step;
    const geometry::PointGrid grid(lines.position, (hatching_tuning.beside + step) * separation, progress);
    const geometry::VecArray places = grid.in_order(lines.position, progress);
    base::Array<std::int32_t> next(runtime.memory); // the point after each point on its line; -1: the line ends there
    base::resize_long(next, lines.position.size(), progress);
    for_lines(runtime, lines, progress, [&](const Stretch& line) {
        for (std::int64_t i = line.begin; i < line.end; ++i) next[i] = static_cast<std::int32_t>(line.after(i));
    });
    // Along a line its own points are beside others only where it winds round.
    const auto is_apart = [&](const Stretch& line, std::int64_t i, std::int64_t j) {
        if (j < line.begin || j >= line.end) return true;
        const std::int64_t way = std::abs(i - j);
        const std::int64_t shortest = line.closed ? std::min(way, line.end - line.begin - way) : way;
        return static_cast<double>(shortest) * step >= hatching_tuning.winding;
    };
    const auto look_around = [&](const Stretch& line, std::int64_t i) {
        const glm::dvec3 p = lines.position[i];
        const glm::dvec3 n = lines.normal[i];
        const glm::dvec3 aside = across[i];
        const glm::dvec3 along = glm::cross(aside, n);
        std::array<Neighbour, 2> found{};
        for (Neighbour& side : found) side.gap = static_cast<float>(hatching_tuning.beside);
        grid.around(p, [&](std::int64_t at) {
            const glm::dvec3 way = places[at] - p;
            const double from = glm::dot(way, along);
            if (std::abs(from) > 2.0 * step * separation) return;
            const std::int64_t j = grid.index(at);
            if (next[j] < 0) return;
            const glm::dvec3 next_way = lines.position[next[j]] - p;
            const double to = glm::dot(next_way, along);
            if ((from > 0.0) == (to > 0.0) || !is_apart(line, i, j)) return;
            const double turned = glm::dot(across[j], aside);
            if (!(glm::dot(n, lines.normal[j]) > hatching_tuning.same_sheet_cosine) ||
                !(std::abs(turned) > hatching_tuning.parallel_cosine))
                return;
            const double share = from / (from - to);
            const glm::dvec3 there = glm::mix(way, next_way, share);
            const double offset = glm::dot(there, aside);
            const double height = glm::dot(there, n);
            if (std::abs(height) > hatching_tuning.steepest * std::abs(offset) + hatching_tuning.thickness * separation)
                return;
            Neighbour& best = found[offset > 0.0 ? 1 : 0];
            const auto gap = static_cast<float>(std::abs(offset) / separation);
            if (gap < best.gap)
                best = {static_cast<std::int32_t>(j), next[j], static_cast<float>(share), gap,
                        turned > 0.0 ? 1.0F : -1.0F};
        });
        beside[i] = found;
    };
    for_lines(runtime, lines, progress, [&](const Stretch& line) {
        for (std::int64_t i = line.begin; i < line.end; ++i) {
            if ((i - line.begin) % 512 == 0) progress.check();
            look_around(line, i);
        }
    });
}

// ---- Moves

// An exponential mean of the values along a line, twice to and fro.
void average(const Stretch& line, float* values) {
    const std::int64_t count = line.end - line.begin;
    const std::int64_t run_up = line.closed ? std::min<std::int64_t>(hatching_tuning.run_up, count) : 0;
    const auto run = [&](const auto& at) {
        float mean = at(run_up == 0 ? 0 : count - run_up);
        for (std::int64_t i = count - run_up; i < count; ++i) mean += hatching_tuning.newest * (at(i) - mean);
        for (std::int64_t i = 0; i < count; ++i) at(i) = mean += hatching_tuning.newest * (at(i) - mean);
    };
    for (int twice = 0; twice < 2; ++twice) {
        run([&](std::int64_t i) -> float& { return values[line.begin + i]; });
        run([&](std::int64_t i) -> float& { return values[line.end - 1 - i]; });
    }
}

// How far a point is from the middle between its neighbours, after the moves of all three; in separations.
float way_to_middle(const Beside& beside, const base::Array<float>& move, std::int64_t i) noexcept {
    std::array<float, 2> gap{};
    for (const std::size_t side : {0U, 1U}) {
        const Neighbour& n = beside[i][side];
        if (n.from < 0) return 0.0F;
        const float wider = n.sense * std::lerp(move[n.from], move[n.to], n.share) - move[i];
        gap[side] = n.gap + (side == 1 ? wider : -wider);
    }
    return 0.5F * (gap[1] - gap[0]);
}

// How far each point is to move across its line, in separations.
base::Array<float> even_moves(const base::Runtime& runtime, const Lines& lines, const Beside& beside,
                              const base::Progress& progress) {
    base::Array<float> move(runtime.memory, beside.size());
    base::Array<float> wanted(runtime.memory, beside.size());
    for (int round = 0; round < hatching_tuning.moves; ++round) {
        for_lines(runtime, lines, progress, [&](const Stretch& line) {
            for (std::int64_t i = line.begin; i < line.end; ++i)
                wanted[i] = hatching_tuning.move_share * std::clamp(way_to_middle(beside, move, i), -0.5F, 0.5F);
            average(line, wanted.data());
        });
        for_lines(runtime, lines, progress, [&](const Stretch& line) {
            for (std::int64_t i = line.begin; i < line.end; ++i) move[i] += wanted[i];
        });
    }
    return move;
}

// ---- Kinks

// Marks the points of all parts, each of two separations, that turn too much within the surface. Parts that turn still
// more are not marked: there the field itself turns, around a singular point. turn: gets the angle by which the line
// turns at each point, radians.
bool mark_kinks(const Lines& lines, const Stretch& line, base::Array<float>& turn, base::Array<std::uint8_t>& kink) {
    for (std::int64_t i = line.begin; i < line.end; ++i) {
        kink[i] = 0;
        turn[i] = 0.0F;
        if (line.before(i) < 0 || line.after(i) < 0) continue;
        const glm::dvec3 n = lines.normal[i];
        const glm::dvec3 from = lines.position[i] - lines.position[line.before(i)];
        const glm::dvec3 to = lines.position[line.after(i)] - lines.position[i];
        const double cosine = glm::dot(from, to) - glm::dot(from, n) * glm::dot(to, n);
        turn[i] = static_cast<float>(std::atan2(glm::dot(glm::cross(from, to), n), cosine));
    }
    const auto for_part = [&](std::int64_t i, const auto& visit) {
        for (int k = 0; k < hatching_tuning.points_of_kink && i >= 0; ++k, i = line.after(i)) visit(i);
    };
    bool any = false;
    for (std::int64_t i = line.begin; i < line.end; ++i) {
        float sum = 0.0F;
        float most = 0.0F;
        for_part(i, [&](std::int64_t k) { most = std::max(most, std::abs(sum += turn[k])); });
        if (most <= hatching_tuning.most_turn || most > hatching_tuning.singular_turn) continue;
        for_part(i, [&](std::int64_t k) { kink[k] = 1; });
        any = true;
    }
    return any;
}

// Moves points in kinks halfway to the middle of those beside them, across the line.
void straighten(const base::Runtime& runtime, Lines& lines, geometry::VecArray& across,
                const base::Progress& progress) {
    base::Array<float> turn(runtime.memory, lines.position.size());
    base::Array<std::uint8_t> kink(runtime.memory, lines.position.size());
    for_lines(runtime, lines, progress, [&](const Stretch& line) {
        for (int round = 0; round < hatching_tuning.straightenings && mark_kinks(lines, line, turn, kink); ++round) {
            set_across(lines, line, across);
            move_between(lines.position, line,
                         [&](std::int64_t i, const glm::dvec3& before, const glm::dvec3& p, const glm::dvec3& after) {
                             const glm::dvec3 way = 0.5 * (before + after) - p;
                             return kink[i] != 0 ? p + 0.5 * glm::dot(way, across[i]) * across[i] : p;
                         });
        }
    });
}

} // namespace

Lines even_out(const base::Runtime& runtime, const Lines& given, double separation, const base::Progress& progress) {
    HRBFNPR_ASSERT(separation > 0.0);
    Lines lines =
        resampled(given, hatching_tuning.even_step * separation, hatching_tuning.shortest * separation, progress);
    // Points on a mesh's edges know their place only to a part of its cells.
    for_lines(runtime, lines, progress, [&](const Stretch& line) {
        for (int round = 0; round < hatching_tuning.smoothings; ++round)
            move_between(lines.position, line,
                         [](std::int64_t, const glm::dvec3& before, const glm::dvec3& p, const glm::dvec3& after) {
                             return 0.25 * before + 0.5 * p + 0.25 * after;
                         });
    });
    geometry::VecArray across(runtime.memory);
    geometry::resize_long(across, lines.position.size(), progress);
    Beside beside(runtime.memory);
    base::resize_long(beside, lines.position.size(), progress);
    for (int round = 0; round < hatching_tuning.rounds; ++round) {
        for_lines(runtime, lines, progress, [&](const Stretch& line) { set_across(lines, line, across); });
        find_beside(runtime, lines, across, separation, beside, progress);
        const base::Array<float> move = even_moves(runtime, lines, beside, progress);
        for_lines(runtime, lines, progress, [&](const Stretch& line) {
            for (std::int64_t i = line.begin; i < line.end; ++i)
                lines.position.set(i, lines.position[i] + static_cast<double>(move[i]) * separation * across[i]);
        });
    }
    straighten(runtime, lines, across, progress);
    return lines;
}

} // namespace hrbfnpr::hatching
