// SPDX-License-Identifier: MIT
// Tuning of the choice of centres. The values were set by scripts/bench fit and scripts/bench points on scans, knots
// and tori of 1000 to 200 000 samples.
#pragma once

#include <cstdint>

namespace hrbfnpr::fit {

struct AdaptiveTuning {
    // A round adds at most this share of the centres. Larger: fewer rounds, and more centres that were not needed.
    double batch = 0.5;
    // A round adds this share of the centres while more than `mostly_outside` of the candidates is outside.
    double large_batch = 1.0;
    double mostly_outside = 0.25;
    // A round may add this many centres, however few there are. Larger: fewer rounds in small fits.
    std::int64_t smallest_batch = 32;
    // If some candidates are outside the tolerance, those beyond this share of it are added too, since they would be
    // next. Larger: more rounds.
    double nearly_outside = 0.75;
    // A normal that is wrong by an angle moves the surface by about this share of the angle times the distance to the
    // next centre. Larger: more centres where normals are off.
    double lever = 0.25;
    // New centres are at least this share of the local spacing of the centres apart, so that a batch covers all bad
    // regions and does not heap in the worst one. The share is halved, down to the least one, while no candidate
    // passes. Larger: smaller batches.
    double apart = 0.5;
    double least_apart = 1e-3;
    // Where f grows inward, a candidate counts as off by at least this many tolerances. Larger: such candidates come
    // first.
    double wrong_side = 2.0;
};
inline constexpr AdaptiveTuning adaptive_tuning;

struct ChoiceTuning {
    // The number of first centres where there is a tolerance. Larger: small fits take longer.
    std::int64_t first_centres = 256;
    // Without a tolerance the number of first centres is the final number divided by this. Larger: more rounds.
    std::int64_t last_of_first = 4;
    // The choice stops after this many rounds, since then it does not converge.
    std::int32_t most_rounds = 50;
    // The smoothing for the noise depends on the fit's variance, and the variance on the smoothing. It is settled if it
    // changes by a smaller factor than this, or after this many fits. Larger factor: fewer fits.
    double settled = 1.2;
    int settling_fits = 4;
    // The smoothing is settled on this many samples before all become centres. Larger: slower.
    std::int64_t pilot_centres = 512;
    // The noise is averaged over this many neighbours. Larger: details are mistaken for noise.
    std::int64_t averaged = 16;
    // Centres nearer to each other than this many standard deviations of the noise would follow it. Larger: less
    // detail.
    double noise_apart = 4.0;
    // With noisy samples a round must add one centre per this many existing ones, since else only noise is left.
    // Larger: more rounds.
    std::int64_t worthwhile = 200;
    // The surface may miss the mean of neighbouring samples by the tolerance minus this many standard deviations of the
    // noise, but at least by `least_tolerance` times the tolerance. Larger: more centres in noise.
    double noise_allowed = 2.0;
    double least_tolerance = 0.5;
};
inline constexpr ChoiceTuning choice_tuning;

} // namespace hrbfnpr::fit
