// SPDX-License-Identifier: MIT
// Tuning of the fit of one sheet. The values were set by scripts/bench edges, in which most sheets are planes, parts of
// cylinders and fillets: few centres are enough for them, and each round is short.
#pragma once

#include <cstdint>

namespace hrbfnpr::mesh {

struct SheetTuning {
    // The number of even samples that a fit begins with. Larger: planes take longer.
    std::int64_t first_centres = 8;
    std::int32_t most_rounds = 12;
    // A round adds at most this share of the centres, but may add `smallest_batch`. Larger: fewer rounds, and more
    // centres that were not needed.
    double batch = 0.7;
    std::int64_t smallest_batch = 12;
    // Centres are at least this many tolerances apart. Larger: fewer centres along creases, which are less exact.
    double apart = 4.0;
};
inline constexpr SheetTuning sheet_tuning;

} // namespace hrbfnpr::mesh
