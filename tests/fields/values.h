// SPDX-License-Identifier: MIT
// Invalid values for a field, chosen by the type of the field alone.
#pragma once

#include "api/struct_fields.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace fields_test {

// A change of a field. `field` points to the first byte of the field.
struct Change {
    std::string place; // within the field, such as "[2]" or ".count"
    std::string value;
    std::function<void(std::byte* field)> apply;
};

// Returns all changes of a field that a caller could make by mistake and that leave its pointers valid. Counts and
// strides get only values that are refused before memory is read.
std::vector<Change> changes_of(const hrbfnpr::api::FieldLayout& field);

} // namespace fields_test
