// SPDX-License-Identifier: MIT
// Inspects a source: its contents, its defects, and the repairs that a picture would make. It fits and draws nothing.
#pragma once

#include "picture/report.h"
#include "picture/sources.h"

namespace hrbfnpr::picture {

// Inspects a source and reports the findings. A defect that makes the source useless is reported as a failure. Only
// errors that the source did not cause are thrown.
[[nodiscard]] hrbfnpr_source_info inspect_source(hrbfnpr_context& context, Source&& source, Report& report);

} // namespace hrbfnpr::picture
