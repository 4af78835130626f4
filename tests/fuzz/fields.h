// SPDX-License-Identifier: MIT
// Changes the fields of any descriptor, by the layout that the library reports for it, so that new fields are fuzzed at
// once.
#pragma once

#include "input.h"

#include <hrbfnpr.h>

#include <string_view>

namespace fuzz {

// Makes no field, one or a few fields odd. The number of elements of a list, strides, addresses and the fields in
// `kept` stay as they are. An array may lose elements, its type or its address, but never gets larger.
void change_fields(Input& input, const char* name, void* desc, std::initializer_list<std::string_view> kept = {});

// Returns a descriptor with its defaults, then changed.
template <class T, class Init>
T changed(Input& input, const char* name, Init init, std::initializer_list<std::string_view> kept = {}) {
    T desc;
    init(&desc, sizeof desc);
    change_fields(input, name, &desc, kept);
    return desc;
}

// Words for names, groups and titles: of many lengths, some not valid UTF-8, some that files must escape; or NULL.
const char* odd_words(Input& input);

} // namespace fuzz
