// SPDX-License-Identifier: MIT
// Tuning of the choice of centres. The values were set by scripts/bench fit and scripts/bench points on scans, knots
// and tori of 1000 to 200 000 samples.
#pragma once

#include <cstdint>

namespace hrbfnpr::fit {

struct AdaptiveTuning {
    // A round adds at most this many centres, as a share of the existing ones. Larger: fewer rounds, and more centres
    // that were not needed.
    double batch = 0.5;
    // A round adds this share of the existing centres while more than the share `mostly_outside` of the candidates is
    // outside the tolerance.
    double large_batch = 1.0;
    double mostly_outside = 0.25;
    // A round may always add this many centres. Larger: fewer rounds in small fits.
    std::int64_t smallest_batch = 32;
    // If some candidates are outside the tolerance, candidates with an error above this share of the tolerance are
    // added too, because later rounds would add them anyway. Larger: more rounds.
    double nearly_outside = 0.75;
    // A normal that is wrong by an angle moves the surface by about this share of the angle times the distance to the
    // next centre. Larger: more centres where normals are off.
    double lever = 0.25;
    // New centres are at least this share of the local spacing of the centres apart, so that a batch covers all regions
    // with large errors. The share is halved, down to the smallest allowed share, while all candidates are too close.
    // Larger: smaller batches.
    double apart = 0.5;
    double least_apart = 1e-3;
    // Where f grows inward, the error of a candidate is at least this many tolerances. Larger: candidates of this kind
    // come first.
    double wrong_side = 2.0;
};
inline constexpr AdaptiveTuning adaptive_tuning;

struct ChoiceTuning {
    // The number of first centres of a fit with a tolerance. Larger: small fits take longer.
    std::int64_t first_centres = 256;
    // Without a tolerance, the number of first centres is the final number of centres divided by this. Larger: more
    // rounds.
    std::int64_t last_of_first = 4;
    // The choice of centres stops after this many rounds: if it needs more, it does not converge.
    std::int32_t most_rounds = 50;
    // The smoothing depends on the variance of the fit, and the variance depends on the smoothing. Fits are repeated
    // until the smoothing changes by less than this factor, or until `settling_fits` fits are made. Larger: fewer fits.
    double settled = 1.2;
    int settling_fits = 4;
    // If all samples become centres, the smoothing is found first on this many samples. Larger: slower.
    std::int64_t pilot_centres = 512;
    // Errors of noisy samples are averaged over this many neighbours. Larger: details are mistaken for noise.
    std::int64_t averaged = 16;
    // New centres are at least this many standard deviations of the noise apart, because closer ones would follow the
    // noise. Larger: less detail.
    double noise_apart = 4.0;
    // With noisy samples the choice ends when a round adds less than one centre per this many existing ones: then only
    // noise is left. Larger: more rounds.
    std::int64_t worthwhile = 200;
    // The mean error of neighbouring samples must be below the tolerance minus this many standard deviations of the
    // noise, but not below `least_tolerance` tolerances. Larger: more centres in noise.
    double noise_allowed = 2.0;
    double least_tolerance = 0.5;
};
inline constexpr ChoiceTuning choice_tuning;

} // namespace hrbfnpr::fit
