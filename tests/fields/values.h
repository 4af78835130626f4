// SPDX-License-Identifier: MIT
// Values that make no sense, for a field of which only the type is known.
#pragma once

#include "api/struct_fields.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace fields_test {

// A change of a field: its bytes begin at `field`.
struct Change {
    std::string place; // within the field, such as "[2]" or ".count"
    std::string value;
    std::function<void(std::byte* field)> apply;
};

// All changes of a field that a caller could make by mistake and that leave its pointers valid: counts and strides are
// only such as are refused before memory is read.
std::vector<Change> changes_of(const hrbfnpr::api::FieldLayout& field);

} // namespace fields_test
