// SPDX-License-Identifier: MIT
// Converts a hrbfnpr_array to the views that other rooms use. Those rooms do not check the views again.
#pragma once

#include "base/memory.h"
#include "base/view.h"

#include <hrbfnpr.h>

namespace hrbfnpr::api {

// Sets of scalar types that an array may have. Each type is one bit.
inline constexpr unsigned float_types = 1U << HRBFNPR_SCALAR_FLOAT32 | 1U << HRBFNPR_SCALAR_FLOAT64;
inline constexpr unsigned float_or_uint8_types = float_types | 1U << HRBFNPR_SCALAR_UINT8;
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

// The functions below throw Error{invalid_argument} with a message that names the array. An array without elements, or
// not given (data NULL, count 0), gives an empty view.
[[nodiscard]] base::InView in_view(const hrbfnpr_array& array, const char* name, ArrayType type);
// The array must have exactly `count` elements, or be absent.
[[nodiscard]] base::InView in_view(const hrbfnpr_array& array, const char* name, ArrayType type, std::int64_t count);
// Copies the numbers element by element. Throws if a number is not finite.
[[nodiscard]] base::Array<double> finite_numbers(base::Memory& memory, const hrbfnpr_array& array, const char* name,
                                                 ArrayType type);
// Returns a view of a packed array, with the caller's constant for the type of its numbers.
template <class T>
[[nodiscard]] hrbfnpr_array packed_view(const base::Array<T>& array, std::uint32_t scalar,
                                        std::uint32_t components) noexcept {
    return {array.empty() ? nullptr : array.data(), array.size() / components,
            static_cast<std::int64_t>(sizeof(T)) * components, scalar, components};
}
// `array` may be NULL if the caller does not need the result.
[[nodiscard]] base::OutView out_view(const hrbfnpr_array_out* array, const char* name, ArrayType type,
                                     std::int64_t count);

} // namespace hrbfnpr::api
