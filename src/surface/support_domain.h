// SPDX-License-Identifier: MIT
// The domain of a surface that its samples support. It ends where s(x) = limit, where s is defined in
// surface/support.h.
#pragma once

#include "base/assert.h"
#include "geometry/point_grid.h"
#include "implicit/domain.h"
#include "surface/support.h"

#include <optional>
#include <utility>

namespace hrbfnpr::surface {

class SupportDomain final : public implicit::Domain {
public:
    // `closest` is the value with which `support` was made.
    SupportDomain(Support support, double limit, double closest) noexcept
        : support_(std::move(support)), limit_(limit), closest_(closest) {}

    // Sets the border of a mesh of the surface, given by points on it. Lines and rays find no end of the surface
    // farther than `reach` from these points.
    void set_border(const geometry::VecArray& places, double reach) {
        HRBFNPR_ASSERT(reach > 0.0);
        border_.emplace(places, reach);
    }

    [[nodiscard]] const Support& support() const noexcept { return support_; }
    [[nodiscard]] double limit() const noexcept { return limit_; }
    [[nodiscard]] double closest() const noexcept { return closest_; }

    [[nodiscard]] double beyond(const glm::dvec3& place, const glm::dvec3& gradient) const noexcept override {
        return support_.may_end_at(place) ? support_.value(place, gradient) - limit_ : -limit_;
    }
    [[nodiscard]] bool near_end(const glm::dvec3& place) const noexcept override {
        return !border_ || border_->any_around(place);
    }
    [[nodiscard]] bool may_end_near(const glm::dvec3& centre, double half) const noexcept override {
        return support_.may_end_near(centre, half);
    }
    [[nodiscard]] bool has_no_surface_in(const glm::dvec3& centre, double half) const noexcept override {
        return support_.has_nothing_near(centre, half, limit_);
    }

private:
    Support support_;
    double limit_, closest_;
    std::optional<geometry::PointGrid> border_;
};

} // namespace hrbfnpr::surface
