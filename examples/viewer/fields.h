// SPDX-License-Identifier: MIT
// The fields of descriptors, by their names in the C header.
#pragma once

#include "handles.h"

namespace viewer {

// A field of a struct that can be set: a number, a vector, a name or a choice.
struct Field {
    std::string name;
    std::string type; // type of one element
    std::size_t offset = 0;
    std::size_t count = 1;            // elements
    std::vector<std::string> choices; // words that mean numbers; empty: the field is not a choice
    std::uint32_t first_choice = 0;   // the number of the first word
};

// Returns the fields of "hrbfnpr_style" or another struct, from the library's own description of its structs.
const std::vector<Field>& fields_of(const std::string& c_name);
// Throws a Failure if the struct has no such field.
const Field& field_of(const std::string& c_name, const std::string& name);

// Returns the value of a struct's field as text for a hrbfnpr_change.
std::string text_of(const Field& field, const void* values);
// Returns the shortest decimals that read as the same number.
std::string decimals(double number);

// Returns every section of settings with its fields and their words, as JSON (docs/settings.md).
std::string schema_text();

} // namespace viewer
