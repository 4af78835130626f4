// SPDX-License-Identifier: MIT
// From hrbfnpr_array to the views that the rooms below take.  Nothing below checks them again.
#pragma once

#include "base/memory.h"
#include "base/view.h"

#include <hrbfnpr.h>

namespace hrbfnpr::api {

// Allowed scalar types, or-ed.
inline constexpr unsigned float_types = 1U << HRBFNPR_SCALAR_FLOAT32 | 1U << HRBFNPR_SCALAR_FLOAT64;
inline constexpr unsigned float32_only = 1U << HRBFNPR_SCALAR_FLOAT32;
inline constexpr unsigned uint8_only = 1U << HRBFNPR_SCALAR_UINT8;
inline constexpr unsigned uint32_only = 1U << HRBFNPR_SCALAR_UINT32;
inline constexpr unsigned uint8_or_uint32 = uint8_only | uint32_only;
inline constexpr unsigned index_types =
    1U << HRBFNPR_SCALAR_INT32 | 1U << HRBFNPR_SCALAR_INT64 | 1U << HRBFNPR_SCALAR_UINT32;

struct ArrayType {
    std::uint32_t components;
    unsigned scalars;
};
inline constexpr ArrayType points_type{3, float_types};
inline constexpr ArrayType number_type{1, float_types};

// Throw Error{invalid_argument} that names the array.  One that is not given (data NULL, count 0)
// or has no elements gives an empty view.
[[nodiscard]] base::InView in_view(const hrbfnpr_array& array, const char* name, ArrayType type);
// ... of exactly `count` elements, or not given.
[[nodiscard]] base::InView in_view(const hrbfnpr_array& array, const char* name, ArrayType type, std::int64_t count);
// Element by element, all of them finite.
[[nodiscard]] base::Array<double> finite_numbers(base::Memory& memory, const hrbfnpr_array& array, const char* name,
                                                 ArrayType type);
// array may be NULL: not wanted.
[[nodiscard]] base::OutView out_view(const hrbfnpr_array_out* array, const char* name, ArrayType type,
                                     std::int64_t count);

} // namespace hrbfnpr::api
