// SPDX-License-Identifier: MIT
// Very small and very large models are sampled in a unit of their own, in which floats hold squares and cubes.
#pragma once

#include "generate/settings.h"
#include "geometry/unit.h"
#include "implicit/scaled.h"
#include "marks/site.h"

#include <optional>

namespace hrbfnpr::generate {

// A model, its samples and the settings' lengths in the model's unit.
class InUnit {
public:
    // What check_request() let pass; all arguments live as long as this.
    InUnit(const base::Runtime& runtime, const implicit::Implicit& implicit, const SampleHint& samples,
           const Settings& settings);
    InUnit(const InUnit&) = delete;
    InUnit& operator=(const InUnit&) = delete;

    [[nodiscard]] marks::Site site() const noexcept {
        return {runtime_, scaled_ ? *scaled_ : implicit_, settings_.projection_tolerance, settings_.random_seed, unit_};
    }
    [[nodiscard]] const SampleHint& samples() const noexcept { return samples_; }
    [[nodiscard]] const Settings& settings() const noexcept { return settings_; }

private:
    const base::Runtime& runtime_;
    const implicit::Implicit& implicit_;
    double unit_;
    std::optional<implicit::Scaled> scaled_; // only in another unit than the caller's
    base::Array<double> sample_position_, seed_position_;
    SampleHint samples_;
    Settings settings_;
};

// Lengths of a finished set.  Throws Error{invalid_argument} for what a float cannot hold.
void to_callers_unit(marks::PointSet& set, double unit);

} // namespace hrbfnpr::generate
