// SPDX-License-Identifier: MIT
// A ray goes from its place to the eye. It marches in steps that are shorter than the distance |f| / |grad f| of the
// surface, and evaluates f and its slope along the ray. While the surface at the place itself is near, the ray is in
// contact with it, and nothing hides the place. After that, each change of sign is bracketed, and so is each minimum of
// |f| that comes near 0. A ray passes through the surface if f has a root on it which lies in the surface's domain. The
// root counts only if the ray is farther than the margin from the surface on both sides of it, or if two roots are
// those of a thin wall. A root that does not count, and a minimum that is nearer than the margin, make the ray
// undecided.
#include "visibility/sight.h"

#include "base/assert.h"
#include "geometry/tangent_frame.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::visibility {
namespace {

constexpr const SightTuning& tuned_sight = sight_tuning;
constexpr auto sight_lanes = static_cast<std::size_t>(tuned_sight.rays_a_task);

// f at a place of a ray.
struct SightSample {
    double at = 0.0; // the distance from the start of the ray
    double value = 0.0, slope = 0.0;
    glm::dvec3 gradient{0.0};

    // Returns the distance of the surface, as the gradient estimates it; infinite where the gradient is 0, such as in
    // the middle of a ball.
    [[nodiscard]] double distance() const noexcept { return std::abs(value) / glm::length(gradient); }
    [[nodiscard]] double sine() const noexcept { return std::abs(slope) / glm::length(gradient); }
    [[nodiscard]] int sign() const noexcept { return value < 0.0 ? -1 : 1; }
};

// All lengths and places are in the coordinates of the occluder.
struct SightRay {
    enum class Phase : std::uint8_t { start, march, root, least, done };

    glm::dvec3 origin{0.0}, direction{0.0};
    double end = 0.0;
    double margin = 0.0, contact = 0.0, lift = 0.0;
    bool is_cut = false; // whether the ray ends at a cut face
    Phase phase = Phase::start;
    int lifts = 0, steps = 0, halvings = 0;
    double trial = 0.0;
    SightSample last;       // the search is complete up to here
    SightSample low, high;  // the bracket of a root or of a minimum
    SightSample beyond;     // where the march goes on after a bracket
    int sign = 0;           // the sign of f; 0: the ray is still in contact with the surface at its place
    double turned_at = 0.0; // the distance from the start at which f last changed its sign
    double deepest = 0.0;   // the largest distance from the surface since then
    bool close = false;     // true since the ray came nearer than the margin, until a root or the way out
    bool entered = false;   // true if the last root counts as soon as the ray is far enough from the surface
    double dip = 0.0;       // how far the ray was inside the solid while it was in contact
    bool doubtful = false;  // true if something is nearer than the margin
    SightSample entry;      // the last root, if `entered`
    Seen seen = Seen::visible;
};

struct SightSizes {
    double least_step, longest_step, tolerance;
};

// Casts the rays of a batch.
class SightBatch {
public:
    SightBatch(const Occluder& occluder, const implicit::Domain* domain) noexcept
        : surface_(*occluder.surface), domain_(domain), size_{tuned_sight.least_step * surface_.diagonal(),
                                                              tuned_sight.longest_step * surface_.diagonal(),
                                                              tuned_sight.root_tolerance * surface_.diagonal()} {}

    std::array<SightRay, sight_lanes> rays;

    void run(std::size_t count, const base::Work& work) {
        for (;;) {
            std::size_t packed = 0;
            for (std::size_t i = 0; i < count; ++i) {
                const SightRay& ray = rays[i];
                if (ray.phase == SightRay::Phase::done) continue;
                const glm::dvec3 p = ray.origin + ray.trial * ray.direction;
                x_[packed] = p.x;
                y_[packed] = p.y;
                z_[packed] = p.z;
                number_[packed++] = i;
            }
            if (packed == 0) return;
            work.check();
            implicit::FieldBatch fields;
            fields.value = value_.data();
            fields.gradient = {gx_.data(), gy_.data(), gz_.data()};
            surface_.evaluate({x_.data(), y_.data(), z_.data(), static_cast<std::int64_t>(packed)}, fields);
            for (std::size_t k = 0; k < packed; ++k) {
                SightRay& ray = rays[number_[k]];
                const glm::dvec3 gradient(gx_[k], gy_[k], gz_[k]);
                take(ray, {ray.trial, value_[k], glm::dot(gradient, ray.direction), gradient});
            }
        }
    }

private:
    using Column = std::array<double, sight_lanes>;

    static void end_with(SightRay& ray, Seen seen) noexcept {
        ray.seen = seen;
        ray.phase = SightRay::Phase::done;
    }

    // The surface is at most as far away as the last change of sign.
    static void deepen(SightRay& ray, const SightSample& now) noexcept {
        const double distance = ray.turned_at > 0.0 ? std::min(now.distance(), now.at - ray.turned_at) : now.distance();
        ray.deepest = std::max(ray.deepest, distance);
    }

    // Chooses the next step of the march.
    void march_on(SightRay& ray, const SightSample& from) const {
        ray.last = from;
        if (ray.sign != 0) {
            const bool is_close = from.distance() < ray.margin;
            if (ray.close && !is_close && is_on_surface(ray, from)) ray.doubtful = true;
            ray.close = is_close && ray.deepest > ray.margin;
            deepen(ray, from);
            if (ray.entered && ray.deepest > ray.margin) return end_with(ray, Seen::hidden);
        }
        if (from.at >= ray.end && ray.is_cut && ray.sign < 0)
            return end_with(ray, ray.deepest > ray.margin ? Seen::hidden : Seen::undecided);
        if (from.at >= ray.end || ray.steps > tuned_sight.most_steps)
            return end_with(ray, ray.doubtful || ray.dip > tuned_sight.deep * ray.contact || ray.entered || ray.close ||
                                         from.at < ray.end
                                     ? Seen::undecided
                                     : Seen::visible);
        const double step = std::clamp(tuned_sight.step_share * from.distance(), size_.least_step, size_.longest_step);
        ray.trial = std::min(ray.end, from.at + step);
        ray.phase = SightRay::Phase::march;
    }

    void take(SightRay& ray, const SightSample& now) const {
        ++ray.steps;
        if (!std::isfinite(now.value) || !std::isfinite(glm::length(now.gradient)))
            return end_with(ray, Seen::undecided);
        switch (ray.phase) {
        case SightRay::Phase::start: return start(ray, now);
        case SightRay::Phase::march: return march(ray, now);
        case SightRay::Phase::root: return narrow_root(ray, now);
        case SightRay::Phase::least: return narrow_least(ray, now);
        case SightRay::Phase::done: return;
        }
    }

    void start(SightRay& ray, const SightSample& now) const {
        const double distance = now.distance();
        if (now.value < 0.0 && distance > ray.contact && ray.lift > 0.0 && ray.lifts < tuned_sight.most_lifts) {
            const double move = std::min(distance + 0.5 * ray.contact, ray.lift);
            ray.origin += move * now.gradient / glm::length(now.gradient);
            ray.lift -= move;
            ray.dip = std::max(ray.dip, 0.5 * tuned_sight.deep * ray.contact);
            ++ray.lifts;
            return;
        }
        if (distance > ray.contact) ray.sign = now.sign();
        march_on(ray, now);
    }

    void march(SightRay& ray, const SightSample& now) const {
        const SightSample before = ray.last;
        if (ray.sign == 0) {
            if (now.value < 0.0) ray.dip = std::max(ray.dip, now.distance());
            if (now.distance() > ray.contact) {
                ray.sign = now.sign();
                if (ray.sign < 0) ray.dip = 0.0;
                // On a smooth surface the distance grows with the square of the length of contact. If it grows faster,
                // the ray ran along a face that is seen edge-on, and passes its edge.
                if (now.sine() * now.at > tuned_sight.sudden * ray.contact &&
                    now.at > tuned_sight.long_contact * ray.margin)
                    ray.doubtful = true;
            }
            return march_on(ray, now);
        }
        if (now.sign() != ray.sign) {
            ray.low = before;
            ray.high = ray.beyond = now;
            ray.halvings = 0;
            ray.trial = glm::mix(before.at, now.at, 0.5);
            ray.phase = SightRay::Phase::root;
            return;
        }
        const double falls = -ray.sign * before.slope;
        const double rises = ray.sign * now.slope;
        if (falls > 0.0 && rises > 0.0) {
            // The tangents at the two places meet below the minimum of a convex function.
            const double length = now.at - before.at;
            const double a = std::abs(before.value);
            const double b = std::abs(now.value);
            const double meet = std::clamp((a - b + rises * length) / (falls + rises), 0.0, length);
            const double bound = 2.0 * ray.margin * std::max(glm::length(before.gradient), glm::length(now.gradient));
            if (std::min({a, b, a - falls * meet}) < bound) {
                ray.low = before;
                ray.high = ray.beyond = now;
                ray.halvings = 0;
                ray.trial = before.at + std::clamp(meet, 0.05 * length, 0.95 * length);
                ray.phase = SightRay::Phase::least;
                return;
            }
        }
        march_on(ray, now);
    }

    void narrow_least(SightRay& ray, const SightSample& now) const {
        deepen(ray, now);
        if (now.sign() != ray.sign) {
            ray.high = ray.beyond = now;
            ray.halvings = 0;
            ray.trial = glm::mix(ray.low.at, ray.high.at, 0.5);
            ray.phase = SightRay::Phase::root;
            return;
        }
        (ray.sign * now.slope < 0.0 ? ray.low : ray.high) = now;
        if (ray.high.at - ray.low.at > size_.tolerance && ++ray.halvings < tuned_sight.most_halvings) {
            const double falls = -ray.sign * ray.low.slope;
            const double rises = ray.sign * ray.high.slope;
            // Every second step is a bisection, because the secant of a kink converges slowly.
            const double share = ray.halvings % 2 == 0 ? std::clamp(falls / (falls + rises), 0.02, 0.98) : 0.5;
            ray.trial = glm::mix(ray.low.at, ray.high.at, std::isfinite(share) ? share : 0.5);
            return;
        }
        const SightSample& nearest = ray.low.distance() < ray.high.distance() ? ray.low : ray.high;
        if (nearest.distance() < ray.margin && is_on_surface(ray, nearest)) ray.doubtful = true;
        march_on(ray, ray.beyond);
    }

    void narrow_root(SightRay& ray, const SightSample& now) const {
        (now.sign() == ray.sign ? ray.low : ray.high) = now;
        if (ray.high.at - ray.low.at > size_.tolerance && ++ray.halvings < tuned_sight.most_halvings) {
            const double share = ray.low.value / (ray.low.value - ray.high.value);
            ray.trial = glm::mix(ray.low.at, ray.high.at, ray.halvings % 2 == 0 ? std::clamp(share, 0.02, 0.98) : 0.5);
            return;
        }
        pass(ray, now);
        if (ray.phase == SightRay::Phase::done) return;
        ray.sign = -ray.sign;
        ray.deepest = 0.0;
        ray.close = false;
        ray.turned_at = now.at;
        march_on(ray, ray.beyond);
    }

    // Judges a root of f.
    void pass(SightRay& ray, const SightSample& root) const {
        const SightSample entry = ray.entry;
        const bool is_second = ray.entered;
        ray.entered = false;
        if (!is_on_surface(ray, root)) {
            ray.doubtful = ray.doubtful || is_second;
            return;
        }
        if (ends_near(ray, root)) {
            ray.doubtful = true;
            return;
        }
        if (is_second) {
            const double facing = glm::dot(glm::normalize(entry.gradient), glm::normalize(root.gradient));
            if (facing < tuned_sight.opposite && entry.sine() > tuned_sight.steep && root.sine() > tuned_sight.steep)
                return end_with(ray, Seen::hidden);
            ray.doubtful = true;
        }
        if (ray.deepest > ray.margin) {
            ray.entered = true;
            ray.entry = root;
        } else if (!is_second) {
            ray.doubtful = true;
        }
    }

    [[nodiscard]] bool is_on_surface(const SightRay& ray, const SightSample& at) const {
        return domain_ == nullptr || domain_->contains(foot_of(ray, at), at.gradient);
    }

    // Returns whether the surface ends within the margin of a root.
    [[nodiscard]] bool ends_near(const SightRay& ray, const SightSample& root) const {
        const glm::dvec3 place = foot_of(ray, root);
        if (domain_ == nullptr || !domain_->near_end(place)) return false;
        const geometry::TangentFrame frame = geometry::combing_frame(glm::normalize(root.gradient));
        for (const glm::dvec3& way : {frame.u, -frame.u, frame.r, -frame.r})
            if (domain_->beyond(place + ray.margin * way, root.gradient) > 0.0) return true;
        return false;
    }

    // Returns the place of the surface next to a place of the ray, approximately.
    [[nodiscard]] static glm::dvec3 foot_of(const SightRay& ray, const SightSample& at) noexcept {
        const double square = glm::dot(at.gradient, at.gradient);
        const glm::dvec3 place = ray.origin + at.at * ray.direction;
        return square > 0.0 ? place - at.value / square * at.gradient : place;
    }

    const implicit::Implicit& surface_;
    const implicit::Domain* domain_;
    SightSizes size_;
    std::array<std::size_t, sight_lanes> number_;
    Column x_, y_, z_, value_, gx_, gy_, gz_;
};

// Moves the start of a ray into a box, and its end to where it leaves the box. Returns false if it does not meet the
// box.
bool clip_to_box(const geometry::Bounds& box, glm::dvec3& origin, const glm::dvec3& direction, double& end) noexcept {
    double from = 0.0;
    double to = end;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = box.min[axis] - origin[axis];
        const double high = box.max[axis] - origin[axis];
        if (direction[axis] == 0.0) {
            if (!(low <= 0.0 && high >= 0.0)) return false;
            continue;
        }
        from = std::max(from, std::min(low / direction[axis], high / direction[axis]));
        to = std::min(to, std::max(low / direction[axis], high / direction[axis]));
    }
    if (!(from < to)) return false;
    origin += from * direction;
    end = to - from;
    return true;
}

// Returns the ray from a place to the eye, in the coordinates of an occluder. The ray is done if it does not meet the
// occluder's region.
SightRay ray_to_eye(const Occluder& occluder, const glm::dmat4& from_world, const SightPlace& place,
                    bool own) noexcept {
    SightRay ray;
    ray.origin = glm::dvec3(from_world * glm::dvec4(place.place, 1.0));
    const glm::dvec3 eye(occluder.eye);
    const glm::dvec3 way = occluder.eye.w != 0.0 ? eye - ray.origin : -eye;
    const double length = glm::length(way);
    ray.direction = way / length;
    // The length of a unit of the world in the direction of the ray.
    const double scale = 1.0 / glm::length(glm::dmat3(occluder.to_world) * ray.direction);
    ray.end = std::min(scale * place.reach, occluder.eye.w != 0.0 ? length : std::numeric_limits<double>::infinity());
    ray.margin = scale * place.margin;
    ray.contact = tuned_sight.contact * ray.margin;
    const double end_at_reach = ray.end;
    ray.lift = own ? scale * place.lift : 0.0;
    if (!std::isfinite(length) || !(length > 0.0) ||
        !clip_to_box(occluder.sheet_counter->mesh().region, ray.origin, ray.direction, ray.end))
        ray.phase = SightRay::Phase::done;
    ray.is_cut = place.is_cut && std::isfinite(end_at_reach) && ray.end == end_at_reach;
    return ray;
}

} // namespace

base::Array<Sighting> look_at(const base::Work& work, std::span<const Occluder> occluders,
                              std::span<const SightPlace> places) {
    const auto count = static_cast<std::int64_t>(places.size());
    base::Array<Sighting> found(work.memory, count);
    for (Sighting& sighting : found) sighting = {};
    for (std::size_t o = 0; o < occluders.size(); ++o) {
        const Occluder& occluder = occluders[o];
        HRBFNPR_ASSERT(occluder.surface != nullptr && occluder.sheet_counter != nullptr);
        const glm::dmat4 from_world = glm::inverse(occluder.to_world);
        const base::Work threads = occluder.surface->threads(work);
        threads.for_chunks(count, tuned_sight.rays_a_task, [&](std::int64_t begin, std::int64_t end) {
            base::OwnedObject<SightBatch> batch(work.memory, occluder, occluder.sheet_counter->mesh().domain);
            for (std::int64_t i = begin; i < end; ++i) {
                const SightPlace& place = places[static_cast<std::size_t>(i)];
                SightRay& ray = batch->rays[static_cast<std::size_t>(i - begin)];
                ray = ray_to_eye(occluder, from_world, place,
                                 place.item == any_item || place.item == static_cast<std::int32_t>(o));
                if (found[i].seen == Seen::hidden) ray.phase = SightRay::Phase::done;
            }
            batch->run(static_cast<std::size_t>(end - begin), threads);
            for (std::int64_t i = begin; i < end; ++i) {
                const SightRay& ray = batch->rays[static_cast<std::size_t>(i - begin)];
                found[i].grazes = found[i].grazes || ray.dip > tuned_sight.grazing * ray.contact;
                if (found[i].seen == Seen::hidden || ray.seen == Seen::visible) continue;
                found[i].seen = ray.seen;
                found[i].hidden_by = ray.seen == Seen::hidden ? static_cast<std::int32_t>(o) : -1;
            }
        });
    }
    return found;
}

} // namespace hrbfnpr::visibility
