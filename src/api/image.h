// SPDX-License-Identifier: MIT
// Images of the caller.
#pragma once

#include "api/descriptor.h"
#include "output/raster/raster.h"

#include <hrbfnpr.h>

namespace hrbfnpr::api {

template <>
hrbfnpr_image defaults() noexcept;

// Checks an image. `name` is its name in messages.
[[nodiscard]] output::Image checked_image(const hrbfnpr_image& image, const char* name);

} // namespace hrbfnpr::api
