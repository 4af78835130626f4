// SPDX-License-Identifier: MIT
// Changes to the fields of any descriptor, by the layout that the library gives of it: a new field is fuzzed as soon as
// there is one.
#pragma once

#include "input.h"

#include <hrbfnpr.h>

#include <string_view>

namespace fuzz {

// Makes some fields odd: none, one or a few.  Numbers of an element of a list, strides and addresses stay as they are,
// as do the fields in `kept`; an array may lose elements, its type or its address, but never gets larger.
void change_fields(Input& input, const char* name, void* desc, std::initializer_list<std::string_view> kept = {});

// A descriptor with its defaults, then changed.
template <class T, class Init>
T changed(Input& input, const char* name, Init init, std::initializer_list<std::string_view> kept = {}) {
    T desc;
    init(&desc, sizeof desc);
    change_fields(input, name, &desc, kept);
    return desc;
}

// Words for names, groups, titles: of many lengths, some no UTF-8, some that files must escape; or NULL.
const char* odd_words(Input& input);

} // namespace fuzz
