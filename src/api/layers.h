// SPDX-License-Identifier: MIT
// Kinds and names of layers of marks, as the caller gives them.
#pragma once

#include "api/descriptor.h"
#include "base/utf8.h"
#include "marks/point_set.h"

#include <cstring>

static_assert(static_cast<int>(hrbfnpr::marks::Kind::any) == HRBFNPR_LAYER_KIND_ANY);
static_assert(static_cast<int>(hrbfnpr::marks::Kind::stipples) == HRBFNPR_LAYER_KIND_STIPPLES);
static_assert(static_cast<int>(hrbfnpr::marks::Kind::own) == HRBFNPR_LAYER_KIND_OWN);
static_assert(static_cast<int>(hrbfnpr::marks::Kind::hatch) == HRBFNPR_LAYER_KIND_HATCH);

namespace hrbfnpr::api {

// Checks the name in "<owner>.name". NULL gives an empty name.
[[nodiscard]] inline marks::LayerName checked_name(const char* given, const char* owner) {
    marks::LayerName name{};
    if (given == nullptr) return name;
    const std::size_t size = strnlen(given, name.size());
    if (size == 0 || size == name.size())
        fail(Status::invalid_argument, "%s.name has %s bytes; it must have 1 to %d, or be NULL", owner,
             size == 0 ? "no" : "64 or more", static_cast<int>(name.size()) - 1);
    if (!base::is_utf8({given, size}))
        fail(Status::invalid_argument, "%s.name is not UTF-8; encode it as UTF-8", owner);
    std::memcpy(name.data(), given, size);
    return name;
}

} // namespace hrbfnpr::api
