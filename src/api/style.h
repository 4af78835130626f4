// From the public style to the frame's.
#pragma once

#include "api/descriptor.h"
#include "frame/scene/style.h"

#include <hrbfnpr.h>

namespace hrbfnpr::api {

template <>
hrbfnpr_style defaults() noexcept;

// Checks every field; `owner` names the struct in messages, such as "items[2].style".
[[nodiscard]] frame::Style checked_style(const hrbfnpr_style& style, const char* owner);

} // namespace hrbfnpr::api
