// SPDX-License-Identifier: MIT
#include "stipples/void_centre.h"

#include <array>
#include <cmath>

namespace hrbfnpr::stipples {
namespace {

constexpr int centre_steps = 6;
constexpr std::size_t none = static_cast<std::size_t>(-1);

double squared(const glm::dvec2& v) noexcept { return glm::dot(v, v); }

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) noexcept {
    const glm::dvec2 u = b - a;
    const glm::dvec2 v = c - a;
    return u.x * v.y - u.y * v.x;
}

class Climb {
public:
    Climb(std::span<const glm::dvec2> around, double wanted, double farthest) noexcept
        : around_(around), wanted_(wanted), farthest_(farthest) {}

    glm::dvec2 run() noexcept {
        nearest_[0] = nearest();
        for (int step = 0; step < centre_steps && advance(); ++step) {
        }
        return squared(at_) <= farthest_ * farthest_ ? at_ : glm::dvec2(0.0);
    }

private:
    [[nodiscard]] std::size_t nearest() const noexcept {
        std::size_t best = 0;
        for (std::size_t i = 1; i < around_.size(); ++i)
            if (squared(around_[i]) < squared(around_[best])) best = i;
        return best;
    }

    // Unit; along it the distances to the nearest points grow, and stay equal.
    [[nodiscard]] glm::dvec2 uphill() const noexcept {
        const glm::dvec2 a = around_[nearest_[0]];
        if (nearest_[1] == none) {
            const double length = glm::length(at_ - a);
            return length > 0.0 ? (at_ - a) / length : glm::dvec2(1.0, 0.0);
        }
        const glm::dvec2 b = around_[nearest_[1]];
        const glm::dvec2 across = glm::normalize(glm::dvec2(a.y - b.y, b.x - a.x));
        return glm::dot(across, at_ - 0.5 * (a + b)) < 0.0 ? -across : across;
    }

    // How far to where the nearest point is `wanted` away; |at + t d - a| = wanted.
    [[nodiscard]] double to_wanted(const glm::dvec2& direction) const noexcept {
        const glm::dvec2 from = at_ - around_[nearest_[0]];
        const double along = glm::dot(from, direction);
        const double missing = wanted_ * wanted_ - squared(from);
        return missing > 0.0 ? std::sqrt(along * along + missing) - along : 0.0;
    }

    // The next point that comes to be as near: |at + t d - q| = |at + t d - a|.
    struct Meeting {
        double distance;
        std::size_t point;
    };
    [[nodiscard]] Meeting next(const glm::dvec2& direction) const noexcept {
        const glm::dvec2 a = around_[nearest_[0]];
        const double own = squared(at_ - a);
        Meeting meeting{2.0 * farthest_, none};
        for (std::size_t i = 0; i < around_.size(); ++i) {
            if (i == nearest_[0] || i == nearest_[1]) continue;
            const double approach = 2.0 * glm::dot(direction, around_[i] - a);
            if (!(approach > 1e-12 * wanted_)) continue;
            const double distance = std::max(0.0, (squared(at_ - around_[i]) - own) / approach);
            if (distance < meeting.distance) meeting = {distance, i};
        }
        return meeting;
    }

    // Returns whether to go on.
    bool advance() noexcept {
        const glm::dvec2 direction = uphill();
        const Meeting meeting = next(direction);
        const double enough = to_wanted(direction);
        at_ += std::min(enough, meeting.distance) * direction;
        if (enough <= meeting.distance || meeting.point == none) return false;
        if (nearest_[1] == none) {
            nearest_[1] = meeting.point;
            return true;
        }
        return leave_vertex(meeting.point);
    }

    // At equal distances from three points: a maximum if they surround it, else on along the edge that it is beyond.
    bool leave_vertex(std::size_t third) noexcept {
        const glm::dvec2 a = around_[nearest_[0]];
        const glm::dvec2 b = around_[nearest_[1]];
        const glm::dvec2 c = around_[third];
        const double all = turn(a, b, c);
        if (turn(b, c, at_) * all < 0.0) {
            nearest_ = {nearest_[1], third};
            return true;
        }
        if (turn(c, a, at_) * all < 0.0) {
            nearest_[1] = third;
            return true;
        }
        return false;
    }

    std::span<const glm::dvec2> around_;
    double wanted_, farthest_;
    glm::dvec2 at_{0.0};
    std::array<std::size_t, 2> nearest_{none, none};
};

} // namespace

glm::dvec2 toward_void(std::span<const glm::dvec2> around, double wanted, double farthest) noexcept {
    return around.empty() ? glm::dvec2(0.0) : Climb(around, wanted, farthest).run();
}

} // namespace hrbfnpr::stipples
