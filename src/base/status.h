// SPDX-License-Identifier: MIT
// Failures inside the library. They are exceptions of a single type with a status and a message.
#pragma once

#include "base/format.h"

#include <cstdint>
#include <exception>

namespace hrbfnpr {

// The values equal the constants HRBFNPR_STATUS_* in hrbfnpr.h (src/api checks this at compile time).
enum class Status : std::int32_t {
    ok = 0,
    invalid_argument = -1,
    out_of_memory = -2,
    buffer_too_small = -3,
    unsupported_struct = -4,
    singular_system = -5,
    not_converged = -6,
    cancelled = -7,
    io = -8,
    corrupt_data = -9,
    version_mismatch = -10,
    callback = -11,
    internal = -99
};

// An error with its message in a fixed array, so that throwing it does not allocate a string.
class Error : public std::exception {
public:
    static constexpr int message_capacity = 248;

    Error(Status status, const char* message) noexcept;

    [[nodiscard]] Status status() const noexcept { return status_; }
    [[nodiscard]] const char* what() const noexcept override { return message_; }

private:
    Status status_;
    char message_[message_capacity];
};

// Throws an Error with a printf-formatted message.
HRBFNPR_PRINTF_LIKE(2, 3) [[noreturn]] void fail(Status status, const char* format, ...);

// Copies `text` and a terminating zero into `destination`. Text that is too long is cut at a UTF-8 character boundary.
void copy_message(char* destination, int capacity, const char* text) noexcept;

} // namespace hrbfnpr
