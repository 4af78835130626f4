// SPDX-License-Identifier: MIT
// Structs that begin with struct_size and grow at their end.
//
// A caller may be older than the library: its struct is shorter, and the missing fields get their defaults. Or it may
// be newer: its struct is longer, and is refused only if it sets fields that the library does not know.  All structs
// have a member of 8 bytes, so a shorter struct also ends on an 8-byte boundary, and no pointer or double is cut in
// two.
#pragma once

#include "base/status.h"

#include <hrbfnpr.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace hrbfnpr::api {

inline constexpr std::uint32_t smallest_struct = 8;
inline constexpr std::uint32_t largest_struct = 65536; // A larger size shows that the struct is not initialised.

// Returns a struct's defaults; struct_size need not be set.  The specialisation stands beside the `_init` function.
template <class T>
[[nodiscard]] T defaults() noexcept;

template <class T>
void check_struct_size(std::uint32_t size, const char* name) {
    static_assert(std::is_trivially_copyable_v<T> && std::is_standard_layout_v<T>);
    if (size < smallest_struct || size > largest_struct)
        fail(Status::unsupported_struct, "%s.struct_size is %u; set up the struct with its _init function", name, size);
}

// Implements the `_init` function of a struct.
template <class T>
hrbfnpr_status init_struct(T* given, std::uint32_t size) noexcept {
    if (given == nullptr) return HRBFNPR_STATUS_INVALID_ARGUMENT;
    if (size < smallest_struct || size > largest_struct) return HRBFNPR_STATUS_UNSUPPORTED_STRUCT;
    T full = defaults<T>();
    full.struct_size = size;
    const std::size_t known = std::min<std::size_t>(size, sizeof full);
    std::memcpy(static_cast<void*>(given), &full, known);
    std::memset(reinterpret_cast<std::byte*>(given) + known, 0, size - known);
    return HRBFNPR_STATUS_OK;
}

// Returns the caller's struct in full. Missing fields have their defaults.
template <class T>
[[nodiscard]] T read_struct(const T* given, const char* name) {
    if (given == nullptr) fail(Status::invalid_argument, "%s is NULL", name);
    std::uint32_t size = 0;
    std::memcpy(&size, given, sizeof size);
    check_struct_size<T>(size, name);
    const auto* bytes = reinterpret_cast<const std::byte*>(given);
    for (std::size_t i = sizeof(T); i < size; ++i)
        if (bytes[i] != std::byte{0})
            fail(Status::unsupported_struct,
                 "%s sets fields that this library, version %s, does not know; use a newer library", name,
                 hrbfnpr_version_string());
    T full = defaults<T>();
    std::memcpy(static_cast<void*>(&full), given, std::min<std::size_t>(size / alignof(T) * alignof(T), sizeof full));
    full.struct_size = sizeof full;
    return full;
}

// Reads a struct. If it is NULL, all fields have their defaults.
template <class T>
[[nodiscard]] T read_optional_struct(const T* given, const char* name) {
    return given != nullptr ? read_struct(given, name) : defaults<T>();
}

// Checks that `out` can receive a result. Call it before the work.
template <class T>
void check_output_struct(const T* out, const char* name) {
    if (out == nullptr) fail(Status::invalid_argument, "%s is NULL", name);
    check_struct_size<T>(out->struct_size, name);
}

// Writes a result to the caller's struct, up to the caller's struct_size.
template <class T>
void write_struct(T* out, const T& full) noexcept {
    const std::uint32_t size = out->struct_size;
    const std::size_t known = std::min<std::size_t>(size, sizeof full);
    std::memcpy(static_cast<void*>(out), &full, known);
    std::memset(reinterpret_cast<std::byte*>(out) + known, 0, size - known);
    out->struct_size = size;
}

// Writes one number of a result struct that was read by read_struct(), if the struct has room for it.
template <class T, class Number>
void write_number(T* out, Number T::*member, Number number) noexcept {
    auto* const to = reinterpret_cast<std::byte*>(&(out->*member));
    const auto end = static_cast<std::size_t>(to - reinterpret_cast<std::byte*>(out)) + sizeof number;
    if (end <= out->struct_size) std::memcpy(to, &number, sizeof number);
}

} // namespace hrbfnpr::api
