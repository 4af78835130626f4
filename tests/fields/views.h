// SPDX-License-Identifier: MIT
// Short ways to make the arguments of calls.
#pragma once

#include <hrbfnpr.h>

#include <cstdint>
#include <vector>

namespace fields_test {

// The value of `*out_handle` before a call. A call that fails sets it to NULL.
template <class T>
T* sentinel() {
    static char place;
    return reinterpret_cast<T*>(&place);
}

inline hrbfnpr_array in(const std::vector<double>& data, std::int64_t count) {
    return {data.data(), count, 0, HRBFNPR_SCALAR_FLOAT64, 3};
}

inline hrbfnpr_array_out out(std::vector<double>& data, std::int64_t count, std::uint32_t components = 3,
                             std::uint32_t scalar = HRBFNPR_SCALAR_FLOAT64) {
    return {data.data(), count, 0, scalar, components};
}

} // namespace fields_test
