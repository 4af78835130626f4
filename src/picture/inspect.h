// SPDX-License-Identifier: MIT
// What a source holds, what is wrong with it, and what a picture would repair; nothing is fitted or drawn.
#pragma once

#include "picture/report.h"
#include "picture/sources.h"

namespace hrbfnpr::picture {

// Looks at a source, and tells the report what it finds; what makes a source useless is told as a failure.  Throws only
// what is not the source's fault.
[[nodiscard]] hrbfnpr_source_info inspect_source(hrbfnpr_context& context, Source&& source, Report& report);

} // namespace hrbfnpr::picture
