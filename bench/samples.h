// SPDX-License-Identifier: MIT
// Samples, as the benchmarks call them.
#pragma once

#include "support/samples.h"

namespace bench {

using hrbfnpr::test::bumpy;
using hrbfnpr::test::Samples;

} // namespace bench
