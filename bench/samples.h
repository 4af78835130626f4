// SPDX-License-Identifier: MIT
// The benchmarks' names for samples.
#pragma once

#include "support/samples.h"

namespace bench {

using hrbfnpr::test::bumpy;
using hrbfnpr::test::Samples;

} // namespace bench
