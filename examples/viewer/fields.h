// SPDX-License-Identifier: MIT
// The fields of descriptors, by the names that the C header has for them.
#pragma once

#include "handles.h"

namespace viewer {

// A field of a struct that can be set: a number, a vector, a name or a choice.
struct Field {
    std::string name;
    std::string type; // of an element
    std::size_t offset = 0;
    std::size_t count = 1;            // elements
    std::vector<std::string> choices; // words that stand for numbers; empty: there are none
    std::uint32_t first_choice = 0;   // the number of the first word
};

// The fields of "hrbfnpr_style" and others, from the library's own description of its structs.
const std::vector<Field>& fields_of(const std::string& c_name);
// A Failure where the struct has no such field.
const Field& field_of(const std::string& c_name, const std::string& name);

// What a field of a struct holds, as the value of a hrbfnpr_change.
std::string text_of(const Field& field, const void* values);
// The shortest decimals that read as the same number.
std::string decimals(double number);

// Every section of settings, its fields, and the words that they can be, as JSON (docs/settings.md).
std::string schema_text();

} // namespace viewer
