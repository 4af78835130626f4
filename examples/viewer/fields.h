// SPDX-License-Identifier: MIT
// Descriptors as JSON objects, field by field, by the names that the C header has for them.
#pragma once

#include "handles.h"

#include <nlohmann/json_fwd.hpp>

namespace viewer {

using Json = nlohmann::ordered_json;

// The fields of a struct that settings can hold: numbers, vectors, names and choices.
struct Field {
    std::string name;
    std::string type; // of an element
    std::size_t offset = 0;
    std::size_t count = 1;            // elements
    std::vector<std::string> choices; // not empty: words in place of numbers ...
    std::uint32_t first_choice = 0;   // ... from this one on
};

// Of "hrbfnpr_style" and others, from the library's own description of its structs.
const std::vector<Field>& fields_of(const std::string& c_name);

// What differs from `base`, of the same type.
Json fields_to_json(const std::string& c_name, const void* values, const void* base);

// Writes what `json` holds.  `where` is how messages call it; keys of `others` are for someone else to read.
void fields_from_json(const std::string& c_name, const Json& json, void* values, const std::string& where,
                      const std::vector<std::string>& others = {});

// Text and numbers that descriptors point to; they stay as long as the program runs.
const char* kept(const std::string& text);
hrbfnpr_array kept(const std::vector<double>& numbers);

// The one number of a kind that JSON can hold without loss: the shortest decimal that reads as the same float.
double shortest(float value);

// Numbers of a JSON array, or a Failure that says where.
std::vector<double> numbers_of(const Json& json, const std::string& where, std::size_t count = 0);

} // namespace viewer
