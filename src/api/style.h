// SPDX-License-Identifier: MIT
// Converts the public style to the frame's style.
#pragma once

#include "api/descriptor.h"
#include "base/memory.h"
#include "frame/scene/style.h"

#include <hrbfnpr.h>

namespace hrbfnpr::api {

// Checks every field; `owner` names the struct in messages, such as "items[2].style".  Appends the style's layers and
// lines to the arrays. The returned style has empty spans, because the arrays may still move.
[[nodiscard]] frame::Style checked_style(const hrbfnpr_style& style, const char* owner,
                                         base::Array<frame::LayerStyle>& layers, base::Array<frame::LineStyle>& lines);

} // namespace hrbfnpr::api
