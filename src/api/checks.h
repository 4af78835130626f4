// SPDX-License-Identifier: MIT
// Checks the fields of a struct, with messages such as
//   fit_desc.regularization is -1; it must be a finite number of at least 0
#pragma once

#include "base/status.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace hrbfnpr::api {

class Checks {
public:
    // `owner` is the name of the struct, such as "fit_desc". It must outlive this object.
    explicit Checks(const char* owner) noexcept : owner_(owner) {}

    void finite(const char* field, double value) const {
        if (!std::isfinite(value)) refuse(field, value, "a finite number");
    }
    void at_least(const char* field, double value, double low) const {
        if (!(std::isfinite(value) && value >= low))
            fail(Status::invalid_argument, "%s.%s is %g; it must be a finite number of at least %g", owner_, field,
                 value, low);
    }
    void positive(const char* field, double value) const {
        if (!(std::isfinite(value) && value > 0.0)) refuse(field, value, "a finite number above 0");
    }
    void between(const char* field, double value, double low, double high) const {
        if (!(value >= low && value <= high))
            fail(Status::invalid_argument, "%s.%s is %g; it must be from %g to %g", owner_, field, value, low, high);
    }
    void strictly_between(const char* field, double value, double low, double high) const {
        if (!(value > low && value < high))
            fail(Status::invalid_argument, "%s.%s is %g; it must be above %g and below %g", owner_, field, value, low,
                 high);
    }
    // Checks that the value is one of the enumerators 0 to count - 1.
    void one_of(const char* field, std::int64_t value, std::uint32_t count, const char* names) const {
        if (value < 0 || value >= static_cast<std::int64_t>(count))
            fail(Status::invalid_argument, "%s.%s is %lld; it must be one of %s (0 to %u)", owner_, field,
                 static_cast<long long>(value), names, count - 1);
    }
    // Checks that the value has only bits of known flags.
    void flags(const char* field, std::uint32_t value, std::uint32_t known) const {
        if ((value & ~known) != 0)
            fail(Status::invalid_argument, "%s.%s is 0x%X; only the bits of 0x%X may be set", owner_, field, value,
                 known);
    }
    void zero_or_one(const char* field, std::int64_t value) const {
        if (value != 0 && value != 1)
            fail(Status::invalid_argument, "%s.%s is %lld; it must be 0 or 1", owner_, field,
                 static_cast<long long>(value));
    }
    void zero(const char* field, std::uint32_t value) const {
        if (value != 0) fail(Status::invalid_argument, "%s.%s is %u; it must be 0", owner_, field, value);
    }
    void not_null(const char* field, bool is_given) const {
        if (!is_given) fail(Status::invalid_argument, "%s.%s is NULL", owner_, field);
    }

private:
    [[noreturn]] void refuse(const char* field, double value, const char* wanted) const {
        fail(Status::invalid_argument, "%s.%s is %g; it must be %s", owner_, field, value, wanted);
    }

    const char* owner_;
};

} // namespace hrbfnpr::api
