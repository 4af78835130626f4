// SPDX-License-Identifier: MIT
// Inspects a source: its contents, its defects, and the repairs that a picture would make. Nothing is fitted or drawn.
#pragma once

#include "picture/report.h"
#include "picture/sources.h"

namespace hrbfnpr::picture {

// Inspects a source and reports the findings. If a defect makes the source unusable, a failure is reported. Errors that
// the source did not cause are thrown.
[[nodiscard]] hrbfnpr_source_info inspect_source(hrbfnpr_context& context, Source&& source, Report& report);

} // namespace hrbfnpr::picture
