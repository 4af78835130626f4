// SPDX-License-Identifier: MIT
#include "api/views.h"

#include "base/status.h"

#include <cmath>
#include <limits>

namespace hrbfnpr::api {
namespace {

static_assert(static_cast<std::uint32_t>(base::Scalar::float32) == HRBFNPR_SCALAR_FLOAT32);
static_assert(static_cast<std::uint32_t>(base::Scalar::float64) == HRBFNPR_SCALAR_FLOAT64);
static_assert(static_cast<std::uint32_t>(base::Scalar::uint8) == HRBFNPR_SCALAR_UINT8);
static_assert(static_cast<std::uint32_t>(base::Scalar::uint32) == HRBFNPR_SCALAR_UINT32);
static_assert(static_cast<std::uint32_t>(base::Scalar::int32) == HRBFNPR_SCALAR_INT32);
static_assert(static_cast<std::uint32_t>(base::Scalar::int64) == HRBFNPR_SCALAR_INT64);

constexpr auto longest = std::numeric_limits<std::int64_t>::max();

const char* names_of(unsigned scalars) noexcept {
    switch (scalars) {
    case float_types: return "FLOAT32 or _FLOAT64";
    case float_or_uint8_types: return "FLOAT32, _FLOAT64 or _UINT8";
    case float32_only: return "FLOAT32";
    case uint8_only: return "UINT8";
    case uint32_only: return "UINT32";
    case index_types: return "INT32, _INT64 or _UINT32";
    default: return "UINT8 or _UINT32";
    }
}

void check_type(std::uint32_t scalar, std::uint32_t components, const char* name, ArrayType type) {
    if (scalar < HRBFNPR_SCALAR_FLOAT32 || scalar > HRBFNPR_SCALAR_INT64 || (type.scalars & (1U << scalar)) == 0)
        fail(Status::invalid_argument, "%s.scalar is %u; it must be HRBFNPR_SCALAR_%s", name, scalar,
             names_of(type.scalars));
    if (components != type.components)
        fail(Status::invalid_argument, "%s.components is %u; it must be %u", name, components, type.components);
}

// Returns the stride in bytes. Checks that all elements are inside the address space.
std::int64_t checked_stride(const void* data, std::int64_t count, std::int64_t stride, std::int64_t element,
                            const char* name) {
    if (stride == 0) stride = element;
    if (stride > -element && stride < element)
        fail(Status::invalid_argument,
             "%s.stride is %lld, but an element has %lld bytes; it must be 0, at least that, or at most its negative",
             name, static_cast<long long>(stride), static_cast<long long>(element));
    // The lowest number has no positive counterpart, so -stride would overflow.
    const std::int64_t step = stride == std::numeric_limits<std::int64_t>::min() ? longest
                              : stride < 0                                       ? -stride
                                                                                 : stride;
    const auto address = reinterpret_cast<std::uintptr_t>(data);
    const bool countable = count - 1 <= (longest - element) / step;
    const auto reach = countable ? static_cast<std::uint64_t>((count - 1) * step) : 0;
    const auto size = static_cast<std::uint64_t>(element);
    const bool fits = stride > 0 ? reach + size <= std::numeric_limits<std::uintptr_t>::max() - address
                                 : reach <= address && size <= std::numeric_limits<std::uintptr_t>::max() - address;
    if (!countable || !fits)
        fail(Status::invalid_argument, "%s: count %lld times stride %lld exceeds the address space", name,
             static_cast<long long>(count), static_cast<long long>(stride));
    return stride;
}

template <class View, class Array>
View checked(const Array& array, const char* name, ArrayType type) {
    if (array.count < 0)
        fail(Status::invalid_argument, "%s.count is %lld; it must be 0 or more", name,
             static_cast<long long>(array.count));
    if (array.count == 0) return {};
    if (array.data == nullptr)
        fail(Status::invalid_argument, "%s.data is NULL, but its count is %lld; give the data, or set count to 0", name,
             static_cast<long long>(array.count));
    check_type(array.scalar, array.components, name, type);
    const auto scalar = static_cast<base::Scalar>(array.scalar);
    const std::int64_t element = base::size_of(scalar) * type.components;
    View view;
    view.data = static_cast<decltype(view.data)>(array.data);
    view.count = array.count;
    view.stride = checked_stride(array.data, array.count, array.stride, element, name);
    view.scalar = scalar;
    view.components = array.components;
    return view;
}

void check_count(std::int64_t given, std::int64_t wanted, const char* name) {
    if (given != wanted)
        fail(Status::invalid_argument, "%s.count is %lld; it must be %lld", name, static_cast<long long>(given),
             static_cast<long long>(wanted));
}

} // namespace

base::InView in_view(const hrbfnpr_array& array, const char* name, ArrayType type) {
    return checked<base::InView>(array, name, type);
}

base::InView in_view(const hrbfnpr_array& array, const char* name, ArrayType type, std::int64_t count) {
    const base::InView view = in_view(array, name, type);
    if (array.data != nullptr || array.count != 0) check_count(view.count, count, name);
    return view;
}

base::Array<double> finite_numbers(base::Memory& memory, const hrbfnpr_array& array, const char* name, ArrayType type) {
    base::Array<double> numbers(memory);
    const base::InView view = in_view(array, name, type);
    for (std::int64_t i = 0; i < view.count; ++i) {
        for (std::uint32_t c = 0; c < type.components; ++c) {
            const double number = view.get(i, c);
            if (!std::isfinite(number))
                fail(Status::invalid_argument, "%s[%lld] has %g; numbers must be finite", name,
                     static_cast<long long>(i), number);
            numbers.push_back(number);
        }
    }
    return numbers;
}

base::OutView out_view(const hrbfnpr_array_out* array, const char* name, ArrayType type, std::int64_t count) {
    if (array == nullptr) return {};
    const auto view = checked<base::OutView>(*array, name, type);
    if (array->data != nullptr || array->count != 0) check_count(view.count, count, name);
    return view;
}

} // namespace hrbfnpr::api
