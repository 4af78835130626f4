// SPDX-License-Identifier: MIT
#include "marks/site.h"

#include "base/random.h"
#include "geometry/long_vec_array.h"
#include "geometry/unit.h"
#include "implicit/evaluate_all.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::marks {

void MarkProjector::project(double stray_limit, LevelReport& report, const base::Progress& progress) {
    const std::int64_t count = start.size();
    resize_long(projection_.position, count, progress);
    for (std::int64_t i = 0; i < count; ++i) projection_.position.set(i, start[i]);
    surface::ProjectionSettings settings;
    settings.tolerance = site_.projection_tolerance;
    surface::project({site_.work, progress}, site_.implicit, settings, projection_);

    placed_.resize(count);
    report.attempted += count;
    for (std::int64_t i = 0; i < count; ++i) {
        placed_[i] = 0;
        switch (projection_.status[i]) {
        case surface::ProjectionStatus::not_converged: ++report.dropped_not_converged; continue;
        case surface::ProjectionStatus::zero_gradient:
        case surface::ProjectionStatus::not_finite: ++report.dropped_degenerate; continue;
        case surface::ProjectionStatus::converged: break;
        }
        if (glm::distance(projection_.position[i], start[i]) > stray_limit) {
            ++report.dropped_strayed;
            continue;
        }
        placed_[i] = 1;
        ++report.placed;
    }
    drop_beyond_end(report);
}

// Drops points where samples do not support the surface.
void MarkProjector::drop_beyond_end(LevelReport& report) {
    if (site_.implicit.domain() == nullptr) return;
    constexpr std::int64_t grain = 256;
    site_.work.for_chunks(placed_.size(), grain, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i)
            if (placed_[i] != 0 && !site_.implicit.contains(projection_.position[i], projection_.gradient[i]))
                placed_[i] = beyond;
    });
    for (std::int64_t i = 0; i < placed_.size(); ++i)
        if (placed_[i] == beyond) drop(i, report.dropped_strayed, report);
}

glm::dvec3 MarkProjector::normal(std::int64_t i) const noexcept { return glm::normalize(projection_.gradient[i]); }

void MarkProjector::drop(std::int64_t i, std::int64_t& reason, LevelReport& report) noexcept {
    HRBFNPR_ASSERT(placed_[i] != 0 && report.placed > 0);
    placed_[i] = 0;
    --report.placed;
    ++reason;
}

void evaluate(const Site& site, const geometry::VecArray& points, FieldSamples& fields) {
    const std::int64_t count = points.size();
    fields.value.resize_for_overwrite(count);
    for (base::Array<double>* of : {&fields.gradient.x, &fields.gradient.y, &fields.gradient.z})
        of->resize_for_overwrite(count);
    implicit::FieldBatch all;
    all.value = fields.value.data();
    all.gradient = {fields.gradient.x.data(), fields.gradient.y.data(), fields.gradient.z.data()};
    implicit::evaluate_all(site.work, site.implicit, points, all);
}

glm::dvec3 tangent_part(const glm::dvec3& d, const glm::dvec3& n) noexcept {
    const glm::dvec3 moderate = d / geometry::unit_for(std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}));
    const glm::dvec3 tangent = moderate - glm::dot(moderate, n) * n;
    const double length = glm::length(tangent);
    return length > 1e-6 * glm::length(moderate) ? tangent / length : glm::dvec3(0.0);
}

base::Array<double> call_at_points(const Site& site, PointFunction function, void* user, const char* name,
                                   const geometry::VecArray& positions, const geometry::VecArray& normals,
                                   std::int64_t components) {
    constexpr std::int64_t places_a_call = 4096;
    const std::int64_t all = positions.size();
    HRBFNPR_ASSERT(normals.size() == all && function != nullptr && components > 0);
    site.work.check();
    base::Array<double> results(site.memory(), components * all);
    base::Array<double> packed(site.memory(), 6 * std::min(all, places_a_call)); // positions, then normals
    for (std::int64_t begin = 0; begin < all; begin += places_a_call) {
        site.work.update(static_cast<double>(begin) / static_cast<double>(all));
        const std::int64_t count = std::min(places_a_call, all - begin);
        for (std::int64_t i = 0; i < count; ++i)
            for (int c = 0; c < 3; ++c) {
                packed[3 * i + c] = site.unit * positions[begin + i][c];
                packed[3 * (count + i) + c] = normals[begin + i][c];
            }
        double* const to = results.data() + components * begin;
        if (const std::int32_t code = function(user, count, packed.data(), packed.data() + 3 * count, to); code != 0)
            fail(Status::callback, "%s returned %d; it must return 0 unless it failed", name, static_cast<int>(code));
    }
    return results;
}

void directions_at(const Site& site, const DirectionFunction& field, const geometry::VecArray& positions,
                   const geometry::VecArray& normals, geometry::VecArray& directions) {
    const base::Array<double> given =
        call_at_points(site, field.function, field.user, "direction_function", positions, normals, 3);
    directions.resize(positions.size());
    for (std::int64_t i = 0; i < positions.size(); ++i) {
        const glm::dvec3 d(given[3 * i], given[3 * i + 1], given[3 * i + 2]);
        if (!std::isfinite(d.x) || !std::isfinite(d.y) || !std::isfinite(d.z))
            fail(Status::callback, "direction_function gave %g %g %g; a direction must be finite, or 0 0 0 for none",
                 d.x, d.y, d.z);
        directions.set(i, tangent_part(d, normals[i]));
    }
}

void require_size(const char* what, double size, const char* remedy) {
    if (size >= smallest_size && size <= largest_size) return;
    fail(Status::invalid_argument,
         "%s %.3g across; marks have float coordinates, so that must be from %g to %g: scale the %s by about %.0g",
         what, size, smallest_size, largest_size, remedy, std::clamp(1.0 / size, 1e-300, 1e300));
}

std::int64_t grown_count(std::int64_t base, std::int64_t factor, std::int32_t levels) noexcept {
    for (std::int32_t level = 0; level < levels; ++level) base *= factor;
    return base;
}

void require_room(std::int64_t layer, std::int64_t full_count, std::int32_t levels, std::int64_t budget) {
    if (full_count <= most_marks || (budget > 0 && budget <= most_marks)) return;
    if (layer < 0)
        fail(Status::invalid_argument,
             "start_level is %d, which would grow to %lld stipples; at most %lld are allowed, so lower it", levels,
             static_cast<long long>(full_count), static_cast<long long>(most_marks));
    fail(Status::invalid_argument,
         "layers[%lld].levels is %d, which would grow to %lld marks; at most %lld are allowed: lower it or set "
         "layers[%lld].budget",
         static_cast<long long>(layer), levels, static_cast<long long>(full_count), static_cast<long long>(most_marks),
         static_cast<long long>(layer));
}

// Returns the seed of the layer's random numbers. The first layer of stipples and the first layer of hatching use the
// seed of the set.
std::uint64_t layer_seed(std::uint64_t random_seed, Kind kind, std::int64_t number) noexcept {
    if (number == 0 && kind != Kind::own) return random_seed;
    const auto n = static_cast<std::uint64_t>(number);
    const base::Philox bits =
        base::philox(random_seed, {static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(n >> 32U),
                                   static_cast<std::uint32_t>(base::Purpose::layer), static_cast<std::uint32_t>(kind)});
    return static_cast<std::uint64_t>(bits[0]) << 32U | bits[1];
}

std::uint64_t Thinning::ticket(std::uint64_t key) const noexcept {
    const base::Philox bits =
        base::philox(seed_, {static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32U),
                             static_cast<std::uint32_t>(base::Purpose::budget), stream_});
    return static_cast<std::uint64_t>(bits[0]) << 32U | bits[1];
}

// Finds the limit: the ticket at index `kept` in sorted order. Tickets are uniform random numbers, so only a few have
// the same first bits as the limit. Only these are sorted; the others are counted.
void Thinning::choose(base::Array<std::uint64_t>& tickets, std::int64_t kept, const base::Progress& progress) {
    HRBFNPR_ASSERT(kept >= 0 && kept < tickets.size());
    constexpr unsigned first_bits = 52; // tickets have 64 bits; each value of the upper 12 bits has a counter
    std::array<std::int64_t, std::size_t{1} << (64U - first_bits)> counted{};
    for (const std::int64_t i : progress.over(tickets.size())) {
        ++counted[static_cast<std::size_t>(tickets[i] >> first_bits)];
    }
    std::uint64_t first = 0;
    for (; kept >= counted[static_cast<std::size_t>(first)]; ++first) kept -= counted[static_cast<std::size_t>(first)];
    std::int64_t alike = 0;
    for (const std::int64_t i : progress.over(tickets.size())) {
        if (tickets[i] >> first_bits == first) tickets[alike++] = tickets[i];
    }
    std::nth_element(tickets.begin(), tickets.begin() + kept, tickets.begin() + alike);
    limit_ = tickets[kept];
}

} // namespace hrbfnpr::marks
