// SPDX-License-Identifier: MIT
#include "marks/size.h"

#include "base/status.h"

#include <algorithm>

namespace hrbfnpr::marks {

void require_size(const char* what, double size, const char* remedy) {
    if (size >= smallest_size && size <= largest_size) return;
    fail(Status::invalid_argument,
         "%s %.3g across; marks are float and can be placed where that is from %g to %g: scale the %s, by about %.0g",
         what, size, smallest_size, largest_size, remedy, std::clamp(1.0 / size, 1e-300, 1e300));
}

} // namespace hrbfnpr::marks
