// SPDX-License-Identifier: MIT
// The end of a surface that its samples do not bear out any more.
#pragma once

#include "implicit/extent.h"
#include "surface/support.h"

#include <utility>

namespace hrbfnpr::surface {

class Trim final : public implicit::Extent {
public:
    // closest: as the support was made with.
    Trim(Support support, double limit, double closest) noexcept
        : support_(std::move(support)), limit_(limit), closest_(closest) {}

    [[nodiscard]] const Support& support() const noexcept { return support_; }
    [[nodiscard]] double limit() const noexcept { return limit_; }
    [[nodiscard]] double closest() const noexcept { return closest_; }

    [[nodiscard]] bool holds(const glm::dvec3& place, const glm::dvec3& gradient) const noexcept override {
        return !support_.may_end_at(place) || support_.value(place, gradient) <= limit_;
    }
    [[nodiscard]] bool may_end_near(const glm::dvec3& place, double half) const noexcept override {
        return support_.may_end_near(place, half);
    }
    [[nodiscard]] bool is_nowhere_near(const glm::dvec3& place, double half) const noexcept override {
        return support_.has_nothing_near(place, half, limit_);
    }

private:
    Support support_;
    double limit_, closest_;
};

} // namespace hrbfnpr::surface
