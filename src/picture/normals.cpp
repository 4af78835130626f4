// SPDX-License-Identifier: MIT
#include "picture/normals.h"

#include "base/assert.h"
#include "geometry/along_curves.h"
#include "geometry/neighbours.h"
#include "picture/statistics.h"
#include "picture/tuning_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace hrbfnpr::picture {
namespace {

constexpr std::uint64_t look_seed = 1;
// Each use of random numbers has a separate stream, so that the uses do not affect each other.
constexpr std::uint32_t sources_stream = 1;
constexpr std::uint32_t queries_stream = 2;

Points selected_points(const Points& points, const Vector<std::int64_t>& chosen, Pool& pool) {
    Points some(&pool);
    some.reserve(chosen.size());
    for (const std::int64_t i : chosen) some.push_back(points[static_cast<std::size_t>(i)]);
    return some;
}

geometry::VecArray in_columns(const Points& points, Pool& pool) {
    geometry::VecArray columns(pool.memory(), static_cast<std::int64_t>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) columns.set(static_cast<std::int64_t>(i), points[i]);
    return columns;
}

double typical_length(const Points& points) noexcept {
    geometry::Bounds bounds;
    for (const glm::dvec3& p : points) bounds.extend(p);
    return bounds.diagonal();
}

glm::dvec3 mean_point(const Points& points) noexcept {
    return std::accumulate(points.begin(), points.end(), glm::dvec3(0.0)) / static_cast<double>(points.size());
}

// Some of the samples, centred at the origin and scaled to size 1.
struct NormalSamples {
    Points points;
    Points normals;
    Vector<double> spacing; // for each sample: the distance to the farthest of its neighbours
    Vector<double> area;
};

// Returns the winding number of the samples at a place. The solid angle of each sample is limited to a hemisphere.
double winding_number(const glm::dvec3& place, const NormalSamples& samples) noexcept {
    double sum = 0.0;
    for (std::size_t j = 0; j < samples.points.size(); ++j) {
        const glm::dvec3 away = samples.points[j] - place;
        const double distance = std::sqrt(glm::dot(away, away) + normals_tuning.soft_area * samples.area[j]);
        const double part = glm::dot(away, samples.normals[j] * samples.area[j]) / (distance * distance * distance) /
                            (4.0 * std::numbers::pi);
        sum += std::clamp(part, -0.5, 0.5);
    }
    return sum;
}

// Returns, for some samples, the sum of the winding numbers on their two sides.
Vector<double> winding_sums(const NormalSamples& samples, Pool& pool) {
    constexpr double least_step = 1e-6;
    Vector<double> sums(&pool);
    for (const std::int64_t query :
         random_subset(samples.points.size(), normals_tuning.most_queries, look_seed, queries_stream, pool)) {
        const auto i = static_cast<std::size_t>(query);
        const glm::dvec3 step = std::max(samples.spacing[i], least_step) * samples.normals[i];
        const double side = normals_tuning.off_surface;
        sums.push_back(winding_number(samples.points[i] + side * step, samples) +
                       winding_number(samples.points[i] - side * step, samples));
    }
    return sums;
}

double share_outside_in(const Vector<double>& sums) noexcept {
    double telling = 0.0;
    double negative = 0.0;
    for (const double sum : sums) {
        telling += std::abs(sum) > normals_tuning.telling_sum ? 1.0 : 0.0;
        negative += sum < -normals_tuning.telling_sum ? 1.0 : 0.0;
    }
    return telling / static_cast<double>(sums.size()) > normals_tuning.telling_share ? negative / telling : 0.0;
}

// Sets look.against, the share of normals that are opposite to most neighbours on the same sheet. Sets look.flipped,
// the share of flipped normals, as estimated from the share of neighbours with opposite normals.
void compare_neighbours(const NormalSamples& samples, const geometry::Neighbours& near, NormalsLook& look) noexcept {
    const std::size_t count = samples.points.size();
    std::int64_t against = 0;
    std::int64_t level_pairs = 0;
    std::int64_t opposed_pairs = 0;
    for (std::size_t i = 0; i < count; ++i) {
        std::int64_t beside = 0;
        std::int64_t opposed_beside = 0;
        for (const std::int64_t other : near.of(static_cast<std::int64_t>(i))) {
            const auto j = static_cast<std::size_t>(other);
            const glm::dvec3 away = samples.points[j] - samples.points[i];
            const double length = glm::length(away);
            const double height = std::abs(glm::dot(away, samples.normals[i]));
            const bool opposed = glm::dot(samples.normals[j], samples.normals[i]) < normals_tuning.opposed_cosine;
            if (height < normals_tuning.beside_height * length) {
                ++beside;
                opposed_beside += opposed ? 1 : 0;
            }
            // A neighbour this near to the sample's tangent plane is certainly on the same sheet as the sample.
            if (height < normals_tuning.level_height * length) {
                ++level_pairs;
                opposed_pairs += opposed ? 1 : 0;
            }
        }
        if (beside >= normals_tuning.fewest_beside &&
            static_cast<double>(opposed_beside) > normals_tuning.against_share * static_cast<double>(beside))
            ++against;
    }
    look.against = look.flipped = static_cast<double>(against) / static_cast<double>(count);
    const double all_pairs = static_cast<double>(count) * static_cast<double>(near.each());
    if (static_cast<double>(level_pairs) / all_pairs < normals_tuning.least_level_share) return;
    const double pairs = static_cast<double>(opposed_pairs) / static_cast<double>(level_pairs);
    // If a share p of normals is flipped, a share 2 p (1 - p) of the pairs is opposite. This solves for p.
    look.flipped = (1.0 - std::sqrt(std::max(1.0 - 2.0 * pairs, 0.0))) / 2.0;
}

} // namespace

bool NormalsLook::inward() const noexcept {
    return closed < normals_tuning.inward_sum && against < normals_tuning.unsure_share;
}

bool NormalsLook::mixed() const noexcept {
    return against >= normals_tuning.mixed_share || flipped >= normals_tuning.unsure_share ||
           (normals_tuning.least_outside_in < outside_in && outside_in < normals_tuning.most_outside_in);
}

NormalsLook look_at_normals(const Points& points, const Points& normals, bool even, Pool& pool) {
    HRBFNPR_ASSERT(points.size() == normals.size());
    const Vector<std::int64_t> some =
        random_subset(points.size(), normals_tuning.most_sources, look_seed, sources_stream, pool);
    NormalSamples samples{selected_points(points, some, pool), selected_points(normals, some, pool),
                          Vector<double>(&pool), Vector<double>(&pool)};
    NormalsLook look;
    const std::size_t count = samples.points.size();
    const double size = count > 0 ? typical_length(samples.points) : 0.0;
    if (count < normals_tuning.fewest_looked_at || !(size > 0.0) || !std::isfinite(size)) return look;
    const glm::dvec3 middle = mean_point(samples.points);
    for (glm::dvec3& p : samples.points) p = (p - middle) / size;

    const geometry::Neighbours near(base::Parallel(), in_columns(samples.points, pool), normals_tuning.neighbours, {});
    for (std::size_t i = 0; i < count; ++i) {
        const auto last = static_cast<std::size_t>(near.of(static_cast<std::int64_t>(i)).back());
        samples.spacing.push_back(glm::length(samples.points[last] - samples.points[i]));
    }
    Vector<double> spacing(samples.spacing, &pool);
    const double typical = even ? median_of(spacing) : 0.0;
    for (const double each : samples.spacing) {
        const double side = even ? typical : each;
        samples.area.push_back(side * side * (std::numbers::pi / static_cast<double>(near.each())));
    }

    Vector<double> sums = winding_sums(samples, pool);
    look.outside_in = share_outside_in(sums);
    look.closed = median_of(sums);
    compare_neighbours(samples, near, look);
    return look;
}

String normals_in_words(const NormalsLook& look, Pool& pool) {
    const char* const words = look.mixed()                               ? "some normals point outward, others inward"
                              : look.closed > -normals_tuning.inward_sum ? "normals point outward"
                                                                         : "open surface, normals kept";
    return {words, &pool};
}

void tell_wrong_normals(const Call& call, const NormalsLook& look, std::size_t count, bool of_mesh, bool advice_apart) {
    if (look.inward()) return;
    const auto warn = [&](std::uint32_t code, std::initializer_list<double> figures, String&& what,
                          std::string_view advice, std::string_view detail) {
        if (advice_apart)
            call.report.warn(code, figures, what, {advice, detail});
        else
            call.report.warn(code, figures, (what += ": ") += advice, {.detail = detail});
    };
    if (of_mesh && look.mixed()) {
        const double share = std::max(look.flipped, look.outside_in);
        warn(HRBFNPR_NOTE_NORMALS_MIXED, {share},
             formatted(call.pool, "about %.0f%% of the faces face inward, and are drawn wrong", 100.0 * share),
             "turn them in MeshLab or Blender", how_to_turn_faces);
    } else if (look.against >= normals_tuning.mixed_share || look.flipped >= normals_tuning.unsure_share) {
        const double wrong = std::nearbyint(look.flipped * static_cast<double>(count));
        warn(HRBFNPR_NOTE_NORMALS_AGAINST, {wrong, static_cast<double>(count)},
             formatted(call.pool, "%.0f of %zu normals oppose their neighbours", wrong, count),
             "{flipped_normals=reorient} repairs a few",
             "The surface is wrong there. Orient the normals again in MeshLab or CloudCompare if many are wrong.");
    } else if (look.mixed()) {
        warn(HRBFNPR_NOTE_NORMALS_MIXED, {look.outside_in},
             formatted(call.pool, "about %.0f%% of the normals point inward", 100.0 * look.outside_in),
             "their parts are drawn empty", "Turn them in MeshLab or CloudCompare.");
    } else if (look.closed < normals_tuning.doubtful_sum) {
        warn(HRBFNPR_NOTE_NORMALS_INWARD, {}, {"most normals of the open surface point inward", &call.pool},
             "{flip!} turns all, if the picture is empty", {});
    }
}

// ---- Points along curves

bool lie_along_curves(const Points& points, Pool& pool) {
    if (points.size() > normals_tuning.most_along_curves) return false;
    return geometry::lie_along_curves(geometry::PointTree(in_columns(points, pool), {}));
}

// ---- Samples at one place

SharedPlaces merge_shared_places(Points& points, Points& normals, Pool& pool) {
    HRBFNPR_ASSERT(points.size() == normals.size());
    Vector<std::size_t> order(points.size(), 0, &pool);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        const glm::dvec3& a = points[i];
        const glm::dvec3& b = points[j];
        if (a.x != b.x) return a.x < b.x;
        if (a.y != b.y) return a.y < b.y;
        if (a.z != b.z) return a.z < b.z;
        return i < j;
    });

    SharedPlaces places;
    Vector<std::uint8_t> goes(points.size(), 0, &pool);
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
        const std::size_t first = order[begin];
        glm::dvec3 mean(0.0);
        bool differs = false;
        for (end = begin; end < order.size() && points[order[end]] == points[first]; ++end) {
            const glm::dvec3& normal = normals[order[end]];
            mean += normal;
            differs = differs || glm::dot(normal, normals[first]) < normals_tuning.agreement;
        }
        if (!differs) continue;
        for (std::size_t k = begin; k < end; ++k) goes[order[k]] = 1;
        mean /= static_cast<double>(end - begin);
        const double length = glm::length(mean);
        if (length > normals_tuning.opposite) {
            goes[first] = 0;
            normals[first] = mean / length;
            ++places.joined;
        } else {
            ++places.left_out;
        }
    }
    if (places.joined + places.left_out == 0) return places;
    std::size_t to = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (goes[i] != 0) continue;
        points[to] = points[i];
        normals[to++] = normals[i];
    }
    points.resize(to);
    normals.resize(to);
    return places;
}

// ---- Normals by the library

namespace {

void set_vector(double (&to)[3], const glm::dvec3& from) noexcept {
    to[0] = from.x;
    to[1] = from.y;
    to[2] = from.z;
}

} // namespace

const char* found_in_words(std::uint32_t found) noexcept {
    switch (found) {
    case HRBFNPR_NORMALS_NONE: return "do not fit the points";
    case HRBFNPR_NORMALS_UNORIENTED: return "point to either side at random";
    case HRBFNPR_NORMALS_MIXED: return "point inward in some places";
    case HRBFNPR_NORMALS_INWARD: return "point inward";
    default: return "point outward";
    }
}

MadeNormals make_normals(const Call& call, Stage& stage, const Points& points, const Points& normals,
                         std::uint32_t mode, const ViewingHints& seen) {
    HRBFNPR_ASSERT(normals.empty() || normals.size() == points.size());
    auto desc = defaults<hrbfnpr_orient_desc>(hrbfnpr_orient_desc_init);
    desc.mode = mode;
    desc.points = view_of(points);
    if (!normals.empty()) desc.normals = view_of(normals);
    if (seen.up) set_vector(desc.up, *seen.up);
    if (seen.viewpoint) {
        set_vector(desc.viewpoint, *seen.viewpoint);
        desc.has_viewpoint = 1;
    }
    MadeNormals made{Points(points.size(), glm::dvec3(0.0), &call.pool),
                     defaults<hrbfnpr_orient_info>(hrbfnpr_orient_info_init)};
    const hrbfnpr_array_out to = room_in(made.normals);
    picture::call([&](hrbfnpr_error* error) {
        return hrbfnpr_orient(&call.context, &desc, stage.operation(), &to, &made.info, error);
    });
    return made;
}

String made_in_words(const hrbfnpr_orient_info& info, std::size_t count, Pool& pool) {
    String words(&pool);
    if (info.made >= static_cast<std::int64_t>(count))
        words = "normals computed";
    else if (info.turned != 0 || info.made != 0)
        words = formatted(pool, "%lld normals turned, %lld computed again", static_cast<long long>(info.turned),
                          static_cast<long long>(info.made));
    else
        words = "normals kept";
    words += info.closed != 0 ? "; closed surface" : "; open surface";
    words += formatted(pool, ", confidence %.2f", info.confidence);
    return words;
}

void tell_unsure_normals(const Call& call, const hrbfnpr_orient_info& info) {
    if (info.confidence < normals_tuning.unsure_confidence)
        call.report.warn(
            HRBFNPR_NOTE_NORMALS_NOT_SURE, {info.confidence},
            formatted(call.pool, "normals may be wrong (confidence %.2f of 1): check the picture", info.confidence),
            {.detail = "More points, or normals from the scanner, are more reliable."});
    if (info.outward_by == HRBFNPR_OUTWARD_UP)
        call.report.warn(HRBFNPR_NOTE_FRONT_NOT_TOLD, {},
                         "the front of this open surface is a guess: {flip!} takes the other side",
                         {.detail = "{viewpoint=X,Y,Z} takes the side that a scanner at this place saw."});
}

String repaired_normals(const Call& call, Stage& stage, const Points& points, Points& normals, std::uint32_t mode,
                        const ViewingHints& seen) {
    MadeNormals made = make_normals(call, stage, points, normals, mode, seen);
    const hrbfnpr_orient_info& info = made.info;
    tell_unsure_normals(call, info);
    if (info.turned != 0 || info.made != 0)
        call.report.note(
            HRBFNPR_NOTE_NORMALS_REPAIRED,
            {static_cast<double>(info.turned), static_cast<double>(info.made), static_cast<double>(info.found)},
            formatted(call.pool, "normals repaired: %lld turned, %lld computed again ({normals=keep} leaves them)",
                      static_cast<long long>(info.turned), static_cast<long long>(info.made)),
            {.detail = formatted(call.pool, "The normals of the source %s.", found_in_words(info.found))});
    normals = std::move(made.normals);
    return made_in_words(info, points.size(), call.pool);
}

String settle_normals(const Call& call, Stage& stage, const Points& points, Points& normals, std::uint32_t mode,
                      const ViewingHints& seen) {
    if (mode == HRBFNPR_NORMALS_GIVEN) return {"normals kept", &call.pool};
    if (mode != HRBFNPR_NORMALS_AUTO) return repaired_normals(call, stage, points, normals, mode, seen);
    const NormalsLook look = look_at_normals(points, normals, false, call.pool);
    if ((look.mixed() && points.size() >= normals_tuning.fewest_repaired) || lie_along_curves(points, call.pool))
        return repaired_normals(call, stage, points, normals, HRBFNPR_NORMALS_AUTO, seen);
    if (look.inward()) {
        call.report.note(HRBFNPR_NOTE_NORMALS_TURNED, {},
                         "all normals pointed inward: they are turned ({normals=keep} leaves them)");
        for (glm::dvec3& normal : normals) normal = -normal;
        return {"normals pointed inward: all turned", &call.pool};
    }
    tell_wrong_normals(call, look, points.size(), false);
    return normals_in_words(look, call.pool);
}

} // namespace hrbfnpr::picture
